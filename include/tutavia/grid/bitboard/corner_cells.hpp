// SPDX-License-Identifier: MIT
#pragma once

#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// CornerCells: the cells around a corner, where any-angle paths bend.

namespace tutavia::detail {

/// Which of the four cells around a corner are free. Corner (x, y) is the lower left one of cell
/// (x, y).
struct CornerCells {
  bool ne, nw, sw, se;

  /// \pre the corner is one of a cell of the grid; the outside of the grid is blocked
  CornerCells(const OccupancyGrid& grid, Cell corner)
      : ne(grid.is_free(corner)),
        nw(grid.is_free(corner + Cell{-1, 0})),
        sw(grid.is_free(corner + Cell{-1, -1})),
        se(grid.is_free(corner + Cell{0, -1})) {}

  bool any_free() const { return ne || nw || sw || se; }
  /// Whether two blocked cells touch at this corner only.
  bool is_double() const { return ne == sw && nw == se && ne != nw; }
  /// Whether the boundary of the blocked cells has a vertex here.
  bool is_vertex() const { return !((ne == nw && sw == se) || (ne == se && nw == sw)); }
};

}  // namespace tutavia::detail
