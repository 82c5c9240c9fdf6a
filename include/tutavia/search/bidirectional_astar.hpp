// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/search/grid/bidirectional_search.hpp"
#include "tutavia/search/grid/search_grid.hpp"

/// \file
/// Bidirectional A*: A* from the start and from the goal at once.

namespace tutavia {

/// A* from both ends at once. Each search has its own consistent heuristic, and the one with fewer
/// open cells expands next. Stops when the larger of the two smallest keys reaches the cost of the
/// best meeting found: one search has then expanded every cell that a shorter path could pass. (The
/// sum of the two keys gives no such bound.) Guarantees and errors as for AStar.
///
/// Source: Pohl 1971, "Bi-directional search" (which search expands next).
///
/// Example: examples/searches_on_cells.cpp.
struct BidirectionalAStar {
  static constexpr std::string_view name = "bidirectional_astar";
  using Scratch = detail::BidirectionalScratch;

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    return detail::search_grid(space, query, observer, detail::BidirectionalSearch{scratch});
  }
};

}  // namespace tutavia
