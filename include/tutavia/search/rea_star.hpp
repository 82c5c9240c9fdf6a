// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/plan/query.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/goal_estimate.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/open_heap.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/grid/search_grid.hpp"
#include "tutavia/search/grid/stamped_labels.hpp"
#include "tutavia/search/heuristic.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/rectangle/border_costs.hpp"
#include "tutavia/search/rectangle/free_rectangle.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// REA*: rectangle expansion A*.

namespace tutavia {

namespace detail {

/// What a rectangle expansion keeps between queries: memory.
class ReaScratch {
 public:
  struct Label {
    Cost g = 0;
    std::uint32_t expansion : 31 = 0;  ///< that reached the cell last
    std::uint32_t is_expanded : 1 = 0;
    std::uint32_t query = 0;
  };
  /// A rectangle and the interval that it grew from.
  struct Expansion {
    detail::CellInterval from;
    detail::CellRectangle rectangle;
  };
  struct Entry {
    Cost key;
    std::uint64_t sequence;
    detail::CellInterval interval;
    std::uint32_t expansion;                                 // that found it
    friend bool operator<(const Entry& a, const Entry& b) {  // worse < better
      return a.key != b.key ? a.key > b.key : a.sequence > b.sequence;
    }
  };

  detail::StampedLabels<Label> labels;
  std::vector<Expansion> expansions;
  detail::OpenHeap<Entry> open;
  detail::BorderCosts reach;
  std::vector<detail::CellRun> exits;
  std::vector<Cell> cells;
};

}  // namespace detail

/// A* over free rectangles: an interval of cells is expanded at once into the largest free
/// rectangle that grows from it, whose inside is never looked at; the cells on its border get their
/// exact octile distances from the interval, and the free intervals beyond its four sides go into
/// the open list. Optimal like A* in octile distance, with far fewer expansions where there is
/// room; the route runs straight through each rectangle, and so is often shorter than
/// `Route::cost`, the octile distance that was minimised.
///
/// Needs the movement rule `no_cut`, else `invalid_option`; other errors as for AStar. Complete on
/// the grid. `Statistics::expanded` counts rectangles. Linear in the border of the rectangles.
///
/// Source: Zhang, Li and Bi 2016, "Rectangle expansion A* pathfinding for grid maps"; all four
/// sides and the diagonals out of corners, which that needs to be complete and optimal, see
/// docs/algorithms.md.
struct ReaStar {
  static constexpr std::string_view name = "rea_star";
  using Scratch = detail::ReaScratch;

  template <ColumnSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const;
};

namespace detail {

template <ColumnSpace S, Observer O>
class RectangleSearch {
 public:
  RectangleSearch(SearchContext<S, O>& context, const GridQuery& linked, ReaScratch& scratch)
      : context_(context),
        space_(context.space),
        rectangles_(space_),
        grid_(space_.grid().view()),
        linked_(linked),
        estimate_(linked),
        scratch_(scratch) {}

  Expected<void, Failure> run() {
    scratch_.labels.reset(space_.grid().index_count());
    scratch_.expansions.clear();
    scratch_.open.clear();
    for (const auto& [cell, cost] : linked_.starts) {
      improve(cell, cost, none);
      push({0, cell.y, cell.x, cell.x, 1}, cost + estimate_(cell), none);
    }
    while (!scratch_.open.empty()) {
      ReaScratch::Entry entry = scratch_.open.pop();
      if (entry.key >= best_) break;
      trim(entry.interval);
      if (entry.interval.first > entry.interval.last) continue;
      if (auto within = context_.check_budget(64); !within) return within;
      context_.count_expanded(entry.interval.middle());
      expand(entry);
    }
    if (best_ == std::numeric_limits<Cost>::max()) return fail(PlanError::unreachable);
    return {};
  }

  /// Of the path in octile distance, the links of start and goal included.
  Cost cost() const { return best_; }
  /// The path from the goal's cell back to the start's.
  void path(std::vector<Cell>& cells) const {
    Cell cell = grid_.cell(goal_);
    cells.assign(1, cell);
    for (std::uint32_t e = label(cell).expansion; e != none; e = label(cell).expansion) {
      const auto& [from, rectangle] = scratch_.expansions[e];
      const bool is_beyond = !rectangle.contains(cell);
      if (is_beyond) {
        cell = last_inside(from, rectangle, cell);
        append_cell(cells, cell);
      }
      cell = nearest(from, cell, is_beyond).first;
      append_cell(cells, cell);
    }
  }

 private:
  static constexpr std::uint32_t none = 0x7fffffff;

  ReaScratch::Label& label(Cell cell) const { return scratch_.labels[grid_.index(cell)]; }

  /// Of the cells of an interval (with or without the cell itself) the one from which a cell of the
  /// rectangle is reached, and what the way costs.
  std::pair<Cell, Cost> nearest(const CellInterval& from, Cell to, bool with_itself) const {
    std::pair<Cell, Cost> best{to, std::numeric_limits<Cost>::max()};
    for (int u = from.first; u <= from.last; ++u) {
      const Cell cell = from.cell(u);
      const Cost cost = label(cell).g + octile_cost(to, cell);
      if (cost < best.second && (with_itself || cell != to)) best = {cell, cost};
    }
    return best;
  }

  /// The cell of a rectangle by which one beyond its sides is reached.
  Cell last_inside(const CellInterval& from, const CellRectangle& rectangle, Cell beyond) const {
    std::pair<Cell, Cost> best{beyond, std::numeric_limits<Cost>::max()};
    for (std::size_t step = 0; step < steps.size(); ++step) {
      const Cell cell = beyond + steps[step];
      if (!rectangle.contains(cell)) continue;
      if (!space_.grid().can_step(beyond, step, MovementRule::no_cut)) continue;
      const Cost cost = nearest(from, cell, true).second + step_cost(step);
      if (cost < best.second) best = {cell, cost};
    }
    return best.first;
  }

  /// Notes a way to a cell. Returns whether it is the first or a better one.
  bool improve(Cell cell, Cost g, std::uint32_t expansion) {
    const std::size_t index = grid_.index(cell);
    const ReaScratch::Label* known = scratch_.labels.find(index);
    if (known != nullptr && known->g <= g) return false;
    scratch_.labels.set(index, {.g = g, .expansion = expansion & none});
    if (const auto exit = linked_.exit_cost(cell); exit && g + *exit < best_) {
      best_ = g + *exit;
      goal_ = index;
    }
    return true;
  }

  void push(const CellInterval& interval, Cost key, std::uint32_t expansion) {
    if (key >= best_) return;
    scratch_.open.push({key, sequence_++, interval, expansion});
    context_.count_generated(interval.middle());
  }

  /// Cuts off the cells at the ends of an interval that were expanded at what they cost now.
  void trim(CellInterval& i) const {
    while (i.first <= i.last && label(i.cell(i.first)).is_expanded) ++i.first;
    while (i.first <= i.last && label(i.cell(i.last)).is_expanded) --i.last;
  }

  void expand(const ReaScratch::Entry& entry) {
    const CellInterval& from = entry.interval;
    const CellRectangle r = rectangles_.grow(from);
    notify_rectangle(context_.observer, space_, from, r);
    const auto expansion = static_cast<std::uint32_t>(scratch_.expansions.size());
    scratch_.expansions.push_back({from, r});
    bool is_unchanged = true;  // since the expansion that found the interval
    scratch_.reach.reset(from, [&](int u) {
      ReaScratch::Label& known = label(from.cell(u));
      known.is_expanded = 1;
      is_unchanged = is_unchanged && known.expansion == entry.expansion;
      return known.g;
    });
    for (const auto& [goal, cost] : linked_.goals) {
      if (r.contains(goal)) improve(goal, scratch_.reach.reach(goal).cost, expansion);
    }
    for (const int side : {1, -1}) {
      CellInterval edge = r.edge(from.axis, side);
      if (side == -from.side && is_unchanged && entry.expansion != none) {
        // Behind the interval lies what it was reached from, but not behind its ends.
        CellInterval left = edge;
        left.last = from.first;
        edge.first = from.last;
        leave(left, expansion);
      }
      leave(edge, expansion);
      leave(r.edge(1 - from.axis, side), expansion);
    }
  }

  /// Finds the free intervals beyond a side of a rectangle, by one cell longer where a diagonal out
  /// of the corner is legal.
  void find_exits(const CellInterval& edge) {
    scratch_.exits.clear();
    const int next = edge.line + edge.side;
    const auto opens = [&](int corner, int beyond) {
      const OccupancyGrid& lines = rectangles_.of(edge.axis);
      return beyond >= 0 && beyond < lines.width() && next >= 0 && next < lines.height() &&
             lines.is_free({beyond, edge.line}) && lines.is_free({corner, next}) &&
             lines.is_free({beyond, next});
    };
    const CellRun within{opens(edge.first, edge.first - 1) ? edge.first - 1 : edge.first,
                         opens(edge.last, edge.last + 1) ? edge.last + 1 : edge.last};
    rectangles_.append_free_runs(edge.axis, next, within, scratch_.exits);
  }

  /// Steps out of a rectangle over a side into the intervals beyond.
  void leave(const CellInterval& edge, std::uint32_t expansion) {
    find_exits(edge);
    if (scratch_.exits.empty()) return;
    CellInterval asked = edge;  // the cells of the side that lead to them, and those in between
    asked.first = std::max(scratch_.exits.front().first, edge.first);
    asked.last = std::min(scratch_.exits.back().last, edge.last);
    const BorderCosts& reach = scratch_.reach;
    scratch_.reach.reach(asked);
    const CellInterval beyond = edge.beyond();
    for (const auto& [begin, end] : scratch_.exits) {
      const int first = std::max(begin, edge.first), last = std::min(end, edge.last);
      for (int q = first; q <= last; ++q) improve(edge.cell(q), reach[q], expansion);
      Cost key = std::numeric_limits<Cost>::max();
      for (int p = begin; p <= end; ++p) {
        Cost cost = std::numeric_limits<Cost>::max();
        for (int q = std::max(p - 1, first); q <= std::min(p + 1, last); ++q) {
          cost = std::min(cost, reach[q] + (q == p ? straight_cost : diagonal_cost));
        }
        const Cell to = beyond.cell(p);
        if (improve(to, cost, expansion)) key = std::min(key, cost + estimate_(to));
      }
      if (key < std::numeric_limits<Cost>::max()) {
        push({beyond.axis, beyond.line, begin, end, beyond.side}, key, expansion);
      }
    }
  }

  SearchContext<S, O>& context_;
  const S& space_;
  FreeRectangles rectangles_;
  OccupancyGrid::View grid_;
  const GridQuery& linked_;
  OctileHeuristic estimate_;
  ReaScratch& scratch_;
  std::uint64_t sequence_ = 0;
  Cost best_ = std::numeric_limits<Cost>::max();  // of a path to the goal
  std::size_t goal_ = 0;                          // its last cell
};

/// A RectangleSearch for search_grid.
struct RectangleGridSearch {
  ReaScratch& scratch;

  template <ColumnSpace S, Observer O>
  Expected<GridPath, Failure> run(const GridQuery& linked, SearchContext<S, O>& context) const {
    RectangleSearch<S, O> search(context, linked, scratch);
    if (auto found = search.run(); !found) return std::move(found).unexpected();
    search.path(scratch.cells);
    return GridPath{scratch.cells, in_metres(search.cost(), context.space.frame().resolution)};
  }
};

}  // namespace detail

template <ColumnSpace S, Observer O>
Expected<Route, Failure> ReaStar::search(const S& space, const Query& query, Scratch& scratch,
                                         O& observer) const {
  if (auto valid = detail::check_no_cut(space, name); !valid) return std::move(valid).unexpected();
  return detail::search_grid(space, query, observer, detail::RectangleGridSearch{scratch});
}

}  // namespace tutavia
