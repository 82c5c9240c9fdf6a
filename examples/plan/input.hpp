// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "map_frame.hpp"
#include "options.hpp"
#include "planning_space.hpp"
#include "tutavia/grid/cell_costs.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/io/ros_map.hpp"
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
  /// Start and goals are in the map's frame, the space and its bounds in that of the grid.
  MapFrame frame{};
  std::optional<RosMap> ros_map{};           ///< without its values
  std::shared_ptr<const CellCosts> costs{};  ///< of --unknown cost:N; null: all cells cost the same
  std::size_t blocked_unknown = 0;           ///< unknown cells of a ROS map that are blocked
};

/// Loads what the command line names. Warnings of files go to stderr. Throws UsageError.
Task load_task(const Arguments& args);

}  // namespace plan_program
