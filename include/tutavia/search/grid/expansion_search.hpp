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
/// One wave from start to goal: A* and Dijkstra's algorithm, canonical or not.

namespace tutavia::detail {

/// Memory of the searches that are one wave.
struct ExpansionScratch {
  GridExpansionScratch wave;
  std::vector<Cell> cells;
};

/// The cells at which the path to `cell` turns, from there back to the seed it came from, both
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

/// A search that is one wave, from the start's links to the goal's. It stops when no cell can lead
/// to a cheaper path than the best one found.
template <SuccessorRule Successors, BucketHeuristic Heuristic>
struct ExpansionSearch {
  ExpansionScratch& scratch;

  template <GridSpace S, Observer O>
  Expected<GridPath, Failure> run(const GridQuery& linked, SearchContext<S, O>& context) const {
    GridExpansion<Successors, Heuristic, S, O> wave(context, Heuristic(linked), linked.starts,
                                                    scratch.wave);
    Cost best = std::numeric_limits<Cost>::max();
    Cell end;
    typename decltype(wave)::Popped popped;
    while (wave.pop(best, popped)) {
      if (linked.near_goal(popped.cell)) {
        if (const auto exit = linked.exit_cost(popped.cell); exit && popped.g + *exit < best) {
          best = popped.g + *exit;
          end = popped.cell;
          if (best <= wave.f(popped)) continue;
        }
      }
      if (auto within = context.check_budget(); !within) return std::move(within).unexpected();
      wave.expand(popped);
    }
    if (best == std::numeric_limits<Cost>::max()) return fail(PlanError::unreachable);
    scratch.cells.clear();
    trace(context.space.grid(), wave.labels(), end, scratch.cells);
    return GridPath{scratch.cells};
  }
};

}  // namespace tutavia::detail
