// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/search/best_first.hpp"
#include "tutavia/search/query.hpp"
#include "tutavia/search/route.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// GridGraph: a grid with a query's start and goal joined to it.

namespace tutavia {

/// The graph of a grid's free cells (node = cell index) and two more nodes for start and goal,
/// which are linked to the cells around them. Link costs are rounded up to whole cost units.
template <GridSpace S>
class GridGraph {
 public:
  GridGraph(const S& space, const Query& query, const Links& start_links, const Links& goal_links)
      : space_(space),
        grid_(space.grid()),
        query_(query),
        start_links_(start_links),
        goal_links_(goal_links),
        goal_cell_(Frame(space.frame()).nearest_cell(query.goal)) {}

  std::size_t size() const { return grid_.index_count() + 2; }
  NodeId source() const { return static_cast<NodeId>(grid_.index_count()); }
  NodeId target() const { return source() + 1; }

  Point point(NodeId node) const {
    if (node == source()) return query_.start;
    if (node == target()) return query_.goal;
    return Frame(space_.frame()).point(grid_.cell(node));
  }

  template <class Visit>
  void for_each_successor(NodeId node, Visit visit) const {
    if (node == source()) {
      for (const Link& link : start_links_) visit(id(link.cell), cost(link));
      return;
    }
    const Cell cell = grid_.cell(node);
    for (std::size_t step = 0; step < steps.size(); ++step) {
      if (grid_.can_step(cell, step, space_.movement())) {
        visit(id(cell + steps[step]), step_cost(step));
      }
    }
    if (octile_cost(cell, goal_cell_) > 2 * diagonal_cost) return;  // links are short
    for (const Link& link : goal_links_) {
      if (link.cell == cell) visit(target(), cost(link));
    }
  }

  /// A consistent estimate of the cost to the goal: octile distance to the cell nearest to it, plus
  /// the least that any of its links adds to that (which may be negative).
  auto octile_heuristic() const {
    Cost offset = std::numeric_limits<Cost>::max();
    for (const Link& link : goal_links_) {
      offset = std::min(offset, cost(link) - octile_cost(link.cell, goal_cell_));
    }
    return [this, offset](NodeId node) -> Cost {
      if (node >= source()) return 0;
      return std::max(Cost{0}, octile_cost(grid_.cell(node), goal_cell_) + offset);
    };
  }

  /// The path that a finished search left in its labels, one piece per step. A cell that coincides
  /// with the start or the goal gives way to it.
  Curve path(BestFirstScratch& scratch) const {
    std::vector<Point>& points = scratch.points();
    points.assign(1, query_.goal);
    NodeId node = scratch.find(target())->parent;
    if (cost_to_target(node) == 0) node = scratch.find(node)->parent;
    while (node != source()) {
      const BestFirstScratch::Label& label = *scratch.find(node);
      const bool coincides = label.parent == source() && label.g == 0;
      if (!coincides) points.push_back(point(node));
      node = label.parent;
    }
    points.push_back(query_.start);
    std::reverse(points.begin(), points.end());
    return Curve::polyline(points);
  }

 private:
  NodeId id(Cell cell) const { return static_cast<NodeId>(grid_.index(cell)); }

  Cost cost(const Link& link) const {
    return static_cast<Cost>(std::ceil(link.length / Frame(space_.frame()).resolution *
                                       static_cast<double>(straight_cost)));
  }

  Cost cost_to_target(NodeId node) const {
    for (const Link& link : goal_links_) {
      if (id(link.cell) == node) return cost(link);
    }
    return -1;
  }

  const S& space_;
  const OccupancyGrid& grid_;
  const Query& query_;
  const Links& start_links_;
  const Links& goal_links_;
  Cell goal_cell_;
};

/// What every search on a grid does around its core. The straight segment from start to goal is
/// tried first; else both are linked to the grid and `run(graph, stats)` searches it, leaving the
/// path in `scratch` or returning what stopped it.
///
/// Errors: those of `check_query`; `start_blocked` and `goal_blocked` also where no cell around the
/// point can be reached from it; `unreachable_at_resolution`; what the budget says.
template <GridSpace S, class Run>
Expected<Route, Failure> search_grid(const S& space, const Query& query, BestFirstScratch& scratch,
                                     Run run) {
  if (auto failure = check_query(space, query)) return Unexpected{std::move(*failure)};
  Route route;
  if (space.segment_free(query.start, query.goal)) {
    route.curve.push_back(Segment{query.start, query.goal});
    route.cost = route.curve.length();
    return route;
  }
  const Links start_links = space.links(query.start), goal_links = space.links(query.goal);
  if (start_links.empty()) {
    return fail(PlanError::start_blocked, "the start has no link to the grid at this resolution");
  }
  if (goal_links.empty()) {
    return fail(PlanError::goal_blocked, "the goal has no link to the grid at this resolution");
  }
  const GridGraph<S> graph(space, query, start_links, goal_links);
  if (const std::optional<PlanError> stopped = run(graph, route.stats)) {
    Failure failure;
    failure.code =
        *stopped == PlanError::unreachable ? PlanError::unreachable_at_resolution : *stopped;
    if (*stopped == PlanError::unreachable) {
      failure.detail = "no path on the grid at resolution " +
                       std::to_string(Frame(space.frame()).resolution) + " m";
    } else if (*stopped == PlanError::budget_exhausted) {
      failure.detail =
          "search stopped after " + std::to_string(route.stats.expanded) + " expansions";
    }
    failure.stats = route.stats;
    return Unexpected{std::move(failure)};
  }
  route.curve = graph.path(scratch);
  route.cost = route.curve.length();
  return route;
}

}  // namespace tutavia
