// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/theta_search.hpp"
#include "tutavia/search/node_placement.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Theta*: any-angle path planning on a grid.

namespace tutavia {

/// Theta*: A* in which the parent of a cell may be any cell with a line of sight to it. Paths bend
/// by any angle, at cell centres or at corners of cells.
///
/// Complete on the grid, and deterministic. Its path is not the shortest any-angle path, and may
/// even be longer than that of A* (in practice it is within 1 % of the optimum). Expanded cells
/// stay closed. Errors: `invalid_option` for corners on any space but a CellSpace of safety radius
/// 0; others as for AStar.
///
/// Source: Nash, Daniel, Koenig and Felner 2007, "Theta*: any-angle path planning on grids".
///
/// Example: examples/searches_on_cells.cpp.
struct ThetaStar {
  static constexpr std::string_view name = "theta_star";
  using Scratch = detail::ThetaScratch;

  NodePlacement nodes = NodePlacement::cell_centre;

  template <LineOfSightSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    return detail::theta_search<detail::SightTest::at_once>(space, query, nodes, scratch, observer);
  }
};

}  // namespace tutavia
