// SPDX-License-Identifier: MIT
/// \file
/// What users of other planners reported of paths for vehicles: issues of
/// ros-navigation/navigation2 by number.

#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/check_vehicle_route.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/hybrid_astar.hpp"
#include "tutavia/smooth/vehicle_shortcut.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using test::search_once;

/// Two walls with gaps at opposite ends.
Workspace two_walls() {
  Workspace world{.bounds = {{0, 0}, {30, 20}}, .safety_radius = 0.1};
  world.obstacles = {Polygon{{{9, 0}, {10, 0}, {10, 13}, {9, 13}}},
                     Polygon{{{19, 7}, {20, 7}, {20, 20}, {19, 20}}}};
  return world;
}

const Query across{.start = {3, 3},
                   .goal = {27, 17},
                   .start_heading = -std::numbers::pi / 2,
                   .goal_heading = -std::numbers::pi / 2};

TEST_CASE("4981: no path is tighter than the turning radius, before and after smoothing") {
  const auto space = InflatedSpace::build(two_walls()).value();
  for (const double radius : {0.4, 1.5, 2.5}) {
    for (const bool reverse : {false, true}) {
      INFO("radius " << radius << ", reverse " << reverse);
      Planner planner{HybridAStar{.vehicle = Vehicle::disc(0.4, radius, reverse)},
                      VehicleShortcut{}};
      const auto plan = planner.plan(space, across);
      REQUIRE(plan);
      CHECK(plan->metrics.max_curvature <= 1 / radius);
      CHECK(test::largest_curvature({plan->route.curve, plan->route.gears}) <=
            1 / test::Real(radius));
    }
  }
}

TEST_CASE("4845: a turning radius of 0 plans") {
  const auto space = InflatedSpace::build(two_walls()).value();
  const HybridAStar search{.vehicle = Vehicle::disc(0.4)};
  const auto route = search_once(search, space, across);
  REQUIRE(route);
  test::check_vehicle_route(two_walls(), search.vehicle, across, *route);
}

TEST_CASE("5584: the goal is reached in its heading, and left in that of the start") {
  const auto space = InflatedSpace::build(two_walls()).value();
  const HybridAStar search{.vehicle = Vehicle::car(2, 1, 1.2, 2)};
  for (const double heading : {0.0, 1e-3, 1.0, 3.14159, -2.0, 9.0}) {
    INFO("heading " << heading);
    Query query = across;
    query.start_heading = -heading;
    query.goal_heading = heading;
    const auto route = search_once(search, space, query);
    REQUIRE(route);
    test::check_vehicle_route(two_walls(), search.vehicle, query, *route);
  }
}

TEST_CASE("2301 and 2690: a smoothed path can be driven as the route can") {
  const auto space = InflatedSpace::build(two_walls()).value();
  Planner planner{HybridAStar{.vehicle = Vehicle::car(2, 1, 1.2, 2)}, VehicleShortcut{}};
  const auto plan = planner.plan(space, across);
  REQUIRE(plan);
  CHECK_FALSE(plan->fell_back);
  const VehicleCertificate proof = certify(space, *plan->route.vehicle, {plan->curve, plan->gears});
  CHECK(proof.status == ProofStatus::proved);
  CHECK(proof.is_drivable);
  CHECK(plan->metrics.length <= plan->route.curve.length());
}

TEST_CASE("5330: a post that reaches between the corners of the footprint is hit") {
  // The corners of the car pass on both sides of the post.
  Workspace world{.bounds = {{-10, -10}, {20, 10}}};
  world.obstacles.emplace_back(Disc{{3, 0}, 0.05});
  const auto space = InflatedSpace::build(world).value();
  const Vehicle car = Vehicle::car(4.5, 1.8, 2.7, 5);
  VehiclePath straight;
  straight.push_back(Segment{{-5, 0}, {8, 0}}, Gear::forward);
  CHECK(certify(space, car, straight).status == ProofStatus::violated);
  const HybridAStar search{.vehicle = car};
  const Query query{.start = {-5, 0}, .goal = {8, 0}, .start_heading = 0, .goal_heading = 0};
  const auto route = search_once(search, space, query);
  REQUIRE(route);
  test::check_vehicle_route(world, car, query, *route);
}

}  // namespace
