// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/grid/bitboard/bits.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// FreeRuns: the free cells of a grid as rectangles.

namespace tutavia::detail {

/// A rectangle of cells by its corners: columns [x0, x1), rows [y0, y1).
struct CellBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  friend bool operator==(const CellBox&, const CellBox&) = default;
};

/// The maximal free runs of every row, read from the grid's bits on demand: a decomposition of free
/// space into convex pieces that needs no preparation. Equal runs of successive rows may be joined
/// to one rectangle.
///
/// Two pieces are neighbours if they share a side of positive length. Pieces that touch at a corner
/// only are not, so no path passes between two blocked cells that touch.
class FreeRuns {
 public:
  /// A piece, given by the index of any of its cells.
  using Piece = std::uint32_t;

  enum class EqualRuns { apart, joined };
  enum class Exits { below, above };  ///< the sides of a box that `for_each_exit_between` visits

  explicit FreeRuns(const OccupancyGrid& grid, EqualRuns equal = EqualRuns::apart)
      : grid_(grid), equal_(equal) {}

  CellBox open(Piece piece) const {
    const Cell cell = grid_.cell(piece);
    CellBox box{first(cell), cell.y, grid_.run_end(cell.y, cell.x, true), cell.y + 1};
    if (equal_ == EqualRuns::joined) {
      while (is_run(box, box.y0 - 1)) --box.y0;
      while (is_run(box, box.y1)) ++box.y1;
    }
    return box;
  }

  /// Calls `visit(piece)` once for every piece that touches a cell.
  template <class Visit>
  void for_each_near(Cell cell, const Visit& visit) const {
    std::array<CellBox, 6> seen;
    std::size_t count = 0;
    for (int y = std::max(cell.y - 1, 0); y <= std::min(cell.y + 1, grid_.height() - 1); ++y) {
      for (int x = std::max(cell.x - 1, 0); x < std::min(cell.x + 2, grid_.width()); ++x) {
        if (!grid_.is_free(Cell{x, y})) continue;
        const CellBox box = open(piece({x, y}));
        if (std::find(seen.begin(), seen.begin() + count, box) != seen.begin() + count) continue;
        seen[count++] = box;  // two runs in each of three rows at most
        visit(piece({x, y}));
      }
    }
  }

  /// Whether a point lies in a piece or on its border; `coordinates(corner)` gives the position of
  /// a corner.
  template <class Coords>
  bool holds(Piece piece, const Point& p, const Coords& coordinates) const {
    const CellBox box = open(piece);
    return Box{coordinates(Cell{box.x0, box.y0}), coordinates(Cell{box.x1, box.y1})}.contains(p);
  }

  /// Calls `visit(right, left, piece)` for every side that the box of a piece shares with a
  /// neighbour. `right` and `left` are the ends of the side as seen from inside.
  template <class Visit>
  void for_each_exit(const CellBox& box, const Visit& visit) const {
    for_each_exit_between(box, Exits::below, box.x0, box.x1, visit);
    for_each_exit_between(box, Exits::above, box.x0, box.x1, visit);
  }

  /// The same for the sides above or below the box that reach into columns [x0, x1).
  template <class Visit>
  void for_each_exit_between(const CellBox& box, Exits exits, int x0, int x1,
                             const Visit& visit) const {
    const int line = exits == Exits::above ? box.y1 : box.y0;
    const int y = exits == Exits::above ? line : line - 1;
    if (y < 0 || y >= grid_.height()) return;
    x1 = std::min(x1, box.x1);
    for (int x = std::max(x0, box.x0); x < x1;) {
      int begin = grid_.run_end(y, x, false);
      if (begin >= x1) return;
      if (begin == x && x > box.x0) begin = std::max(first({x, y}), box.x0);
      const int end = std::min(grid_.run_end(y, std::max(begin, x), true), box.x1);
      const Cell left{begin, line}, right{end, line};
      visit(exits == Exits::above ? right : left, exits == Exits::above ? left : right,
            piece({begin, y}));
      x = end;
    }
  }

 private:
  Piece piece(Cell cell) const { return static_cast<Piece>(grid_.index(cell)); }

  /// Whether a box is as wide as a run of row y.
  bool is_run(const CellBox& box, int y) const {
    if (y < 0 || y >= grid_.height()) return false;
    const std::size_t from = grid_.index({box.x0, y});
    const auto length = static_cast<std::size_t>(box.x1 - box.x0);
    return !grid_.is_free(from - 1) && !grid_.is_free(from + length) &&
           grid_.run_end(y, box.x0, true) == box.x1;
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
  EqualRuns equal_;
};

}  // namespace tutavia::detail
