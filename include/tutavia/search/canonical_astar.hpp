// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/search/grid/expansion_search.hpp"
#include "tutavia/search/grid/goal_estimate.hpp"

/// \file
/// Canonical A*: A* that generates only one of many equal paths.

namespace tutavia {

/// A* that follows only canonical successors: of all paths of equal cost between two cells, the one
/// that takes its diagonal steps first. Paths have the same length as those of A*, with far fewer
/// generated cells. Guarantees and errors as for AStar.
///
/// Source: Sturtevant and Rabin 2016, "Canonical orderings on grids".
///
/// Example: examples/searches_on_cells.cpp.
struct CanonicalAStar {
  static constexpr std::string_view name = "canonical_astar";
  using Scratch = detail::ExpansionScratch;

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    const detail::ExpansionSearch<detail::SuccessorRule::canonical, detail::OctileHeuristic>
        expansion{scratch};
    return detail::search_grid(space, query, observer, expansion);
  }
};

}  // namespace tutavia
