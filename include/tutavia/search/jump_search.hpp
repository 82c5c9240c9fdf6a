// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/grid/successors.hpp"
#include "tutavia/search/jump_labels.hpp"
#include "tutavia/search/jump_queue.hpp"
#include "tutavia/search/linked_query.hpp"

/// \file
/// Jump point search: what the online and the prepared variant share.

namespace tutavia {

/// Memory of a jump point search.
struct JumpScratch {
  JumpLabels labels;
  JumpQueue open;
  std::vector<Cell> cells;
};

/// A* over the jump points of a grid under `no_cut`.
///
/// Only cells with a forced neighbour enter the open list; diagonal jump points, where a path does
/// nothing but turn, are passed on the way. Goals are met while jumping and never enter it either.
///
/// A `Scanner` jumps. `scanner.straight<Step>(cell)` is the number of steps to the jump point in
/// that direction, or -n where there are n steps to a wall. `scanner.diagonal<Step>(cell, goal,
/// visit)` calls `visit(k, horizontal, vertical)` for each number k of diagonal steps after which
/// one of the two straight jumps from there leads to a jump point, or to a goal next to the cell
/// `goal`; the jumps are as `straight` has them. `scanner.prefetch(cell)` says that a cell will be
/// jumped from.
template <class Scanner, Observer O>
class JumpSearch {
 public:
  JumpSearch(const OccupancyGrid& grid, const Frame& frame, const Scanner& scanner,
             const LinkedQuery& linked, JumpScratch& scratch, O& observer, Statistics& stats)
      : grid_(grid.view()),
        frame_(frame),
        scanner_(scanner),
        table_(canonical_table(MovementRule::no_cut)),
        linked_(linked),
        labels_(scratch.labels),
        open_(scratch.open),
        observer_(observer),
        stats_(stats) {}

  std::optional<Failure> run(const Budget& budget) {
    labels_.begin();
    Cost least = none;
    for (const auto& [cell, cost] : linked_.starts) least = std::min(least, cost + estimate(cell));
    open_.begin(least);
    for (const auto& [cell, cost] : linked_.starts) {
      reach(cell, cost, no_step, cell);
      if (const auto exit = linked_.exit_cost(cell)) meet_goal(cell, cost + *exit, cell);
    }
    while (!open_.empty() && open_.advance() < best_) {
      const JumpQueue::Entry entry = open_.pop();
      if (entry.key >= best_) continue;
      const Cell cell = grid_.cell(entry.node);
      const Cost g = labels_.g(entry.node);
      if (g + estimate(cell) != entry.key) continue;  // a better way has overtaken it
      if (stats_.expanded >= budget.max_expansions) {
        return Failure{.code = PlanError::budget_exhausted};
      }
      if (stats_.expanded % 64 == 0) {
        if (const auto code = budget.exceeded()) return Failure{.code = *code};
      }
      expand(cell, g, labels_.arrival(entry.node));
    }
    if (best_ == none) return Failure{.code = PlanError::unreachable};
    return std::nullopt;
  }

  /// The path found, from the goal's cell back to the start's: every cell where it may turn.
  void trace(std::vector<Cell>& cells) {
    Cell to = best_goal_, from = best_parent_;
    cells.push_back(to);
    while (true) {
      if (from != to) {
        // A jump runs along its diagonal first.
        const int dx = to.x - from.x, dy = to.y - from.y;
        const int diagonal = std::min(std::abs(dx), std::abs(dy));
        const Cell turn{from.x + diagonal * sign(dx), from.y + diagonal * sign(dy)};
        if (turn != from && turn != to) cells.push_back(turn);
        cells.push_back(from);
      }
      const auto index = static_cast<std::uint32_t>(grid_.index(from));
      if (labels_.arrival(index) == no_step) return;
      to = from;
      from = grid_.cell(labels_.parent(index));
    }
  }

 private:
  static constexpr Cost none = std::numeric_limits<Cost>::max();

  static int sign(int value) { return (value > 0) - (value < 0); }

  Cost estimate(Cell cell) const {
    return std::max(Cost{0}, octile_cost(cell, linked_.goal_cell) + linked_.goal_offset);
  }

  void expand(Cell from, Cost g, std::size_t arrival) {
    ++stats_.expanded;
    if constexpr (!std::same_as<O, NoObserver>) observer_.expanded(frame_.point(from));
    const StepSet successors = table_[arrival][grid_.neighbourhood(grid_.index(from))];
    const auto has = [&](std::size_t step) { return ((successors >> step) & 1u) != 0; };
    if (has(0)) jump<0>(from, scanner_.template straight<0>(from), g, from);
    if (has(2)) jump<2>(from, scanner_.template straight<2>(from), g, from);
    if (has(4)) jump<4>(from, scanner_.template straight<4>(from), g, from);
    if (has(6)) jump<6>(from, scanner_.template straight<6>(from), g, from);
    if (has(1)) jump_diagonally<1>(from, g);
    if (has(3)) jump_diagonally<3>(from, g);
    if (has(5)) jump_diagonally<5>(from, g);
    if (has(7)) jump_diagonally<7>(from, g);
  }

  template <std::size_t Step>
  void jump_diagonally(Cell from, Cost g) {
    constexpr Cell d = steps[Step];
    scanner_.template diagonal<Step>(from, linked_.goal_cell,
                                     [&](int k, int horizontal, int vertical) {
                                       const Cell cell{from.x + k * d.x, from.y + k * d.y};
                                       const Cost cost = g + k * diagonal_cost;
                                       if (const auto exit = linked_.exit_cost(cell))
                                         meet_goal(cell, cost + *exit, from);
                                       jump<d.x == 1 ? 0 : 4>(cell, horizontal, cost, from);
                                       jump<d.y == 1 ? 2 : 6>(cell, vertical, cost, from);
                                     });
  }

  /// Follows a straight jump from `cell`, which is reached from `parent`.
  template <std::size_t Step>
  void jump(Cell cell, int stop, Cost g, Cell parent) {
    constexpr Cell d = steps[Step];
    const int aside = d.x != 0 ? linked_.goal_cell.y - cell.y : linked_.goal_cell.x - cell.x;
    if (-1 <= aside && aside <= 1) {
      for (const auto& [goal, exit] : linked_.goals) {
        const Cell to = goal - cell;
        const int along = to.x * d.x + to.y * d.y;
        const bool ahead = (d.x != 0 ? to.y : to.x) == 0 && along > 0 && along <= std::abs(stop);
        if (ahead) meet_goal(goal, g + along * straight_cost + exit, parent);
      }
    }
    if (stop > 0) {
      reach({cell.x + stop * d.x, cell.y + stop * d.y}, g + stop * straight_cost, Step, parent);
    }
  }

  void meet_goal(Cell goal, Cost total, Cell parent) {
    if (total >= best_) return;
    best_ = total;
    best_goal_ = goal;
    best_parent_ = parent;
  }

  void reach(Cell cell, Cost g, std::size_t arrival, Cell parent) {
    const Cost f = g + estimate(cell);
    if (f >= best_) return;
    const auto index = static_cast<std::uint32_t>(grid_.index(cell));
    if (!labels_.improve(index, g, arrival, static_cast<std::uint32_t>(grid_.index(parent)))) {
      return;
    }
    ++stats_.generated;
    if constexpr (!std::same_as<O, NoObserver>) observer_.generated(frame_.point(cell));
    scanner_.prefetch(cell);
    open_.push(index, f);
  }

  OccupancyGrid::View grid_;
  const Frame& frame_;
  const Scanner& scanner_;
  const CanonicalTable& table_;
  const LinkedQuery& linked_;
  JumpLabels& labels_;
  JumpQueue& open_;
  O& observer_;
  Statistics& stats_;
  Cost best_ = none;
  Cell best_goal_{}, best_parent_{};
};

/// What both variants do around the search.
template <GridSpace S, class Scanner, Observer O>
Expected<Route, Failure> jump_search(const S& space, const Query& query, const Scanner& scanner,
                                     JumpScratch& scratch, O& observer) {
  return search_grid(space, query, scratch.cells,
                     [&](const LinkedQuery& linked, std::vector<Cell>& cells,
                         Statistics& stats) -> std::optional<Failure> {
                       JumpSearch<Scanner, O> search(space.grid(), space.frame(), scanner, linked,
                                                     scratch, observer, stats);
                       if (auto failure = search.run(query.budget)) return failure;
                       search.trace(cells);
                       return std::nullopt;
                     });
}

}  // namespace tutavia
