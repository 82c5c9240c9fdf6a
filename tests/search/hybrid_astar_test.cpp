// SPDX-License-Identifier: MIT
#include "tutavia/search/hybrid_astar.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <stop_token>
#include <string>

#include "support/catch.hpp"
#include "support/check_vehicle_route.hpp"
#include "support/random_grids.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"

namespace {

using namespace tutavia;
using test::search_once;

constexpr double pi = std::numbers::pi;

Vehicle random_vehicle(Random& random, double size) {
  const double radius = size * random.uniform(0.02, 0.12);
  const bool reverse = random.below(4) != 0;
  switch (random.below(3)) {
    case 0:
      return Vehicle::point(radius, reverse);
    case 1:
      return Vehicle::disc(size * random.uniform(0.01, 0.03), radius, reverse);
    default: {
      const double length = size * random.uniform(0.03, 0.1),
                   width = length * random.uniform(0.3, 0.6);
      return Vehicle::car(length, width, 0.6 * length, radius, reverse, width / 8);
    }
  }
}

TEST_CASE("routes in random worlds keep clearance, curvature and headings", "[soak]") {
  const std::uint64_t seed = 31;
  test::WorldGenerator worlds(seed);
  Random random(seed);
  std::size_t found = 0, refused = 0, cusps = 0;
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    Workspace world = worlds.workspace();
    world.safety_radius = random.below(2) == 0 ? 0 : 0.01 * world.bounds.width();
    const auto space = InflatedSpace::build(world).value();
    const HybridAStar search{.vehicle = random_vehicle(random, world.bounds.width()),
                             .reverse_weight = random.uniform(1, 2),
                             .headings = 16,
                             .searches = 2};
    Query query{.start = worlds.point(world), .goal = worlds.point(world)};
    if (random.below(4) != 0) query.start_heading = random.uniform(-7, 7);
    if (random.below(4) != 0) query.goal_heading = random.uniform(-7, 7);
    query.budget.max_expansions = 20'000;
    const auto route = search_once(search, space, query);
    if (!route) {
      ++refused;
      continue;
    }
    ++found;
    test::check_vehicle_route(world, search.vehicle, query, *route);
    cusps += VehiclePath{route->curve, route->gears}.cusps().size();
  }
  CHECK(found > test::scaled(200) / 5);
  CHECK(refused > test::scaled(200) / 20);
  CHECK(cusps > test::scaled(200) / 40);
}

TEST_CASE("lattices and cells are searched as the workspace is") {
  Workspace world{.bounds = {{0, 0}, {20, 20}}, .safety_radius = 0.3};
  world.obstacles.emplace_back(Polygon{{{9, 0}, {11, 0}, {11, 14}, {9, 14}}});
  const HybridAStar search{.vehicle = Vehicle::car(2, 1, 1.2, 2)};
  const Query query{.start = {3, 3}, .goal = {17, 3}, .start_heading = 0, .goal_heading = pi};
  const auto lattice = LatticeSpace::build(world, {.resolution = 0.25}).value();
  const auto route = search_once(search, lattice, query);
  REQUIRE(route);
  test::check_vehicle_route(world, search.vehicle, query, *route);

  OccupancyGrid grid = test::free_grid(20, 20);
  for (int y = 0; y < 14; ++y) {
    for (int x = 9; x < 11; ++x) grid.set({x, y}, false);
  }
  const auto cells = CellSpace::build(grid, {.safety_radius = 0.3}).value();
  const auto on_cells = search_once(search, cells, query);
  REQUIRE(on_cells);
  test::check_vehicle_route(world, search.vehicle, query, *on_cells);
}

/// An axis-parallel rectangle.
Polygon rectangle(double x0, double y0, double x1, double y1) {
  return Polygon{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

TEST_CASE("a car parks into a parallel gap of 6 m and into a bay of 2.6 m") {
  const HybridAStar search{.vehicle = Vehicle::car(4.5, 1.8, 2.7, 5)};
  Workspace street{.bounds = {{-20, -8}, {20, 8}}};
  street.obstacles = {rectangle(-20, -1.9, -3, -0.1), rectangle(3, -1.9, 20, -0.1),
                      rectangle(-20, -2.4, 20, -2.2), rectangle(-20, 6, 20, 6.5)};
  Workspace bays{.bounds = {{-20, -8}, {20, 8}}};
  bays.obstacles = {rectangle(-20, -6, -1.3, -0.8), rectangle(1.3, -6, 20, -0.8),
                    rectangle(-20, -6.4, 20, -6.1), rectangle(-20, 6, 20, 6.5)};
  const auto parks = [&](const Workspace& world, const Query& query) {
    const auto route = search_once(search, InflatedSpace::build(world).value(), query);
    REQUIRE(route);
    test::check_vehicle_route(world, search.vehicle, query, *route);
  };
  parks(street, {.start = {-8, 1.5}, .goal = {-1.35, -1}, .start_heading = 0, .goal_heading = 0});
  parks(bays, {.start = {-8, 1.5}, .goal = {0, -2.2}, .start_heading = 0, .goal_heading = -pi / 2});
  parks(bays, {.start = {-8, 1.5}, .goal = {0, -4.6}, .start_heading = 0, .goal_heading = pi / 2});
}

TEST_CASE("a vehicle that turns on the spot takes the path of a robot without headings") {
  Workspace world{.bounds = {{0, 0}, {20, 20}}, .safety_radius = 0.2};
  world.obstacles.emplace_back(rectangle(9, 0, 11, 14));
  const Query query{.start = {3, 3}, .goal = {17, 3}, .start_heading = 1, .goal_heading = -2};
  const Query plain{.start = query.start, .goal = query.goal};
  const auto space = InflatedSpace::build(world).value();
  for (const double radius : {0.0, 0.5}) {
    const HybridAStar search{.vehicle = Vehicle::disc(radius)};
    const auto route = search_once(search, space, query);
    REQUIRE(route);
    const auto wide = space.with_safety_radius(0.2 + radius).value();
    CHECK(route->cost == search_once(AutoSearch{}, wide, plain)->cost);
    test::check_vehicle_route(world, search.vehicle, query, *route);
    const VehiclePath path{route->curve, route->gears};
    CHECK(certify(space, search.vehicle, path).status == ProofStatus::proved);
  }
  Query still{.start = {3, 3}, .goal = {3, 3}, .start_heading = 1, .goal_heading = -2};
  for (const double turning : {0.0, 1.0}) {
    const HybridAStar search{.vehicle = Vehicle::point(turning, true)};
    test::check_vehicle_route(world, search.vehicle, still, *search_once(search, space, still));
  }
  // With the start's heading free the search may begin at the goal.
  const Query leaning{.start = {8.5, 10}, .goal = {8.5, 10}, .goal_heading = 0};
  const HybridAStar both{.vehicle = Vehicle::point(1, true)};
  test::check_vehicle_route(world, both.vehicle, leaning, *search_once(both, space, leaning));
  still.goal_heading = 1;
  for (const double turning : {0.0, 1.0}) {
    const HybridAStar search{.vehicle = Vehicle::point(turning, true)};
    const auto route = search_once(search, space, still);
    test::check_vehicle_route(world, search.vehicle, still, *route);
    CHECK(route->curve.length() == 0);
  }
}

TEST_CASE("of two ways of the same cost one is taken, not parts of both", "[soak]") {
  // Worlds that are their own mirror images have such ways.
  const std::uint64_t seed = 147;
  Random random(seed);
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(150); ++round) {
    INFO("seed " << seed << ", round " << round);
    Workspace world{.bounds = {{-10, -6}, {10, 6}}, .safety_radius = 0.1};
    for (std::uint64_t i = 0; i < 2 + random.below(8); ++i) {
      const double x = random.uniform(-8, 8), y = random.uniform(0, 5),
                   r = random.uniform(0.2, 1.2);
      world.obstacles.emplace_back(Disc{{x, y}, r});
      world.obstacles.emplace_back(Disc{{x, -y}, r});
    }
    const auto space = InflatedSpace::build(world).value();
    const HybridAStar search{.vehicle = Vehicle::point(random.uniform(0.5, 3), true),
                             .heuristic_weight = random.uniform(1, 2),
                             .searches = 1};
    Query query{.start = {-9, 0}, .goal = {9, 0}, .start_heading = 0, .goal_heading = 0};
    if (random.below(2) == 0) query.goal_heading = pi;
    if (random.below(4) == 0) query.start_heading = std::nullopt;
    query.budget.max_expansions = 5000;
    const auto route = search_once(search, space, query);
    if (!route) continue;
    ++found;
    test::check_vehicle_route(world, search.vehicle, query, *route);
    CHECK(certify(space, search.vehicle, {route->curve, route->gears}).status ==
          ProofStatus::proved);
  }
  CHECK(found > test::scaled(150) / 2);
}

TEST_CASE("a robot as wide as its corridor turns on the spot and drives through") {
  OccupancyGrid grid = OccupancyGrid::blocked(12, 3).value();
  for (int x = 0; x < 12; ++x) grid.set({x, 1}, true);
  const Query query{.start = {1.5, 1.5}, .goal = {9.5, 1.5}, .start_heading = 2, .goal_heading = 1};
  for (const double safety : {0.5, 0.25, 0.0}) {
    INFO("safety radius " << safety);
    const auto space = CellSpace::build(grid, {.safety_radius = safety}).value();
    const HybridAStar search{.vehicle = Vehicle::disc(0.5 - safety)};
    const auto route = search_once(search, space, query);
    REQUIRE(route);
    CHECK(certify(space, search.vehicle, {route->curve, route->gears}).status ==
          ProofStatus::proved);
  }
}

TEST_CASE("failures of vehicles say what is wrong") {
  Workspace world{.bounds = {{0, 0}, {20, 20}}, .safety_radius = 0.2};
  world.obstacles.emplace_back(rectangle(9, 0, 11, 20));
  const auto space = InflatedSpace::build(world).value();
  const auto failure = [&](const HybridAStar& search, const Query& query) {
    const auto route = search_once(search, space, query);
    REQUIRE_FALSE(route);
    return route.error();
  };
  const HybridAStar car{.vehicle = Vehicle::car(2, 1, 1.2, 2)};
  const auto code = [&](const Query& query) { return failure(car, query).code; };
  const double nan = std::nan("");
  CHECK(code({.start = {3, 3}, .goal = {17, 3}}) == PlanError::unreachable);
  CHECK(code({.start = {7.5, 3}, .goal = {3, 3}, .start_heading = 0}) == PlanError::start_blocked);
  CHECK(code({.start = {3, 3}, .goal = {0.5, 3}, .goal_heading = pi}) != PlanError::start_blocked);
  CHECK(code({.start = {3, 3}, .goal = {7.5, 3}, .goal_heading = 0}) == PlanError::goal_blocked);
  CHECK(code({.start = {-3, 3}, .goal = {7, 3}}) == PlanError::start_out_of_bounds);
  CHECK(code({.start = {3, 3}, .goal = {7, nan}}) == PlanError::invalid_input);
  CHECK(code({.start = {3, 3}, .goal = {7, 3}, .start_heading = nan}) == PlanError::invalid_input);
  const Query query{.start = {3, 3}, .goal = {5, 5}};
  HybridAStar bad = car;
  for (double HybridAStar::*weight : {&HybridAStar::reverse_weight, &HybridAStar::cusp_cost}) {
    bad = car;
    bad.*weight = nan;
    CHECK(failure(bad, query).code == PlanError::invalid_option);
  }
  bad = car;
  bad.vehicle = Vehicle::point(1e-300, true);
  CHECK(failure(bad, query).code == PlanError::invalid_option);
  bad = car;
  bad.headings = 2;
  CHECK(failure(bad, query).code == PlanError::invalid_option);
  Query limited{.start = {3, 3}, .goal = {3.5, 3.2}, .start_heading = 0, .goal_heading = 0};
  limited.budget.max_expansions = 0;
  CHECK(failure(car, limited).code == PlanError::budget_exhausted);
  std::stop_source stop;
  stop.request_stop();
  limited.budget = {.stop = stop.get_token()};
  CHECK(failure(car, limited).code == PlanError::cancelled);
}

TEST_CASE("searches without headings refuse a query with headings by its name") {
  const auto space = CellSpace::build(test::free_grid(9, 9)).value();
  Query query{.start = {1.5, 1.5}, .goal = {5.5, 5.5}, .goal_heading = 1};
  const auto route = search_once(AutoSearch{}, space, query);
  REQUIRE_FALSE(route);
  CHECK(route.error().code == PlanError::invalid_option);
  CHECK(route.error().detail.find("goal_heading") != std::string::npos);
  CHECK(route.error().detail.find("hybrid_astar") != std::string::npos);
}

}  // namespace
