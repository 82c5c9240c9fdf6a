// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "tutavia/geometry/point.hpp"
#include "tutavia/grid/cell.hpp"

/// \file
/// What an any-angle search asks of a decomposition of free space.

namespace tutavia::detail {

/// A decomposition of the free cells of a grid into convex pieces with numbers. Corners (x, y) are
/// those of cells, the lower left one of cell (x, y).
///
/// `open(piece)` gives what is to be known of a piece before its sides are asked for; two
/// numbers name one piece where they are equal in that. `for_each_exit(opened, visit)` calls
/// `visit(right, left, beyond)` for every side that a piece shares with another, `beyond`: the
/// corners at its ends as seen from within. `for_each_near(cell, visit)` calls `visit(piece)` for
/// every piece that touches a cell, and perhaps for others. `holds(piece, p, place)` says whether a
/// point lies in a piece or on its border, where `place(corner)` is the place of a corner.
template <class P>
concept ConvexPieces = requires(const P& pieces, std::uint32_t piece, Cell cell, const Point& p,
                                Point (*place)(Cell), void (*visit)(std::uint32_t),
                                void (*visit_exit)(Cell, Cell, std::uint32_t)) {
  { pieces.open(piece) } -> std::equality_comparable;
  pieces.for_each_exit(pieces.open(piece), visit_exit);
  pieces.for_each_near(cell, visit);
  { pieces.holds(piece, p, place) } -> std::same_as<bool>;
};

/// Pieces of which it is known where they lead: `is_dead_end(piece)` says whether only paths that
/// begin or end in a piece, or in dead ends behind it, need it; `way_out(piece)` is the neighbour
/// that leads out of a dead end, or the piece itself where there is none; all dead ends have
/// numbers less than `dead_end_limit()`.
template <class P>
concept PiecesWithDeadEnds = ConvexPieces<P> && requires(const P& pieces, std::uint32_t piece) {
  { pieces.is_dead_end(piece) } -> std::same_as<bool>;
  { pieces.way_out(piece) } -> std::same_as<std::uint32_t>;
  { pieces.dead_end_limit() } -> std::same_as<std::size_t>;
};

}  // namespace tutavia::detail
