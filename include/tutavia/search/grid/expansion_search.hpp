// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "tutavia/search/grid/grid_expansion.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/search_grid.hpp"
#include "tutavia/search/query_checks.hpp"

/// \file
/// ExpansionSearch: one expansion from start to goal, for A* and Dijkstra's algorithm, canonical or
/// not.

namespace tutavia::detail {

/// Memory of searches with one expansion.
struct ExpansionScratch {
  GridExpansionScratch expansion;
  std::vector<Cell> cells;
};

/// The cells at which the path to `cell` turns, from `cell` back to the seed it started from, both
/// included.
inline void trace(const OccupancyGrid& grid, const GridLabels::View& labels, Cell cell,
                  std::vector<Cell>& cells) {
  cells.push_back(cell);
  std::size_t step = labels.arrival(grid.index(cell));
  while (step != no_step) {
    const std::size_t straight = step;
    while (step == straight) {
      cell = cell - steps[step];
      step = labels.arrival(grid.index(cell));
    }
    cells.push_back(cell);
  }
}

/// A search by one expansion from the start's links to the goal's. Stops when no cell can lead to a
/// cheaper path than the best one found. Models GridSearch, so `search_grid` runs it.
template <SuccessorRule Successors, BucketHeuristic Heuristic>
struct ExpansionSearch {
  ExpansionScratch& scratch;

  template <GridSpace S, Observer O>
  Expected<GridPath, Failure> run(const GridQuery& linked, SearchContext<S, O>& context) const {
    GridExpansion<Successors, Heuristic, S, O> expansion(context, Heuristic(linked), linked.starts,
                                                         scratch.expansion);
    Cost best = std::numeric_limits<Cost>::max();
    Cell end;
    typename decltype(expansion)::Popped popped;
    while (expansion.pop(best, popped)) {
      if (linked.near_goal(popped.cell)) {
        if (const auto exit = linked.exit_cost(popped.cell); exit && popped.g + *exit < best) {
          best = popped.g + *exit;
          end = popped.cell;
          if (best <= expansion.f(popped)) continue;
        }
      }
      if (auto within = context.check_budget(); !within) return std::move(within).unexpected();
      expansion.expand(popped);
    }
    if (best == std::numeric_limits<Cost>::max()) return fail(PlanError::unreachable);
    scratch.cells.clear();
    trace(context.space.grid(), expansion.labels(), end, scratch.cells);
    return GridPath{scratch.cells};
  }
};

}  // namespace tutavia::detail
