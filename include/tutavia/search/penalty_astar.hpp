// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>

#include "tutavia/search/grid/goal_estimate.hpp"
#include "tutavia/search/grid/grid_graph.hpp"
#include "tutavia/search/grid/search_grid.hpp"
#include "tutavia/search/grid/step_rule.hpp"
#include "tutavia/search/heuristic.hpp"

/// \file
/// Penalty A*: A* with a cost for turning.

namespace tutavia {

/// A* over cells and headings. Minimises length + `turn_penalty` x total change of heading along
/// the grid's steps. The start has no heading, and turns at the links of start and goal are free. A
/// larger penalty gives longer paths with fewer turns. `Route::cost` is the minimised sum [m].
/// Errors: `invalid_option` for a penalty that is negative or above 1000 m per radian;
/// `limit_exceeded` for grids of more than 2^28 cells; others as for AStar.
///
/// Source: the penalty-based A* with which Abdulshaheed 2025 compares (lambda = 0.4). The paper
/// does not give its formula; see docs/algorithms.md.
///
/// Example: examples/searches_on_cells.cpp.
struct PenaltyAStar {
  static constexpr std::string_view name = "penalty_astar";
  using Scratch = detail::GridGraphScratch;

  double turn_penalty = 0.4;  ///< lambda [m per radian]

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (!(turn_penalty >= 0 && turn_penalty <= 1000)) {
      return fail(PlanError::invalid_option, "turn_penalty must lie between 0 and 1000");
    }
    if (space.grid().index_count() >= std::numeric_limits<detail::NodeId>::max() / 16) {
      return fail(PlanError::limit_exceeded,
                  std::to_string(space.grid().index_count()) +
                      " cells with padding, 2^28 allowed by penalty_astar");
    }
    return detail::search_grid(space, query, observer, HeadingSearch{turn_penalty, scratch});
  }

 private:
  /// A node is 16 x cell index + the step by which it is entered, or + `no_step` for start cells.
  template <GridSpace S>
  struct HeadingGraph {
    const S& space;
    const Query& query;
    const detail::GridQuery& linked;
    OccupancyGrid::View grid;
    detail::StepRule steps_from;
    double unit;  // cost of one metre
    Cost eighth;  // cost of a turn by 45 degrees

    std::size_t size() const { return 16 * space.grid().index_count() + 2; }
    detail::NodeId source() const { return static_cast<detail::NodeId>(size() - 2); }
    detail::NodeId target() const { return source() + 1; }
    Cell cell(detail::NodeId node) const { return grid.cell(node / 16); }
    Point point(detail::NodeId node) const {
      if (node >= source()) return node == source() ? query.start : query.goal;
      return space.frame().point(cell(node));
    }
    double in_metres(Cost cost) const { return static_cast<double>(cost) / unit; }
    detail::NodeId id(Cell at, std::size_t arrival) const {
      return static_cast<detail::NodeId>(16 * grid.index(at) + arrival);
    }

    template <class Visit>
    void for_each_successor(detail::NodeId node, Visit visit) const {
      if (node == source()) {
        for (const auto& [at, cost] : linked.starts) visit(id(at, detail::no_step), cost);
        return;
      }
      const Cell from = cell(node);
      const auto arrival = static_cast<int>(node % 16);
      for (unsigned left = steps_from(node / 16); left != 0; left &= left - 1) {
        const int step = std::countr_zero(left);
        const int turn = arrival == static_cast<int>(detail::no_step)
                             ? 0
                             : 4 - std::abs(4 - std::abs(step - arrival));
        const auto direction = static_cast<std::size_t>(step);
        visit(id(from + steps[direction], direction), detail::step_cost(direction) + turn * eighth);
      }
      if (const auto cost = linked.exit_cost(from)) visit(target(), *cost);
    }
  };

  struct HeadingSearch {
    double turn_penalty;
    detail::GridGraphScratch& scratch;
    static constexpr bool takes_any_steps = true;

    template <GridSpace S, Observer O>
    Expected<detail::GridPath, Failure> run(const detail::GridQuery& linked,
                                            detail::SearchContext<S, O>& context) const {
      const S& space = context.space;
      const double unit = static_cast<double>(straight_cost) / space.frame().resolution;
      const HeadingGraph<S> graph{
          .space = space,
          .query = context.query,
          .linked = linked,
          .grid = space.grid().view(),
          .steps_from = detail::StepRule(space),
          .unit = unit,
          .eighth = static_cast<Cost>(std::lround(turn_penalty * std::numbers::pi / 4 * unit))};
      return detail::search_cells(graph, detail::GoalEstimate(HeuristicKind::octile, linked),
                                  scratch, context);
    }
  };
};

}  // namespace tutavia
