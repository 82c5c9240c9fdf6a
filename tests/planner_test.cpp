// SPDX-License-Identifier: MIT
#include "tutavia/planner.hpp"

#include "support/catch.hpp"
#include "support/exact_checker.hpp"
#include "support/reference_distance.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/search/theta_star.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/no_smoothing.hpp"
#include "tutavia/smooth/shortcut.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

/// Goes straight, whatever is in the way.
struct BlindSearch {
  static constexpr std::string_view name = "blind";
  struct Scratch {};
  template <class S, class O>
  Expected<Route, Failure> search(const S&, const Query& query, Scratch&, O&) const {
    const Point points[] = {query.start, query.goal};
    return Route{.curve = Curve::polyline(points)};
  }
};

/// Replaces every curve by its chord, whatever is in the way.
struct BlindSmoother {
  static constexpr std::string_view name = "blind";
  template <class S>
  Expected<Curve, Failure> smooth(const S&, const Curve& curve, const Budget&) const {
    const Point points[] = {curve.start(), curve.end()};
    return Curve::polyline(points);
  }
};

/// Fails with a code of one's choice.
struct FailingSmoother {
  static constexpr std::string_view name = "failing";
  PlanError code = PlanError::budget_exhausted;
  template <class S>
  Expected<Curve, Failure> smooth(const S&, const Curve&, const Budget&) const {
    return fail(code, "on purpose");
  }
};

const LatticeSpace& space() {
  static const LatticeSpace s =
      LatticeSpace::build(test::open_scene().workspace, {.resolution = 0.1}).value();
  return s;
}
const Query query{.start = {0.5, 2}, .goal = {3.5, 2}, .seed = 7};

TEST_CASE("an unsafe route never leaves the planner") {
  Planner planner{BlindSearch{}};
  const auto plan = planner.plan(space(), query);
  REQUIRE_FALSE(plan);
  CHECK(plan.error().code == PlanError::not_proved);
  CHECK(planner.plan(space(), {.start = {0.5, 1}, .goal = {0.5, 3}}));
}

TEST_CASE("an unsafe smoother makes the planner fall back to the route") {
  Planner planner{AStar{}, BlindSmoother{}};
  const Plan plan = planner.plan(space(), query).value();
  CHECK(plan.fell_back);
  CHECK(plan.certificate.status == ProofStatus::proved);
  CHECK(test::same_curve(plan.curve, plan.route.curve));
}

TEST_CASE("a smoother that fails leaves the route, unless its options are wrong") {
  Planner late{AStar{}, FailingSmoother{}};
  CHECK(late.plan(space(), query).value().fell_back);
  Planner wrong{AStar{}, FailingSmoother{PlanError::invalid_option}};
  const auto refused = wrong.plan(space(), query);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_option);
  CHECK(refused.error().detail == "on purpose");
}

TEST_CASE("a plan carries metrics, statistics and the seed") {
  Planner planner{AStar{}, Shortcut{}};
  const Plan plan = planner.plan(space(), query).value();
  CHECK(plan.metrics.length == plan.curve.length());
  CHECK(plan.metrics.min_clearance == plan.certificate.lower);
  CHECK_FALSE(plan.metrics.mean_clearance);  // costs more than the search: only where asked for
  CHECK(plan.stats.expanded > 0);
  CHECK(plan.stats.search_us > 0);
  CHECK(plan.stats.certify_us > 0);
  CHECK(plan.stats.seed == 7);
  const auto failure = planner.plan(space(), {.start = {2, 2}, .goal = {0, 0}, .seed = 9});
  CHECK(failure.error().stats.seed == 9);
}

TEST_CASE("start and goal in one place give a plan of one point") {
  Planner planner{AStar{}, DeltaSmoother{}};
  const Plan plan = planner.plan(space(), {.start = {1, 1}, .goal = {1, 1}}).value();
  CHECK(plan.metrics.length == 0);
  CHECK(plan.certificate.status == ProofStatus::proved);
  CHECK(plan.curve.point(0) == Point(1, 1));
}

TEST_CASE("a start exactly at the safety radius is planned and proved") {
  // The obstacle's left edge is x = 1.5; the safety radius 0.25 is exact in binary.
  Planner planner{AStar{}, DeltaSmoother{}};
  const auto plan = planner.plan(space(), {.start = {1.25, 2}, .goal = {2.75, 2}});
  REQUIRE(plan);
  CHECK(plan->certificate.status == ProofStatus::proved);
  CHECK(plan->certificate.lower == 0.25);
}

/// Plans every built-in task; all of them are smoothed, and proved to others than the planner.
template <class Search, class Smooth>
void plan_built_in_maps(const Search& search, const Smooth& smoother) {
  std::size_t tasks = 0;
  Planner planner{search, smoother};
  for (const Scene& scene : {maps::array(), maps::complex(), maps::maze()}) {
    const auto space =
        LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
    const test::ExactChecker checker(scene.workspace);
    for (const Point& goal : scene.goals) {
      INFO(Search::name << " and " << Smooth::name << " on " << scene.name << " to "
                        << goal.transpose());
      ++tasks;
      const auto plan = planner.plan(space, {.start = scene.start, .goal = goal});
      REQUIRE(plan);
      CHECK(plan->certificate.status == ProofStatus::proved);
      CHECK(plan->certificate.lower >= scene.workspace.safety_radius);
      CHECK(plan->certificate.lower >= 0.3);
      CHECK_FALSE(plan->fell_back);
      CHECK(plan->curve.start() == scene.start);
      CHECK(plan->curve.end() == goal);
      CHECK(plan->curve.length() <= plan->route.curve.length());
      CHECK(checker.check(plan->curve) == test::ExactVerdict::free);
      CHECK(test::sampled_clearance(scene.workspace, plan->curve) >=
            scene.workspace.safety_radius - 1e-12);
    }
  }
  CHECK(tasks == 12);
}

template <class Search>
void plan_with_all_smoothers(const Search& search) {
  plan_built_in_maps(search, NoSmoothing{});
  plan_built_in_maps(search, Shortcut{});
  plan_built_in_maps(search, DeltaSmoother{});
  plan_built_in_maps(search, BezierSmoother{});
  plan_built_in_maps(search, BSplineSmoother{});
}

TEST_CASE("A* with any smoother plans all built-in tasks") { plan_with_all_smoothers(AStar{}); }
TEST_CASE("JPS with any smoother plans all built-in tasks") { plan_with_all_smoothers(Jps{}); }
TEST_CASE("Theta* with any smoother plans all built-in tasks") {
  plan_with_all_smoothers(ThetaStar{});
}
TEST_CASE("Dijkstra with any smoother plans all built-in tasks") {
  plan_with_all_smoothers(Dijkstra{});
}

/// Stops half way, in free space.
struct HalfWay {
  static constexpr std::string_view name = "half_way";
  struct Scratch {};
  static Curve half(const Point& from, const Point& to) {
    const Point points[] = {from, 0.5 * (from + to)};
    return Curve::polyline(points);
  }
  template <class S, class O>
  Expected<Route, Failure> search(const S&, const Query& asked, Scratch&, O&) const {
    return Route{.curve = half(asked.start, asked.goal)};
  }
  template <class S>
  Expected<Curve, Failure> smooth(const S&, const Curve& curve, const Budget&) const {
    return half(curve.start(), curve.end());
  }
};

TEST_CASE("a curve that does not lead from start to goal is no plan, however free it is") {
  Planner smoothed{AStar{}, HalfWay{}};
  const auto plan = smoothed.plan(space(), query);
  REQUIRE(plan);
  CHECK(plan->fell_back);
  CHECK(plan->curve.end() == query.goal);
  Planner searched{HalfWay{}, NoSmoothing{}};
  const auto failed = searched.plan(space(), query);
  REQUIRE_FALSE(failed);
  CHECK(failed.error().code == PlanError::not_proved);
  CHECK(failed.error().detail.find("does not lead from the start to the goal") !=
        std::string::npos);
}

}  // namespace
