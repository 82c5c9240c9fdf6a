// SPDX-License-Identifier: MIT
#include "tutavia/smooth/route/risk_runs.hpp"

#include <vector>

#include "support/registry.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/safe_rrt_star.hpp"
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
      const Curve curve = detail::smooth_outside_risk(space, smoother, route, {}).value();
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
  const Curve curve = detail::smooth_outside_risk(space, TautString{}, route, {}).value();
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
  CHECK(
      test::same_curve(detail::smooth_outside_risk(space, TautString{}, route, {}).value(), plain));
  route.risk_width = 1;
  route.risk_weight = 1;
  std::stop_source stop;
  stop.request_stop();
  const auto cancelled =
      detail::smooth_outside_risk(space, TautString{}, route, {.stop = stop.get_token()});
  REQUIRE_FALSE(cancelled);
  CHECK(cancelled.error().code == PlanError::cancelled);
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
}

}  // namespace
