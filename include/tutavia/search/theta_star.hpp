// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/theta_search.hpp"
#include "tutavia/search/node_placement.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Theta*: A* on a grid whose paths leave the grid's directions.

namespace tutavia {

/// Theta*: A* in which a cell's parent may be any cell that sees it, so that paths turn by any
/// angle, at cell centres or at corners of cells.
///
/// Complete on the grid, and deterministic; not a shortest any-angle path, nor always shorter than
/// A*'s (in practice within 1 % of the optimum). Cells are closed when they are expanded. Errors as
/// for AStar, and `invalid_option` for corners on anything but cells at safety radius 0. Source:
/// Nash, Daniel, Koenig and Felner 2007, "Theta*: any-angle path planning on grids".
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
