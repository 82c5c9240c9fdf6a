// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "tutavia/grid/bits.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// Lines of sight between cell centres, in integers.

namespace tutavia {

namespace detail {

/// Whether `count` cells from an index on are free.
inline bool run_is_free(const std::uint64_t* words, std::size_t first, std::uint32_t count) {
  constexpr std::uint32_t most = loaded_bits;
  for (; count > most; count -= most, first += loaded_bits) {
    if ((~load_bits(words, first) & ((std::uint64_t{1} << most) - 1)) != 0) return false;
  }
  return (~load_bits(words, first) & ((std::uint64_t{1} << count) - 1)) == 0;
}

}  // namespace detail

/// Whether all cells that the segment between the centres of two cells touches are free: its
/// supercover, with both cells beside every corner it passes through.
///
/// Exact, and one look-up per row for up to 57 cells of it: the segment leaves row k at the column
/// (dx (2 k + 1) + dy) / (2 dy), whose remainder says whether it leaves through a corner.
/// \pre both cells lie in the grid
inline bool line_of_sight(const OccupancyGrid::View& grid, Cell a, Cell b) {
  if (a.y > b.y) std::swap(a, b);
  // Below 2^30 each, so that sums of four fit.
  const auto across = static_cast<std::uint32_t>(std::abs(b.x - a.x));
  const auto rows = static_cast<std::uint32_t>(b.y - a.y);
  const bool right = b.x >= a.x;
  std::size_t row = grid.index({0, a.y}) + static_cast<std::size_t>(a.x);
  const auto is_free = [&](std::uint32_t from, std::uint32_t to) {
    return detail::run_is_free(grid.words, right ? row + from : row - to, to - from + 1);
  };
  if (rows == 0) return is_free(0, across);
  std::uint32_t in = 0, out = (across + rows) / (2 * rows), rest = (across + rows) % (2 * rows);
  const std::uint32_t whole = across / rows, part = 2 * (across % rows);
  for (std::uint32_t k = 0; k < rows; ++k, row += grid.stride) {
    if (!is_free(in, out)) return false;
    in = out - (rest == 0 ? 1 : 0);
    out += whole;
    rest += part;
    if (rest >= 2 * rows) ++out, rest -= 2 * rows;
  }
  return is_free(in, across);
}

/// The same, with the grid's transpose for lines that cross more rows than columns.
inline bool line_of_sight(const OccupancyGrid::View& rows, const OccupancyGrid::View& columns,
                          Cell a, Cell b) {
  const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  return steep ? line_of_sight(columns, {a.y, a.x}, {b.y, b.x}) : line_of_sight(rows, a, b);
}

}  // namespace tutavia
