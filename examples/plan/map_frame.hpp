// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/io/ros_map.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/search_record.hpp"

/// \file
/// MapFrame: the frame of a turned map, in which users give and get points.

namespace plan_program {

using namespace tutavia;

/// The rows of a turned map are not along the axes of its frame. It is planned in the frame of its
/// grid, whose axes are along the rows and columns. The default is a map that is not turned: both
/// frames are the same.
class MapFrame {
 public:
  MapFrame() = default;
  /// The frame of a map with this origin and yaw; its values are not needed.
  explicit MapFrame(const RosMap& map) : is_turned_(map.yaw != 0) {
    map_.origin = map.origin;
    map_.yaw = map.yaw;
  }

  bool is_turned() const { return is_turned_; }
  double yaw() const { return map_.yaw; }

  /// Converts a point to the frame of the grid. `to_map` gives back exactly this point.
  Point to_grid(const Point& in_map);
  /// Converts a heading to the frame of the grid [rad].
  double heading_to_grid(double in_map) const { return in_map - yaw(); }
  /// Converts to the frame of the map. Coordinates are rounded. Gears stay as they are.
  Point to_map(const Point& in_grid) const;
  Curve to_map(const Curve& in_grid) const;
  Expected<Plan, Failure> to_map(Expected<Plan, Failure> plan) const;
  /// Rectangles are given by two opposite corners, still.
  SearchRecord to_map(SearchRecord record) const;

 private:
  Piece to_map(const Piece& in_grid) const;

  RosMap map_{};
  bool is_turned_ = false;
  std::vector<std::pair<Point, Point>> given_{};  // in the frames of the grid and of the map
};

}  // namespace plan_program
