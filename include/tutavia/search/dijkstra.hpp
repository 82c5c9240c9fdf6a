// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>

#include "tutavia/search/astar.hpp"
#include "tutavia/search/grid/goal_estimate.hpp"

/// \file
/// Dijkstra's algorithm: a cheapest path on a grid, without a heuristic.

namespace tutavia {

/// Dijkstra's algorithm: A* with heuristic 0. Same guarantees and errors and paths of the same
/// length as AStar, with more expansions. For many queries that share one end see FlowField.
///
/// Source: Dijkstra 1959, "A note on two problems in connexion with graphs".
///
/// Example: examples/searches_on_cells.cpp.
struct Dijkstra {
  static constexpr std::string_view name = "dijkstra";
  using Scratch = detail::AStarScratch;

  std::shared_ptr<const CellCosts> costs{};  ///< cost factors; null: all cells cost the same

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (auto valid = detail::check_costs(space, costs); !valid) {
      return std::move(valid).unexpected();
    }
    if (costs != nullptr) {
      return detail::graph_search(space, query, scratch.graph, observer, *costs,
                                  [](const detail::GridQuery&) { return detail::ZeroHeuristic(); });
    }
    if (space.movement() == MovementRule::by_edge) {
      return detail::graph_search(space, query, scratch.graph, observer, detail::PlainStepCosts{},
                                  [](const detail::GridQuery&) { return detail::ZeroHeuristic(); });
    }
    const detail::ExpansionSearch<detail::SuccessorRule::all, detail::ZeroHeuristic> expansion{
        scratch.expansion};
    return detail::search_grid(space, query, observer, expansion);
  }
};

}  // namespace tutavia
