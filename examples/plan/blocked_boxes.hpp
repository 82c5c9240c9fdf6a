// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "map_frame.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/polygon.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// blocked_boxes: blocked cells as rectangles.

namespace plan_program {

using namespace tutavia;

/// A run of blocked cells from `first` to `last`, the same in all rows from `from_row` on.
struct Run {
  int first, last, from_row;
};

inline std::vector<Run> blocked_runs(const OccupancyGrid& cells, int y) {
  std::vector<Run> runs;
  if (y == cells.height()) return runs;
  cells.for_each_run(y, false, [&](int first, int last) { runs.push_back({first, last, y}); });
  return runs;
}

/// The blocked cells as rectangles. Runs of equal extent in neighbouring rows share one.
inline std::vector<Box> blocked_boxes(const OccupancyGrid& cells, const Point& origin,
                                      double side) {
  std::vector<Box> boxes;
  std::vector<Run> open;
  for (int y = 0; y <= cells.height(); ++y) {
    std::vector<Run> row = blocked_runs(cells, y);
    for (const Run& run : open) {
      const auto same = std::find_if(row.begin(), row.end(), [&](const Run& other) {
        return other.first == run.first && other.last == run.last;
      });
      if (same != row.end()) {
        same->from_row = run.from_row;
        continue;
      }
      boxes.push_back(
          {origin + side * Point(run.first, run.from_row), origin + side * Point(run.last + 1, y)});
    }
    open = std::move(row);
  }
  return boxes;
}

/// The corners of a box in the frame of the grid, counterclockwise, in that of the map.
inline Ring corners_of(const Box& box, const MapFrame& frame) {
  return {frame.to_map(box.min), frame.to_map(Point{box.max.x(), box.min.y()}),
          frame.to_map(box.max), frame.to_map(Point{box.min.x(), box.max.y()})};
}

/// Adds the blocked cells as obstacles, in the frame of the map.
inline void add_blocked_cells(const OccupancyGrid& cells, const Point& origin, double side,
                              const MapFrame& frame, Workspace& workspace) {
  for (const Box& box : blocked_boxes(cells, origin, side)) {
    workspace.obstacles.emplace_back(Polygon{corners_of(box, frame)});
  }
}

}  // namespace plan_program
