// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/search/concepts.hpp"
#include "tutavia/search/free_rectangle.hpp"
#include "tutavia/search/heuristic.hpp"
#include "tutavia/search/linked_query.hpp"
#include "tutavia/search/octile_reach.hpp"
#include "tutavia/search/query.hpp"
#include "tutavia/search/query_labels.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// REA*: rectangle expansion A*.

namespace tutavia {

/// What a rectangle expansion keeps between queries: memory.
class ReaScratch {
 public:
  struct Label {
    Cost g = 0;
    Cost expanded = 0;  ///< g when the cell was expanded last
    std::uint32_t parent = 0;
    std::uint32_t query = 0;
  };
  struct Entry {
    Cost key;
    std::uint64_t sequence;
    CellInterval interval;
    friend bool operator<(const Entry& a, const Entry& b) {  // for std::push_heap: worse < better
      return a.key != b.key ? a.key > b.key : a.sequence > b.sequence;
    }
  };
  QueryLabels<Label> labels;
  std::vector<Entry> open;
  OctileReach reach;
  std::vector<CellRun> exits;
  std::vector<Cell> cells;
};

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
  using Scratch = ReaScratch;

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const;
};

namespace detail {

template <class S, class O>
class RectangleSearch {
 public:
  RectangleSearch(const S& space, const Query& query, const LinkedQuery& linked,
                  ReaScratch& scratch, O& observer, Statistics& stats)
      : space_(space),
        rectangles_(space),
        grid_(space.grid().view()),
        query_(query),
        linked_(linked),
        estimate_{linked.goal_cell, linked.goal_offset},
        scratch_(scratch),
        observer_(observer),
        stats_(stats) {}

  std::optional<Failure> run() {
    scratch_.labels.begin(space_.grid().index_count());
    scratch_.open.clear();
    for (const auto& [cell, cost] : linked_.starts) {
      const std::size_t index = grid_.index(cell);
      improve(cell, cost, index);
      push({0, cell.y, cell.x, cell.x, 1}, cost + estimate_(cell));
    }
    while (!scratch_.open.empty()) {
      std::pop_heap(scratch_.open.begin(), scratch_.open.end());
      ReaScratch::Entry entry = scratch_.open.back();
      scratch_.open.pop_back();
      if (entry.key >= best_) break;
      if (!take(entry.interval)) continue;
      if (is_checked(query_.budget, stats_.expanded, 64)) {
        if (auto failure = exceeded(query_.budget, stats_.expanded)) return failure;
      }
      ++stats_.expanded;
      observer_.expanded(place(entry.interval.middle()));
      expand(entry.interval);
    }
    if (best_ == std::numeric_limits<Cost>::max()) return Failure{.code = PlanError::unreachable};
    return std::nullopt;
  }

  /// Of the path in octile distance, the links of start and goal included.
  Cost cost() const { return best_; }
  /// The path from the goal's cell back to the start's.
  void path(std::vector<Cell>& cells) const {
    for (std::size_t index = goal_;;) {
      append_cell(cells, grid_.cell(index));
      const std::size_t parent = scratch_.labels[index].parent;
      if (parent == index) return;
      index = parent;
    }
  }

 private:
  Point place(Cell cell) const { return space_.frame().point(cell); }

  /// Notes a way to a cell. Returns whether it is the first or a better one.
  bool improve(Cell cell, Cost g, std::size_t parent) {
    const std::size_t index = grid_.index(cell);
    const ReaScratch::Label* label = scratch_.labels.find(index);
    if (label != nullptr && label->g <= g) return false;
    const Cost expanded = label != nullptr ? label->expanded : std::numeric_limits<Cost>::max();
    scratch_.labels.set(index, {g, expanded, static_cast<std::uint32_t>(parent)});
    if (const auto exit = linked_.exit_cost(cell); exit && g + *exit < best_) {
      best_ = g + *exit;
      goal_ = index;
    }
    return true;
  }

  void push(const CellInterval& interval, Cost key) {
    if (key >= best_) return;
    scratch_.open.push_back({key, sequence_++, interval});
    std::push_heap(scratch_.open.begin(), scratch_.open.end());
    ++stats_.generated;
    observer_.generated(place(interval.middle()));
  }

  /// Reads the costs along an interval, less the cells at its ends that were expanded already.
  /// Returns whether there are others.
  bool take(CellInterval& interval) {
    const auto label = [&](int u) -> ReaScratch::Label& {
      return scratch_.labels[grid_.index(interval.cell(u))];
    };
    const auto is_new = [&](int u) { return label(u).g < label(u).expanded; };
    while (interval.first <= interval.last && !is_new(interval.first)) ++interval.first;
    while (interval.first <= interval.last && !is_new(interval.last)) --interval.last;
    scratch_.reach.begin(interval, [&](int u) { return label(u).expanded = label(u).g; });
    return interval.first <= interval.last;
  }

  void expand(const CellInterval& from) {
    const CellRectangle r = rectangles_.grow(from);
    tell_of(observer_, space_, from, r);
    for (const auto& [goal, cost] : linked_.goals) {
      if (!r.contains(goal)) continue;
      const OctileReach::Source source = scratch_.reach.reach(goal);
      improve(goal, source.cost, grid_.index(from.cell(source.place)));
    }
    for (const int side : {1, -1}) {
      leave(from, r.edge(from.axis, side));
      leave(from, r.edge(1 - from.axis, side));
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
  void leave(const CellInterval& from, const CellInterval& edge) {
    find_exits(edge);
    if (scratch_.exits.empty()) return;
    CellInterval asked = edge;  // the cells of the side that lead to them, and those in between
    asked.first = std::max(scratch_.exits.front().first, edge.first);
    asked.last = std::min(scratch_.exits.back().last, edge.last);
    OctileReach& reach = scratch_.reach;
    reach.reach(asked);
    const CellInterval beyond = edge.beyond();
    for (const auto& [begin, end] : scratch_.exits) {
      const int first = std::max(begin, edge.first), last = std::min(end, edge.last);
      for (int q = first; q <= last; ++q) {
        const std::size_t index = grid_.index(edge.cell(q));
        if (!improve(edge.cell(q), reach[q].cost, grid_.index(from.cell(reach[q].place)))) {
          reach[q].cost = scratch_.labels[index].g;
        }
      }
      Cost key = std::numeric_limits<Cost>::max();
      for (int p = begin; p <= end; ++p) {
        Cost cost = std::numeric_limits<Cost>::max();
        int over = p;  // the cell of the side on the way
        for (int q = std::max(p - 1, first); q <= std::min(p + 1, last); ++q) {
          const Cost way = reach[q].cost + (q == p ? straight_cost : diagonal_cost);
          if (way < cost) cost = way, over = q;
        }
        const Cell to = beyond.cell(p);
        if (improve(to, cost, grid_.index(edge.cell(over)))) {
          key = std::min(key, cost + estimate_(to));
        }
      }
      if (key < std::numeric_limits<Cost>::max()) {
        push({beyond.axis, beyond.line, begin, end, beyond.side}, key);
      }
    }
  }

  const S& space_;
  FreeRectangles rectangles_;
  OccupancyGrid::View grid_;
  const Query& query_;
  const LinkedQuery& linked_;
  OctileHeuristic estimate_;
  ReaScratch& scratch_;
  O& observer_;
  Statistics& stats_;
  std::uint64_t sequence_ = 0;
  Cost best_ = std::numeric_limits<Cost>::max();  // of a path to the goal
  std::size_t goal_ = 0;                          // its last cell
};

}  // namespace detail

template <GridSpace S, Observer O>
Expected<Route, Failure> ReaStar::search(const S& space, const Query& query, Scratch& scratch,
                                         O& observer) const {
  if (space.movement() != MovementRule::no_cut) {
    return fail(PlanError::invalid_option, "rea_star is defined for the movement rule no_cut");
  }
  std::optional<Cost> paid;
  auto route = search_grid(space, query, scratch.cells,
                           [&](const LinkedQuery& linked, std::vector<Cell>& cells,
                               Statistics& stats) -> std::optional<Failure> {
                             detail::RectangleSearch<S, O> search(space, query, linked, scratch,
                                                                  observer, stats);
                             if (auto failure = search.run()) return failure;
                             search.path(cells);
                             paid = search.cost();
                             return std::nullopt;
                           });
  if (route && paid) {
    route->cost = in_metres(*paid, Frame(space.frame()).resolution);
  }
  return route;
}

}  // namespace tutavia
