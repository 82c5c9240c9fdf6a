// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tutavia/core/parts/compiler.hpp"
#include "tutavia/grid/bitboard/bits.hpp"
#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/cell.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// OccupancyGrid: a grid of free and blocked cells, one bit each.

namespace tutavia {

class OccupancyGrid;
namespace detail {
OccupancyGrid transposed(const OccupancyGrid& grid);
}  // namespace detail

/// A width x height grid of free and blocked cells, one bit each in 64-bit words, row by row.
/// A set bit is a free cell. (The ROS message nav_msgs/OccupancyGrid is RosMap.)
///
/// At least one blocked cell pads every side, so neighbours are read without bounds checks. A
/// cell's `index` includes the padding: it addresses label arrays of `index_count()` entries.
class OccupancyGrid {
 public:
  /// A grid by value, for inner loops: its members stay in registers whatever the loop writes.
  struct View {
    const std::uint64_t* words;
    std::size_t stride;
    std::uint64_t reciprocal;
    int reciprocal_shift;

    std::size_t index(Cell cell) const {
      return static_cast<std::size_t>(cell.y + 1) * stride + static_cast<std::size_t>(cell.x + 1);
    }
    Cell cell(std::size_t index) const {
      // Rounded up, the reciprocal gives exact quotients for fewer than 2^26 words.
      const auto row = static_cast<std::size_t>((index / 64 * reciprocal) >> reciprocal_shift);
      return {static_cast<int>(index - row * stride) - 1, static_cast<int>(row) - 1};
    }
    bool is_free(std::size_t index) const { return detail::bit_at(words, index); }
    /// The eight neighbours of a cell. \pre the cell lies in the grid
    TUTAVIA_ALWAYS_INLINE detail::Neighbourhood neighbourhood(std::size_t index) const {
      const auto three = [this](std::size_t from) {
        return static_cast<unsigned>(detail::load_bits(words, from) & 7u);
      };
      const unsigned below = three(index - stride - 1), beside = three(index - 1),
                     above = three(index + stride - 1);
      return static_cast<detail::Neighbourhood>(below | (beside & 1u) << 3 | (beside & 4u) << 2 |
                                                above << 5);
    }
  };

  /// A grid without cells.
  OccupancyGrid() : OccupancyGrid(0, 0, 1) {}

  /// Whether the indices of a grid of this size, with the padding, stay below 2^32 - 64.
  static bool fits(std::int64_t width, std::int64_t height) {
    constexpr std::int64_t longest = std::int64_t{1} << 30, max_words = (std::int64_t{1} << 26) - 1;
    if (width > longest || height > longest) return false;
    return height + 2 <= max_words / words_per_row(width);
  }

  /// A grid with every cell blocked. Errors: `limit_exceeded` (checked before any allocation) for
  /// more than `max_cells` or, with the padding, 2^32 - 64 indices; `invalid_input` for a negative
  /// size.
  static Expected<OccupancyGrid, Failure> blocked(std::int64_t width, std::int64_t height,
                                                  std::int64_t max_cells = std::int64_t{1} << 30) {
    if (width < 0 || height < 0) return fail(PlanError::invalid_input, "grid size is negative");
    if (!fits(width, height) || (height > 0 && width > max_cells / height)) {
      return fail(PlanError::limit_exceeded,
                  "grid of " + std::to_string(width) + " x " + std::to_string(height) +
                      " cells needed, " + std::to_string(max_cells) +
                      " cells and 2^32 - 64 bits of padded rows allowed");
    }
    return OccupancyGrid(static_cast<int>(width), static_cast<int>(height),
                         static_cast<std::size_t>(words_per_row(width)));
  }

  View view() const { return {bits_.data(), stride_, reciprocal_, reciprocal_shift_}; }

  int width() const { return width_; }
  int height() const { return height_; }

  bool contains(Cell cell) const {
    return 0 <= cell.x && cell.x < width_ && 0 <= cell.y && cell.y < height_;
  }

  /// \pre the cell lies in the grid or in its one-cell frame, which is blocked
  bool is_free(Cell cell) const { return is_free(index(cell)); }
  bool is_free(std::size_t index) const { return view().is_free(index); }

  /// \pre the cell lies in the grid
  void set(Cell cell, bool free) {
    const std::size_t i = index(cell);
    const std::uint64_t bit = std::uint64_t{1} << (i % 64);
    bits_[i / 64] = free ? bits_[i / 64] | bit : bits_[i / 64] & ~bit;
  }

  /// Sets the cells of row y from column `first` to `last`; those outside the grid are skipped.
  void set_run(int y, int first, int last, bool free) {
    first = std::max(first, 0);
    last = std::min(last, width_ - 1);
    if (y < 0 || y >= height_ || first > last) return;
    const std::size_t begin = index({first, y}), end = index({last, y});
    for (std::size_t word = begin / 64; word <= end / 64; ++word) {
      std::uint64_t mask = ~std::uint64_t{0};
      if (word == begin / 64) mask <<= begin % 64;
      if (word == end / 64) mask &= ~std::uint64_t{0} >> (63 - end % 64);
      bits_[word] = free ? bits_[word] | mask : bits_[word] & ~mask;
    }
  }

  /// Calls `visit(first, last)` for every maximal run of free (or blocked) cells of row y, from
  /// left to right. \pre the row lies in the grid
  template <class Visit>
  void for_each_run(int y, bool free, Visit visit) const {
    for (int first = run_end(y, 0, !free); first < width_;) {
      const int end = run_end(y, first, free);
      visit(first, end - 1);
      first = run_end(y, end, !free);
    }
  }

  /// The first column from x on whose cell is not free (or not blocked), or the width. \pre the row
  /// lies in the grid
  int run_end(int y, int x, bool free) const {
    while (x < width_) {
      const std::uint64_t bits = detail::load_bits(bits_.data(), index({x, y}));
      const int same = std::countr_one(free ? bits : ~bits);
      if (same < static_cast<int>(detail::loaded_bits)) return std::min(x + same, width_);
      x += static_cast<int>(detail::loaded_bits);
    }
    return width_;
  }

  std::size_t count_free() const {
    std::size_t count = 0;
    for (const std::uint64_t word : bits_) count += static_cast<std::size_t>(std::popcount(word));
    return count;
  }

  /// The index of a cell in label arrays.
  std::size_t index(Cell cell) const { return view().index(cell); }
  Cell cell(std::size_t index) const { return view().cell(index); }
  /// One more than the largest index.
  std::size_t index_count() const { return stride_ * (static_cast<std::size_t>(height_) + 2); }
  /// Difference between the indices of a cell and the one above it.
  std::size_t stride() const { return stride_; }

  /// The words of the rows, 64 cells each (1: free); the cell with index i is bit i % 64 of word
  /// i / 64. One spare word of zeros follows the last row.
  const std::vector<std::uint64_t>& words() const { return bits_; }

  /// Whether a robot may step from a free cell of the grid in direction `step` (an index into
  /// `steps`).
  bool can_step(Cell from, std::size_t step, MovementRule rule) const {
    return detail::can_step(view().neighbourhood(index(from)), step, rule);
  }

 private:
  static std::int64_t words_per_row(std::int64_t width) { return (width + 2 + 63) / 64; }

  OccupancyGrid(int width, int height, std::size_t words_per_row)
      : width_(width),
        height_(height),
        stride_(words_per_row * 64),
        reciprocal_shift_(26 + static_cast<int>(std::bit_width(words_per_row))),
        reciprocal_(((std::uint64_t{1} << reciprocal_shift_) + words_per_row - 1) / words_per_row),
        bits_(words_per_row * (static_cast<std::size_t>(height) + 2) + 1, 0) {}

  friend OccupancyGrid detail::transposed(const OccupancyGrid& grid);

  int width_;
  int height_;
  std::size_t stride_;
  int reciprocal_shift_;
  std::uint64_t reciprocal_;
  std::vector<std::uint64_t> bits_;  // 1: free; with a spare word for loads from the last one
};

}  // namespace tutavia
