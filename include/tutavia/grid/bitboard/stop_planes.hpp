// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/grid/bitboard/bits.hpp"
#include "tutavia/grid/bitboard/transposed.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// StopPlanes: the cells at which straight jumps end.

namespace tutavia::detail {

/// One bit per cell for each of the four straight directions. It is set if a jump in that direction
/// stops at the cell, because the cell is blocked or has a forced neighbour under `no_cut` (a free
/// cell beside it that follows a blocked one). A jump is then a search for the next set bit.
///
/// The planes for east and west are stored row by row like the grid, those for north (+y) and south
/// column by column. Source: the block-based scanning of Harabor and Grastien 2014, "Improving jump
/// point search", with its results stored instead of recomputed.
class StopPlanes {
 public:
  explicit StopPlanes(const OccupancyGrid& grid)
      : row_stride_(grid.stride()),
        column_stride_((static_cast<std::size_t>(grid.height()) + 2 + 63) / 64 * 64) {
    const std::size_t rows = static_cast<std::size_t>(grid.height()) + 2;
    const std::size_t columns = static_cast<std::size_t>(grid.width()) + 2;
    build(grid.words(), row_stride_ / 64, rows, planes_[0], planes_[2]);
    build(transposed(grid).words(), column_stride_ / 64, columns, planes_[1], planes_[3]);
  }

  /// The bit indices of a cell in the planes.
  struct PlaneIndex {
    std::size_t in_rows;
    std::size_t in_columns;
  };
  PlaneIndex plane_index(Cell cell) const {
    return {
        static_cast<std::size_t>(cell.y + 1) * row_stride_ + static_cast<std::size_t>(cell.x + 1),
        static_cast<std::size_t>(cell.x + 1) * column_stride_ +
            static_cast<std::size_t>(cell.y + 1)};
  }
  std::size_t row_stride() const { return row_stride_; }
  std::size_t column_stride() const { return column_stride_; }

  /// Distance from a cell to the next stop in a straight direction, at least 1.
  /// \pre the cell lies in the grid
  template <std::size_t Step>
  int jump(const PlaneIndex& from) const {
    static_assert(!is_diagonal(Step));
    const std::size_t bit = Step % 4 == 0 ? from.in_rows : from.in_columns;
    const std::uint64_t* words = planes_[Step / 2].data();
    return Step < 4 ? next_bit(words, bit) : previous_bit(words, bit);
  }

  /// Whether a jump in a straight direction stops at a cell. \pre the cell lies in the grid
  bool is_stop(Cell cell, std::size_t step) const {
    const PlaneIndex at = plane_index(cell);
    const std::size_t bit = step % 4 == 0 ? at.in_rows : at.in_columns;
    return ((planes_[step / 2][bit / 64] >> (bit % 64)) & 1u) != 0;
  }

  std::size_t memory() const {
    std::size_t words = 0;
    for (const auto& plane : planes_) words += plane.size();
    return words * sizeof(std::uint64_t);
  }

 private:
  using Words = std::vector<std::uint64_t>;

  /// Distance to the next set bit after `from`.
  static int next_bit(const std::uint64_t* words, std::size_t from) {
    std::size_t first = from + 1;
    while (true) {
      const std::uint64_t bits = load_bits(words, first);
      if (bits != 0) return static_cast<int>(first - from) + std::countr_zero(bits);
      first += loaded_bits;
    }
  }

  /// Distance to the last set bit before `from`. \pre bit from - 64 is in the array
  static int previous_bit(const std::uint64_t* words, std::size_t from) {
    std::size_t first = from - loaded_bits;
    while (true) {
      const std::uint64_t bits = load_bits(words, first) & ((std::uint64_t{1} << loaded_bits) - 1);
      if (bits != 0) {
        const int highest = 63 - std::countl_zero(bits);
        return static_cast<int>(from - first) - highest;
      }
      first -= loaded_bits;
    }
  }

  /// Stops towards higher bits and towards lower ones, for lines of `per_line` words.
  static void build(const Words& free, std::size_t per_line, std::size_t lines, Words& up,
                    Words& down) {
    up.assign(lines * per_line, ~std::uint64_t{0});
    down.assign(lines * per_line, ~std::uint64_t{0});
    for (std::size_t line = 1; line + 1 < lines; ++line) {
      for (std::size_t j = 0; j < per_line; ++j) {
        const std::size_t i = line * per_line + j;
        // Cells of a neighbouring line that are free behind a blocked one.
        const auto opens_up = [&](std::size_t word) {
          return free[word] & ~(free[word] << 1 | (j > 0 ? free[word - 1] >> 63 : 0));
        };
        const auto opens_down = [&](std::size_t word) {
          return free[word] & ~(free[word] >> 1 | (j + 1 < per_line ? free[word + 1] << 63 : 0));
        };
        up[i] = ~free[i] | opens_up(i - per_line) | opens_up(i + per_line);
        down[i] = ~free[i] | opens_down(i - per_line) | opens_down(i + per_line);
      }
    }
  }

  std::size_t row_stride_;
  std::size_t column_stride_;
  std::array<Words, 4> planes_;  // east, north, west, south
};

}  // namespace tutavia::detail
