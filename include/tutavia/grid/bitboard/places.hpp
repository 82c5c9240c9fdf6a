// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "tutavia/grid/cell.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// Place: a cell as rows and columns of bits address it.

namespace tutavia::detail {

/// The index of a cell in a grid, row by row, and in its transpose, column by column.
struct Place {
  std::array<std::size_t, 2> index;

  std::size_t in_rows() const { return index[0]; }
  std::size_t in_columns() const { return index[1]; }
};

/// The places of a grid's cells, and how they change from step to step. By value, for inner loops.
class Places {
 public:
  explicit Places(const OccupancyGrid& grid)
      : rows_(grid.stride()),
        columns_((static_cast<std::size_t>(grid.height()) + 2 + 63) / 64 * 64) {
    for (std::size_t step = 0; step < steps.size(); ++step) {
      const auto x = static_cast<std::size_t>(steps[step].x);  // modulo 2^64
      const auto y = static_cast<std::size_t>(steps[step].y);
      per_step_[step] = {{x + y * rows_, x * columns_ + y}};
    }
  }

  Place of(Cell cell) const {
    const std::size_t x = static_cast<std::size_t>(cell.x) + 1;
    const std::size_t y = static_cast<std::size_t>(cell.y) + 1;
    return {{x + y * rows_, x * columns_ + y}};
  }
  /// The place `count` steps from another.
  Place advanced(const Place& from, std::size_t step, int count) const {
    const auto n = static_cast<std::size_t>(count);
    return {{from.in_rows() + n * per_step_[step].in_rows(),
             from.in_columns() + n * per_step_[step].in_columns()}};
  }
  /// The difference in the grid's index that a step makes, modulo 2^64.
  std::size_t per_step(std::size_t step) const { return per_step_[step].in_rows(); }

  std::size_t row_stride() const { return rows_; }
  std::size_t column_stride() const { return columns_; }

 private:
  std::size_t rows_, columns_;
  std::array<Place, 8> per_step_{};
};

}  // namespace tutavia::detail
