// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "tutavia/core/parts/compiler.hpp"
#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/jump_concepts.hpp"
#include "tutavia/search/grid/label_map.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/grid/search_grid.hpp"
#include "tutavia/search/grid/wide_bucket_queue.hpp"
#include "tutavia/search/heuristic.hpp"
#include "tutavia/search/query_checks.hpp"

/// \file
/// JumpSearch: the search shared by jump point search with and without a table.

namespace tutavia::detail {

/// Cost of the straight line between two cells' reference points, rounded up.
inline Cost euclidean_cost(Cell a, Cell b) {
  const double dx = double{1} * a.x - b.x, dy = double{1} * a.y - b.y;
  return static_cast<Cost>(
      std::ceil(static_cast<double>(straight_cost) * std::sqrt(dx * dx + dy * dy)));
}

/// A* over the jump points of a grid.
///
/// Only cells with a forced neighbour enter the open list. Diagonal jump points, where a path only
/// turns, are handled within a jump. Goals are detected during jumps and do not enter it either.
template <JumpScanner Scanner, JumpGuide Guide, GridSpace S, Observer O>
class JumpSearch {
 public:
  JumpSearch(SearchContext<S, O>& context, const GridQuery& linked, const Scanner& scanner,
             const Guide& guide, JumpScratchWith<typename Guide::Open>& scratch)
      : context_(context),
        grid_(context.space.grid().view()),
        scanner_(scanner),
        guide_(guide),
        table_(canonical_table(context.space.movement())),
        linked_(linked),
        labels_(scratch.labels),
        open_(scratch.open) {}

  Expected<void, Failure> run() {
    labels_.reset();
    Cost least = none;
    for (const auto& [cell, cost] : linked_.starts) least = std::min(least, cost + estimate(cell));
    open_.reset(least);
    for (const auto& [cell, cost] : linked_.starts) {
      queue_label(cell, cost, no_step);
      label_pending(cell);
      try_exit(cell, cost, cell);
    }
    while (!open_.empty()) {
      const Cost least_key = open_.seek_first();
      if (least_key >= best_) break;
      const auto entry = open_.pop();
      const std::uint64_t label = labels_[entry.node].word;
      if (LabelWords::tag(label) != entry.tag) continue;  // a cheaper path was found since
      const Cell cell = grid_.cell(entry.node);
      const Cost g = labels_.words().g(label);
      if (least_key > best_ - Open::width && g + estimate(cell) >= best_) continue;
      if (auto within = context_.check_budget(64); !within) return within;
      expand(cell, g, LabelWords::arrival(label));
    }
    if (best_ == none) return fail(PlanError::unreachable);
    return {};
  }

  /// The path found, from the goal's cell back to the start's: every cell at which it may turn.
  void trace(std::vector<Cell>& cells) {
    Cell to = best_goal_, from = best_parent_;
    cells.assign(1, to);
    while (true) {
      if (from != to) {
        // A jump first runs along its diagonal.
        const int dx = to.x - from.x, dy = to.y - from.y;
        const int diagonal = std::min(std::abs(dx), std::abs(dy));
        const Cell turn{from.x + diagonal * sign(dx), from.y + diagonal * sign(dy)};
        const bool bends = turn != from && turn != to && !sees(from, to);
        if (bends) cells.push_back(turn);
        cells.push_back(from);
      }
      const auto index = static_cast<std::uint32_t>(grid_.index(from));
      const LabelMap::Label& label = labels_[index];
      if (LabelWords::arrival(label.word) == no_step) return;
      to = from;
      from = grid_.cell(label.parent);
    }
  }

 private:
  using Open = typename Guide::Open;
  static constexpr Cost none = std::numeric_limits<Cost>::max();

  static int sign(int value) { return (value > 0) - (value < 0); }

  Cost estimate(Cell cell) const { return guide_.estimate(cell); }

  void expand(Cell from, Cost g, std::size_t arrival) {
    context_.count_expanded(from);
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
    label_pending(from);
  }

  template <std::size_t Step>
  void jump_diagonally(Cell from, Cost g) {
    constexpr Cell d = steps[Step];
    const auto turn = [&](int k, int horizontal, int vertical) {
      const Cell cell{from.x + k * d.x, from.y + k * d.y};
      const Cost cost = g + k * diagonal_cost;
      try_exit(cell, cost, from);
      jump<d.x == 1 ? 0 : 4>(cell, horizontal, cost, from);
      jump<d.y == 1 ? 2 : 6>(cell, vertical, cost, from);
    };
    if constexpr (DiagonalStopScanner<Scanner>) {
      const int k = scanner_.template diagonal<Step>(from, linked_.goal_cell, turn);
      if (k == 0) return;
      const Cell stop{from.x + k * d.x, from.y + k * d.y};
      try_exit(stop, g + k * diagonal_cost, from);
      if (pending_count_ == pending_.size()) label_pending(from);
      queue_label(stop, g + k * diagonal_cost, Step);
    } else {
      scanner_.template diagonal<Step>(from, linked_.goal_cell, turn);
    }
  }

  /// Follows a straight jump from `cell`, which is reached from `parent`.
  template <std::size_t Step>
  TUTAVIA_ALWAYS_INLINE void jump(Cell cell, int stop, Cost g, Cell parent) {
    constexpr Cell d = steps[Step];
    const int across = d.x != 0 ? linked_.goal_cell.y - cell.y : linked_.goal_cell.x - cell.x;
    if (-1 <= across && across <= 1) {
      for (const auto& [goal, exit] : linked_.goals) {
        const Cell to = goal - cell;
        const int along = to.x * d.x + to.y * d.y;
        const bool ahead = (d.x != 0 ? to.y : to.x) == 0 && along > 0 && along <= std::abs(stop);
        if (ahead) improve_goal(goal, g + along * straight_cost + exit, parent);
      }
    }
    if (stop > 0) {
      if (pending_count_ == pending_.size()) label_pending(parent);
      queue_label({cell.x + stop * d.x, cell.y + stop * d.y}, g + stop * straight_cost, Step);
    }
  }

  /// Records a path that leaves the grid to the goal at a cell reached from `parent`, if the cell
  /// has a link.
  void try_exit(Cell cell, Cost g, Cell parent) {
    if (!linked_.near_goal(cell)) return;
    if (const auto exit = linked_.exit_cost(cell)) improve_goal(cell, g + *exit, parent);
  }

  void improve_goal(Cell goal, Cost total, Cell parent) {
    if (total >= best_) return;
    best_ = total;
    best_goal_ = goal;
    best_parent_ = parent;
  }

  /// Queues a cell reached by a jump. Labels are far away in memory, so they are prefetched now and
  /// read after all jumps of an expansion.
  TUTAVIA_ALWAYS_INLINE void queue_label(Cell cell, Cost g, std::size_t arrival) {
    const auto index = static_cast<std::uint32_t>(grid_.index(cell));
    labels_.prefetch(index);
    pending_[pending_count_++] = {labels_.words().word(g, arrival), cell, index};
  }

  /// Labels the queued cells, which are reached from `parent`.
  void label_pending(Cell parent) {
    for (Pending& to : std::span(pending_.data(), pending_count_)) {
      auto from = static_cast<std::uint32_t>(grid_.index(parent));
      const bool first = LabelWords::arrival(to.label) == no_step;
      if (LookBackGuide<Guide> && !first) from = look_back(to, from);
      if (!labels_.improve(to.index, to.label, from)) continue;
      const Cost f = labels_.words().g(to.label) + estimate(to.cell);
      if (f >= best_) continue;
      context_.count_generated(to.cell);
      open_.push(f, to.index, LabelWords::tag(to.label));
      if constexpr (PrefetchingScanner<Scanner>) scanner_.prefetch(to.cell);
    }
    pending_count_ = 0;
  }

  struct Pending {
    std::uint64_t label;  // see LabelWords
    Cell cell;
    std::uint32_t index;
  };

  /// Replaces the path to a cell by a straight line from the parent of `parent`, or else from
  /// `parent` itself. Returns the start of that line.
  std::uint32_t look_back(Pending& to, std::uint32_t parent) {
    for (const std::uint32_t from : {labels_[parent].parent, parent}) {
      const Cell cell = grid_.cell(from);
      if (!sees(cell, to.cell)) continue;
      const Cost g = labels_.words().g(labels_[from].word) + euclidean_cost(cell, to.cell);
      to.label = labels_.words().word(g, LabelWords::arrival(to.label));
      return from;
    }
    return parent;
  }

  bool sees(Cell a, Cell b) const {
    if constexpr (LookBackGuide<Guide>) {
      return guide_.line_of_sight(a, b);
    } else {
      return false;
    }
  }

  SearchContext<S, O>& context_;
  OccupancyGrid::View grid_;
  const Scanner& scanner_;
  const Guide& guide_;
  const CanonicalTable& table_;
  const GridQuery& linked_;
  LabelMap& labels_;
  Open& open_;
  Cost best_ = none;
  Cell best_goal_{}, best_parent_{};
  std::array<Pending, 32> pending_;
  std::size_t pending_count_ = 0;
};

/// Runs a JumpSearch within `search_grid`; see `jump_search`.
template <JumpScanner Scanner, std::invocable<const GridQuery&> MakeGuide, OpenList Open,
          std::invocable<std::vector<Cell>&> Finish>
struct GuidedJumpSearch {
  const Scanner& scanner;
  const MakeGuide& make_guide;
  JumpScratchWith<Open>& scratch;
  const Finish& finish;

  template <GridSpace S, Observer O>
  Expected<GridPath, Failure> run(const GridQuery& linked, SearchContext<S, O>& context) const {
    const auto guide = make_guide(linked);
    JumpSearch search(context, linked, scanner, guide, scratch);
    if (auto found = search.run(); !found) return std::move(found).unexpected();
    search.trace(scratch.cells);
    finish(scratch.cells);
    return GridPath{scratch.cells};
  }
};

/// Jump point search with any guide. `make_guide(linked)` creates the guide, `finish(cells)` may
/// change the path found.
template <GridSpace S, JumpScanner Scanner, std::invocable<const GridQuery&> MakeGuide,
          OpenList Open, Observer O, std::invocable<std::vector<Cell>&> Finish>
Expected<Route, Failure> jump_search(const S& space, const Query& query, const Scanner& scanner,
                                     const MakeGuide& make_guide, JumpScratchWith<Open>& scratch,
                                     O& observer, const Finish& finish) {
  const GuidedJumpSearch<Scanner, MakeGuide, Open, Finish> search{scanner, make_guide, scratch,
                                                                  finish};
  return search_grid(space, query, observer, search);
}

/// Plain jump point search.
template <GridSpace S, JumpScanner Scanner, Observer O>
Expected<Route, Failure> jump_search(const S& space, const Query& query, const Scanner& scanner,
                                     JumpScratch& scratch, O& observer) {
  return jump_search(
      space, query, scanner, [](const GridQuery& linked) { return OctileGuide(linked); }, scratch,
      observer, [](std::vector<Cell>&) {});
}

}  // namespace tutavia::detail
