// SPDX-License-Identifier: MIT
#include "tutavia/smooth/pipeline.hpp"

#include "support/searcher_contract.hpp"
#include "support/smoother_contract.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

TEST_CASE("a pipeline keeps the smoother contract") {
  test::smoother_contract(Pipeline{Shortcut{}, BezierSmoother{}});
  test::smoother_contract(Pipeline<DeltaSmoother>{});
}

TEST_CASE("a pipeline does what its stages do in turn, under a name made of theirs") {
  const Pipeline pipeline{Shortcut{}, BezierSmoother{.trim = 2}};
  STATIC_REQUIRE(decltype(pipeline)::name == "shortcut+bezier");
  STATIC_REQUIRE(Pipeline<DeltaSmoother>::name == "delta");

  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  const auto route =
      test::search_once(AStar{}, space, {.start = scene.start, .goal = scene.goals[0]});
  const Curve cut = Shortcut{}.smooth(space, route->curve, {}).value();
  const Curve both = BezierSmoother{.trim = 2}.smooth(space, cut, {}).value();
  CHECK(test::same_curve(pipeline.smooth(space, route->curve, {}).value(), both));

  Planner planner{AStar{}, pipeline};
  const auto plan = planner.plan(space, {.start = scene.start, .goal = scene.goals[0]});
  REQUIRE(plan);
  CHECK_FALSE(plan->fell_back);
  CHECK(test::same_curve(plan->curve, both));
}

TEST_CASE("a pipeline fails as its first stage that fails") {
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  const Point points[] = {scene.start, scene.start + Point(0.4, 0), scene.start + Point(0.4, 0.4)};
  const Curve route = Curve::polyline(points);
  const auto polylines_only = Pipeline{BezierSmoother{}, TautString{}}.smooth(space, route, {});
  REQUIRE_FALSE(polylines_only);
  CHECK(polylines_only.error().code == PlanError::invalid_input);
  const auto bad = Pipeline{BezierSmoother{.trim = -1}, TautString{}}.smooth(space, route, {});
  REQUIRE_FALSE(bad);
  CHECK(bad.error().code == PlanError::invalid_option);
}

}  // namespace
