// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>

#include "tutavia/grid/cell_costs.hpp"
#include "tutavia/search/grid/expansion_search.hpp"
#include "tutavia/search/grid/goal_estimate.hpp"
#include "tutavia/search/grid/grid_graph.hpp"
#include "tutavia/search/heuristic.hpp"

/// \file
/// A*: a cheapest path on a grid, guided by a heuristic.

namespace tutavia {

namespace detail {

/// Memory of A* and Dijkstra's algorithm: one part for plain searches, one for searches with cell
/// costs or other heuristics.
struct AStarScratch {
  ExpansionScratch expansion;
  GridGraphScratch graph;
};

/// `invalid_option` for cell costs whose size differs from that of the space's grid.
template <GridSpace S>
Expected<void, Failure> check_costs(const S& space, const std::shared_ptr<const CellCosts>& costs) {
  if (costs == nullptr ||
      (costs->width() == space.grid().width() && costs->height() == space.grid().height())) {
    return {};
  }
  return fail(PlanError::invalid_option, "costs must have the size of the space's grid");
}

}  // namespace detail

/// A* with the octile heuristic, which is admissible and consistent under every movement rule.
///
/// Of all paths of equal cost between two cells, the search follows one: that with its diagonal
/// steps first. All others have the same length, and the search generates far fewer cells.
/// `successors` is there for those who want to see every step.
///
/// Returns a shortest path among the grid's steps and the links of start and goal (to 1.3e-9
/// relative, the rounding of integer costs). If start or goal is off the grid and the straight
/// segment between them is free, it returns that segment. With `costs` it returns the path of least
/// traversal cost on the grid and reports that cost in `Route::cost`. The answer is the same on
/// every platform. Complete on the grid: `unreachable_at_resolution` means that the grid has no
/// path.
///
/// Errors: `invalid_option` for costs of another size; those of `search_grid`.
///
/// Source: Hart, Nilsson and Raphael 1968, "A formal basis for the heuristic determination of
/// minimum cost paths"; Sturtevant and Rabin 2016, "Canonical orderings on grids".
///
/// Example: examples/searches_on_cells.cpp.
struct AStar {
  static constexpr std::string_view name = "astar";
  using Scratch = detail::AStarScratch;

  /// Which steps the search follows from a cell. Without effect with `costs`, another heuristic or
  /// in spaces whose nodes have steps of their own: all are followed there.
  enum class Successors {
    canonical,  ///< those of one of many equal paths
    all,
  };

  HeuristicKind heuristic = HeuristicKind::octile;
  Successors successors = Successors::canonical;
  std::shared_ptr<const CellCosts> costs{};  ///< cost factors; null: all cells cost the same

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (auto valid = detail::check_costs(space, costs); !valid) {
      return std::move(valid).unexpected();
    }
    if (costs != nullptr) {
      return detail::graph_search(
          space, query, scratch.graph, observer, *costs, [this](const detail::GridQuery& linked) {
            return [estimate = detail::GoalEstimate(heuristic, linked)](Cell cell) {
              return CellCosts::scale * estimate(cell);
            };
          });
    }
    if (heuristic != HeuristicKind::octile || space.movement() == MovementRule::by_edge) {
      return detail::graph_search(space, query, scratch.graph, observer, detail::PlainStepCosts{},
                                  [this](const detail::GridQuery& linked) {
                                    return detail::GoalEstimate(heuristic, linked);
                                  });
    }
    return successors == Successors::canonical
               ? expand<detail::SuccessorRule::canonical>(space, query, scratch, observer)
               : expand<detail::SuccessorRule::all>(space, query, scratch, observer);
  }

 private:
  template <detail::SuccessorRule Rule, GridSpace S, Observer O>
  static Expected<Route, Failure> expand(const S& space, const Query& query, Scratch& scratch,
                                         O& observer) {
    const detail::ExpansionSearch<Rule, detail::OctileHeuristic> expansion{scratch.expansion};
    return detail::search_grid(space, query, observer, expansion);
  }
};

}  // namespace tutavia
