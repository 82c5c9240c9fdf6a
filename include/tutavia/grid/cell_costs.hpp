// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// CellCosts: traversal costs of cells.

namespace tutavia {

/// An 8-bit extra cost for every cell of a grid. A step costs its length times 1 + c / 32, where c
/// is the mean of the two cells' values (at most 9 times its length).
class CellCosts {
 public:
  /// Units of `step_cost` per unit of `Cost` on a grid without extra costs; both are integers.
  static constexpr Cost scale = 64;

  /// No extra cost on any cell of a grid of this size.
  explicit CellCosts(const OccupancyGrid& grid)
      : width_(grid.width()),
        height_(grid.height()),
        values_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0) {}

  int width() const { return width_; }
  int height() const { return height_; }
  /// \pre the cell lies in the grid
  std::uint8_t operator[](Cell cell) const { return values_[at(cell)]; }
  void set(Cell cell, std::uint8_t value) { values_[at(cell)] = value; }

  /// The cost of a step, in units of 1 / scale.
  Cost step_cost(Cell from, std::size_t step) const {
    return detail::step_cost(step) * (scale + (*this)[from] + (*this)[from + steps[step]]);
  }

 private:
  std::size_t at(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x);
  }

  int width_, height_;
  std::vector<std::uint8_t> values_;
};

}  // namespace tutavia
