// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/search/grid/best_first.hpp"
#include "tutavia/search/grid/goal_estimate.hpp"
#include "tutavia/search/grid/grid_graph.hpp"
#include "tutavia/search/heuristic.hpp"

/// \file
/// Penalty A*: a cheapest path when turning costs something.

namespace tutavia {

/// A* over cells and headings: minimises length + `turn_penalty` x total change of heading among
/// the grid's steps. The start has no heading, and turns at the links of start and goal cost
/// nothing. A larger penalty gives longer paths with fewer turns. `Route::cost` is the sum
/// minimised [m]. Errors: `invalid_option` for a penalty that is negative or above 1000 m per
/// radian, `limit_exceeded` for grids of more than 2^28 cells; else as for AStar. Source: the
/// penalty-based A* that Abdulshaheed 2025 compares with (lambda = 0.4); its formula is not given
/// there, see docs/algorithms.md.
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
    const double resolution = space.frame().resolution;
    const double unit = static_cast<double>(straight_cost) / resolution;
    const auto eighth = static_cast<Cost>(std::lround(turn_penalty * std::numbers::pi / 4 * unit));
    std::optional<Cost> paid;
    auto route = detail::search_grid(
        space, query, scratch.cells,
        [&](const detail::LinkedQuery& linked, std::vector<Cell>& cells,
            Statistics& stats) -> std::optional<Failure> {
          const HeadingGraph<S> graph{
              space, query, linked, space.grid().view(), detail::all_successors(space.movement()),
              eighth};
          const detail::GoalEstimate estimate(Heuristic::octile, linked);
          const auto heuristic = [&](detail::NodeId node) -> Cost {
            return node >= graph.source() ? 0 : estimate(graph.cell(node));
          };
          const auto stopped = detail::best_first(graph, heuristic, scratch.best_first,
                                                  query.budget, observer, stats);
          if (stopped) return Failure{.code = *stopped};
          const detail::BestFirstScratch& labels = scratch.best_first;
          for (detail::NodeId node = labels.find(graph.target())->parent; node != graph.source();
               node = labels.find(node)->parent) {
            detail::append_cell(cells, graph.cell(node));
          }
          paid = labels.find(graph.target())->g;
          return std::nullopt;
        });
    if (route && paid) route->cost = static_cast<double>(*paid) / unit;
    return route;
  }

 private:
  /// Nodes are 16 x cell index + the step of arrival, or `no_step` at first cells.
  template <GridSpace S>
  struct HeadingGraph {
    const S& space;
    const Query& query;
    const detail::LinkedQuery& linked;
    OccupancyGrid::View grid;
    const detail::SuccessorTable& table;
    Cost eighth;  // what a turn of 45 degrees costs

    std::size_t size() const { return 16 * space.grid().index_count() + 2; }
    detail::NodeId source() const { return static_cast<detail::NodeId>(size() - 2); }
    detail::NodeId target() const { return source() + 1; }
    Cell cell(detail::NodeId node) const { return grid.cell(node / 16); }
    Point point(detail::NodeId node) const {
      if (node >= source()) return node == source() ? query.start : query.goal;
      return space.frame().point(cell(node));
    }
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
      for (unsigned left = table[grid.neighbourhood(node / 16)]; left != 0; left &= left - 1) {
        const int step = std::countr_zero(left);
        const int turn = arrival == static_cast<int>(detail::no_step)
                             ? 0
                             : 4 - std::abs(4 - std::abs(step - arrival));
        const auto direction = static_cast<std::size_t>(step);
        visit(id(from + steps[direction], direction), step_cost(direction) + turn * eighth);
      }
      if (const auto cost = linked.exit_cost(from)) visit(target(), *cost);
    }
  };
};

}  // namespace tutavia
