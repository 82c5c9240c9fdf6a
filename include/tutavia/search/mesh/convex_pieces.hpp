// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "tutavia/geometry/point.hpp"
#include "tutavia/grid/cell.hpp"

/// \file
/// ConvexPieces: decompositions of free space for an any-angle search.

namespace tutavia::detail {

/// A decomposition of the free cells of a grid into numbered convex pieces. Corner (x, y) is the
/// lower left corner of cell (x, y).
///
/// - `open(piece)`: a piece's geometry, needed for its sides; two numbers name the same piece if
///   these are equal
/// - `for_each_exit(opened, visit)`: calls `visit(right, left, beyond)` for every side shared with
///   another piece `beyond`; the corners at its ends are ordered as seen from inside
/// - `for_each_near(cell, visit)`: calls `visit(piece)` for every piece that touches a cell, and
///   possibly for others
/// - `holds(piece, p, position)`: whether a point lies in a piece or on its border;
///   `position(corner)` gives a corner's coordinates
template <class P>
concept ConvexPieces = requires(const P& pieces, std::uint32_t piece, Cell cell, const Point& p,
                                Point (*position)(Cell), void (*visit)(std::uint32_t),
                                void (*visit_exit)(Cell, Cell, std::uint32_t)) {
  { pieces.open(piece) } -> std::equality_comparable;
  pieces.for_each_exit(pieces.open(piece), visit_exit);
  pieces.for_each_near(cell, visit);
  { pieces.holds(piece, p, position) } -> std::same_as<bool>;
};

/// Pieces with known dead ends. `is_dead_end(piece)`: only paths that start or end in the piece, or
/// in dead ends behind it, need it. `exit_of_dead_end(piece)`: the neighbour through which a dead
/// end is left, or the piece itself if there is none. `dead_end_limit()`: all dead ends have
/// smaller numbers.
template <class P>
concept PiecesWithDeadEnds = ConvexPieces<P> && requires(const P& pieces, std::uint32_t piece) {
  { pieces.is_dead_end(piece) } -> std::same_as<bool>;
  { pieces.exit_of_dead_end(piece) } -> std::same_as<std::uint32_t>;
  { pieces.dead_end_limit() } -> std::same_as<std::size_t>;
};

/// Pieces that are rectangles with neighbours above and below, of which those within some columns
/// can be asked for (see FreeRuns).
template <class P>
concept RectangularPieces = ConvexPieces<P> &&
    requires(const P& pieces, std::uint32_t piece, int x,
             void (*visit_exit)(Cell, Cell, std::uint32_t)) {
  pieces.for_each_exit_between(pieces.open(piece), P::Exits::above, x, x, visit_exit);
};

}  // namespace tutavia::detail
