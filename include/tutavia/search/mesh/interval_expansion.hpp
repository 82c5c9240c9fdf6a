// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "tutavia/geometry/predicates.hpp"
#include "tutavia/grid/bitboard/free_runs.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/statistics.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/mesh/convex_pieces.hpp"
#include "tutavia/search/mesh/interval_geometry.hpp"
#include "tutavia/search/mesh/interval_scratch.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// IntervalExpansion: the successors of a search node of Polyanya.

namespace tutavia::detail {

/// The search nodes of one query over a decomposition of the free cells into convex pieces.
///
/// A node is a part of a side that is visible from a root, the last bend of the path. Its
/// successors are parts of the other sides of the piece beyond. Observable successors lie between
/// the two rays that bound the root's view. Non-observable successors lie outside the rays and have
/// a new root at an end of the side. Collinear successors arise if the root lies on the line of the
/// side.
template <ConvexPieces Pieces, Observer O>
class IntervalExpansion {
 public:
  using Node = IntervalNode;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  IntervalExpansion(const CellSpace& space, const Pieces& pieces, const Query& query,
                    IntervalScratch& scratch, O& observer, Statistics& stats)
      : space_(space),
        pieces_(pieces),
        query_(query),
        scratch_(scratch),
        observer_(observer),
        stats_(stats),
        geometry_(space, query) {}

  /// Starts a query: adds the successors of the start, which are all sides of the pieces that
  /// contain it.
  void start() {
    scratch_.reset(geometry_.corners(), dead_end_limit());
    for_each_piece_at(query_.goal, [&](Piece piece) {
      goal_pieces_.push_back(pieces_.open(piece));
      mark_passage(piece);
    });
    for_each_piece_at(query_.start, [&](Piece piece) { mark_passage(piece); });
    for_each_piece_at(query_.start, [&](Piece piece) {
      const Opened opened = pieces_.open(piece);
      if (holds_goal(opened)) {
        improve_goal(IntervalGeometry::length(geometry_.start(), geometry_.goal()), at_start);
      }
      pieces_.for_each_exit(opened, [&](Cell right, Cell left, Piece beyond) {
        // Sides through the start lead to pieces that contain it as well.
        if (geometry_.on_side(query_.start, right, left)) return;
        add_successor(at_start, 0, right, left, right, left, beyond);
      });
    });
  }

  /// Whether a shorter path to the root has been found since the node was generated.
  bool is_stale(const Node& node) const {
    return node.root != at_start &&
           scratch_.root(geometry_.id(node.root)).g * (1 + tolerance) < node.g;
  }

  /// Appends a node's successors to those in the scratch.
  void expand(const Node& node) {
    ++stats_.expanded;
    if constexpr (!std::same_as<O, NoObserver>) {
      observer_.expanded(geometry_.middle(node.right, node.left));
    }
    const Opened opened = pieces_.open(node.piece);
    if (geometry_.side_of(node.root, node.right, node.left) == 0) {
      expand_collinear(node, opened);
    } else {
      expand_observable(node, opened);
    }
  }

  /// Length of the shortest path to the goal so far, infinite if there is none [cells].
  double best() const { return best_; }
  /// The last bend of that path.
  Cell best_root() const { return best_root_; }
  const IntervalGeometry& geometry() const { return geometry_; }

 private:
  using Piece = std::uint32_t;
  using Opened = decltype(std::declval<const Pieces&>().open(Piece{}));
  using Turn = IntervalGeometry::Turn;
  static constexpr Cell at_start = IntervalGeometry::at_start;
  static constexpr double tolerance = 1e-13;  // relative; closer lengths count as equal

  std::size_t dead_end_limit() const {
    if constexpr (PiecesWithDeadEnds<Pieces>) {
      return pieces_.dead_end_limit();
    } else {
      return 0;
    }
  }

  /// Marks the dead ends from a piece to where they branch off.
  void mark_passage([[maybe_unused]] Piece piece) {
    if constexpr (PiecesWithDeadEnds<Pieces>) {
      while (pieces_.is_dead_end(piece) && !scratch_.is_passage(piece)) {
        scratch_.set_passage(piece);
        piece = pieces_.exit_of_dead_end(piece);
      }
    }
  }

  /// Whether a piece is a dead end that no path of this query enters.
  bool leads_nowhere([[maybe_unused]] Piece piece) const {
    if constexpr (PiecesWithDeadEnds<Pieces>) {
      return pieces_.is_dead_end(piece) && !scratch_.is_passage(piece);
    } else {
      return false;
    }
  }

  /// The root lies on the line of the side. All of the piece is visible from the side's nearer end,
  /// or from the root itself if it lies on the side.
  void expand_collinear(const Node& node, const Opened& opened) {
    Cell root = node.root;
    double g = node.g;
    if (!geometry_.on_side(geometry_.point(root), node.right, node.left)) {
      const double to_right = distance_to(root, node.right), to_left = distance_to(root, node.left);
      const bool right = to_right < to_left;
      const Cell end = right ? node.right : node.left;
      if (!geometry_.can_bend(root, end, right ? Turn::right : Turn::left)) return;
      g += right ? to_right : to_left;
      if (!reach_root(end, g, root)) return;
      root = end;
    }
    if (holds_goal(opened)) improve_goal(g + distance_to_goal(root), root);
    for_each_other_exit(node, opened, [&](Cell right, Cell left, Piece beyond) {
      add_successor(root, g, right, left, right, left, beyond);
    });
  }

  /// The ends of a side at which a path may bend, and the path's length at them; infinite if it may
  /// not bend.
  struct Bends {
    bool right, left;
    double by_right, by_left;
  };
  Bends bends_of(const Node& node) const {
    const bool right =
        node.right == node.right_ray && geometry_.can_bend(node.root, node.right, Turn::right);
    const bool left =
        node.left == node.left_ray && geometry_.can_bend(node.root, node.left, Turn::left);
    return {right, left, right ? node.g + distance_to(node.root, node.right) : infinity,
            left ? node.g + distance_to(node.root, node.left) : infinity};
  }

  /// The root sees the piece between two rays. What lies outside them is visible from an end of the
  /// side, if a path may bend there.
  void expand_observable(const Node& node, const Opened& opened) {
    const Bends bends = bends_of(node);
    const bool goal_here = holds_goal(opened);
    if (goal_here) improve_goal_beyond(node, bends);
    if constexpr (RectangularPieces<Pieces>) {
      expand_view(node, opened, bends, goal_here);
    } else {
      for_each_other_exit(node, opened, [&](Cell right, Cell left, Piece beyond) {
        expand_exit(node, bends, right, left, beyond);
      });
    }
  }

  void improve_goal_beyond(const Node& node, const Bends& bends) {
    const Point root = geometry_.point(node.root);
    if (orientation(root, space_.corner(node.right_ray), query_.goal) < 0) {
      if (bends.right && reach_root(node.right, bends.by_right, node.root)) {
        improve_goal(bends.by_right + distance_to_goal(node.right), node.right);
      }
    } else if (orientation(root, space_.corner(node.left_ray), query_.goal) > 0) {
      if (bends.left && reach_root(node.left, bends.by_left, node.root)) {
        improve_goal(bends.by_left + distance_to_goal(node.left), node.left);
      }
    } else {
      improve_goal(node.g + distance_to_goal(node.root), node.root);
    }
  }

  /// Adds the successors on one side: an observable one and non-observable ones to its right and
  /// left.
  void expand_exit(const Node& node, const Bends& bends, Cell right, Cell left, Piece beyond) {
    const int right_of_right = geometry_.side_of(node.root, node.right_ray, right);
    const int left_of_right = geometry_.side_of(node.root, node.right_ray, left);
    const int right_of_left = geometry_.side_of(node.root, node.left_ray, right);
    const int left_of_left = geometry_.side_of(node.root, node.left_ray, left);
    const bool on_ray =
        (right_of_right == 0 && left_of_right == 0) || (right_of_left == 0 && left_of_left == 0);
    if (on_ray) {  // the side lies on a ray; a path bends at its end
      add_successor(node.root, node.g, right, left, right, left, beyond);
    }
    if ((right_of_right < 0 || left_of_right < 0) && bends.right &&
        reach_root(node.right, bends.by_right, node.root)) {
      add_successor(
          node.right, bends.by_right, right, left, right,
          left_of_right > 0 ? IntervalGeometry::behind_on_ray(node.root, node.right, left) : left,
          beyond);
    }
    if (left_of_right > 0 && right_of_left < 0) {
      add_successor(node.root, node.g, right, left, right_of_right >= 0 ? right : node.right_ray,
                    left_of_left <= 0 ? left : node.left_ray, beyond);
    }
    if ((left_of_left > 0 || right_of_left > 0) && bends.left &&
        reach_root(node.left, bends.by_left, node.root)) {
      add_successor(
          node.left, bends.by_left, right, left,
          right_of_left < 0 ? IntervalGeometry::behind_on_ray(node.root, node.left, right) : right,
          left, beyond);
    }
  }

  /// Calls `visit(right, left, beyond)` for every exit of a piece except the one by which it was
  /// entered.
  template <class Visit>
  void for_each_other_exit(const Node& node, const Opened& opened, const Visit& visit) const {
    pieces_.for_each_exit(opened, [&](Cell right, Cell left, Piece beyond) {
      if (right == node.left && left == node.right) return;
      visit(right, left, beyond);
    });
  }

  /// What a root sees through the side by which a rectangle is entered: the part of a horizontal
  /// line between two rays. Rounded; used to leave out what is certainly not seen.
  struct View {
    View(const IntervalGeometry& geometry, const Node& node, const CellBox& opened)
        : is_upwards(opened.y0 == node.right.y),
          from(geometry.position(node.root)),
          low(is_upwards ? node.left_ray : node.right_ray),
          high(is_upwards ? node.right_ray : node.left_ray) {}

    /// Where a ray crosses a line; NaN or infinity if it does not.
    double crossing(Cell ray, int line) const {
      return from.x + (ray.x - from.x) * ((line - from.y) / (ray.y - from.y));
    }
    /// The columns [first, second) that hold what is seen on a line, and one more on each side;
    /// within [x0, x1).
    std::pair<int, int> columns(int line, int x0, int x1) const {
      const double from_x = crossing(low, line), to_x = crossing(high, line);
      return {from_x >= x0 + 1 ? static_cast<int>(std::fmin(from_x, x1)) - 1 : x0,
              to_x <= x1 - 2 ? static_cast<int>(std::fmax(to_x, x0)) + 2 : x1};
    }
    /// The line beyond a box.
    int ahead(const CellBox& box) const { return is_upwards ? box.y1 : box.y0; }

    bool is_upwards;
    IntervalGeometry::CellPoint from;
    Cell low, high;  // on the rays with lower and higher x
  };

  /// Expands a rectangle: passes on to the last one that the view runs through without
  /// reaching an end, and leaves out exits that the view and bends do not reach.
  void expand_view(const Node& node, const Opened& opened, const Bends& bends, bool goal_here) {
    const View view(geometry_, node, opened);
    if (goal_here || bends.right || bends.left) {
      expand_exits_in_reach(node, opened, bends, view);
      return;
    }
    const Opened last = last_passed(opened, view);
    if (holds_goal(last)) improve_goal_beyond(node, bends);
    expand_exits_in_reach(node, last, bends, view);
  }

  /// The rectangle up to which a view passes through single runs of rows without reaching their
  /// ends: its only successors are those of the last one.
  Opened last_passed(const Opened& opened, const View& view) const {
    const OccupancyGrid& cells = space_.cells();
    const int step = view.is_upwards ? 1 : -1;
    int line = view.ahead(opened), x = opened.x0;
    auto [first, last] = view.columns(line, 0, cells.width());
    if (first < opened.x0 || last > opened.x1) return opened;
    bool passed = false;
    while (true) {
      const int row = view.is_upwards ? line : line - 1;
      const bool may_hold_goal = std::abs(row + 0.5 - geometry_.goal().y) < 1;
      if (row < 0 || row >= cells.height() || may_hold_goal) break;
      const auto [next_first, next_last] = view.columns(line + step, 0, cells.width());
      const int begin = std::min(first, next_first), end = std::max(last, next_last);
      if (begin <= 0 || end >= cells.width() || cells.run_end(row, begin, true) < end) break;
      passed = true;
      x = begin;
      line += step;
      std::tie(first, last) = std::tie(next_first, next_last);
    }
    if (!passed) return opened;
    const Cell cell{x, view.is_upwards ? line - 1 : line};
    return pieces_.open(static_cast<Piece>(cells.index(cell)));
  }

  /// Expands the exits of a rectangle, but those that neither the root sees nor a bend leads to.
  void expand_exits_in_reach(const Node& node, const Opened& opened, const Bends& bends,
                             const View& view) {
    using Exits = typename Pieces::Exits;
    const auto expand = [&](Cell right, Cell left, Piece beyond) {
      expand_exit(node, bends, right, left, beyond);
    };
    const bool bends_low = view.is_upwards ? bends.left : bends.right;
    const bool bends_high = view.is_upwards ? bends.right : bends.left;
    const auto [first, last] = view.columns(view.ahead(opened), opened.x0, opened.x1);
    pieces_.for_each_exit_between(opened, view.is_upwards ? Exits::above : Exits::below,
                                  bends_low ? opened.x0 : first, bends_high ? opened.x1 : last,
                                  expand);
    // A bend at an end of the side leads back beyond that end.
    const Exits back = view.is_upwards ? Exits::below : Exits::above;
    const auto [low_end, high_end] = std::minmax(node.right.x, node.left.x);
    if (bends_low) pieces_.for_each_exit_between(opened, back, opened.x0, low_end, expand);
    if (bends_high) pieces_.for_each_exit_between(opened, back, high_end, opened.x1, expand);
  }

  /// Records a path to a corner. Returns false if a path of at most this length is known. Ties keep
  /// the first parent: anything visible only through the second is either already visible from the
  /// first parent or not part of a taut path. Otherwise, rows of aligned corners would generate
  /// each path 2^n times.
  bool reach_root(Cell corner, double g, Cell from) {
    const std::uint32_t root = geometry_.id(corner), parent = geometry_.id(from);
    if (const IntervalRoot* known = scratch_.find_root(root)) {
      if (g >= known->g * (1 - tolerance)) {
        return known->parent == parent && g <= known->g * (1 + tolerance);
      }
    }
    scratch_.set_root(root, g, parent);
    return true;
  }

  void add_successor(Cell root, double g, Cell right, Cell left, Cell right_ray, Cell left_ray,
                     Piece piece) {
    if (leads_nowhere(piece)) return;
    Node node{0, g, root, piece, right, left, right_ray, left_ray};
    node.f = g + geometry_.estimate(node);
    if (node.f >= best_) return;
    ++stats_.generated;
    if constexpr (!std::same_as<O, NoObserver>) observer_.generated(geometry_.middle(right, left));
    scratch_.successors.push_back(node);
  }

  void improve_goal(double total, Cell root) {
    if (total >= best_) return;
    best_ = total;
    best_root_ = root;
  }

  double distance_to(Cell root, Cell corner) const {
    return IntervalGeometry::length(geometry_.position(root), geometry_.position(corner));
  }
  double distance_to_goal(Cell root) const {
    return IntervalGeometry::length(geometry_.position(root), geometry_.goal());
  }

  /// Calls `visit(piece)` once for every piece that contains a point, also on its border.
  template <class Visit>
  void for_each_piece_at(const Point& p, const Visit& visit) const {
    const IntervalGeometry::CellPoint at = geometry_.in_cells(p);
    const Cell near{static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y))};
    pieces_.for_each_near(near, [&](Piece piece) {
      if (pieces_.holds(piece, p, [&](Cell corner) { return space_.corner(corner); })) visit(piece);
    });
  }
  bool holds_goal(const Opened& opened) const {
    return std::find(goal_pieces_.begin(), goal_pieces_.end(), opened) != goal_pieces_.end();
  }

  const CellSpace& space_;
  const Pieces& pieces_;
  const Query& query_;
  IntervalScratch& scratch_;
  O& observer_;
  Statistics& stats_;
  IntervalGeometry geometry_;
  std::vector<Opened> goal_pieces_;
  double best_ = infinity;
  Cell best_root_ = at_start;
};

}  // namespace tutavia::detail
