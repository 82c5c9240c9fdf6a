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
/// BidirectionalRectangles: rectangle expansion from both ends.

namespace tutavia::detail {

/// Rectangle expansion from the start and from the goal in turn. Each side expands its exit with
/// the smallest key into a rectangle. The sides meet when a rectangle of one side contains cells of
/// an exit of the other. Before the first meeting, a new exit with cells in a rectangle of the
/// other side counts as a meeting too. The search ends at the first meeting or, with
/// `continue_after_contact`, when no key is below the length of the best meeting.
///
/// An exit is skipped if rectangles of its own side already cover the cells beyond it. A side
/// without open exits has therefore reached all it can reach.
template <ColumnSpace S, ExitEvaluation Evaluation, Observer O>
class BidirectionalRectangles {
 public:
  using Expansion = RectangleExpansion<Evaluation>;

  BidirectionalRectangles(SearchContext<S, O>& context, const GridQuery& linked,
                          BidirectionalRectanglesScratch<Evaluation>& scratch)
      : context_(context),
        space_(context.space),
        free_(space_),
        linked_(linked),
        scratch_(scratch) {}

  Expected<void, Failure> run(bool continue_after_contact) {
    reset(scratch_.expansions[0], linked_);
    reset(scratch_.expansions[1], linked_.reversed());
    for (std::size_t turn = 0; continue_after_contact || !met(); turn = 1 - turn) {
      auto next = pop(scratch_.expansions[turn]);
      if (!next) {
        if (!met()) return fail(PlanError::unreachable);
        turn = 1 - turn;
        next = pop(scratch_.expansions[turn]);
        if (!next) break;
      }
      if (auto within = context_.check_budget(64); !within) return within;
      expand(turn, *next);
    }
    return {};
  }

  /// The portals of the path found, from start to goal; the first and the last are roots. `meeting`
  /// is the index of the portal where the sides met. The evaluation places the nodes.
  void follow(std::vector<CellPortal>& portals, std::size_t& meeting) {
    portals.clear();
    Expansion &mine = scratch_.expansions[best_.turn], &other = scratch_.expansions[1 - best_.turn];
    portals.push_back({best_.meeting, best_.meeting.axis == 0 ? best_.cell.x : best_.cell.y});
    append_path(mine, best_.entry, portals);
    std::reverse(portals.begin(), portals.end());
    meeting = portals.size() - 1;
    const Exit& exit = other.exits[best_.exit];
    if (!is_root(other, best_.exit)) append_path(other, exit.parent, portals);
    for (std::size_t i = meeting; i < portals.size(); ++i) portals[i].cells.side *= -1;
    if (best_.turn == 0) return;
    std::reverse(portals.begin(), portals.end());
    for (CellPortal& portal : portals) portal.cells.side *= -1;
    meeting = portals.size() - 1 - meeting;
  }

 private:
  static constexpr bool is_cellwise = CellwiseEvaluation<Evaluation>;

  struct Meeting {
    double length = std::numeric_limits<double>::max();
    Cell cell{};
    CellInterval meeting{};
    std::size_t turn = 0;     // the side whose rectangle it is
    std::uint32_t entry = 0;  // the exit from which the rectangle grew
    std::uint32_t exit = 0;   // of the other side
  };

  /// Appends the portals from an exit back to its root. Each node is placed for the path to the
  /// node before it.
  static void append_path(Expansion& expansion, std::uint32_t from,
                          std::vector<CellPortal>& portals) {
    while (true) {
      const Exit& exit = expansion.exits[from];
      const int u = expansion.evaluation.source_of(exit, portals.back().node());
      portals.push_back({exit.cells, u});
      if (is_root(expansion, from)) return;
      from = exit.parent;
    }
  }

  bool met() const { return best_.length < std::numeric_limits<double>::max(); }

  void reset(Expansion& expansion, const GridQuery& endpoints) {
    expansion.exits.clear();
    expansion.expanded.clear();
    expansion.open.clear();
    const OccupancyGrid& grid = space_.grid();
    expansion.marked.reset(grid);
    expansion.covered.reset(grid);
    if (expansion.markers.size() < grid.index_count()) expansion.markers.resize(grid.index_count());
    expansion.evaluation.reset(endpoints.goal_cell, endpoints.goal_offset, grid);
    for (const auto& [cell, cost] : endpoints.starts) {
      Exit root{.cells = {0, cell.y, cell.x, cell.x, 1}, .parent = next(expansion)};
      const double key = expansion.evaluation.root(root, cost);
      push(expansion, root, key);
    }
  }

  static std::uint32_t next(const Expansion& expansion) {
    return static_cast<std::uint32_t>(expansion.exits.size());
  }

  void push(Expansion& expansion, const Exit& exit, double key) {
    const CellInterval& cells = exit.cells;
    for (int u = cells.first; u <= cells.last; ++u) {
      expansion.marked.add(cells.cell(u));
      expansion.markers[space_.grid().index(cells.cell(u))] = next(expansion);
    }
    expansion.open.push({key, next(expansion)});
    expansion.exits.push_back(exit);
    context_.count_generated(cells.middle());
  }

  static bool is_root(const Expansion& expansion, std::uint32_t exit) {
    return expansion.exits[exit].parent == exit;
  }

  /// The open exit with the smallest key, without exits to cells that rectangles of this side
  /// already cover. Empty if no such key is below the length of the best path.
  std::optional<std::uint32_t> pop(Expansion& expansion) {
    while (!expansion.open.empty() && expansion.open.top().key < best_.length) {
      const std::uint32_t exit = expansion.open.pop().exit;
      const CellInterval& cells = expansion.exits[exit].cells;
      if (is_root(expansion, exit) || !expansion.covered.holds(cells.beyond())) return exit;
    }
    return std::nullopt;
  }

  void expand(std::size_t turn, std::uint32_t from) {
    Expansion &expansion = scratch_.expansions[turn], &other = scratch_.expansions[1 - turn];
    const CellInterval cells = expansion.exits[from].cells;
    const bool had_met = met();
    context_.count_expanded(cells.middle());
    const CellRectangle r =
        is_root(expansion, from) ? free_.grow_around(cells.cell(cells.first)) : free_.grow(cells);
    const SearchSide whose = turn == 0 ? SearchSide::start : SearchSide::goal;
    notify_rectangle(context_.observer, space_, cells, r, whose);
    expansion.exits[from].rectangle = r;
    expansion.expanded.push_back(from);
    expansion.covered.add(r);
    if constexpr (AimedEvaluation<Evaluation>) {
      const auto& done = other.expanded;
      if (!done.empty()) expansion.evaluation.aim_at(other.exits[done.back()].cells);
    }
    if constexpr (is_cellwise) expansion.evaluation.expand(expansion.exits[from]);
    const std::uint64_t now = context_.statistics.expanded;
    other.marked.for_each_in(r, [&](Cell cell) {
      const std::uint32_t exit = other.markers[space_.grid().index(cell)];
      if (std::exchange(other.exits[exit].last_visited, now) != now) {
        consider(turn, from, exit);
      }
    });
    const std::uint32_t old = next(expansion);
    for (const int side : {1, -1}) {
      for (const int axis : {cells.axis, 1 - cells.axis}) {
        cross_side(expansion, from, r.edge(axis, side));
      }
    }
    if (!had_met) look_for_meetings(turn, old);
  }

  /// Considers the exits from number `first` on that have cells in rectangles of the other side.
  void look_for_meetings(std::size_t turn, std::uint32_t first) {
    const Expansion& expansion = scratch_.expansions[turn];
    Expansion& other = scratch_.expansions[1 - turn];
    for (std::uint32_t p = first; p < expansion.exits.size(); ++p) {
      if (!other.covered.meets(expansion.exits[p].cells)) continue;
      for (const std::uint32_t entry : other.expanded) {
        const Exit& grown = other.exits[entry];
        if (grown.rectangle.clip(expansion.exits[p].cells).run().size() <= 0) continue;
        if constexpr (is_cellwise) other.evaluation.expand(grown);
        consider(1 - turn, entry, p);
      }
    }
  }

  /// Adds the exits over one side of a rectangle. On the side where the rectangle was entered, only
  /// cells beside the entry count.
  void cross_side(Expansion& expansion, std::uint32_t from, const CellInterval& edge) {
    const CellInterval& cells = expansion.exits[from].cells;
    const bool is_entered =
        !is_root(expansion, from) && edge.axis == cells.axis && edge.side == -cells.side;
    if (!is_entered) {
      add_exits(expansion, from, edge);
      return;
    }
    CellInterval left = edge, right = edge;
    left.last = cells.first - 1;
    right.first = cells.last + 1;
    add_exits(expansion, from, left);
    add_exits(expansion, from, right);
  }

  /// Adds the exits over an edge of a rectangle.
  void add_exits(Expansion& expansion, std::uint32_t from, const CellInterval& edge) {
    scratch_.exits.clear();
    const CellInterval beyond = edge.beyond();
    free_.append_free_runs(edge.axis, beyond.line, edge.run(), scratch_.exits);
    if (scratch_.exits.empty()) return;
    CellInterval span = edge;  // the part of the edge that the exits need
    span.first = scratch_.exits.front().first;
    span.last = scratch_.exits.back().last;
    bool reached = false;
    for (const auto& [first, last] : scratch_.exits) {
      const CellInterval cells{edge.axis, edge.line, first, last, edge.side};
      if (expansion.covered.holds(cells.beyond())) continue;
      if (!std::exchange(reached, true)) {
        if constexpr (is_cellwise) expansion.evaluation.reach(span);
      }
      Exit exit{.cells = cells, .parent = from};
      const double key = expansion.evaluation.enter(exit, expansion.exits[from]);
      push(expansion, exit, key);
    }
  }

  /// Checks for a better path through the rectangle of `entry`, an exit of one side that was
  /// expanded last, and `exit`, an exit of the other side with cells in it.
  void consider(std::size_t turn, std::uint32_t entry, std::uint32_t exit) {
    Expansion& mine = scratch_.expansions[turn];
    const Expansion& other = scratch_.expansions[1 - turn];
    const Exit &from = mine.exits[entry], &to = other.exits[exit];
    const CellInterval meeting = from.rectangle.clip(to.cells);
    const auto [length, cell] = mine.evaluation.meet(from, other.evaluation, to, meeting);
    if (length < best_.length) best_ = {length, cell, meeting, turn, entry, exit};
  }

  SearchContext<S, O>& context_;
  const S& space_;
  FreeRectangles free_;
  const GridQuery& linked_;
  BidirectionalRectanglesScratch<Evaluation>& scratch_;
  Meeting best_;
};

/// Runs BidirectionalRectangles within `search_grid`; see `bidirectional_rectangles`.
template <ExitEvaluation Evaluation,
          std::invocable<std::vector<CellPortal>&, std::size_t, std::vector<Cell>&> LayPath>
struct BidirectionalRectanglesSearch {
  BidirectionalRectanglesScratch<Evaluation>& scratch;
  bool continue_after_contact;
  const LayPath& lay_path;

  template <ColumnSpace S, Observer O>
  Expected<GridPath, Failure> run(const GridQuery& linked, SearchContext<S, O>& context) const {
    BidirectionalRectangles<S, Evaluation, O> search(context, linked, scratch);
    auto found = search.run(continue_after_contact);
    if (!found) return std::move(found).unexpected();
    std::size_t meeting = 0;
    search.follow(scratch.portals, meeting);
    scratch.cells.clear();
    lay_path(scratch.portals, meeting, scratch.cells);
    return GridPath{scratch.cells};
  }
};

/// Searches by rectangle expansion from both ends. `lay_path(portals, meeting, cells)` turns the
/// portals into the cells of the path's vertices, from last to first.
template <ExitEvaluation Evaluation, ColumnSpace S,
          std::invocable<std::vector<CellPortal>&, std::size_t, std::vector<Cell>&> LayPath,
          Observer O>
Expected<Route, Failure> bidirectional_rectangles(
    const S& space, const Query& query, BidirectionalRectanglesScratch<Evaluation>& scratch,
    O& observer, std::string_view name, bool continue_after_contact, const LayPath& lay_path) {
  if (auto valid = check_no_cut(space, name); !valid) return std::move(valid).unexpected();
  const BidirectionalRectanglesSearch<Evaluation, LayPath> search{scratch, continue_after_contact,
                                                                  lay_path};
  return search_grid(space, query, observer, search);
}

}  // namespace tutavia::detail
