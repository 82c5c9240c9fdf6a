// SPDX-License-Identifier: MIT
#include "support/archetypes.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "support/catch.hpp"
#include "support/registry.hpp"
#include "tutavia/batch.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/smooth/pipeline.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::test;

const Query query{.start = {1, 1}, .goal = {7, 7}};

/// A path of grid steps.
Curve path() {
  const Point corners[] = {query.start, {4, 1}, {7, 4}, query.goal};
  return Curve::polyline(corners);
}

/// Runs some smoothers on a new space of type S and notes their names.
class Runs {
 public:
  template <class S, class... Smoothers>
  void on(const Smoothers&... smoothers) {
    const S space;
    (run(smoothers, space), ...);
  }

  bool has(std::string_view name) const {
    return std::find(names_.begin(), names_.end(), name) != names_.end();
  }

 private:
  template <class A, class S>
  void run(const A& smoother, const S& space) {
    static_assert(Smoother<A, S>);
    INFO(A::name);
    const auto curve = smoother.smooth(space, path(), Budget{});
    REQUIRE(curve);
    CHECK(curve->start() == query.start);
    CHECK(curve->end() == query.goal);
    CHECK(curve->length() <= path().length() * (1 + 1e-12));
    if constexpr (ClearanceSpace<S>) CHECK(certify(space, *curve).status == ProofStatus::proved);
    names_.push_back(A::name);
  }

  std::vector<std::string_view> names_;
};

TEST_CASE("every smoother works on any space that has the operations its concept names") {
  Runs runs;
  runs.on<FreeArchetype>(NoSmoothing{});
  runs.on<ClearanceArchetype>(Shortcut{}, RedundantNodeRemoval{},
                              RedundantNodeRemoval{RedundantNodeRemoval::Scan::from_far_end},
                              BezierSmoother{}, BSplineSmoother{}, SmoothingSpline{},
                              Pipeline{Shortcut{}, BezierSmoother{}});
  runs.on<ClearanceGridArchetype>(Shortcut{}, BezierSmoother{}, TwoStageBSpline{});
  runs.on<CornerArchetype>(DeltaSmoother{}, DeltaSmoother{.join = DeltaSmoother::Join::paper});
  runs.on<FeatureArchetype>(TautString{}, ClothoidSmoother{}, HomotopyRefine{});
  for (const auto& smoother : all_smoothers<LatticeSpace>()) {
    INFO(smoother.name);
    CHECK(runs.has(smoother.name));
  }
}

// And on no others.
static_assert(!Smoother<Shortcut, GridArchetype>);
static_assert(!Smoother<RedundantNodeRemoval, GridArchetype>);
static_assert(!Smoother<BezierSmoother, GridArchetype>);
static_assert(!Smoother<BSplineSmoother, GridArchetype>);
static_assert(!Smoother<SmoothingSpline, GridArchetype>);
static_assert(!Smoother<TwoStageBSpline, ClearanceArchetype>);
static_assert(!Smoother<TwoStageBSpline, GridArchetype>);
static_assert(!Smoother<DeltaSmoother, ClearanceArchetype>);
static_assert(!Smoother<DeltaSmoother, FeatureArchetype>);
static_assert(!Smoother<TautString, ClearanceArchetype>);
static_assert(!Smoother<TautString, CornerArchetype>);
static_assert(!Smoother<ClothoidSmoother, ClearanceArchetype>);
static_assert(!Smoother<HomotopyRefine, ClearanceArchetype>);
static_assert(!Smoother<StringPull, WorkspaceArchetype> && Smoother<StringPull, CellSpace>);
static_assert(!Smoother<Pipeline<Shortcut, DeltaSmoother>, ClearanceArchetype>);

TEST_CASE("the registry lists the smoothers that work on a space") {
  const auto has = [](const auto& smoothers, std::string_view name) {
    return std::any_of(smoothers.begin(), smoothers.end(),
                       [&](const auto& smoother) { return smoother.name == name; });
  };
  CHECK(all_smoothers<FreeArchetype>().size() == 1);
  CHECK_FALSE(has(all_smoothers<FeatureArchetype>(), "homotopy_refine"));
  CHECK(has(all_smoothers<WorkspaceArchetype>(), "homotopy_refine"));
}

TEST_CASE("a planner plans on any space that its search and its smoother work on") {
  const ClearanceGridArchetype space;
  static_assert(detail::PlannableSpace<ClearanceGridArchetype, AStar, Shortcut>);
  static_assert(!detail::PlannableSpace<GridArchetype, AStar, NoSmoothing>);
  static_assert(!detail::PlannableSpace<ClearanceArchetype, AStar, NoSmoothing>);
  static_assert(!detail::PlannableSpace<ClearanceGridArchetype, AStar, TautString>);
  Planner planner{AStar{}, Shortcut{}};
  ObserverArchetype observer;
  const auto plan = planner.plan(space, query, observer);
  REQUIRE(plan);
  CHECK(plan->curve.length() == Approx(distance(query.start, query.goal)));
  CHECK(observer.told > 0);
  CHECK(plan_batch(planner, space, std::span(&query, 1))[0]);
  CHECK(detail::mean_clearance(space, plan->curve) > 1e6);
}

}  // namespace
