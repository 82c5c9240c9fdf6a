// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tutavia/geometry/point.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// ROS maps as grids, and nav2's costmaps. io/ros_map_yaml.hpp reads the files of map_server.

namespace tutavia {

/// A map as ROS publishes it (nav_msgs/OccupancyGrid).
struct RosMap {
  /// How to treat unknown cells.
  enum class UnknownCells { blocked, free };

  int width = 0;   ///< [cells]
  int height = 0;  ///< [cells]
  /// Row by row, row 0 is the BOTTOM of the map: -1 unknown, 0 free, ..., 100 occupied.
  std::vector<std::int8_t> values{};
  double resolution = 1;                ///< side of a cell [m]
  Point origin = Point::Zero();         ///< lower left corner of the map, in the map frame [m]
  double yaw = 0;                       ///< of the map's rows in the map frame, left positive [rad]
  std::vector<std::string> warnings{};  ///< doubts about the files, one line each
};

namespace detail {

/// The grid whose cells are free where `is_free` holds for their value.
template <class Value, class IsFree>
Expected<OccupancyGrid, Failure> make_grid(std::span<const Value> values, int width, int height,
                                           IsFree is_free) {
  const auto cells = static_cast<std::int64_t>(width) * height;
  if (width >= 0 && height >= 0 && values.size() != static_cast<std::size_t>(cells)) {
    return fail(PlanError::invalid_input, "expected " + std::to_string(width) + " x " +
                                              std::to_string(height) + " values, found " +
                                              std::to_string(values.size()));
  }
  auto grid = OccupancyGrid::blocked(width, height);
  if (!grid) return grid;
  auto value = values.begin();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) grid->set({x, y}, is_free(*value++));
  }
  return grid;
}

}  // namespace detail

/// The map as a grid; row 0 is the map's bottom row. In the grid frame, cell (x, y) is the square
/// from (x, y) to (x + 1, y + 1), times the resolution.
///
/// Cells with values of `occupied_at` or more are blocked. 100 is the value of nav2's static layer;
/// for a map in scale mode it blocks only cells of full certainty. Errors: `invalid_option` for an
/// `occupied_at` outside 1 to 100; `invalid_input` if the values are not width x height, or one is
/// outside -1 to 100.
inline Expected<OccupancyGrid, Failure> to_grid(const RosMap& map, RosMap::UnknownCells unknown,
                                                int occupied_at = 100) {
  if (occupied_at < 1 || occupied_at > 100) {
    return fail(PlanError::invalid_option,
                "occupied_at: expected 1 to 100, found " + std::to_string(occupied_at));
  }
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (map.values[i] >= -1 && map.values[i] <= 100) continue;
    return fail(PlanError::invalid_input, "values[" + std::to_string(i) +
                                              "]: expected -1 to 100, found " +
                                              std::to_string(map.values[i]));
  }
  return detail::make_grid(std::span(map.values), map.width, map.height, [&](int value) {
    return value < 0 ? unknown == RosMap::UnknownCells::free : value < occupied_at;
  });
}

/// Converts a point from the map frame to the grid frame, both in metres. The grid frame has its
/// origin at the lower left corner of the map's image, x along the rows to the right and y upwards.
inline Point to_grid_frame(const RosMap& map, const Point& in_map) {
  const double c = std::cos(map.yaw), s = std::sin(map.yaw);
  const double dx = in_map.x() - map.origin.x(), dy = in_map.y() - map.origin.y();
  return {c * dx + s * dy, c * dy - s * dx};
}

/// The inverse of `to_grid_frame`.
inline Point to_map_frame(const RosMap& map, const Point& in_grid) {
  const double c = std::cos(map.yaw), s = std::sin(map.yaw);
  return {map.origin.x() + c * in_grid.x() - s * in_grid.y(),
          map.origin.y() + s * in_grid.x() + c * in_grid.y()};
}

/// A costmap of nav2 (nav2_costmap_2d) as a grid; row 0 is the bottom row, 255 is unknown.
///
/// Cells of cost `blocked_at` or more are blocked: use 254 (lethal: an obstacle) if the planner
/// keeps its own safety radius, 253 (inscribed: a robot centred here collides) if it keeps none.
/// Lower costs are dropped; for soft costs see clearance_costs. Example: examples/03_costmap.cpp.
/// Errors: `invalid_option` for a `blocked_at` outside 1 to 254; `invalid_input` if there are not
/// width x height values.
inline Expected<OccupancyGrid, Failure> grid_from_costmap(std::span<const std::uint8_t> costs,
                                                          int width, int height, int blocked_at,
                                                          RosMap::UnknownCells unknown) {
  if (blocked_at < 1 || blocked_at > 254) {
    return fail(PlanError::invalid_option,
                "blocked_at: expected 1 to 254, found " + std::to_string(blocked_at));
  }
  return detail::make_grid(costs, width, height, [&](int cost) {
    return cost == 255 ? unknown == RosMap::UnknownCells::free : cost < blocked_at;
  });
}

}  // namespace tutavia
