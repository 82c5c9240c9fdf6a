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
#include <type_traits>
#include <utility>
#include <vector>

#include "tutavia/core/parts/compiler.hpp"
#include "tutavia/grid/bitboard/places.hpp"
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
        places_(context.space.grid()),
        scanner_(scanner),
        guide_(guide),
        table_(canonical_table(context.space.movement())),
        linked_(linked),
        labels_(scratch.labels),
        open_(scratch.open) {}

  Expected<void, Failure> run() {
    labels_.reset(context_.space.grid().index_count());
    Cost least = none;
    for (const auto& [cell, cost] : linked_.starts) least = std::min(least, cost + estimate(cell));
    open_.reset(least);
    for (const auto& [cell, cost] : linked_.starts) {
      const auto index = static_cast<std::uint32_t>(grid_.index(cell));
      label({labels_.words().word(cost, no_step), index}, index);
      if (const auto exit = linked_.exit_cost(cell)) improve_goal(cell, cost + *exit, cell);
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
      expand(cell, entry.node, g, LabelWords::arrival(label));
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

  /// A jump point to be labelled.
  struct Note {
    std::uint64_t label;  // see LabelWords
    std::uint32_t index;
  };

  static constexpr unsigned straight_steps = 0b01010101;
  /// The step towards (x, y), by 3 sign(y) + sign(x) + 4.
  static constexpr std::array<std::size_t, 9> step_towards{5, 6, 7, 4, no_step, 0, 3, 2, 1};

  static int sign(int value) { return (value > 0) - (value < 0); }

  Cost estimate(Cell cell) const { return guide_.estimate(cell); }

  void expand(Cell cell, std::uint32_t index, Cost g, std::size_t arrival) {
    context_.count_expanded(cell);
    const unsigned successors = table_[arrival][grid_.neighbourhood(index)];
    const Place from = places_.of(cell);
    const std::uint64_t label = labels_.words().word(g, 0);
    std::array<Note, 32> notes;
    std::size_t noted = 0;
    // Notes the end of a jump from a cell with a label, if it is a jump point.
    const auto note = [&](const Jump& jump, std::uint64_t at, std::size_t step, Cost cost) {
      notes[noted] = {LabelWords::farther(at, jump.length * cost) | step, jump.end};
      noted += jump.at_jump_point ? 1 : 0;  // unpredictable, so branch-free
    };
    // Labels are far away in memory: they are read after all jumps.
    const auto label_noted = [&] {
      for (std::size_t i = 0; i < noted; ++i) {
        Note& to = notes[i];
        std::uint32_t parent = index;
        if constexpr (LookBackGuide<Guide>) parent = look_back(to, parent);
        this->label(to, parent);
      }
      noted = 0;
    };
    std::array<int, 8> lengths{};  // of the jumps, by step
    for (unsigned left = successors & straight_steps; left != 0; left &= left - 1) {
      const auto step = static_cast<std::size_t>(std::countr_zero(left));
      const Jump jump = scanner_.straight(step, from);
      note(jump, label, step, straight_cost);
      lengths[step] = jump.length;
    }
    for (unsigned left = successors & ~straight_steps; left != 0; left &= left - 1) {
      const auto step = static_cast<std::size_t>(std::countr_zero(left));
      const auto turn = [&](int k, const Jump& sideways, const Jump& upright) {
        if (noted + 2 > notes.size()) label_noted();
        const std::uint64_t at = LabelWords::farther(label, k * diagonal_cost);
        note(sideways, at, horizontal_of(step), straight_cost);
        note(upright, at, vertical_of(step), straight_cost);
      };
      const Jump jump = scanner_.diagonal(step, cell, from, turn);
      if (noted == notes.size()) label_noted();
      note(jump, label, step, diagonal_cost);
      lengths[step] = jump.length;
    }
    for (const auto& [goal, exit] : linked_.goals) {
      if (reaches(cell, lengths, goal)) {
        improve_goal(goal, g + octile_cost(cell, goal) + exit, cell);
      }
    }
    label_noted();
  }

  /// Whether jumps of these lengths from a cell lead to a goal, or to a cell from which a straight
  /// jump does.
  bool reaches(Cell from, const std::array<int, 8>& lengths, Cell goal) const {
    const int x = goal.x - from.x, y = goal.y - from.y;
    const int towards = 3 * sign(y) + sign(x) + 4;
    const std::size_t step = step_towards[static_cast<std::size_t>(towards)];
    if (step == no_step) return false;
    const int longer = std::max(std::abs(x), std::abs(y));
    const int first = is_diagonal(step) ? std::min(std::abs(x), std::abs(y)) : longer;
    if (first > lengths[step]) return false;
    if (first == longer) return true;
    const std::size_t onwards = std::abs(y) > std::abs(x) ? vertical_of(step) : horizontal_of(step);
    const Place turn = places_.advanced(places_.of(from), step, first);
    return longer - first <= scanner_.straight(onwards, turn).length;
  }

  void improve_goal(Cell goal, Cost total, Cell parent) {
    if (total >= best_) return;
    best_ = total;
    best_goal_ = goal;
    best_parent_ = parent;
  }

  /// Labels a jump point reached from `parent`, and queues it unless its path is no better than a
  /// known one.
  TUTAVIA_ALWAYS_INLINE void label(const Note& to, std::uint32_t parent) {
    if (!labels_.improve(to.index, to.label, parent)) return;
    const Cell cell = grid_.cell(to.index);
    const Cost f = labels_.words().g(to.label) + estimate(cell);
    if (f >= best_) return;
    context_.count_generated(cell);
    open_.push(f, to.index, LabelWords::tag(to.label));
    if constexpr (PrefetchingScanner<Scanner>) scanner_.prefetch(to.index);
  }

  /// Replaces the path to a cell by a straight line from the parent of `parent`, or else from
  /// `parent` itself. Returns the start of that line.
  std::uint32_t look_back(Note& to, std::uint32_t parent) {
    for (const std::uint32_t from : {labels_[parent].parent, parent}) {
      const Cell cell = grid_.cell(from);
      if (!sees(cell, grid_.cell(to.index))) continue;
      const Cost g =
          labels_.words().g(labels_[from].word) + euclidean_cost(cell, grid_.cell(to.index));
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
  Places places_;
  const Scanner& scanner_;
  const Guide& guide_;
  const CanonicalTable& table_;
  const GridQuery& linked_;
  LabelMap& labels_;
  Open& open_;
  Cost best_ = none;
  Cell best_goal_{}, best_parent_{};
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
