// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/search/grid/goal_estimate.hpp"
#include "tutavia/search/grid/grid_graph.hpp"
#include "tutavia/search/heuristic.hpp"

/// \file
/// Weighted A*: fewer expansions for a bounded increase of length.

namespace tutavia {

/// A* with the octile heuristic times `weight`: the path costs at most `weight` times the cheapest
/// one. Cells are re-opened when a cheaper path to them is found. Errors: `invalid_option` for a
/// weight less than 1 or more than 1000; others as for AStar.
///
/// Source: Pohl 1970, "Heuristic search viewed as path finding in a graph".
///
/// Example: examples/searches_on_cells.cpp.
struct WeightedAStar {
  static constexpr std::string_view name = "weighted_astar";
  using Scratch = detail::GridGraphScratch;

  double weight = 1.5;

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (!(weight >= 1 && weight <= 1000)) {
      return fail(PlanError::invalid_option, "weight must lie between 1 and 1000");
    }
    return detail::graph_search(
        space, query, scratch, observer, detail::PlainStepCosts{},
        [this](const detail::GridQuery& linked) {
          return [w = weight,
                  estimate = detail::GoalEstimate(HeuristicKind::octile, linked)](Cell cell) {
            return static_cast<Cost>(w * static_cast<double>(estimate(cell)));
          };
        });
  }
};

}  // namespace tutavia
