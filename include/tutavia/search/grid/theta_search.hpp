// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "tutavia/core/parts/zeroed_array.hpp"
#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/grid/search_grid.hpp"
#include "tutavia/search/grid/step_rule.hpp"
#include "tutavia/search/grid/wide_bucket_queue.hpp"
#include "tutavia/search/mesh/corner_graph.hpp"
#include "tutavia/search/node_placement.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// ThetaSearch: the search of Theta* and Lazy Theta*.

namespace tutavia::detail {

/// Memory of a Theta* search.
class ThetaScratch {
 public:
  struct Label {
    double g;              ///< length of the path found, in cells
    std::uint32_t parent;  ///< start of its last segment
    std::uint32_t stamp;
  };

  void reset(std::size_t size) {
    if (labels_.size() < size || query_ == last_query) {
      labels_ = ZeroedArray<Label>(size);
      query_ = 0;
    }
    ++query_;
  }

  bool reached(std::uint32_t node) const { return labels_[node].stamp >> 1 == query_; }
  bool closed(std::uint32_t node) const { return labels_[node].stamp == (query_ << 1 | 1); }
  const Label& operator[](std::uint32_t node) const { return labels_[node]; }
  void set(std::uint32_t node, double g, std::uint32_t parent) {
    labels_[node] = {g, parent, query_ << 1};
  }
  void close(std::uint32_t node) { labels_[node].stamp |= 1; }

  WideBucketQueueOf<6> open;  // narrow: closed cells stay closed, so order matters
  std::vector<Cell> cells;

 private:
  static constexpr std::uint32_t last_query = (std::uint32_t{1} << 31) - 1;

  ZeroedArray<Label> labels_;
  std::uint32_t query_ = 0;
};

/// A function that gives the legal steps from a node of the space's grid, by its index.
template <LineOfSightSpace S>
auto successors_of(const S& space) {
  if constexpr (GridSpace<S>) {
    return StepRule(space);
  } else {
    return [&space](std::size_t index) -> unsigned { return space.successors(index); };
  }
}

/// When a search tests the line of sight between a node and its parent.
enum class SightTest {
  at_once,       ///< when the node is reached: Theta*
  at_expansion,  ///< when the node is expanded: Lazy Theta*
};

/// One query of Theta* or Lazy Theta*. Nodes are cell indices, plus the query's start and goal if
/// they are not cells.
template <SightTest Test, LineOfSightSpace S, Observer O>
class ThetaSearch {
 public:
  ThetaSearch(SearchContext<S, O>& context, const GridQuery& linked, ThetaScratch& scratch)
      : context_(context),
        space_(context.space),
        grid_(space_.grid().view()),
        frame_(space_.frame()),
        successors_(successors_of(space_)),
        linked_(linked),
        labels_(scratch),
        cells_(static_cast<std::uint32_t>(space_.grid().index_count())),
        start_(linked.starts.is_cell() ? index(linked.starts.begin()->cell) : cells_),
        goal_(linked.goals.is_cell() ? index(linked.goals.begin()->cell) : cells_ + 1),
        start_position_(in_cells(context.query.start)),
        goal_position_(in_cells(context.query.goal)) {}

  Expected<void, Failure> run() {
    labels_.reset(std::size_t{cells_} + 2);
    labels_.open.reset(0);
    push(start_, 0, start_);
    while (!labels_.open.empty()) {
      labels_.open.seek_first();
      const std::uint32_t node = labels_.open.pop().node;
      if (labels_.closed(node)) continue;
      if (is_lazy && !resolve_parent(node)) continue;
      if (node == goal_) return {};
      if (auto within = context_.check_budget(); !within) return within;
      expand(node);
    }
    return fail(PlanError::unreachable);
  }

  /// The cells at which the path bends, from the goal back to the start. Start and goal are
  /// included only if they are cells.
  void trace(std::vector<Cell>& cells) const {
    cells.clear();
    for (std::uint32_t node = goal_;; node = labels_[node].parent) {
      if (node < cells_) cells.push_back(grid_.cell(node));
      if (node == start_) return;
    }
  }

 private:
  static constexpr bool is_lazy = Test == SightTest::at_expansion;

  void expand(std::uint32_t node) {
    context_.count_expanded(point(node));
    labels_.close(node);
    for_each_neighbour(node, [&](std::uint32_t next) {
      if (!labels_.closed(next)) relax(node, next);
    });
    if (node < cells_ && goal_ >= cells_ && linked_.exit_cost(grid_.cell(node))) relax(node, goal_);
  }

  /// Visits all nodes reached by one step or link, except by the goal's links.
  template <class Visit>
  void for_each_neighbour(std::uint32_t node, const Visit& visit) const {
    if (node >= cells_) {
      for (const CellLink& link : node == start_ ? linked_.starts : linked_.goals) {
        visit(index(link.cell));
      }
      return;
    }
    const Cell cell = grid_.cell(node);
    for (unsigned left = successors_(node); left != 0; left &= left - 1) {
      visit(index(cell + steps[static_cast<std::size_t>(std::countr_zero(left))]));
    }
  }

  /// Relaxes the path from `node` to its neighbour `next`, or the straight one from the parent of
  /// `node` if that sees `next`.
  void relax(std::uint32_t node, std::uint32_t next) {
    const double known =
        labels_.reached(next) ? labels_[next].g : std::numeric_limits<double>::infinity();
    const std::uint32_t parent = labels_[node].parent;
    const double straight = labels_[parent].g + length(parent, next);
    if (straight >= known) return;  // so is the path by `node`: the triangle inequality
    if (is_lazy || parent == node || sees(parent, next)) {
      push(next, straight, parent);
    } else if (const double bent = labels_[node].g + length(node, next); bent < known) {
      push(next, bent, node);
    }
  }

  void push(std::uint32_t reached, double g, std::uint32_t parent) {
    context_.count_generated(point(reached));
    labels_.set(reached, g, parent);
    labels_.open.push(static_cast<Cost>((g + length(position(reached), goal_position_)) *
                                        static_cast<double>(straight_cost)),
                      reached, 0);
  }

  /// Lazy Theta*: if its parent does not see a node, the node gets the best of its closed
  /// neighbours as parent and is pushed again. Returns whether the node can be expanded now. (The
  /// published algorithm expands it at once, out of order; on maps full of obstacles its paths are
  /// up to 0.4 % longer.)
  bool resolve_parent(std::uint32_t node) {
    if (node == start_ || sees(labels_[node].parent, node)) return true;
    double best = std::numeric_limits<double>::infinity();
    std::uint32_t parent = node;
    const auto try_parent = [&](std::uint32_t neighbour) {
      if (!labels_.closed(neighbour)) return;
      const double g = labels_[neighbour].g + length(neighbour, node);
      if (g < best) {
        best = g;
        parent = neighbour;
      }
    };
    for_each_neighbour(node, try_parent);
    if (node < cells_ && start_ >= cells_ && linked_.starts.cost_of(grid_.cell(node))) {
      try_parent(start_);
    }
    // The grid allows this step, even if it does not count as a line of sight.
    if (parent == labels_[node].parent) return true;
    push(node, best, parent);
    return false;
  }

  bool sees(std::uint32_t a, std::uint32_t b) const {
    if (a < cells_ && b < cells_) return space_.line_of_sight(grid_.cell(a), grid_.cell(b));
    return space_.segment_free(point(a), point(b));
  }

  /// Coordinates in cells.
  struct CellCoords {
    double x, y;
  };
  CellCoords in_cells(const Point& p) const {
    const Point offset = (p - frame_.origin) / frame_.resolution;
    return {offset.x(), offset.y()};
  }
  CellCoords position(std::uint32_t node) const {
    if (node >= cells_) return node == cells_ ? start_position_ : goal_position_;
    const Cell cell = grid_.cell(node);
    return {static_cast<double>(cell.x), static_cast<double>(cell.y)};
  }
  static double length(CellCoords a, CellCoords b) {
    const double dx = a.x - b.x, dy = a.y - b.y;
    return std::sqrt(dx * dx + dy * dy);
  }
  double length(std::uint32_t a, std::uint32_t b) const { return length(position(a), position(b)); }

  Point point(std::uint32_t node) const {
    if (node < cells_) return frame_.point(grid_.cell(node));
    return node == cells_ ? context_.query.start : context_.query.goal;
  }
  std::uint32_t index(Cell cell) const { return static_cast<std::uint32_t>(grid_.index(cell)); }

  SearchContext<S, O>& context_;
  const S& space_;
  OccupancyGrid::View grid_;
  Frame frame_;
  decltype(successors_of(std::declval<const S&>())) successors_;
  const GridQuery& linked_;
  ThetaScratch& labels_;
  std::uint32_t cells_;
  std::uint32_t start_, goal_;
  CellCoords start_position_, goal_position_;
};

/// Runs a ThetaSearch within `search_grid`.
template <SightTest Test>
struct ThetaGridSearch {
  ThetaScratch& scratch;
  static constexpr bool takes_any_steps = true;

  template <LineOfSightSpace S, Observer O>
  Expected<GridPath, Failure> run(const GridQuery& linked, SearchContext<S, O>& context) const {
    ThetaSearch<Test, S, O> search(context, linked, scratch);
    if (auto found = search.run(); !found) return std::move(found).unexpected();
    search.trace(scratch.cells);
    return GridPath{scratch.cells};
  }
};

template <SightTest Test, LineOfSightSpace S, Observer O>
Expected<Route, Failure> theta_search(const S& space, const Query& query, NodePlacement nodes,
                                      ThetaScratch& scratch, O& observer) {
  if (nodes == NodePlacement::cell_centre) {
    return search_grid(space, query, observer, ThetaGridSearch<Test>{scratch});
  }
  if constexpr (std::same_as<S, CellSpace>) {
    const OccupancyGrid& cells = space.cells();
    if (!OccupancyGrid::fits(cells.width() + std::int64_t{1}, cells.height() + std::int64_t{1})) {
      return fail(PlanError::limit_exceeded, "the grid has too many corners for 32-bit indices");
    }
    if (space.safety_radius() == 0) {
      if (auto valid = check_query(space, query); !valid) return std::move(valid).unexpected();
      return search_grid(CornerGraph(space), query, observer, ThetaGridSearch<Test>{scratch});
    }
  }
  return fail(PlanError::invalid_option, "cell_corner is defined for cells at safety radius 0");
}

}  // namespace tutavia::detail
