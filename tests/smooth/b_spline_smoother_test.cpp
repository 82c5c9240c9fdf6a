// SPDX-License-Identifier: MIT
#include "tutavia/smooth/b_spline_smoother.hpp"

#include <cmath>

#include "support/searcher_contract.hpp"
#include "support/smoother_contract.hpp"
#include "tutavia/search/astar.hpp"

namespace {

using namespace tutavia;

TEST_CASE("BSplineSmoother keeps the smoother contract") {
  test::smoother_contract(BSplineSmoother{});
  test::smoother_contract(BSplineSmoother{.reach = 100});
}

TEST_CASE("a B-spline runs along the pruned route, with a reach in spacings of the grid") {
  const Scene scene = test::open_scene();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.1}).value();
  const auto route =
      test::search_once(AStar{}, space, {.start = scene.start, .goal = scene.goals[0]});
  REQUIRE(route);
  const Curve pruned = RedundantNodeRemoval{}.smooth(space, route->curve, {}).value();
  const Curve curve = BSplineSmoother{.reach = 2}.smooth(space, route->curve, {}).value();
  const Curve expected = detail::CornerSpline(waypoints(pruned), 0.2).prove(space, {}).value();
  CHECK(test::same_curve(curve, expected));
  CHECK(curve.length() < route->curve.length());
}

TEST_CASE("a reach without meaning and blocked routes are refused") {
  const auto space =
      InflatedSpace::build(
          {.bounds = {{-9, -9}, {9, 9}}, .safety_radius = 0.5, .obstacles = {Disc{{0, 0}, 1}}})
          .value();
  const Point through[] = {{-4, 0}, {4, 0}};
  const Curve blocked = Curve::polyline(through);
  for (const double reach : {0.0, -1.0, std::nan("")}) {
    const auto refused = BSplineSmoother{.reach = reach}.smooth(space, blocked, {});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == PlanError::invalid_option);
    CHECK(refused.error().detail.find("reach") == 0);
  }
  const auto refused = BSplineSmoother{}.smooth(space, blocked, {});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_input);
  CHECK(refused.error().detail.find("segment 0 ") == 0);
}

}  // namespace
