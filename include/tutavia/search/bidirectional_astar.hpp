// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "tutavia/search/grid/expansion_search.hpp"
#include "tutavia/search/grid/goal_estimate.hpp"
#include "tutavia/search/query_checks.hpp"

/// \file
/// Bidirectional A*.

namespace tutavia {

/// A* from both ends at once, each wave with its own consistent heuristic; the wave with the fewer
/// open cells goes next. Stops when the larger of the waves' smallest keys reaches the best meeting
/// found: one wave has then expanded every cell that a shorter path could pass. (The sum of the two
/// keys gives no such bound.) Guarantees and errors as for AStar.
/// Source: Pohl 1971, "Bi-directional search" (which wave goes next).
struct BidirectionalAStar {
  static constexpr std::string_view name = "bidirectional_astar";
  struct Scratch {
    detail::GridWaveScratch forward, backward;
    std::vector<Cell> cells, half;
  };

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    const auto run = [&](const detail::LinkedQuery& there, std::vector<Cell>& cells,
                         Statistics& stats) -> std::optional<Failure> {
      using Wave = detail::GridWave<false, detail::OctileHeuristic, O>;
      const OccupancyGrid& grid = space.grid();
      const detail::LinkedQuery back = there.reversed();
      Wave forward(grid, space.movement(), space.frame(), {there.goal_cell, there.goal_offset},
                   there.starts, scratch.forward, observer);
      Wave backward(grid, space.movement(), space.frame(), {back.goal_cell, back.goal_offset},
                    back.starts, scratch.backward, observer);
      Cost best = std::numeric_limits<Cost>::max();
      std::uint32_t meeting = 0;
      std::optional<Failure> stopped;
      /// Expands one cell of a wave; false when the wave has come to its end.
      const auto advance = [&](Wave& wave, const Wave& other) {
        typename Wave::Popped popped;
        if (!wave.pop(best, popped)) return false;
        if (other.labels().reached(popped.index)) {
          const Cost total = popped.g + other.labels().g(popped.index);
          if (total < best) best = total, meeting = popped.index;
        }
        wave.expand(popped);
        return true;
      };
      while (true) {
        const std::uint64_t expanded = forward.expanded() + backward.expanded();
        if (detail::is_checked(query.budget, expanded)) {
          if (stopped = detail::exceeded(query.budget, expanded); stopped) break;
        }
        const bool go_forward = forward.open_cells() <= backward.open_cells();
        if (!(go_forward ? advance(forward, backward) : advance(backward, forward))) break;
      }
      stats.expanded = forward.expanded() + backward.expanded();
      stats.generated = forward.generated() + backward.generated();
      if (stopped) return stopped;
      if (best == std::numeric_limits<Cost>::max()) return Failure{.code = PlanError::unreachable};
      const Cell middle = grid.cell(meeting);
      detail::trace(grid, backward.labels(), middle, cells);
      std::reverse(cells.begin(), cells.end());
      scratch.half.clear();
      detail::trace(grid, forward.labels(), middle, scratch.half);
      cells.insert(cells.end(), scratch.half.begin() + 1, scratch.half.end());
      return std::nullopt;
    };
    return detail::search_grid(space, query, scratch.cells, run);
  }
};

}  // namespace tutavia
