// SPDX-License-Identifier: MIT
#include "tutavia/search/heading_join.hpp"

#include <cstddef>
#include <cstdint>
#include <numbers>

#include "support/catch.hpp"
#include "support/check_vehicle_route.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/smooth/vehicle_shortcut.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using test::search_once;

static_assert(PlansVehicles<HeadingJoin<>>);
static_assert(!PlansVehicles<AutoSearch>);

TEST_CASE("a route without headings becomes a drive along it") {
  Workspace world{.bounds = {{0, 0}, {40, 40}}, .safety_radius = 0.5};
  world.obstacles.emplace_back(Polygon{{{18, 0}, {22, 0}, {22, 28}, {18, 28}}});
  const auto space = InflatedSpace::build(world).value();
  const HeadingJoin<> search{.hybrid = {.vehicle = Vehicle::point(2, true)}};
  const double pi = std::numbers::pi;
  const Query query{.start = {5, 5}, .goal = {35, 5}, .start_heading = pi, .goal_heading = pi / 2};
  const auto route = search_once(search, space, query);
  REQUIRE(route);
  CHECK(route->found_by == "auto");
  test::check_vehicle_route(world, search.hybrid.vehicle, query, *route);
  const double shortest =
      search_once(AutoSearch{}, space, {.start = {5, 5}, .goal = {35, 5}})->cost;
  CHECK(route->curve.length() < 1.3 * shortest + 4 * pi);
  Planner planner{search, VehicleShortcut{}};
  const auto plan = planner.plan(space, query);
  REQUIRE(plan);
  CHECK(plan->metrics.length <= route->curve.length());
}

TEST_CASE("where the route does not help, HybridAStar answers") {
  // The route leads through a gap that the long vehicle cannot pass.
  Workspace world{.bounds = {{0, 0}, {40, 40}}};
  world.obstacles.emplace_back(Polygon{{{18, 0}, {19, 0}, {19, 12}, {18, 12}}});
  world.obstacles.emplace_back(Polygon{{{18, 12.5}, {19, 12.5}, {19, 30}, {18, 30}}});
  const auto space = InflatedSpace::build(world).value();
  const HeadingJoin<TangentGraph> search{.hybrid = {.vehicle = Vehicle::car(3, 1.5, 2, 3)}};
  const Query query{.start = {8, 12}, .goal = {30, 12}, .start_heading = 0, .goal_heading = 0};
  const auto route = search_once(search, space, query);
  REQUIRE(route);
  CHECK(route->found_by == "hybrid_astar");
  test::check_vehicle_route(world, search.hybrid.vehicle, query, *route);
  HeadingJoin<TangentGraph> bad = search;
  bad.places = 1;
  CHECK(search_once(bad, space, query).error().code == PlanError::invalid_option);
  Query outside = query;
  outside.goal = {-3, 3};
  CHECK(search_once(search, space, outside).error().code == PlanError::goal_out_of_bounds);
}

TEST_CASE("joined routes in random worlds keep what vehicles need", "[soak]") {
  const std::uint64_t seed = 19;
  test::WorldGenerator worlds(seed);
  Random random(seed);
  std::size_t joined = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    Workspace world = worlds.workspace();
    const double size = world.bounds.width();
    world.safety_radius = 0.02 * size;
    const auto space = InflatedSpace::build(world).value();
    const Vehicle vehicle =
        random.below(2) == 0
            ? Vehicle::point(0.05 * size, random.below(2) == 0)
            : Vehicle::car(0.05 * size, 0.02 * size, 0.03 * size, 0.05 * size, true, 0.003 * size);
    const HeadingJoin<> search{.hybrid = {.vehicle = vehicle, .headings = 16, .searches = 1}};
    Query query{.start = worlds.point(world), .goal = worlds.point(world)};
    query.start_heading = random.uniform(-3, 3);
    if (random.below(2) == 0) query.goal_heading = random.uniform(-3, 3);
    query.budget.max_expansions = 5000;
    const auto route = search_once(search, space, query);
    if (!route) continue;
    if (route->found_by != HybridAStar::name) ++joined;
    test::check_vehicle_route(world, vehicle, query, *route);
  }
  CHECK(joined > test::scaled(60) / 10);
}

}  // namespace
