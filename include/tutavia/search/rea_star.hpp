// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/search/concepts.hpp"
#include "tutavia/search/heuristic.hpp"
#include "tutavia/search/linked_query.hpp"
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
  /// Cells of one line with the free rectangle still to be grown from them: along x (`axis` 0) or
  /// along y (1), on the line `line`, on towards `side`.
  struct Interval {
    int axis = 0, line = 0, first = 0, last = 0, side = 1;
  };
  struct Entry {
    Cost key;
    std::uint64_t sequence;
    Interval interval;
    friend bool operator<(const Entry& a, const Entry& b) {  // for std::push_heap: worse < better
      return a.key != b.key ? a.key > b.key : a.sequence > b.sequence;
    }
  };
  /// The cheapest of some cells of an interval, by what it costs to the cell at hand.
  struct Source {
    Cost cost;
    int place;
  };

  /// Cells of a line from the first to the last.
  struct Run {
    int first, last;
  };

  QueryLabels<Label> labels;
  std::vector<Entry> open;
  std::vector<Cost> costs;                             // g along the interval that is expanded
  std::vector<Source> reached, before, after, window;  // see detail::RectangleSearch
  std::vector<Run> exits;
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
        lines_{&space.grid(), &space.columns()},
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
      observer_.expanded(middle(entry.interval));
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
  using Interval = ReaScratch::Interval;
  using Source = ReaScratch::Source;

  /// Columns [u0, u1] along an axis on the lines [v0, v1].
  struct Rectangle {
    int u0, u1, v0, v1;
  };
  static constexpr Source nowhere{std::numeric_limits<Cost>::max(), 0};
  static constexpr Cost aslant = diagonal_cost - straight_cost;

  static Cell cell(int axis, int u, int v) { return axis == 0 ? Cell{u, v} : Cell{v, u}; }
  Point middle(const Interval& interval) const {
    return space_.frame().point(
        cell(interval.axis, (interval.first + interval.last) / 2, interval.line));
  }
  bool is_free(int axis, int u, int v) const { return space_.grid().is_free(cell(axis, u, v)); }
  /// Whether the cells [first, last] of a line are free.
  bool is_free(int axis, int line, int first, int last) const {
    const OccupancyGrid& lines = *lines_[static_cast<std::size_t>(axis)];
    return line >= 0 && line < lines.height() && lines.run_end(line, first, true) > last;
  }

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

  void push(const Interval& interval, Cost key) {
    if (key >= best_) return;
    scratch_.open.push_back({key, sequence_++, interval});
    std::push_heap(scratch_.open.begin(), scratch_.open.end());
    ++stats_.generated;
    observer_.generated(middle(interval));
  }

  /// Reads the costs along an interval, less the cells at its ends that were expanded already.
  /// Returns whether there are others.
  bool take(Interval& interval) {
    const auto is_new = [&](int u) {
      const auto& label = scratch_.labels[grid_.index(cell(interval.axis, u, interval.line))];
      return label.g < label.expanded;
    };
    while (interval.first <= interval.last && !is_new(interval.first)) ++interval.first;
    while (interval.first <= interval.last && !is_new(interval.last)) --interval.last;
    scratch_.costs.clear();
    for (int u = interval.first; u <= interval.last; ++u) {
      ReaScratch::Label& label =
          scratch_.labels[grid_.index(cell(interval.axis, u, interval.line))];
      label.expanded = label.g;
      scratch_.costs.push_back(label.g);
    }
    return !scratch_.costs.empty();
  }

  /// Grows the largest free rectangle from an interval: on to its side, then along it both ways.
  Rectangle grow(const Interval& from) const {
    Rectangle rectangle{from.first, from.last, from.line, from.line};
    int& front = from.side > 0 ? rectangle.v1 : rectangle.v0;
    while (is_free(from.axis, front + from.side, from.first, from.last)) front += from.side;
    const int across = 1 - from.axis;
    while (is_free(across, rectangle.u0 - 1, rectangle.v0, rectangle.v1)) --rectangle.u0;
    while (is_free(across, rectangle.u1 + 1, rectangle.v0, rectangle.v1)) ++rectangle.u1;
    return rectangle;
  }

  void expand(const Interval& from) {
    const Rectangle r = grow(from);
    for (const auto& [goal, cost] : linked_.goals) relax_inside(from, r, goal);
    for (const int side : {1, -1}) {
      const int line = side > 0 ? r.v1 : r.v0, column = side > 0 ? r.u1 : r.u0;
      if (find_exits(from.axis, r.u0, r.u1, line, side)) {
        reach_line(from, std::abs(line - from.line));
        leave(from, from.axis, r.u0, r.u1, line, side);
      }
      if (find_exits(1 - from.axis, r.v0, r.v1, column, side)) {
        reach_column(from, column);
        leave(from, 1 - from.axis, r.v0, r.v1, column, side);
      }
    }
  }

  /// Finds the free intervals beyond a side of a rectangle, by one cell longer where a diagonal out
  /// of the corner is legal, and the cells of the side that lead there: between the first and the
  /// last of them. Returns whether there are any.
  bool find_exits(int axis, int u0, int u1, int line, int side) {
    scratch_.exits.clear();
    const OccupancyGrid& lines = *lines_[static_cast<std::size_t>(axis)];
    const int next = line + side;
    if (next < 0 || next >= lines.height()) return false;
    const auto opens = [&](int corner, int beyond) {
      return beyond >= 0 && beyond < lines.width() && is_free(axis, beyond, line) &&
             is_free(axis, corner, next) && is_free(axis, beyond, next);
    };
    const int first = opens(u0, u0 - 1) ? u0 - 1 : u0, last = opens(u1, u1 + 1) ? u1 + 1 : u1;
    for (int u = first; u <= last;) {
      const int begin = lines.run_end(next, u, false);
      if (begin > last) break;
      const int end = std::min(lines.run_end(next, begin, true) - 1, last);
      scratch_.exits.push_back({begin, end});
      u = end + 1;
    }
    if (scratch_.exits.empty()) return false;
    first_ = std::max(scratch_.exits.front().first, u0);
    last_ = std::min(scratch_.exits.back().last, u1);
    scratch_.reached.assign(static_cast<std::size_t>(last_ - first_ + 1), nowhere);
    return true;
  }

  Cost g(const Interval& from, int u) const {
    return scratch_.costs[static_cast<std::size_t>(u - from.first)];
  }
  /// What it costs to the cell of a side at hand.
  Source& reached(int u) { return scratch_.reached[static_cast<std::size_t>(u - first_)]; }
  static void lower(Source& to, const Source& from, Cost way) {
    if (from.cost < nowhere.cost && from.cost + way < to.cost) to = {from.cost + way, from.place};
  }

  /// The cells of a side that lies `depth` lines from the interval. The way from a cell of the
  /// interval to one that lies `aside` has as many slant steps as the smaller of depth and aside,
  /// and is straight for the rest: so the cheapest of them is sought among those within `depth` on
  /// either hand, by a sliding window, and among those beyond.
  void reach_line(const Interval& from, int depth) {
    for (const int hand : {1, -1}) {   // the cells to the left, then to the right
      auto& window = scratch_.window;  // of cost - aslant * place, ever dearer
      window.clear();
      std::size_t head = 0;
      Source beyond = nowhere;  // of cost - straight * place
      const int begin = hand > 0 ? std::min(first_, from.first) : std::max(last_, from.last);
      const int end = hand > 0 ? last_ + 1 : first_ - 1;
      for (int u = begin; u != end; u += hand) {
        if (from.first <= u && u <= from.last) {
          const Source entering{g(from, u) - aslant * hand * u, u};
          while (window.size() > head && window.back().cost > entering.cost) window.pop_back();
          window.push_back(entering);
        }
        const int gone = u - hand * (depth + 1);
        if (from.first <= gone && gone <= from.last) {
          if (head < window.size() && window[head].place == gone) ++head;
          const Cost cost = g(from, gone) - straight_cost * hand * gone;
          if (cost < beyond.cost) beyond = {cost, gone};
        }
        if (u < first_ || u > last_) continue;
        if (head < window.size()) {
          lower(reached(u), window[head], aslant * hand * u + straight_cost * depth);
        }
        lower(reached(u), beyond, straight_cost * hand * u + aslant * depth);
      }
    }
  }

  /// The cells of a side across the interval, at `column`. Cells no further aside than a line is
  /// deep are cheapest of those up to there, others of those from there on.
  void reach_column(const Interval& from, int column) {
    const int hand = column <= from.first ? 1 : -1;
    const int nearest = hand > 0 ? from.first : from.last;
    const int count = from.last - from.first + 1;
    auto &before = scratch_.before, &after = scratch_.after;
    before.clear();
    after.assign(static_cast<std::size_t>(count) + 1, nowhere);
    for (int k = 0; k < count; ++k) {
      const int u = nearest + hand * k;
      const Source source{g(from, u) + aslant * std::abs(u - column), u};
      before.push_back(k > 0 && before.back().cost <= source.cost ? before.back() : source);
    }
    for (int k = count; k-- > 0;) {
      const int u = nearest + hand * k;
      const Source source{g(from, u) + straight_cost * std::abs(u - column), u};
      const auto i = static_cast<std::size_t>(k);
      after[i] = after[i + 1].cost <= source.cost ? after[i + 1] : source;
    }
    for (int v = first_; v <= last_; ++v) {
      const int depth = std::abs(v - from.line);
      const int within = std::clamp(depth - std::abs(nearest - column) + 1, 0, count);
      const auto i = static_cast<std::size_t>(within);
      if (within > 0) lower(reached(v), before[i - 1], straight_cost * depth);
      lower(reached(v), after[i], aslant * depth);
    }
  }

  /// A goal's cell that the rectangle may hold.
  void relax_inside(const Interval& from, const Rectangle& r, Cell goal) {
    const int u = from.axis == 0 ? goal.x : goal.y, v = from.axis == 0 ? goal.y : goal.x;
    if (u < r.u0 || u > r.u1 || v < r.v0 || v > r.v1) return;
    Source best = nowhere;
    for (int j = from.first; j <= from.last; ++j) {
      const Cost cost = g(from, j) + octile_cost({u, v}, {j, from.line});
      if (cost < best.cost) best = {cost, j};
    }
    improve(goal, best.cost, grid_.index(cell(from.axis, best.place, from.line)));
  }

  /// Steps out of a rectangle over its side on `line` into the intervals found beyond.
  void leave(const Interval& from, int axis, int u0, int u1, int line, int side) {
    const int next = line + side;
    for (const auto& [begin, end] : scratch_.exits) {
      const int first = std::max(begin, u0), last = std::min(end, u1);
      for (int q = first; q <= last; ++q) {
        Source& source = reached(q);
        const Cell on_side = cell(axis, q, line);
        const Cell origin = cell(from.axis, source.place, from.line);
        if (!improve(on_side, source.cost, grid_.index(origin))) {
          source.cost = scratch_.labels[grid_.index(on_side)].g;
        }
      }
      Cost key = std::numeric_limits<Cost>::max();
      for (int p = begin; p <= end; ++p) {
        Cost cost = std::numeric_limits<Cost>::max();
        int over = p;  // the cell of the side on the way
        for (int q = std::max(p - 1, first); q <= std::min(p + 1, last); ++q) {
          const Cost way = reached(q).cost + (q == p ? straight_cost : diagonal_cost);
          if (way < cost) cost = way, over = q;
        }
        const Cell to = cell(axis, p, next);
        if (improve(to, cost, grid_.index(cell(axis, over, line)))) {
          key = std::min(key, cost + estimate_(to));
        }
      }
      if (key < std::numeric_limits<Cost>::max()) push({axis, next, begin, end, side}, key);
    }
  }

  const S& space_;
  std::array<const OccupancyGrid*, 2> lines_;  // by axis: rows, and columns as rows
  OccupancyGrid::View grid_;
  const Query& query_;
  const LinkedQuery& linked_;
  OctileHeuristic estimate_;
  ReaScratch& scratch_;
  O& observer_;
  Statistics& stats_;
  int first_ = 0, last_ = 0;  // of the side of a rectangle that is left
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
