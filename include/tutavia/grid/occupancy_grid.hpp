// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tutavia/core/error.hpp"
#include "tutavia/grid/cell.hpp"
#include "tutavia/grid/movement.hpp"

/// \file
/// OccupancyGrid: one bit per cell.

namespace tutavia {

/// A width x height grid of free and blocked cells, one bit each in 64-bit words, row by row.
///
/// At least one blocked cell pads every side, so the neighbours of any cell of the grid can be read
/// without a test of bounds. A cell's `index` counts the padding: it addresses label arrays of
/// `index_count()` entries.
class OccupancyGrid {
 public:
  /// No cells at all.
  OccupancyGrid() : OccupancyGrid(0, 0, 1) {}

  /// A grid with every cell blocked. `limit_exceeded` (checked before anything is allocated) for
  /// more than `max_cells` or, with the padding, 2^32 - 64 indices; `invalid_input` for a negative
  /// size.
  static Expected<OccupancyGrid, Failure> blocked(std::int64_t width, std::int64_t height,
                                                  std::int64_t max_cells = std::int64_t{1} << 30) {
    if (width < 0 || height < 0) return fail(PlanError::invalid_input, "grid size is negative");
    constexpr std::int64_t longest = std::int64_t{1} << 30;
    const std::int64_t words = (std::min(width, longest) + 2 + 63) / 64;
    constexpr std::int64_t max_words = (std::int64_t{1} << 26) - 1;  // 32-bit indices
    if (width > longest || height > longest || (height > 0 && width > max_cells / height) ||
        height + 2 > max_words / words) {
      return fail(PlanError::limit_exceeded,
                  "grid of " + std::to_string(width) + " x " + std::to_string(height) +
                      " cells needed, " + std::to_string(max_cells) +
                      " cells and 2^32 - 64 bits of padded rows allowed");
    }
    return OccupancyGrid(static_cast<int>(width), static_cast<int>(height),
                         static_cast<std::size_t>(words));
  }

  int width() const { return width_; }
  int height() const { return height_; }

  bool contains(Cell cell) const {
    return 0 <= cell.x && cell.x < width_ && 0 <= cell.y && cell.y < height_;
  }

  /// \pre the cell lies in the grid or in its one-cell frame, which is blocked
  bool is_free(Cell cell) const { return is_free(index(cell)); }
  bool is_free(std::size_t index) const { return ((bits_[index / 64] >> (index % 64)) & 1u) != 0; }

  /// \pre the cell lies in the grid
  void set(Cell cell, bool free) {
    const std::size_t i = index(cell);
    const std::uint64_t bit = std::uint64_t{1} << (i % 64);
    bits_[i / 64] = free ? bits_[i / 64] | bit : bits_[i / 64] & ~bit;
  }

  std::size_t count_free() const {
    std::size_t count = 0;
    for (const std::uint64_t word : bits_) count += static_cast<std::size_t>(std::popcount(word));
    return count;
  }

  /// Position of a cell in label arrays.
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y + 1) * stride() + static_cast<std::size_t>(cell.x + 1);
  }
  Cell cell(std::size_t index) const {
    return {static_cast<int>(index % stride()) - 1, static_cast<int>(index / stride()) - 1};
  }
  /// One more than the largest index.
  std::size_t index_count() const { return bits_.size() * 64; }
  /// Difference between the indices of a cell and the one above it.
  std::size_t stride() const { return words_per_row_ * 64; }

  /// Whether a robot may step from a free cell of the grid in direction `step` (an index into
  /// `steps`).
  bool can_step(Cell from, std::size_t step, MovementRule rule) const {
    if (!is_free(from + steps[step])) return false;
    if (!is_diagonal(step)) return true;
    if (rule == MovementRule::four_connected) return false;
    if (rule == MovementRule::allow) return true;
    const bool left = is_free(from + steps[(step + 1) % 8]);
    const bool right = is_free(from + steps[step - 1]);
    return rule == MovementRule::no_cut ? left && right : left || right;
  }

 private:
  OccupancyGrid(int width, int height, std::size_t words_per_row)
      : width_(width),
        height_(height),
        words_per_row_(words_per_row),
        bits_(words_per_row * (static_cast<std::size_t>(height) + 2), 0) {}

  int width_;
  int height_;
  std::size_t words_per_row_;
  std::vector<std::uint64_t> bits_;  // 1: free
};

}  // namespace tutavia
