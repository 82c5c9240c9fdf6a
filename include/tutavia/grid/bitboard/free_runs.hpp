// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/grid/bitboard/bits.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// FreeRuns: the free cells of a grid as rectangles one cell high.

namespace tutavia::detail {

/// A rectangle of cells by its corners: columns [x0, x1), rows [y0, y1).
struct CellBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  friend bool operator==(const CellBox&, const CellBox&) = default;
};

/// The maximal free runs of every row, read from the grid's bits on demand: a decomposition of free
/// space into convex pieces that needs no preparation.
///
/// Two runs are neighbours if they share a side of positive length. Runs that touch at a corner
/// only are not, so no path passes between two blocked cells that touch.
class FreeRuns {
 public:
  /// A run, given by the index of any of its cells.
  using Piece = std::uint32_t;

  explicit FreeRuns(const OccupancyGrid& grid) : grid_(grid) {}

  CellBox open(Piece piece) const {
    const Cell cell = grid_.cell(piece);
    return {first(cell), cell.y, grid_.run_end(cell.y, cell.x, true), cell.y + 1};
  }

  /// Calls `visit(piece)` for every run that touches a cell.
  template <class Visit>
  void for_each_near(Cell cell, const Visit& visit) const {
    for (int y = std::max(cell.y - 1, 0); y <= std::min(cell.y + 1, grid_.height() - 1); ++y) {
      const int begin = std::max(cell.x - 1, 0), end = std::min(cell.x + 2, grid_.width());
      for (int x = begin; x < end; ++x) {
        const bool known = x > begin && grid_.is_free(Cell{x - 1, y});
        if (!known && grid_.is_free(Cell{x, y})) visit(piece({x, y}));
      }
    }
  }

  /// Whether a point lies in a run or on its border; `coordinates(corner)` gives the position of a
  /// corner.
  template <class Coords>
  bool holds(Piece piece, const Point& p, const Coords& coordinates) const {
    const CellBox box = open(piece);
    return Box{coordinates(Cell{box.x0, box.y0}), coordinates(Cell{box.x1, box.y1})}.contains(p);
  }

  /// Calls `visit(right, left, piece)` for every side that the box of a run shares with a
  /// neighbour. `right` and `left` are the ends of the side as seen from inside.
  template <class Visit>
  void for_each_exit(const CellBox& box, const Visit& visit) const {
    for_each_run(box.y0 - 1, box, [&](int x0, int x1) {
      visit(Cell{x0, box.y0}, Cell{x1, box.y0}, piece({x0, box.y0 - 1}));
    });
    for_each_run(box.y1, box, [&](int x0, int x1) {
      visit(Cell{x1, box.y1}, Cell{x0, box.y1}, piece({x0, box.y1}));
    });
  }

 private:
  Piece piece(Cell cell) const { return static_cast<Piece>(grid_.index(cell)); }

  /// Calls `visit(x0, x1)` for the parts of a row's runs between the left and right side of a box.
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

  /// The first column of the free run of a cell.
  int first(Cell cell) const {
    constexpr int before = static_cast<int>(loaded_bits) - 1;
    constexpr std::uint64_t mask = (std::uint64_t{1} << loaded_bits) - 1;
    const std::uint64_t* words = grid_.words().data();
    while (true) {  // ends at the padding
      const std::size_t from = grid_.index(cell) - static_cast<std::size_t>(before);
      const std::uint64_t blocked = ~load_bits(words, from) & mask;
      if (blocked != 0) return cell.x - before + (64 - std::countl_zero(blocked));
      cell.x -= static_cast<int>(loaded_bits);
    }
  }

  const OccupancyGrid& grid_;
};

}  // namespace tutavia::detail
