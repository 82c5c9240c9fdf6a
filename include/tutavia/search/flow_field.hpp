// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/search/grid/expansion_search.hpp"
#include "tutavia/search/grid/flow_runs.hpp"
#include "tutavia/search/query_checks.hpp"

/// \file
/// FlowField: shortest paths from every cell to the nearest of several goals.

namespace tutavia {

/// The cost and the first step of a cheapest path from every cell of a grid to the nearest of
/// several goals. Built by Dijkstra's algorithm over the whole map; 8 bytes per cell. Paths are as
/// long as Dijkstra's. Immutable once built. It holds no reference to the space, but its members
/// must be given the space it was built for.
///
/// Example: examples/flow_field.cpp.
class FlowField {
 public:
  /// Errors: those of a query for the goals (no goals: `invalid_input`); `invalid_option` for a
  /// space without a movement rule; those of the budget.
  template <GridSpace S>
  static Expected<FlowField, Failure> build(const S& space, std::span<const Point> goals,
                                            const Budget& budget = {}) {
    if (goals.empty()) return fail(PlanError::invalid_input, "no goals");
    if (auto valid = detail::check_has_rule(space); !valid) return std::move(valid).unexpected();
    FlowField field;
    std::vector<detail::CellLink> seeds;
    for (const Point& goal : goals) {
      if (auto valid = detail::check_endpoint(space, goal, false); !valid) {
        return std::move(valid).unexpected();
      }
      const detail::CellLinks links(space.links(goal), space.frame().resolution);
      if (links.size() == 0) return detail::no_link(false);
      for (const detail::CellLink& link : links) {
        seeds.push_back(link);
        field.ends_.push_back({link, goal});
      }
    }
    detail::FlowRuns runs(space.grid(), space.movement(), seeds, field.labels_);
    if (auto done = runs.run(budget, field.stats_); !done) return std::move(done).unexpected();
    return field;
  }

  /// Whether a goal can be reached from a cell. \pre the cell lies in the grid of the space
  template <GridSpace S>
  bool reached(const S& space, Cell cell) const {
    return labels_.view().reached(space.grid().index(cell));
  }
  /// Length of the shortest path from a cell's reference point to the nearest goal [m]; infinity if
  /// there is none. \pre the cell lies in the grid of the space
  template <GridSpace S>
  double cost(const S& space, Cell cell) const {
    if (!reached(space, cell)) return std::numeric_limits<double>::infinity();
    return detail::in_metres(labels_.view().g(space.grid().index(cell)), space.frame().resolution);
  }

  /// The path from a point to the nearest goal. Errors as for a query.
  template <GridSpace S>
  Expected<Route, Failure> path(const S& space, const Point& start) const {
    if (auto valid = detail::check_endpoint(space, start, true); !valid) {
      return std::move(valid).unexpected();
    }
    const Frame& frame = space.frame();
    const detail::GridLabels::View labels = labels_.view();
    Cost best = std::numeric_limits<Cost>::max();
    Cell first;
    for (const auto& [cell, cost] : detail::CellLinks(space.links(start), frame.resolution)) {
      const std::size_t index = space.grid().index(cell);
      if (!labels.reached(index) || labels.g(index) + cost >= best) continue;
      best = labels.g(index) + cost;
      first = cell;
    }
    if (best == std::numeric_limits<Cost>::max()) {
      return fail(PlanError::unreachable_at_resolution, "no goal can be reached on the grid");
    }
    std::vector<Cell> cells;
    detail::trace(space.grid(), labels, first, cells);
    const Point* goal = nullptr;
    Cost exit = std::numeric_limits<Cost>::max();
    for (const auto& [link, point] : ends_) {
      if (link.cell != cells.back() || link.cost >= exit) continue;
      goal = &point;
      exit = link.cost;
    }
    Route route;
    Point previous = start;
    const auto go = [&](const Point& p) {
      if (p == previous) return;
      route.curve.push_back(Segment{previous, p});
      previous = p;
    };
    for (const Cell cell : cells) go(frame.point(cell));
    go(*goal);
    if (route.curve.empty()) route.curve.push_back(Segment{start, *goal});
    route.cost = route.curve.length();
    return route;
  }

  /// The cell nearest to `p` from which a goal can be reached; empty if there is none. With the
  /// start as the goal, this tells how near to `p` a path from the start can get.
  template <GridSpace S>
  std::optional<Cell> nearest_reached(const S& space, const Point& p) const {
    std::optional<Cell> best;
    double least = std::numeric_limits<double>::infinity();
    for (int y = 0; y < space.grid().height(); ++y) {
      for (int x = 0; x < space.grid().width(); ++x) {
        if (!reached(space, {x, y})) continue;
        const double gap = distance(space.frame().point({x, y}), p);
        if (!(gap < least)) continue;
        best = Cell{x, y};
        least = gap;
      }
    }
    return best;
  }

  const Statistics& stats() const { return stats_; }

 private:
  struct End {
    detail::CellLink link;
    Point goal;
  };

  FlowField() = default;

  detail::GridLabels labels_;
  std::vector<End> ends_;
  Statistics stats_;
};

}  // namespace tutavia
