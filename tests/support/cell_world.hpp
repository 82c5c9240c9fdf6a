// SPDX-License-Identifier: MIT
#pragma once

#include "tutavia/space/cell_space.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// world_of_cells: blocked cells as polygons.

namespace tutavia::test {

/// The same free space with polygons: a rectangle for every run of blocked cells. At radius 0 such
/// rectangles alone would leave a slit between two rows, so there are also rectangles over two
/// rows, and the outside of the map counts as blocked.
inline Workspace world_of_cells(const CellSpace& space) {
  Workspace world{.bounds = space.bounds(), .safety_radius = space.safety_radius()};
  const OccupancyGrid& map = space.cells();
  const bool at_contact = space.safety_radius() == 0;
  const auto solid = [&](int x, int y) {
    return map.contains({x, y}) ? !map.is_free(Cell{x, y}) : at_contact;
  };
  const auto add_runs = [&](int y, int rows) {
    for (int x = -1; x <= map.width(); ++x) {
      const int first = x;
      while (x <= map.width() && solid(x, y) && solid(x, y + rows - 1)) ++x;
      if (x == first || first >= map.width() || x <= 0) continue;  // no cell of the map
      const Point low = space.corner({first, y}), high = space.corner({x, y + rows});
      world.obstacles.push_back(Polygon{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}});
    }
  };
  for (int y = 0; y < map.height(); ++y) add_runs(y, 1);
  for (int y = -1; at_contact && y < map.height(); ++y) add_runs(y, 2);
  return world;
}

}  // namespace tutavia::test
