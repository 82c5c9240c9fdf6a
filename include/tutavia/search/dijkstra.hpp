// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "tutavia/search/best_first.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid_graph.hpp"

/// \file
/// Dijkstra's algorithm: a cheapest path on a grid, found without a heuristic.

namespace tutavia {

/// Dijkstra's algorithm: A* with heuristic 0. Same guarantees, answers of the same length, and more
/// expansions: the yardstick for everything else.
/// Source: Dijkstra 1959, "A note on two problems in connexion with graphs".
struct Dijkstra {
  static constexpr std::string_view name = "dijkstra";
  using Scratch = BestFirstScratch;

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    return search_grid(space, query, scratch, [&](const auto& graph, Statistics& stats) {
      const auto zero = [](NodeId) -> Cost { return 0; };
      return best_first(graph, zero, scratch, query.budget, observer, stats);
    });
  }
};

}  // namespace tutavia
