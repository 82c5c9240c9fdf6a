// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "tutavia/search/grid/goal_estimate.hpp"
#include "tutavia/search/grid/grid_graph.hpp"
#include "tutavia/search/heuristic.hpp"

/// \file
/// SSA-A*: A* with a heuristic tuned by a salp swarm.

namespace tutavia {

/// A* with the heuristic of `Weights`, which overestimates: fewer expansions for a bounded increase
/// of length. Let C be the least cost in cells and W = max(1, w1 + w2). If cells are re-opened when
/// a cheaper path to them is found, the path costs at most W C + w3 cells. Without re-opening
/// (`reopen`) it costs at most (W + w3 / 2) C + w3 cells; docs/algorithms.md has the proof. On
/// large maps most expansions are of re-opened cells (docs/performance.md): without re-opening the
/// search takes about a quarter of the time on a city map, and its paths are 1 % longer. `tune_ssa`
/// finds weights for a class of maps. Errors: `invalid_option` for a weight that is negative or
/// more than 1000; others as for AStar.
///
/// Source: the SSA-A* paper, equation (1) and algorithm 1, which re-opens; see docs/algorithms.md.
///
/// Example: examples/searches_on_cells.cpp.
struct SsaAStar {
  static constexpr std::string_view name = "ssa_astar";
  using Scratch = detail::GridGraphScratch;

  /// The heuristic, in cells: w1 x Chebyshev distance + w2 x Euclidean distance + w3 x share of
  /// blocked cells among the eight neighbours (cells outside the map count as blocked). The
  /// defaults are close to what `tune_ssa` finds on grids of 20 x 20 cells, with random or
  /// clustered obstacles.
  struct Weights {
    double chebyshev = 1.55;  ///< w1
    double euclidean = 0.85;  ///< w2
    double density = 0.7;     ///< w3
  };

  Weights weights{};
  bool reopen = true;  ///< whether a cell is expanded again when a cheaper path to it is found

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (auto valid = check(weights); !valid) return std::move(valid).unexpected();
    return detail::graph_search(
        space, query, scratch, observer, detail::PlainStepCosts{},
        [&](const detail::GridQuery& linked) {
          return [w = weights, grid = space.grid().view(),
                  chebyshev = detail::GoalEstimate(HeuristicKind::chebyshev, linked),
                  euclidean = detail::GoalEstimate(HeuristicKind::euclidean, linked)](Cell cell) {
            const int free = std::popcount(unsigned{grid.neighbourhood(grid.index(cell))});
            return static_cast<Cost>(w.chebyshev * static_cast<double>(chebyshev(cell)) +
                                     w.euclidean * static_cast<double>(euclidean(cell)) +
                                     w.density * (8 - free) * (straight_cost / 8.0));
          };
        },
        detail::Tracked{reopen ? detail::Reopening::allowed : detail::Reopening::never});
  }

  /// `invalid_option` for weights out of range.
  static Expected<void, Failure> check(const Weights& weights) {
    for (const auto& [weight, option] :
         {std::pair{weights.chebyshev, "chebyshev"}, std::pair{weights.euclidean, "euclidean"},
          std::pair{weights.density, "density"}}) {
      if (weight >= 0 && weight <= 1000) continue;
      return fail(PlanError::invalid_option,
                  std::string("the weight ") + option + " must lie between 0 and 1000");
    }
    return {};
  }
};

}  // namespace tutavia
