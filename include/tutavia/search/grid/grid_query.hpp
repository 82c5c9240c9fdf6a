// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/core/parts/number_text.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// GridQuery: a query whose start and goal are linked to the cells of a grid.

namespace tutavia::detail {

/// A cost in metres; `straight` is the cost of a straight step.
inline double in_metres(Cost cost, double resolution, Cost straight = straight_cost) {
  return static_cast<double>(cost) * resolution / static_cast<double>(straight);
}

/// A cell to which the start or the goal is linked, and the cost of the link.
struct CellLink {
  Cell cell{};
  Cost cost = 0;
};

/// The links of the start or the goal. The fixed capacity avoids allocation.
class CellLinks {
 public:
  CellLinks() = default;
  /// Converts lengths to cost units, rounded up.
  CellLinks(const EndpointLinks& links, double resolution) {
    for (const EndpointLink& link : links) {
      links_[size_++] = {
          link.cell, static_cast<Cost>(
                         std::ceil(link.length / resolution * static_cast<double>(straight_cost)))};
    }
  }

  std::size_t size() const { return size_; }
  const CellLink* data() const { return links_.data(); }
  const CellLink* begin() const { return links_.data(); }
  const CellLink* end() const { return links_.data() + size_; }

  /// Whether the point is the reference point of a cell.
  bool is_cell() const { return size_ == 1 && links_[0].cost == 0; }
  /// The cost of the link to a cell, if there is one.
  std::optional<Cost> cost_of(Cell cell) const {
    for (const CellLink& link : *this) {
      if (link.cell == cell) return link.cost;
    }
    return std::nullopt;
  }

 private:
  std::array<CellLink, EndpointLinks::capacity> links_{};
  std::size_t size_ = 0;
};

/// Start and goal of a query, linked to a grid.
struct GridQuery {
  CellLinks starts;
  CellLinks goals;
  Cell start_cell{};  ///< starts lie no more than one step from it
  Cell goal_cell{};   ///< goals lie no more than one step from it

  /// Octile distance to `goal_cell` plus this offset is a consistent estimate of the cost to the
  /// goal. The offset is the least cost of a goal link minus the octile distance of its cell from
  /// `goal_cell`; it may be negative.
  Cost goal_offset = 0;
  /// Whether the straight segment between start and goal is free and is the answer.
  bool is_straight = false;

  GridQuery reversed() const {
    GridQuery result{goals, starts, goal_cell, start_cell};
    result.goal_offset = least_offset(starts, start_cell);
    return result;
  }

  /// Whether a cell is `goal_cell` or next to it; only these can have a link to the goal.
  bool near_goal(Cell cell) const {
    const Cell d = cell - goal_cell;
    return -1 <= d.x && d.x <= 1 && -1 <= d.y && d.y <= 1;
  }

  /// Cost of leaving the grid from a cell to the goal, if it has a link.
  std::optional<Cost> exit_cost(Cell cell) const {
    if (!near_goal(cell)) return std::nullopt;
    return goals.cost_of(cell);
  }

  static Cost least_offset(const CellLinks& goals, Cell goal_cell) {
    Cost offset = std::numeric_limits<Cost>::max();
    for (const auto& [cell, cost] : goals) {
      offset = std::min(offset, cost - octile_cost(cell, goal_cell));
    }
    return offset;
  }
};

/// Appends a cell to a path that keeps only turns. A repeated cell is ignored, and a cell in line
/// with the last two replaces the last.
inline void append_cell(std::vector<Cell>& cells, Cell cell) {
  if (!cells.empty() && cells.back() == cell) return;
  if (cells.size() >= 2) {
    const Cell a = cells[cells.size() - 2], b = cells.back();
    const auto sign = [](int v) { return (v > 0) - (v < 0); };
    const Cell before = b - a, after = cell - b;
    if (sign(before.x) == sign(after.x) && sign(before.y) == sign(after.y) &&
        std::int64_t{before.x} * after.y == std::int64_t{before.y} * after.x) {
      cells.back() = cell;
      return;
    }
  }
  cells.push_back(cell);
}

/// Whether a free straight segment between start and goal, if one is off the grid, is the answer.
enum class StraightSegment { tried_first, ignored };

/// The failure for a free start (or goal) that has no link to the grid.
inline Unexpected<Failure> no_link(bool is_start) {
  return fail(PlanError::unreachable_at_resolution,
              std::string(is_start ? "the start" : "the goal")
                  .append(" is free, but no node of the grid near it can be reached from it in a "
                          "straight line; a finer resolution or TangentGraph may find a path"));
}

/// Links start and goal to the grid. Errors: those of `check_query`; `unreachable_at_resolution` if
/// no node near one of them can be reached from it, unless the straight segment is the answer.
template <LinkedSpace S>
Expected<GridQuery, Failure> link_to_grid(const S& space, const Query& query,
                                          StraightSegment straight) {
  if (auto valid = check_query(space, query); !valid) return std::move(valid).unexpected();
  const Frame& frame = space.frame();
  const EndpointLinks starts = space.links(query.start), goals = space.links(query.goal);
  GridQuery linked{{starts, frame.resolution},
                   {goals, frame.resolution},
                   starts.centre().value_or(frame.nearest_cell(query.start)),
                   goals.centre().value_or(frame.nearest_cell(query.goal))};
  const bool on_grid = linked.starts.is_cell() && linked.goals.is_cell();
  const bool tries_straight = straight == StraightSegment::tried_first && !on_grid;
  if (tries_straight && space.segment_free(query.start, query.goal)) {
    linked.is_straight = true;
    return linked;
  }
  if (linked.starts.size() == 0) return no_link(true);
  if (linked.goals.size() == 0) return no_link(false);
  linked.goal_offset = GridQuery::least_offset(linked.goals, linked.goal_cell);
  return linked;
}

/// Completes the failure of a search on a grid.
inline Failure grid_failure(Failure failure, const Statistics& stats, double resolution) {
  if (failure.code == PlanError::unreachable) {
    failure.code = PlanError::unreachable_at_resolution;
    failure.detail = "no path on the grid at resolution " + number_text(resolution) +
                     " m; a finer one or TangentGraph may find one";
  } else if (failure.code == PlanError::budget_exhausted) {
    failure.detail = "search stopped after " + std::to_string(stats.expanded) + " expansions";
  }
  failure.stats = stats;
  return failure;
}

/// The polyline from start to goal through `cells`, which are ordered from the goal's cell back to
/// the start's. A cell at the position of the start or the goal is left out.
inline Curve path_through(std::span<const Cell> cells, const GridQuery& linked, const Query& query,
                          const Frame& frame) {
  auto first = cells.rbegin(), last = cells.rend();
  if (first != last && linked.starts.cost_of(*first) == Cost{0}) ++first;
  if (first != last && linked.goals.cost_of(cells.front()) == Cost{0}) --last;
  Curve path;
  path.reserve(cells.size() + 1);
  Point previous = query.start;
  const auto go = [&](const Point& p) {
    path.push_back(Segment{previous, p});
    previous = p;
  };
  for (; first != last; ++first) go(frame.point(*first));
  if (previous != query.goal || path.empty()) go(query.goal);
  return path;
}

}  // namespace tutavia::detail
