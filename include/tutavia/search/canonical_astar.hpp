// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/search/grid/expansion_search.hpp"
#include "tutavia/search/grid/goal_estimate.hpp"

/// \file
/// Canonical A*: A* that generates each of many equal paths once.

namespace tutavia {

/// A* that follows only canonical successors: of the equal paths between two cells the one with its
/// diagonal steps first. Same answers as A* in length, for far fewer generated cells. Guarantees
/// and errors as for AStar. Source: Sturtevant and Rabin 2016, "Canonical orderings on grids".
struct CanonicalAStar {
  static constexpr std::string_view name = "canonical_astar";
  using Scratch = detail::ExpansionScratch;

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    const detail::ExpansionSearch<detail::SuccessorRule::canonical, detail::OctileHeuristic> wave{
        scratch};
    return detail::search_grid(space, query, observer, wave);
  }
};

}  // namespace tutavia
