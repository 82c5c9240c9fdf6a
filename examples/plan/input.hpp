// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "options.hpp"
#include "planning_space.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// Input: built-in maps, workspace files and grid maps, with overrides from the command line.

namespace plan_program {

/// A space with a start and goals.
struct Task {
  Scene scene;  ///< of a grid map without its obstacles
  PlanningSpace space;
  bool y_down = false;  ///< in pictures
  /// The cells of the map before --buffer blocked some.
  std::optional<OccupancyGrid> without_buffer{};
};

/// Loads what the command line names. Warnings of files go to stderr. Throws UsageError.
Task load_task(const Arguments& args);

}  // namespace plan_program
