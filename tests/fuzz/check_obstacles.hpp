// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <utility>
#include <vector>

#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/workspace_report.hpp"

namespace tutavia::test {

/// Obstacles from a file make a space, or are refused by validation.
inline void check_obstacles(std::vector<Obstacle> obstacles) {
  Workspace workspace{.bounds = {{-100, -100}, {100, 100}}, .safety_radius = 0.5};
  workspace.obstacles = std::move(obstacles);
  if (!validate(workspace)) return;
  (void)inspect(workspace);
  const auto space = InflatedSpace::build(workspace);
  if (!space) std::abort();
  const double clearance = space->clearance({1, 2});
  if (space->is_free({1, 2}) && clearance < 0.5 - space->distance_error_bound()) std::abort();
}

}  // namespace tutavia::test
