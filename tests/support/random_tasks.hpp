// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "support/random_worlds.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// Routes through random worlds, to be smoothed.

namespace tutavia::test {

/// A world and a route of A* through it, with a positive safety radius.
struct Task {
  Workspace world;
  std::vector<Point> route;
};

inline std::optional<Task> random_task(WorldGenerator& worlds) {
  Task task{worlds.workspace(), {}};
  if (!(task.world.safety_radius > 0)) return std::nullopt;
  const auto space =
      LatticeSpace::build(task.world, {.resolution = task.world.bounds.width() / 40}).value();
  const auto route = search_once(
      AStar{}, space, {.start = worlds.point(task.world), .goal = worlds.point(task.world)});
  if (!route) return std::nullopt;
  task.route = waypoints(route->curve);
  return task;
}

/// A box around a route and all obstacles whose zones can reach it.
inline Box surroundings(const std::vector<Point>& route, double safety_radius) {
  Box box;
  for (const Point& p : route) box.include(p);
  return box.inflated(safety_radius * 1.01 + 1e-6);
}

/// The largest turn where two pieces of a curve meet [rad].
inline double largest_corner(const Curve& curve) { return measure(curve).max_joint_deflection; }

}  // namespace tutavia::test
