// SPDX-License-Identifier: MIT
#include "tutavia/smooth/route/risk_runs.hpp"

#include <vector>

#include "support/registry.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/safe_rrt_star.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/shortcut.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

static_assert(detail::AdjustableSpace<InflatedSpace>);
static_assert(detail::AdjustableSpace<LatticeSpace>);
static_assert(detail::AdjustableSpace<CellSpace>);

TEST_CASE("no smoother leads a route of SafeRrtStar into the zone that the route avoids") {
  for (const Scene& scene : {maps::rrt_scene_1(), maps::rrt_scene_2()}) {
    const auto space =
        LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
    const Query query{.start = scene.start, .goal = scene.goals[0], .seed = 5};
    const auto route = test::search_once(SafeRrtStar{}, space, query).value();
    REQUIRE(route.risk_width == 2);
    const auto wide = space.with_safety_radius(2).value();
    REQUIRE(certify(wide, route.curve).status == ProofStatus::proved);
    for (const auto& smoother : all_smoothers<LatticeSpace>()) {
      INFO(scene.name << ", " << smoother.name);
      const Curve curve = detail::smooth_outside_risk(space, smoother, route, {}).value().curve;
      CHECK(certify(wide, curve).status == ProofStatus::proved);
      CHECK(curve.start() == query.start);
      CHECK(curve.end() == query.goal);
    }
  }
}

/// A wall with a gap of 2 m, in which every point is in a zone 1.5 m wide.
LatticeSpace gap() {
  return LatticeSpace::build({.bounds = {{0, 0}, {20, 20}},
                              .safety_radius = 0.5,
                              .obstacles = {Polygon{{{9, -1}, {11, -1}, {11, 9}, {9, 9}}},
                                            Polygon{{{9, 11}, {11, 11}, {11, 21}, {9, 21}}}}},
                             {.resolution = 0.25})
      .value();
}

TEST_CASE(
    "a route through the zone is smoothed in runs: outside it stays outside, inside no worse") {
  const auto space = gap();
  const RiskZone zone{.width = 1.5, .weight = 2};
  const Point points[] = {{2, 2}, {5, 8}, {6.8, 10}, {13.2, 10}, {15, 14}, {18, 18}};
  const Curve input = Curve::polyline(points);
  const Route route{.curve = input, .risk_width = 1.5, .risk_weight = 2};
  const Curve curve = detail::smooth_outside_risk(space, TautString{}, route, {}).value().curve;
  CHECK(certify(space, curve).status == ProofStatus::proved);
  CHECK(curve.length() < input.length());
  const auto inside = [&](const Curve& c) { return zone.length_inside(space, c); };
  CHECK(inside(curve).value <= inside(input).value + inside(curve).error + inside(input).error);
  const Curve free = TautString{}.smooth(space, input, {}).value();
  CHECK(zone.integral(space, free).value > zone.integral(space, curve).value);
}

TEST_CASE("without a zone the smoother sees the space as it is, and its errors are passed on") {
  const auto space = gap();
  const Point points[] = {{2, 2}, {5, 8}, {6.8, 10}, {13.2, 10}, {15, 14}, {18, 18}};
  Route route{.curve = Curve::polyline(points)};
  const Curve plain = TautString{}.smooth(space, route.curve, {}).value();
  CHECK(test::same_curve(detail::smooth_outside_risk(space, TautString{}, route, {}).value().curve,
                         plain));
  route.risk_width = 1;
  route.risk_weight = 1;
  std::stop_source stop;
  stop.request_stop();
  const auto cancelled =
      detail::smooth_outside_risk(space, TautString{}, route, {.stop = stop.get_token()});
  REQUIRE_FALSE(cancelled);
  CHECK(cancelled.error().code == PlanError::cancelled);
}

/// A space of a user's own, which cannot be had at another radius.
struct FixedSpace {
  const InflatedSpace& inner;

  bool is_free(const Point& p) const { return inner.is_free(p); }
  bool segment_free(const Point& p, const Point& q) const { return inner.segment_free(p, q); }
  const Box& bounds() const { return inner.bounds(); }
  double clearance(const Point& p) const { return inner.clearance(p); }
  template <class P>
  NearestObstacle nearest(const P& piece, double cap) const {
    return inner.nearest(piece, cap);
  }
  bool is_inside(const Point& p) const { return inner.is_inside(p); }
  double safety_radius() const { return inner.safety_radius(); }
  double distance_error_bound() const { return inner.distance_error_bound(); }
  double largest_coordinate() const { return inner.largest_coordinate(); }
};
static_assert(ClearanceSpace<FixedSpace> && !detail::AdjustableSpace<FixedSpace>);

TEST_CASE("in a space of one radius a smoothed curve is used only if it is out of the zone") {
  const Scene scene = maps::rrt_scene_1();
  const auto inner = InflatedSpace::build(scene.workspace).value();
  const auto wide = inner.with_safety_radius(2).value();
  const FixedSpace space{inner};
  std::size_t kept = 0, smoothed = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Query query{.start = scene.start, .goal = scene.goals[0], .seed = seed};
    const auto route = test::search_once(SafeRrtStar{.prune = false}, inner, query).value();
    const auto result = detail::smooth_outside_risk(space, Shortcut{}, route, {}).value();
    CHECK(certify(wide, result.curve).status == ProofStatus::proved);
    ++(result.is_whole ? smoothed : kept);
  }
  CHECK(kept + smoothed == 10);
  CHECK(kept > 0);
}

TEST_CASE("a plan says that it fell back if parts of its route stay as they are") {
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  std::size_t whole = 0, plans = 0;
  for (const Point& goal : scene.goals) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Planner planner{SafeRrtStar{}, DeltaSmoother{}};
      const auto plan = planner.plan(space, {.start = scene.start, .goal = goal, .seed = seed});
      REQUIRE(plan);
      ++plans;
      whole += !plan->fell_back;
      if (!plan->fell_back) CHECK(plan->metrics.max_joint_deflection < 1e-6);
    }
  }
  CHECK(plans == 20);
  // The maze's gaps are narrower than its zones: most routes must lead through them.
  CHECK(whole > 0);
  CHECK(whole < plans);
}

TEST_CASE("a space at another safety radius is the one built with it") {
  const Scene scene = maps::complex();
  const auto lattice = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  const auto wide = lattice.with_safety_radius(0.45).value();
  CHECK(wide.safety_radius() == 0.45);
  CHECK(wide.frame().resolution == 0.2);
  CHECK(wide.movement() == lattice.movement());
  CHECK(lattice.inflated().with_safety_radius(0.45).value().safety_radius() == 0.45);
  CHECK_FALSE(lattice.with_safety_radius(-1));
  const auto cells =
      CellSpace::build(lattice.grid(), {.resolution = 0.5, .origin = {3, 4}}).value();
  const auto inflated = cells.with_safety_radius(0.7).value();
  CHECK(inflated.safety_radius() == 0.7);
  CHECK(inflated.corner({0, 0}) == cells.corner({0, 0}));
  CHECK(inflated.frame().resolution == cells.frame().resolution);
  const auto strict =
      LatticeSpace::build(scene.workspace, {.resolution = 0.2, .edges = EdgeRule::paper_strict})
          .value();
  CHECK_FALSE(strict.with_safety_radius(0.4).value().edge_steps().empty());
  CHECK(strict.with_safety_radius(0.4).value().safety_radius() == Approx(0.4).epsilon(1e-15));
  CHECK_FALSE(strict.with_safety_radius(-1));
}

}  // namespace
