// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/vehicle_checker.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"

/// \file
/// check_vehicle_route: what every route of a vehicle promises.

namespace tutavia::test {

/// Checks all that a route of a vehicle promises, by code that shares nothing with the search.
inline void check_vehicle_route(const Workspace& world, const Vehicle& vehicle, const Query& query,
                                const Route& route) {
  REQUIRE(route.vehicle);
  const VehiclePath path{route.curve, route.gears};
  REQUIRE(path.gears.size() == path.curve.pieces().size());
  CHECK(path.curve.start() == query.start);
  CHECK(path.curve.end() == query.goal);
  const Pose start{query.start, query.start_heading.value_or(path.start().heading)};
  const Pose goal{query.goal, query.goal_heading.value_or(path.end().heading)};
  const double largest = world.bounds.largest_coordinate();
  CHECK(largest_jump(path, start, goal) <= 1e-12L * (1 + largest));
  CHECK(std::abs(std::remainder(path.start().heading - start.heading, 2 * std::numbers::pi)) <=
        1e-12);
  CHECK(std::abs(std::remainder(path.end().heading - goal.heading, 2 * std::numbers::pi)) <= 1e-12);
  const double radius = vehicle.min_turning_radius;
  if (radius > 0) CHECK(largest_curvature(path) <= 1 / Real(radius));
  for (const Gear gear : path.gears) CHECK((gear == Gear::forward || vehicle.reverse));
  CHECK(clearance_deficit(world, vehicle, path) <= 1e-12L * (1 + largest));
}

}  // namespace tutavia::test
