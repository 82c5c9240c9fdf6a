// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// transposed: a grid with rows and columns exchanged, for scans along columns.

namespace tutavia::detail {

/// Transposes 64 x 64 bits in place, by swapping ever smaller blocks (Warren 2012, "Hacker's
/// delight", section 7-3).
inline void transpose_64(std::array<std::uint64_t, 64>& rows) {
  std::uint64_t mask = 0xFFFFFFFFu;
  for (std::size_t width = 32; width > 0; width /= 2, mask ^= mask << width) {
    for (std::size_t row = 0; row < 64; row = ((row | width) + 1) & ~width) {
      const std::uint64_t swapped = ((rows[row] >> width) ^ rows[row | width]) & mask;
      rows[row] ^= swapped << width;
      rows[row | width] ^= swapped;
    }
  }
}

/// Transposes a matrix of `rows` x `columns` bits with `per_row` words a row, in blocks of 64 x 64.
/// The result, with `per_column` words a row, goes to `to`; its bits beyond `rows` are 0.
inline void transpose_bits(const std::uint64_t* from, std::size_t rows, std::size_t columns,
                           std::size_t per_row, std::size_t per_column, std::uint64_t* to) {
  std::array<std::uint64_t, 64> block;
  for (std::size_t i = 0; i < per_column; ++i) {
    for (std::size_t j = 0; j < per_row; ++j) {
      for (std::size_t k = 0; k < 64; ++k) {
        block[k] = 64 * i + k < rows ? from[(64 * i + k) * per_row + j] : 0;
      }
      transpose_64(block);
      for (std::size_t k = 0; k < 64 && 64 * j + k < columns; ++k) {
        to[(64 * j + k) * per_column + i] = block[k];
      }
    }
  }
}

/// Whether a grid has a transpose. Errors: `limit_exceeded` for one of so many columns that the
/// rows of the transpose, padded to 64 cells, have more than 2^32 - 64 indices.
inline Expected<void, Failure> check_transpose(const OccupancyGrid& grid) {
  if (OccupancyGrid::fits(grid.height(), grid.width())) return {};
  return fail(PlanError::limit_exceeded,
              "grid of " + std::to_string(grid.width()) + " x " + std::to_string(grid.height()) +
                  " cells needed, 2^32 - 64 bits of padded columns allowed");
}

/// The transpose of a grid. \pre check_transpose
inline OccupancyGrid transposed(const OccupancyGrid& grid) {
  OccupancyGrid result = OccupancyGrid::blocked(grid.height(), grid.width(),
                                                std::int64_t{grid.height()} * grid.width())
                             .value();
  // Sizes with the padding.
  const std::size_t rows = static_cast<std::size_t>(grid.height()) + 2;
  const std::size_t columns = static_cast<std::size_t>(grid.width()) + 2;
  transpose_bits(grid.words().data(), rows, columns, grid.stride() / 64, result.stride() / 64,
                 result.bits_.data());
  return result;
}

}  // namespace tutavia::detail
