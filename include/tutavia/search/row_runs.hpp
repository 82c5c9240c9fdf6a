// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "tutavia/grid/bits.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// RowRuns: the free cells of a grid as rectangles one cell high.

namespace tutavia {

/// A rectangle of cells by its corners: columns [x0, x1), rows [y0, y1).
struct CellBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// The longest free runs of every row, found in the grid's bits when they are asked for: a
/// decomposition of free space into convex pieces that costs nothing to prepare.
///
/// A piece is named by any of its cells. Two pieces are neighbours where they share a side of
/// positive length; rectangles that only touch at a corner are not, so that no path passes between
/// two blocked cells that touch.
class RowRuns {
 public:
  explicit RowRuns(const OccupancyGrid& grid) : grid_(grid) {}

  /// The piece that holds a free cell.
  CellBox box(Cell cell) const {
    return {first(cell), cell.y, grid_.run_end(cell.y, cell.x, true), cell.y + 1};
  }

  /// Calls `visit(right, left, cell)` for every side that the box of a piece shares with a
  /// neighbour: its ends as seen from within, and a cell of the neighbour.
  template <class Visit>
  void for_each_exit(const CellBox& box, const Visit& visit) const {
    for_each_run(box.y0 - 1, box, [&](int x0, int x1) {
      visit(Cell{x0, box.y0}, Cell{x1, box.y0}, Cell{x0, box.y0 - 1});
    });
    for_each_run(box.y1, box, [&](int x0, int x1) {
      visit(Cell{x1, box.y1}, Cell{x0, box.y1}, Cell{x0, box.y1});
    });
  }

 private:
  /// Calls `visit(x0, x1)` for the parts of a row's runs that lie between a box's sides.
  template <class Visit>
  void for_each_run(int y, const CellBox& box, const Visit& visit) const {
    if (y < 0 || y >= grid_.height()) return;
    for (int x = box.x0; x < box.x1;) {
      const int begin = std::min(grid_.run_end(y, x, false), box.x1);
      if (begin == box.x1) return;
      x = std::min(grid_.run_end(y, begin, true), box.x1);
      visit(begin, x);
    }
  }

  /// The column where the free run of a cell begins.
  int first(Cell cell) const {
    constexpr int before = static_cast<int>(loaded_bits) - 1;
    constexpr std::uint64_t mask = (std::uint64_t{1} << loaded_bits) - 1;
    const std::uint64_t* words = grid_.words().data();
    while (true) {  // the padding ends it
      const std::size_t from = grid_.index(cell) - static_cast<std::size_t>(before);
      const std::uint64_t blocked = ~load_bits(words, from) & mask;
      if (blocked != 0) return cell.x - before + (64 - std::countl_zero(blocked));
      cell.x -= static_cast<int>(loaded_bits);
    }
  }

  const OccupancyGrid& grid_;
};

}  // namespace tutavia
