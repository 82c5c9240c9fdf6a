// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "support/random_worlds.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/geometry/curve.hpp"
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
  task.route = joints(route->curve);
  return task;
}

/// The largest turn where two pieces of a curve meet [rad].
inline double largest_corner(const Curve& curve) {
  double largest = 0;
  for (std::size_t i = 0; i + 1 < curve.pieces().size(); ++i) {
    const auto direction = [&](std::size_t piece, bool end) {
      return std::visit(
          [&](const auto& p) -> Point { return end ? p.end_direction() : p.start_direction(); },
          curve.pieces()[piece]);
    };
    const Point in = direction(i, true), out = direction(i + 1, false);
    largest = std::fmax(largest, std::abs(std::atan2(cross(in, out), in.dot(out))));
  }
  return largest;
}

}  // namespace tutavia::test
