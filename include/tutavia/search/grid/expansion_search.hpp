// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/search/grid/grid_expansion.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/query_checks.hpp"

/// \file
/// One wave from start to goal: A* and Dijkstra's algorithm, canonical or not.

namespace tutavia::detail {

/// Memory of the searches that are one wave.
struct WaveScratch {
  GridWaveScratch wave;
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

/// Searches from the start's links to the goal's, and stops when no cell can lead to a cheaper
/// path than the best one found. `make_heuristic(linked)` makes the wave's heuristic.
template <bool Canonical, GridSpace S, std::invocable<const LinkedQuery&> MakeHeuristic, Observer O>
Expected<Route, Failure> wave_search(const S& space, const Query& query, WaveScratch& scratch,
                                     O& observer, const MakeHeuristic& make_heuristic) {
  const auto run = [&](const LinkedQuery& linked, std::vector<Cell>& cells,
                       Statistics& stats) -> std::optional<Failure> {
    const OccupancyGrid& grid = space.grid();
    const auto heuristic = make_heuristic(linked);
    GridWave<Canonical, std::decay_t<decltype(heuristic)>, O> wave(
        grid, space.movement(), space.frame(), heuristic, linked.starts, scratch.wave, observer);
    Cost best = std::numeric_limits<Cost>::max();
    Cell end;
    std::optional<Failure> stopped;
    typename decltype(wave)::Popped popped;
    while (wave.pop(best, popped)) {
      if (linked.near_goal(popped.cell)) {
        if (const auto exit = linked.exit_cost(popped.cell); exit && popped.g + *exit < best) {
          best = popped.g + *exit;
          end = popped.cell;
          if (best <= wave.f(popped)) continue;
        }
      }
      if (is_checked(query.budget, wave.expanded())) {
        if (stopped = exceeded(query.budget, wave.expanded()); stopped) break;
      }
      wave.expand(popped);
    }
    stats.expanded = wave.expanded();
    stats.generated = wave.generated();
    if (stopped) return stopped;
    if (best == std::numeric_limits<Cost>::max()) return Failure{.code = PlanError::unreachable};
    trace(grid, wave.labels(), end, cells);
    return std::nullopt;
  };
  return search_grid(space, query, scratch.cells, run);
}

}  // namespace tutavia::detail
