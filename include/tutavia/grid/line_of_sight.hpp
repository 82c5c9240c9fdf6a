// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "tutavia/grid/bitboard/bits.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// Lines of sight between cell centres and between corners of cells, in integer arithmetic.

namespace tutavia {

namespace detail {

/// Whether `count` consecutive cells from index `first` are free.
inline bool run_is_free(const std::uint64_t* words, std::size_t first, std::uint32_t count) {
  constexpr std::uint32_t most = loaded_bits;
  for (; count > most; count -= most, first += loaded_bits) {
    if ((~load_bits(words, first) & ((std::uint64_t{1} << most) - 1)) != 0) return false;
  }
  return (~load_bits(words, first) & ((std::uint64_t{1} << count) - 1)) == 0;
}

}  // namespace detail

/// Whether all cells are free that the segment between the centres of two cells touches (its
/// supercover, including both cells beside every corner it passes through).
///
/// Exact, with one look-up per row and 57 cells: the segment leaves row k at the column
/// (dx (2 k + 1) + dy) / (2 dy), whose remainder tells whether it leaves through a corner.
/// \pre both cells lie in the grid
inline bool line_of_sight(const OccupancyGrid::View& grid, Cell a, Cell b) {
  if (a.y > b.y) std::swap(a, b);
  // Below 2^30 each, so sums of four fit.
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

/// The same; uses the grid's transpose if the segment crosses more rows than columns.
inline bool line_of_sight(const OccupancyGrid::View& rows, const OccupancyGrid::View& columns,
                          Cell a, Cell b) {
  const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  return steep ? line_of_sight(columns, {a.y, a.x}, {b.y, b.x}) : line_of_sight(rows, a, b);
}

namespace detail {

/// Whether the segment between two corners in one row is free: every unit of it borders a free
/// cell, and every two consecutive units border free cells on the same side.
inline bool edge_is_free(const OccupancyGrid::View& grid, Cell a, Cell b) {
  if (a.x > b.x) std::swap(a, b);
  const std::size_t above = grid.index(a), below = grid.index({a.x, a.y - 1});
  constexpr auto most = static_cast<int>(loaded_bits);
  const int units = b.x - a.x;
  for (int first = 0; first == 0 || first + 1 < units; first += most - 1) {
    const int count = std::min(units - first, most);
    const auto from = static_cast<std::size_t>(first);
    const std::uint64_t up = load_bits(grid.words, above + from);
    const std::uint64_t down = load_bits(grid.words, below + from);
    const std::uint64_t on = (up & up >> 1) | (down & down >> 1);
    if ((~(up | down) & ((std::uint64_t{1} << count) - 1)) != 0) return false;
    if ((~on & ((std::uint64_t{1} << (count - 1)) - 1)) != 0) return false;
  }
  return true;
}

/// Whether the segment between two corners in different rows is free; see `corner_line_of_sight`.
inline bool corners_in_sight(const OccupancyGrid::View& grid, Cell a, Cell b) {
  if (a.y > b.y) std::swap(a, b);
  const auto across = static_cast<std::uint32_t>(std::abs(b.x - a.x));
  const auto rows = static_cast<std::uint32_t>(b.y - a.y);
  const bool right = b.x >= a.x;
  std::size_t row = grid.index({0, a.y}) + static_cast<std::size_t>(a.x);
  const std::uint32_t whole = across / rows, part = across % rows;
  std::uint32_t in = 0, rest = 0;  // column and remainder where it enters the row
  for (std::uint32_t k = 0; k < rows; ++k, row += grid.stride) {
    std::uint32_t out = in + whole;
    const std::uint32_t before = rest;
    rest += part;
    if (rest >= rows) ++out, rest -= rows;
    // Its interior meets the cells from `in` to `last`; to the left, cell i lies left of corner i.
    const std::uint32_t last = rest == 0 ? out - 1 : out;
    if (!run_is_free(grid.words, right ? row + in : row - last - 1, last - in + 1)) return false;
    if (before == 0 && k > 0) {  // at a corner, one of the two cells beside it must be free
      const std::size_t ahead = right ? row + in - 1 : row - in;
      const std::size_t behind = (right ? row + in : row - in - 1) - grid.stride;
      if (!grid.is_free(ahead) && !grid.is_free(behind)) return false;
    }
    in = out;
  }
  return true;
}

/// Whether the segment between two corners of cells is free for a point robot. It may not cross the
/// interior of a blocked cell, run between two that share a side, or pass a corner (other than its
/// ends) where two touch. It may slide along blocked cells and touch their corners.
///
/// Exact. Rules of the Grid-Based Path Planning Competition 2014.
/// \pre both are corners of cells of the grid; `columns` is its transpose
inline bool corner_line_of_sight(const OccupancyGrid::View& rows,
                                 const OccupancyGrid::View& columns, Cell a, Cell b) {
  const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  const OccupancyGrid::View& grid = steep ? columns : rows;
  if (steep) {
    a = {a.y, a.x};
    b = {b.y, b.x};
  }
  if (a == b) return true;
  return a.y == b.y ? edge_is_free(grid, a, b) : corners_in_sight(grid, a, b);
}

}  // namespace detail

}  // namespace tutavia
