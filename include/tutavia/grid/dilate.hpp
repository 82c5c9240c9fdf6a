// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// dilated: a grid with its blocked cells grown.

namespace tutavia {

/// The grid with every cell blocked whose centre lies too close to a blocked cell. A cell stays
/// free if d >= `least`, where the integer d is the squared distance from its centre to the nearest
/// blocked square, in units of half a cell side. O(runs of blocked cells x radius in cells).
inline OccupancyGrid dilated(const OccupancyGrid& grid, std::int64_t least) {
  // Along each axis the gap is the distance of the centres less half a cell.
  const auto squared_gap = [](std::int64_t cells) {
    return cells == 0 ? 0 : (2 * cells - 1) * (2 * cells - 1);
  };
  std::vector<int> reach;  // along x, for every distance along y; clamped to the grid
  int dx = grid.width();
  for (int dy = 0; squared_gap(dy) < least && dy < grid.height(); ++dy) {
    while (dx > 0 && squared_gap(dx) + squared_gap(dy) >= least) --dx;
    reach.push_back(dx);
  }
  OccupancyGrid result = grid;
  for (int y = 0; y < grid.height(); ++y) {
    grid.for_each_run(y, false, [&](int first, int last) {
      for (int dy = 0; dy < static_cast<int>(reach.size()); ++dy) {
        const int wide = reach[static_cast<std::size_t>(dy)];
        result.set_run(y + dy, first - wide, last + wide, false);
        result.set_run(y - dy, first - wide, last + wide, false);
      }
    });
  }
  return result;
}

}  // namespace tutavia
