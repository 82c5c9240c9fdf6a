// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
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
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/rectangle/border_costs.hpp"
#include "tutavia/search/rectangle/free_rectangle.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// RectangleSearch: the search of REA*, over free rectangles.

namespace tutavia::detail {

/// Memory of a rectangle search, reused by later queries.
class ReaScratch {
 public:
  struct Label {
    Cost g = 0;
    std::uint32_t expansion : 31 = 0;  ///< the last one that reached the cell
    std::uint32_t is_expanded : 1 = 0;
    std::uint32_t query = 0;
  };
  /// A rectangle and the interval from which it grew.
  struct Expansion {
    CellInterval from;
    CellRectangle rectangle;
  };
  struct Entry {
    Cost key;
    std::uint64_t sequence;
    CellInterval interval;
    std::uint32_t expansion;                                 // the one that found the interval
    friend bool operator<(const Entry& a, const Entry& b) {  // worse < better
      return a.key != b.key ? a.key > b.key : a.sequence > b.sequence;
    }
  };

  StampedLabels<Label> labels;
  std::vector<Expansion> expansions;
  OpenHeap<Entry> open;
  BorderCosts border;
  std::vector<CellRun> exits;
  std::vector<Cell> cells;
};

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

  /// Octile length of the path, including the links of start and goal.
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

  /// The cell of an interval, with or without `to` itself, from which a cell of the rectangle is
  /// reached at the least cost; and that cost.
  std::pair<Cell, Cost> nearest(const CellInterval& from, Cell to, bool with_itself) const {
    std::pair<Cell, Cost> best{to, std::numeric_limits<Cost>::max()};
    for (int u = from.first; u <= from.last; ++u) {
      const Cell cell = from.cell(u);
      const Cost cost = label(cell).g + octile_cost(to, cell);
      if (cost < best.second && (with_itself || cell != to)) best = {cell, cost};
    }
    return best;
  }

  /// The cell of a rectangle through which a cell beyond its sides is reached.
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

  /// Records a path to a cell. Returns whether it is the first or a cheaper one.
  bool improve(Cell cell, Cost g, std::uint32_t expansion) {
    return improve(grid_.index(cell), cell, g, expansion);
  }
  bool improve(std::size_t index, Cell cell, Cost g, std::uint32_t expansion) {
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

  /// Removes cells from the ends of an interval that were already expanded at their current cost.
  void trim(CellInterval& i) const {
    while (i.first <= i.last && label(i.cell(i.first)).is_expanded) ++i.first;
    while (i.first <= i.last && label(i.cell(i.last)).is_expanded) --i.last;
  }

  void expand(const ReaScratch::Entry& entry) {
    const CellInterval& from = entry.interval;
    const CellRectangle r = rectangles_.grow(from);
    notify_rectangle(context_.observer, space_, from, r, SearchSide::start);
    const auto expansion = static_cast<std::uint32_t>(scratch_.expansions.size());
    scratch_.expansions.push_back({from, r});
    bool is_unchanged = true;  // whether no cost fell since the interval was found
    scratch_.border.reset(from, [&](int u) {
      ReaScratch::Label& known = label(from.cell(u));
      known.is_expanded = 1;
      is_unchanged = is_unchanged && known.expansion == entry.expansion;
      return known.g;
    });
    for (const auto& [goal, cost] : linked_.goals) {
      if (r.contains(goal)) improve(goal, scratch_.border.reach(goal).cost, expansion);
    }
    for (const int side : {1, -1}) {
      CellInterval edge = r.edge(from.axis, side);
      if (side == -from.side && is_unchanged && entry.expansion != none) {
        // The cells behind the interval are those it was reached from; cells behind its ends are
        // not.
        CellInterval left = edge;
        left.last = from.first;
        edge.first = from.last;
        cross_side(left, expansion);
      }
      cross_side(edge, expansion);
      cross_side(r.edge(1 - from.axis, side), expansion);
    }
  }

  /// Finds the free intervals beyond a side of a rectangle. They extend one cell past a corner if a
  /// diagonal step over the corner is legal.
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

  /// Relaxes the cells beyond a side of a rectangle and pushes the free intervals there.
  void cross_side(const CellInterval& edge, std::uint32_t expansion) {
    find_exits(edge);
    if (scratch_.exits.empty()) return;
    CellInterval span = edge;  // the part of the side that the exits need
    span.first = std::max(scratch_.exits.front().first, edge.first);
    span.last = std::min(scratch_.exits.back().last, edge.last);
    const BorderCosts& costs = scratch_.border;
    scratch_.border.reach(span);
    const CellInterval beyond = edge.beyond();
    const std::size_t stride = edge.axis == 0 ? 1 : space_.grid().stride();
    const std::size_t inner = grid_.index(edge.cell(0)), outer = grid_.index(beyond.cell(0));
    const auto index_of = [stride](std::size_t origin, int u) {
      return origin + stride * static_cast<std::size_t>(u);
    };
    for (const auto& [exit_first, exit_last] : scratch_.exits) {
      const int first = std::max(exit_first, edge.first), last = std::min(exit_last, edge.last);
      for (int q = first; q <= last; ++q) {
        improve(index_of(inner, q), edge.cell(q), costs[q], expansion);
      }
      // The costs of the cells of the side next to p - 1, p and p + 1.
      constexpr Cost beyond_side = std::numeric_limits<Cost>::max() / 2;
      const auto cost_at = [&](int q) { return q >= first && q <= last ? costs[q] : beyond_side; };
      Cost before = cost_at(exit_first - 1), here = cost_at(exit_first);
      Cost key = std::numeric_limits<Cost>::max();
      for (int p = exit_first; p <= exit_last; ++p) {
        const Cost after = cost_at(p + 1);
        const Cost cost = std::min(here + straight_cost, std::min(before, after) + diagonal_cost);
        before = std::exchange(here, after);
        const Cell to = beyond.cell(p);
        if (improve(index_of(outer, p), to, cost, expansion))
          key = std::min(key, cost + estimate_(to));
      }
      if (key < std::numeric_limits<Cost>::max()) {
        push({beyond.axis, beyond.line, exit_first, exit_last, beyond.side}, key, expansion);
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
  Cost best_ = std::numeric_limits<Cost>::max();  // cost of the best path to the goal
  std::size_t goal_ = 0;                          // index of its last cell
};

/// Runs a RectangleSearch within `search_grid`.
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

}  // namespace tutavia::detail
