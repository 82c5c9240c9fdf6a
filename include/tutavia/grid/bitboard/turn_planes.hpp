// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/grid/bitboard/bits.hpp"
#include "tutavia/grid/bitboard/places.hpp"
#include "tutavia/grid/bitboard/stop_planes.hpp"
#include "tutavia/grid/bitboard/transposed.hpp"
#include "tutavia/grid/cell.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// TurnPlanes: the cells at which diagonal jumps end or turn.

namespace tutavia::detail {

/// One bit per cell for each of the four diagonal directions, under `no_cut`. It is set if the step
/// into the cell is not allowed, or if a straight jump along one of the direction's components
/// leads from the cell to a jump point. So the next place at which a diagonal jump ends or may turn
/// is the next set bit.
///
/// With its blocked frame the grid has W columns X and H rows Y. In the plane for north-east, cells
/// of equal (X - Y) mod W form a line, in the order of Y; in that for north-west, those of equal
/// (W - 1 - X - Y) mod W. So every line has H cells, whatever the grid's shape. A line that leaves
/// the grid on one side and enters it on the other is cut by the frame. The planes for south-west
/// and south-east have all bits in reverse order, as in StopPlanes.
class TurnPlanes {
 public:
  /// \pre `stops` are the planes of the grid
  TurnPlanes(const OccupancyGrid& grid, const StopPlanes& stops)
      : columns_(static_cast<std::size_t>(grid.width()) + 2),
        stride_(Places(grid).column_stride()) {
    const OccupancyGrid transpose = transposed(grid);
    const std::size_t rows = static_cast<std::size_t>(grid.height()) + 2;
    const std::size_t per_row = grid.stride() / 64, per_column = stride_ / 64;
    const Words north = leads(stops.words(2), transpose.words(), per_column, columns_, false);
    const Words south = leads(stops.words(6), transpose.words(), per_column, columns_, true);
    Words sideways(columns_ * per_column), sheared(columns_ + 63);
    for (const bool is_east : {true, false}) {
      const Words led = leads(stops.words(is_east ? 0 : 4), grid.words(), per_row, rows, !is_east);
      transpose_bits(led.data(), rows, columns_, per_row, per_column, sideways.data());
      build(transpose.words(), sideways, north, is_east ? 1 : 3, sheared);
      build(transpose.words(), sideways, south, is_east ? 7 : 5, sheared);
    }
  }

  /// The plane of one diagonal step.
  class Plane {
   public:
    Plane() = default;
    Plane(const std::vector<std::uint64_t>& words, std::size_t columns, std::size_t stride,
          std::size_t step)
        : words_(words.data()),
          columns_(columns),
          stride_(stride),
          reciprocal_shift_(31 + static_cast<int>(std::bit_width(columns))),
          reciprocal_(((std::uint64_t{1} << reciprocal_shift_) + columns - 1) / columns),
          is_rising_(steps[step].x == steps[step].y),
          reverse_(step < 4 ? 0 : ~std::size_t{0}),
          offset_(step < 4 ? 0 : 64 * (words.size() - 1)) {}

    /// The bit of a cell; that of the next cell follows. \pre the cell lies in the grid
    std::size_t bit(Cell cell) const {
      const std::size_t x = static_cast<std::size_t>(cell.x) + 1;
      const std::size_t y = static_cast<std::size_t>(cell.y) + 1;
      // Rounded up, the reciprocal gives exact quotients for rows below 2^31.
      const auto rounds = static_cast<std::size_t>((y * reciprocal_) >> reciprocal_shift_);
      const std::size_t y_mod = y - rounds * columns_;
      const std::size_t line = (is_rising_ ? x : columns_ - 1 - x) + columns_ - y_mod;
      return (((line < columns_ ? line : line - columns_) * stride_ + y) ^ reverse_) + offset_;
    }
    /// Steps from the cell with this bit to the next one with a set bit.
    int jump(std::size_t bit) const { return next_bit(words_, bit); }

   private:
    const std::uint64_t* words_ = nullptr;
    std::size_t columns_ = 1, stride_ = 0;
    int reciprocal_shift_ = 0;
    std::uint64_t reciprocal_ = 0;
    bool is_rising_ = true;
    std::size_t reverse_ = 0, offset_ = 0;
  };

  /// \pre the step is diagonal
  Plane plane(std::size_t step) const { return {planes_[step / 2], columns_, stride_, step}; }

  std::size_t memory() const {
    std::size_t words = 0;
    for (const Words& plane : planes_) words += plane.size();
    return words * sizeof(std::uint64_t);
  }

 private:
  using Words = std::vector<std::uint64_t>;

  /// The cells from which the straight jump in a direction leads to a jump point, line by line.
  /// `stops` is the plane of the direction, in reverse order if `is_reversed`; `free` and the
  /// result are not.
  static Words leads(const Words& stops, const Words& free, std::size_t per_line, std::size_t lines,
                     bool is_reversed) {
    const std::size_t count = lines * per_line;
    Words result(count, 0);
    for (std::size_t line = 1; line + 1 < lines; ++line) {
      // A cell leads to what the next cell leads to, unless the jump stops there: a carry that
      // runs against the jump.
      bool carry = false;
      for (std::size_t i = (line + 1) * per_line; i-- > line * per_line;) {
        const std::size_t at = is_reversed ? count - 1 - i : i;
        std::uint64_t led = stops[i] & (is_reversed ? reversed(free[at]) : free[at]);
        std::uint64_t open = ~stops[i];
        for (int bits = 1; bits < 64; bits *= 2) {
          led |= open & (led >> bits);
          open &= open >> bits | ~(~std::uint64_t{0} >> bits);
        }
        if (carry) led |= open;
        const std::uint64_t leading = led >> 1 | std::uint64_t{carry} << 63;
        result[at] = is_reversed ? reversed(leading) : leading;
        carry = (led & 1u) != 0;
      }
    }
    return result;
  }

  /// Builds the plane of a diagonal step. `free`, `sideways` and `ahead` are stored column by
  /// column: the grid, and the leads of the step's components. `sheared` is working memory.
  void build(const Words& free, const Words& sideways, const Words& ahead, std::size_t step,
             Words& sheared) {
    const Cell d = steps[step];
    const bool is_rising = d.x == d.y;
    const std::size_t per_line = stride_ / 64, count = columns_ * per_line;
    Words& plane = planes_[step / 2];
    plane.assign(count + 1, ~std::uint64_t{0});
    // The bits of column X for the rows of word j.
    const auto column = [&](std::size_t x, std::size_t j) {
      if (x == 0 || x + 1 == columns_) return ~std::uint64_t{0};
      const std::size_t i = x * per_line + j, beside = d.x > 0 ? i - per_line : i + per_line;
      const std::uint64_t before = d.y > 0 ? free[i] << 1 | (j > 0 ? free[i - 1] >> 63 : 0)
                                           : free[i] >> 1 | free[i + 1] << 63;
      const std::uint64_t allowed = free[i] & free[beside] & before;
      return ~allowed | sideways[i] | ahead[i];
    };
    for (std::size_t j = 0; j < per_line; ++j) {
      for (std::size_t x = 0; x < columns_; ++x) {
        sheared[x] = column(is_rising ? x : columns_ - 1 - x, j);
      }
      for (std::size_t i = 0; i < 63; ++i) sheared[columns_ + i] = sheared[i % columns_];
      // Bit k moves from word X + k to word X, by powers of two.
      for (std::size_t shift = 32; shift > 0; shift /= 2) {
        const std::uint64_t moved = bits_with(shift);
        for (std::size_t i = 0; i < columns_ + shift - 1; ++i) {
          sheared[i] ^= (sheared[i] ^ sheared[i + shift]) & moved;
        }
      }
      std::size_t line = (columns_ - 64 * j % columns_) % columns_;
      for (std::size_t x = 0; x < columns_; ++x) {
        const std::size_t i = line * per_line + j;
        plane[step < 4 ? i : count - 1 - i] = step < 4 ? sheared[x] : reversed(sheared[x]);
        if (++line == columns_) line = 0;
      }
    }
  }

  /// The positions in a word whose number has the bit `shift`.
  static constexpr std::uint64_t bits_with(std::size_t shift) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < 64; ++i) bits |= std::uint64_t{(i & shift) != 0} << i;
    return bits;
  }

  std::size_t columns_;  // with the frame
  std::size_t stride_;
  std::array<Words, 4> planes_;  // north-east, north-west, south-west, south-east
};

}  // namespace tutavia::detail
