// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// \file
/// Cell: an index pair on a grid. It also stands for a corner of cells: the lower left one of that
/// cell.

namespace tutavia {

/// Column x and row y of a grid.
struct Cell {
  int x = 0;
  int y = 0;

  friend bool operator==(const Cell&, const Cell&) = default;
  friend constexpr Cell operator+(Cell a, Cell b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Cell operator-(Cell a, Cell b) { return {a.x - b.x, a.y - b.y}; }
};

namespace detail {

/// Twice the area of the triangle a, b, c: positive if c lies left of the line from a to b.
/// \pre differences below 2^31
inline std::int64_t turn(Cell a, Cell b, Cell c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
         (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

}  // namespace detail

}  // namespace tutavia
