// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/grid/bitboard/bits.hpp"
#include "tutavia/grid/bitboard/places.hpp"
#include "tutavia/grid/bitboard/transposed.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// StopPlanes: the cells at which straight jumps end.

namespace tutavia::detail {

/// One bit per cell for each of the four straight directions. It is set if a jump in that direction
/// stops at the cell, because the cell is blocked or has a forced neighbour under `no_cut` (a free
/// cell beside it that follows a blocked one). A jump is then a search for the next set bit.
///
/// The plane for east is stored row by row like the grid, that for north (+y) column by column.
/// Those for west and south have all bits in reverse order. So every jump leads to higher bits, and
/// its direction is data. Source: the block-based scanning of Harabor and Grastien 2014, "Improving
/// jump point search", with its results stored instead of recomputed.
class StopPlanes {
 public:
  explicit StopPlanes(const OccupancyGrid& grid) {
    const Places places(grid);
    const std::size_t rows = static_cast<std::size_t>(grid.height()) + 2;
    const std::size_t columns = static_cast<std::size_t>(grid.width()) + 2;
    build(grid.words(), places.row_stride() / 64, rows, planes_[0], planes_[2]);
    build(transposed(grid).words(), places.column_stride() / 64, columns, planes_[1], planes_[3]);
  }

  /// The plane of one straight step.
  class Plane {
   public:
    Plane() = default;
    Plane(const std::vector<std::uint64_t>& words, std::size_t step)
        : words_(words.data()),
          axis_(step % 4 / 2),
          reverse_(step < 4 ? 0 : ~std::size_t{0}),
          offset_(step < 4 ? 0 : 64 * (words.size() - 1)) {}

    /// Steps from a free cell to the next stop. \pre the cell lies in the grid
    int jump(const Place& from) const { return next_bit(words_, bit(from)); }
    /// \pre the cell lies in the grid
    bool is_stop(const Place& cell) const { return bit_at(words_, bit(cell)); }

   private:
    std::size_t bit(const Place& cell) const {
      // A plane of n bits in reverse order has bit b at n - 1 - b, which is n + ~b.
      return (cell.index[axis_] ^ reverse_) + offset_;
    }

    const std::uint64_t* words_ = nullptr;
    std::size_t axis_ = 0;
    std::size_t reverse_ = 0, offset_ = 0;
  };

  /// \pre the step is straight
  Plane plane(std::size_t step) const { return {planes_[step / 2], step}; }

  /// The words of a straight step's plane, line by line, with a spare word at the end. The first
  /// and the last line are all stops.
  const std::vector<std::uint64_t>& words(std::size_t step) const { return planes_[step / 2]; }

  std::size_t memory() const {
    std::size_t words = 0;
    for (const auto& plane : planes_) words += plane.size();
    return words * sizeof(std::uint64_t);
  }

 private:
  using Words = std::vector<std::uint64_t>;

  /// Stops towards higher bits, and towards lower ones in reverse order; for lines of `per_line`
  /// words.
  static void build(const Words& free, std::size_t per_line, std::size_t lines, Words& up,
                    Words& down) {
    const std::size_t count = lines * per_line;
    up.assign(count + 1, ~std::uint64_t{0});
    down.assign(count + 1, ~std::uint64_t{0});
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
        down[count - 1 - i] =
            reversed(~free[i] | opens_down(i - per_line) | opens_down(i + per_line));
      }
    }
  }

  std::array<Words, 4> planes_;  // east, north, west, south
};

}  // namespace tutavia::detail
