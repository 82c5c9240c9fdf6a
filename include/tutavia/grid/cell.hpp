// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// \file
/// Cell: an index pair on a grid.

namespace tutavia {

/// Column x and row y of a grid.
struct Cell {
  int x = 0;
  int y = 0;

  friend bool operator==(const Cell&, const Cell&) = default;
  friend Cell operator+(Cell a, Cell b) { return {a.x + b.x, a.y + b.y}; }
  friend Cell operator-(Cell a, Cell b) { return {a.x - b.x, a.y - b.y}; }
};

}  // namespace tutavia
