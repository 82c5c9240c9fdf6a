// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/heuristic.hpp"

/// \file
/// Estimates of the cost from a cell to a goal linked to the grid.

namespace tutavia::detail {

/// The estimate for a linked goal: distance to the cell nearest to the goal, plus the least offset
/// that any of its links adds to that, if negative.
class GoalEstimate {
 public:
  GoalEstimate(HeuristicKind heuristic, const GridQuery& linked)
      : heuristic_(heuristic), goal_(linked.goal_cell) {
    for (const auto& [cell, cost] : linked.goals) {
      offset_ = std::min(offset_, cost - distance(cell));
    }
  }

  Cost operator()(Cell from) const { return std::max(Cost{0}, distance(from) + offset_); }

 private:
  Cost distance(Cell from) const {
    const Cost dx = std::abs(from.x - goal_.x), dy = std::abs(from.y - goal_.y);
    switch (heuristic_) {
      case HeuristicKind::euclidean:
        return static_cast<Cost>(std::floor(static_cast<double>(straight_cost) *
                                            std::sqrt(static_cast<double>(dx * dx + dy * dy))));
      case HeuristicKind::chebyshev:
        return straight_cost * std::max(dx, dy);
      case HeuristicKind::manhattan:
        return straight_cost * (dx + dy);
      case HeuristicKind::octile:
        break;
    }
    return octile_cost(from, goal_);
  }

  HeuristicKind heuristic_;
  Cell goal_;
  Cost offset_ = 0;
};

/// The heuristic of Dijkstra's algorithm.
struct ZeroHeuristic {
  ZeroHeuristic() = default;
  explicit ZeroHeuristic(const GridQuery&) {}

  /// Buckets are narrower than a straight step, so no cell is expanded twice.
  static constexpr int bucket_shift = 13;
  Cost operator()(Cell) const { return 0; }
};

/// Octile distance to a cell, plus `offset` (see GridQuery); consistent.
struct OctileHeuristic {
  OctileHeuristic() = default;
  OctileHeuristic(Cell to, Cost add) : goal(to), offset(add) {}
  explicit OctileHeuristic(const GridQuery& linked)
      : OctileHeuristic(linked.goal_cell, linked.goal_offset) {}

  /// A step raises f by at most two diagonals, which is within 63 buckets.
  static constexpr int bucket_shift = 10;
  Cell goal{};
  Cost offset = 0;
  Cost operator()(Cell cell) const { return std::max(Cost{0}, octile_cost(cell, goal) + offset); }
};

}  // namespace tutavia::detail
