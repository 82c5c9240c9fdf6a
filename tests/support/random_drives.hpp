// SPDX-License-Identifier: MIT
#pragma once

#include "support/random_worlds.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// Worlds for vehicles: random ones with poses, and a yard.

namespace tutavia::test {

/// A vehicle that is to drive from one pose to another in a world.
struct DriveTask {
  Workspace world;
  Vehicle vehicle;
  Query query;  ///< at most 10,000 expansions
};

/// A point or a car, in a third of the cases without reverse. The turning radius is a twentieth of
/// the world, the safety radius a hundredth.
inline DriveTask random_drive(WorldGenerator& worlds, Random& random) {
  DriveTask task{worlds.workspace(), {}, {}};
  const double size = task.world.bounds.width();
  task.world.safety_radius = 0.01 * size;
  const bool reverse = random.below(3) != 0;
  task.vehicle = random.below(2) == 0 ? Vehicle::point(0.05 * size, reverse)
                                      : Vehicle::car(0.06 * size, 0.03 * size, 0.04 * size,
                                                     0.05 * size, reverse, 0.004 * size);
  task.query = {.start = worlds.point(task.world), .goal = worlds.point(task.world)};
  task.query.start_heading = random.uniform(-3, 3);
  task.query.goal_heading = random.uniform(-3, 3);
  task.query.budget.max_expansions = 10'000;
  return task;
}

/// A square of 30 m with a disc of 4 m in the middle.
inline InflatedSpace yard() {
  return InflatedSpace::build(
             {.bounds = {{0, 0}, {30, 30}}, .safety_radius = 0.2, .obstacles = {Disc{{15, 15}, 4}}})
      .value();
}

}  // namespace tutavia::test
