// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "tutavia/search/best_first.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid_graph.hpp"

/// \file
/// A*: a cheapest path on a grid, guided by the octile distance.

namespace tutavia {

/// A* with the octile heuristic, which is admissible and consistent under every movement rule.
///
/// Returns a shortest path among the grid's steps and the links of start and goal (to 1.3e-9
/// relative, the rounding of integer costs), or the straight segment where that is free. Ties go to
/// the larger g, then to the earlier label, so the answer is the same everywhere. Complete on the
/// grid: `unreachable_at_resolution` means that the grid has no path. Other errors: see
/// search_grid. Source: Hart, Nilsson and Raphael 1968.
struct AStar {
  static constexpr std::string_view name = "astar";
  using Scratch = BestFirstScratch;

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    return search_grid(space, query, scratch, [&](const auto& graph, Statistics& stats) {
      return best_first(graph, graph.octile_heuristic(), scratch, query.budget, observer, stats);
    });
  }
};

}  // namespace tutavia
