// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/plan/query.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/grid/search_grid.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/rectangle/exit.hpp"
#include "tutavia/search/rectangle/free_rectangle.hpp"
#include "tutavia/search/rectangle/portal_chain.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Two waves of free rectangles that meet: the search of SbReaStar and ImprovedReaStar.

namespace tutavia::detail {

/// Rectangles grow from the start and from the goal by turns, in each wave from the exit with
/// the smallest key, until one holds cells of a exit of the other wave (or, if the search is to
/// go on, until no key is below the length of the best such meeting); until then a new exit with
/// cells in a rectangle of the other wave is a meeting, too. A exit whose next cells lie in
/// rectangles of its wave already leads nowhere new and is left out; a wave that comes to its end
/// has therefore seen all it can reach.
template <ColumnSpace S, ExitEvaluation Evaluation, Observer O>
class BidirectionalRectangles {
 public:
  using Wave = RectangleExpansion<Evaluation>;

  BidirectionalRectangles(SearchContext<S, O>& context, const GridQuery& linked,
                          BidirectionalRectanglesScratch<Evaluation>& scratch)
      : context_(context),
        space_(context.space),
        free_(space_),
        linked_(linked),
        scratch_(scratch) {}

  Expected<void, Failure> run(bool continue_after_contact) {
    reset(scratch_.waves[0], linked_);
    reset(scratch_.waves[1], linked_.reversed());
    for (std::size_t turn = 0; continue_after_contact || !met(); turn = 1 - turn) {
      auto next = pop(scratch_.waves[turn]);
      if (!next) {
        if (!met()) return fail(PlanError::unreachable);
        turn = 1 - turn;
        next = pop(scratch_.waves[turn]);
        if (!next) break;
      }
      if (auto within = context_.check_budget(64); !within) return within;
      expand(turn, *next);
    }
    return {};
  }

  /// The rails of the path that was found, from start to goal, the first and the last a root;
  /// `joint` is the one where the waves met. Nodes where the evaluation has them.
  void follow(std::vector<Rail>& rails, std::size_t& joint) {
    rails.clear();
    Wave &mine = scratch_.waves[best_.turn], &other = scratch_.waves[1 - best_.turn];
    rails.push_back({best_.joint, best_.joint.axis == 0 ? best_.cell.x : best_.cell.y});
    append_way(mine, best_.entry, rails);
    std::reverse(rails.begin(), rails.end());
    joint = rails.size() - 1;
    const Exit& exit = other.exits[best_.exit];
    if (!is_root(other, best_.exit)) append_way(other, exit.parent, rails);
    for (std::size_t i = joint; i < rails.size(); ++i) rails[i].cells.side *= -1;
    if (best_.turn == 0) return;
    std::reverse(rails.begin(), rails.end());
    for (Rail& rail : rails) rail.cells.side *= -1;
    joint = rails.size() - 1 - joint;
  }

 private:
  static constexpr bool looks_from_cells = CellwiseEvaluation<Evaluation>;

  struct Meeting {
    double length = std::numeric_limits<double>::max();
    Cell cell{};
    CellInterval joint{};
    std::size_t turn = 0;     // the wave whose rectangle it is
    std::uint32_t entry = 0;  // the exit that the rectangle grew from
    std::uint32_t exit = 0;   // of the other wave
  };

  /// Appends the rails from a exit back to its root, on the way from the last node.
  static void append_way(Wave& wave, std::uint32_t from, std::vector<Rail>& rails) {
    while (true) {
      const Exit& exit = wave.exits[from];
      const int place = wave.evaluation.place_before(exit, rails.back().node());
      rails.push_back({exit.cells, place});
      if (is_root(wave, from)) return;
      from = exit.parent;
    }
  }

  bool met() const { return best_.length < std::numeric_limits<double>::max(); }

  void reset(Wave& wave, const GridQuery& there) {
    wave.exits.clear();
    wave.expanded.clear();
    wave.open.clear();
    const OccupancyGrid& grid = space_.grid();
    wave.marked.reset(grid);
    wave.covered.reset(grid);
    if (wave.markers.size() < grid.index_count()) wave.markers.resize(grid.index_count());
    wave.evaluation.reset(there.goal_cell, there.goal_offset, grid);
    for (const auto& [cell, cost] : there.starts) {
      Exit root{.cells = {0, cell.y, cell.x, cell.x, 1}, .parent = next(wave)};
      const double key = wave.evaluation.root(root, cost);
      push(wave, root, key);
    }
  }

  static std::uint32_t next(const Wave& wave) {
    return static_cast<std::uint32_t>(wave.exits.size());
  }

  void push(Wave& wave, const Exit& exit, double key) {
    const CellInterval& cells = exit.cells;
    for (int u = cells.first; u <= cells.last; ++u) {
      wave.marked.add(cells.cell(u));
      wave.markers[space_.grid().index(cells.cell(u))] = next(wave);
    }
    wave.open.push({key, next(wave)});
    wave.exits.push_back(exit);
    context_.count_generated(cells.middle());
  }

  static bool is_root(const Wave& wave, std::uint32_t exit) {
    return wave.exits[exit].parent == exit;
  }

  /// The exit with the smallest key, of those that lead to cells that no rectangle of the wave
  /// holds, if that key is below the length of the best path.
  std::optional<std::uint32_t> pop(Wave& wave) {
    while (!wave.open.empty() && wave.open.top().key < best_.length) {
      const std::uint32_t exit = wave.open.pop().exit;
      const CellInterval& cells = wave.exits[exit].cells;
      if (is_root(wave, exit) || !wave.covered.holds(cells.beyond())) return exit;
    }
    return std::nullopt;
  }

  void expand(std::size_t turn, std::uint32_t from) {
    Wave& wave = scratch_.waves[turn];
    Wave& other = scratch_.waves[1 - turn];
    const CellInterval cells = wave.exits[from].cells;
    const bool had_met = met();
    context_.count_expanded(cells.middle());
    const bool root = is_root(wave, from);
    const CellRectangle r = root ? free_.grow_around(cells.cell(cells.first)) : free_.grow(cells);
    notify_rectangle(context_.observer, space_, cells, r);
    wave.exits[from].rectangle = r;
    wave.expanded.push_back(from);
    wave.covered.add(r);
    if constexpr (looks_from_cells) wave.evaluation.expand(wave.exits[from]);
    const std::uint64_t now = context_.statistics.expanded;
    other.marked.for_each_in(r, [&](Cell cell) {
      const std::uint32_t exit = other.markers[space_.grid().index(cell)];
      if (std::exchange(other.exits[exit].asked, now) != now) {
        consider(turn, from, exit);
      }
    });
    const std::uint32_t old = next(wave);
    for (const int side : {1, -1}) {
      for (const int axis : {cells.axis, 1 - cells.axis}) leave(wave, from, r.edge(axis, side));
    }
    if (!had_met) look_for_meetings(turn, old);
  }

  /// Considers the exits of a wave from `first` on that have cells in rectangles of the other
  /// wave.
  void look_for_meetings(std::size_t turn, std::uint32_t first) {
    const Wave& wave = scratch_.waves[turn];
    Wave& other = scratch_.waves[1 - turn];
    for (std::uint32_t p = first; p < wave.exits.size(); ++p) {
      if (!other.covered.meets(wave.exits[p].cells)) continue;
      for (const std::uint32_t entry : other.expanded) {
        const Exit& grown = other.exits[entry];
        if (grown.rectangle.clip(wave.exits[p].cells).run().size() <= 0) continue;
        if constexpr (looks_from_cells) other.evaluation.expand(grown);
        consider(1 - turn, entry, p);
      }
    }
  }

  /// Leaves a rectangle by a side of it; where the exit lies on that side, beside the exit.
  void leave(Wave& wave, std::uint32_t from, const CellInterval& edge) {
    const CellInterval& cells = wave.exits[from].cells;
    const bool is_entered =
        !is_root(wave, from) && edge.axis == cells.axis && edge.side == -cells.side;
    if (!is_entered) {
      add_passages(wave, from, edge);
      return;
    }
    CellInterval left = edge, right = edge;
    left.last = cells.first - 1;
    right.first = cells.last + 1;
    add_passages(wave, from, left);
    add_passages(wave, from, right);
  }

  /// Adds the exits out of a rectangle over an edge of it.
  void add_passages(Wave& wave, std::uint32_t from, const CellInterval& edge) {
    scratch_.exits.clear();
    const CellInterval beyond = edge.beyond();
    free_.append_free_runs(edge.axis, beyond.line, edge.run(), scratch_.exits);
    if (scratch_.exits.empty()) return;
    CellInterval asked = edge;
    asked.first = scratch_.exits.front().first;
    asked.last = scratch_.exits.back().last;
    bool reached = false;
    for (const auto& [first, last] : scratch_.exits) {
      const CellInterval cells{edge.axis, edge.line, first, last, edge.side};
      if (wave.covered.holds(cells.beyond())) continue;
      if (!std::exchange(reached, true)) {
        if constexpr (looks_from_cells) wave.evaluation.reach(asked);
      }
      Exit exit{.cells = cells, .parent = from};
      const double key = wave.evaluation.enter(exit, wave.exits[from]);
      push(wave, exit, key);
    }
  }

  /// Looks for a better path through the rectangle that grew from a exit of one wave, expanded
  /// last, and a exit of the other wave with cells in it.
  void consider(std::size_t turn, std::uint32_t entry, std::uint32_t exit) {
    Wave& mine = scratch_.waves[turn];
    const Wave& other = scratch_.waves[1 - turn];
    const Exit &from = mine.exits[entry], &to = other.exits[exit];
    const CellInterval joint = from.rectangle.clip(to.cells);
    const auto [length, cell] = mine.evaluation.meet(from, other.evaluation, to, joint);
    if (length < best_.length) best_ = {length, cell, joint, turn, entry, exit};
  }

  SearchContext<S, O>& context_;
  const S& space_;
  FreeRectangles free_;
  const GridQuery& linked_;
  BidirectionalRectanglesScratch<Evaluation>& scratch_;
  Meeting best_;
};

/// BidirectionalRectangles for search_grid; see `bidirectional_rectangles`.
template <ExitEvaluation Evaluation,
          std::invocable<std::vector<Rail>&, std::size_t, std::vector<Cell>&> LayPath>
struct RectangleWavesSearch {
  BidirectionalRectanglesScratch<Evaluation>& scratch;
  bool continue_after_contact;
  const LayPath& lay_path;

  template <ColumnSpace S, Observer O>
  Expected<GridPath, Failure> run(const GridQuery& linked, SearchContext<S, O>& context) const {
    BidirectionalRectangles<S, Evaluation, O> waves(context, linked, scratch);
    auto found = waves.run(continue_after_contact);
    if (!found) return std::move(found).unexpected();
    std::size_t joint = 0;
    waves.follow(scratch.rails, joint);
    scratch.cells.clear();
    lay_path(scratch.rails, joint, scratch.cells);
    return GridPath{scratch.cells};
  }
};

/// Searches by waves of rectangles; `lay_path(rails, joint, cells)` makes of the rails the cells of
/// the path's corners, from the last to the first.
template <ExitEvaluation Evaluation, ColumnSpace S,
          std::invocable<std::vector<Rail>&, std::size_t, std::vector<Cell>&> LayPath, Observer O>
Expected<Route, Failure> bidirectional_rectangles(
    const S& space, const Query& query, BidirectionalRectanglesScratch<Evaluation>& scratch,
    O& observer, std::string_view name, bool continue_after_contact, const LayPath& lay_path) {
  if (auto valid = check_no_cut(space, name); !valid) return std::move(valid).unexpected();
  const RectangleWavesSearch<Evaluation, LayPath> search{scratch, continue_after_contact, lay_path};
  return search_grid(space, query, observer, search);
}

}  // namespace tutavia::detail
