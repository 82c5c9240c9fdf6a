// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// with_safety_buffer: blocks the cells around blocked ones.

namespace tutavia {

/// A grid with a safety buffer.
struct BufferedGrid {
  OccupancyGrid grid;            ///< blocked: the blocked cells and the buffer
  std::vector<Cell> exempted{};  ///< cells in the buffer that were left free
};

/// Blocks all cells within `width` cells of a blocked one, also diagonally: the centre of a free
/// cell is more than `width` cells from that of any blocked cell, along x or along y. The border of
/// the grid has no buffer. Cells of `exempt` (start and goal) within the buffer stay free and are
/// reported; they may be disconnected from the other free cells.
///
/// For an exact Euclidean distance in metres, use CellOptions::safety_radius.
///
/// Errors: `invalid_option` for a negative width, `invalid_input` for an exempt cell outside the
/// grid. O(runs of blocked cells x width).
///
/// Source: "Improved REA*", algorithm 1 ("safety buffer area", width 1); see docs/algorithms.md.
inline Expected<BufferedGrid, Failure> with_safety_buffer(const OccupancyGrid& grid,
                                                          std::span<const Cell> exempt = {},
                                                          int width = 1) {
  if (width < 0) return fail(PlanError::invalid_option, "the width of a safety buffer is negative");
  for (const Cell& cell : exempt) {
    if (!grid.contains(cell)) {
      return fail(PlanError::invalid_input, "exempt cell (" + std::to_string(cell.x) + ", " +
                                                std::to_string(cell.y) + ") lies outside the grid");
    }
  }
  // Clamped to the size of the grid, so that sums do not overflow.
  const int wide = std::min(width, grid.width()), high = std::min(width, grid.height());
  BufferedGrid result{grid};
  for (int y = 0; y < grid.height(); ++y) {
    grid.for_each_run(y, false, [&](int first, int last) {
      for (int row = y - high; row <= y + high; ++row) {
        result.grid.set_run(row, first - wide, last + wide, false);
      }
    });
  }
  for (const Cell& cell : exempt) {
    if (!grid.is_free(cell) || result.grid.is_free(cell)) continue;
    result.grid.set(cell, true);
    result.exempted.push_back(cell);
  }
  return result;
}

}  // namespace tutavia
