// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tutavia/search/linked_query.hpp"

/// \file
/// Heuristics on grids.

namespace tutavia {

/// How a search estimates the cost from a cell to the goal. On eight-connected grids octile,
/// Euclidean and Chebyshev distance never exceed it (they are admissible, in this order of
/// strength); Manhattan distance does, by a factor of up to sqrt(2), and so gives paths up to that
/// much longer. On four-connected grids all are admissible and Manhattan distance is the strongest.
enum class Heuristic { octile, euclidean, chebyshev, manhattan };

/// The estimate for a linked goal: distance to the cell nearest to it, plus the least that any of
/// its links adds to that.
inline Cost estimated_cost(Heuristic heuristic, const LinkedQuery& linked, Cell from) {
  const auto distance = [heuristic](Cell a, Cell b) -> Cost {
    const Cost dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
    switch (heuristic) {
      case Heuristic::euclidean:
        return static_cast<Cost>(std::floor(static_cast<double>(straight_cost) *
                                            std::sqrt(static_cast<double>(dx * dx + dy * dy))));
      case Heuristic::chebyshev:
        return straight_cost * std::max(dx, dy);
      case Heuristic::manhattan:
        return straight_cost * (dx + dy);
      case Heuristic::octile:
        break;
    }
    return octile_cost(a, b);
  };
  Cost offset = 0;
  for (const auto& [cell, cost] : linked.goals) {
    offset = std::min(offset, cost - distance(cell, linked.goal_cell));
  }
  return std::max(Cost{0}, distance(from, linked.goal_cell) + offset);
}

}  // namespace tutavia
