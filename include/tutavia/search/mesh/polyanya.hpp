// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "tutavia/core/parts/zeroed_array.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/plan/statistics.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/wide_bucket_queue.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// The search behind AnyAngle: over sides of convex pieces and what a bend of the path sees of
/// them.

namespace tutavia::detail {

/// Memory of an any-angle search.
class IntervalScratch {
 public:
  /// A side through which a piece is to be entered, and the part of it that a root sees.
  struct Node {
    double f = 0;                  ///< least length of a path by it [cells]
    double g = 0;                  ///< length of the path to the root [cells]
    Cell root{};                   ///< the corner where the path bends last
    std::uint32_t piece = 0;       ///< the piece to be entered
    Cell right{}, left{};          ///< the side's ends, as seen from the piece left behind
    Cell right_ray{}, left_ray{};  ///< points on the rays from the root that bound its view of it
  };

  /// What is known of a corner at which paths bend.
  struct Root {
    double g;
    std::uint32_t parent;
    std::uint32_t query;
  };

  void begin(std::size_t corners, std::size_t pieces) {
    if (roots_.size() < corners || passages_.size() < pieces ||
        query_ == std::numeric_limits<std::uint32_t>::max()) {
      roots_ = ZeroedArray<Root>(corners);
      passages_ = ZeroedArray<std::uint32_t>(pieces);
      query_ = 0;
    }
    ++query_;
    open_.begin(0);
    nodes_.clear();
  }

  bool reached(std::uint32_t corner) const { return roots_[corner].query == query_; }
  const Root& root(std::uint32_t corner) const { return roots_[corner]; }
  void set_root(std::uint32_t corner, double g, std::uint32_t parent) {
    roots_[corner] = {g, parent, query_};
  }

  /// Dead ends that the start or the goal lies in, or that lead there.
  bool is_passage(std::size_t piece) const { return passages_[piece] == query_; }
  void set_passage(std::size_t piece) { passages_[piece] = query_; }

  bool empty() const { return open_.empty(); }
  /// Moves on to the nodes with the least f; a lower bound of it. \pre not empty
  double advance() {
    least_ = open_.advance();
    return static_cast<double>(least_) / scale;
  }
  void push(const Node& node) {
    open_.push(key(node), static_cast<std::uint32_t>(nodes_.size()), 0);
    nodes_.push_back(node);
  }
  /// Whether a node, if it were pushed, would be popped at once.
  bool is_next(const Node& node) const { return key(node) < least_ + JumpQueue::width; }
  /// A node with about the least f. \pre `advance` was called after the last push
  const Node& pop() { return nodes_[open_.pop().node]; }

  std::vector<Node> successors;

 private:
  static constexpr auto scale = static_cast<double>(straight_cost);
  static Cost key(const Node& node) { return static_cast<Cost>(node.f * scale); }

  ZeroedArray<Root> roots_;
  ZeroedArray<std::uint32_t> passages_;
  JumpQueue open_;
  Cost least_ = 0;
  std::vector<Node> nodes_;
  std::uint32_t query_ = 0;
};

/// A decomposition of the free cells of a grid into convex pieces with numbers. Corners (x, y) are
/// those of cells, the lower left one of cell (x, y).
///
/// `open(piece)` gives what is to be known of a piece before its sides are asked for; two
/// numbers name one piece where they are equal in that. `for_each_exit(opened, visit)` calls
/// `visit(right, left, beyond)` for every side that a piece shares with another, `beyond`: the
/// corners at its ends as seen from within. `for_each_near(cell, visit)` calls `visit(piece)` for
/// every piece that touches a cell, and perhaps for others. `holds(piece, p, place)` says whether a
/// point lies in a piece or on its border, where `place(corner)` is the place of a corner.
template <class P>
concept ConvexPieces = requires(const P& pieces, std::uint32_t piece, Cell cell, const Point& p,
                                Point (*place)(Cell), void (*visit)(std::uint32_t),
                                void (*visit_exit)(Cell, Cell, std::uint32_t)) {
  { pieces.open(piece) } -> std::equality_comparable;
  pieces.for_each_exit(pieces.open(piece), visit_exit);
  pieces.for_each_near(cell, visit);
  { pieces.holds(piece, p, place) } -> std::same_as<bool>;
};

/// Pieces of which it is known where they lead: `is_dead_end(piece)` says whether only paths that
/// begin or end in a piece, or in dead ends behind it, need it; `way_out(piece)` is the neighbour
/// that leads out of a dead end, or the piece itself where there is none; all dead ends have
/// numbers less than `dead_end_limit()`.
template <class P>
concept PiecesWithDeadEnds = ConvexPieces<P> && requires(const P& pieces, std::uint32_t piece) {
  { pieces.is_dead_end(piece) } -> std::same_as<bool>;
  { pieces.way_out(piece) } -> std::same_as<std::uint32_t>;
  { pieces.dead_end_limit() } -> std::same_as<std::size_t>;
};

/// One query over a decomposition of the free cells into convex pieces, RowRuns or NavigationMesh.
template <ConvexPieces Pieces, Observer O>
class IntervalSearch {
 public:
  IntervalSearch(const CellSpace& space, const Pieces& pieces, const Query& query,
                 IntervalScratch& scratch, O& observer, Statistics& stats)
      : space_(space),
        grid_(space.cells()),
        pieces_(pieces),
        query_(query),
        scratch_(scratch),
        observer_(observer),
        stats_(stats),
        columns_(static_cast<std::uint32_t>(grid_.width()) + 1),
        corners_(columns_ * (static_cast<std::uint32_t>(grid_.height()) + 1)),
        start_(in_cells(query.start)),
        goal_(in_cells(query.goal)) {}

  std::optional<Failure> run() {
    begin();
    while (!scratch_.empty() && scratch_.advance() < best_) {
      Node node = scratch_.pop();
      while (true) {
        if (is_stale(node)) break;
        if (is_checked(query_.budget, stats_.expanded)) {
          if (auto failure = exceeded(query_.budget, stats_.expanded)) return failure;
        }
        scratch_.successors.clear();
        expand(node);
        const auto& next = scratch_.successors;
        if (next.size() == 1 && scratch_.is_next(next[0])) {
          node = next[0];
          continue;
        }
        for (const Node& successor : next) {
          if (successor.f < best_) scratch_.push(successor);
        }
        break;
      }
    }
    if (best_ == infinity) return Failure{.code = PlanError::unreachable};
    return std::nullopt;
  }

  /// The path found, straight runs whole.
  Curve curve() const {
    std::vector<Point> points{query_.goal};
    for (std::uint32_t root = id(best_root_); root != corners_; root = scratch_.root(root).parent) {
      const Point p = space_.corner(corner_of(root));
      if (p != points.back()) points.push_back(p);
    }
    if (query_.start != points.back() || points.size() == 1) points.push_back(query_.start);
    std::reverse(points.begin(), points.end());
    Curve result;
    std::size_t from = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const bool straight_on = i + 1 < points.size() &&
                               orientation(points[from], points[i], points[i + 1]) == 0 &&
                               (points[i] - points[from]).dot(points[i + 1] - points[i]) > 0;
      if (straight_on) continue;
      result.push_back(Segment{points[from], points[i]});
      from = i;
    }
    return result;
  }

 private:
  using Node = IntervalScratch::Node;
  using Piece = std::uint32_t;
  using Room = decltype(std::declval<const Pieces&>().open(Piece{}));
  enum Turn { right_turn, left_turn };
  static constexpr int nowhere = std::numeric_limits<int>::min();
  static constexpr Cell at_start{nowhere, nowhere};  // the root that is no corner
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double tolerance = 1e-13;  // lengths as equal as rounding lets them be

  /// From the start to all sides of the pieces that hold it.
  void begin() {
    scratch_.begin(corners_, dead_end_limit());
    for_each_around(query_.goal, [&](Piece piece) {
      goal_rooms_.push_back(pieces_.open(piece));
      mark_passage(piece);
    });
    for_each_around(query_.start, [&](Piece piece) { mark_passage(piece); });
    for_each_around(query_.start, [&](Piece piece) {
      const Room room = pieces_.open(piece);
      if (holds_goal(room)) offer_goal(length(start_, goal_), at_start);
      pieces_.for_each_exit(room, [&](Cell right, Cell left, Piece beyond) {
        // Sides through the start lead to pieces that hold it as well.
        if (on_side(query_.start, right, left)) return;
        succeed(at_start, 0, right, left, right, left, beyond);
      });
    });
    for (const Node& node : scratch_.successors) scratch_.push(node);
    scratch_.successors.clear();
  }

  std::size_t dead_end_limit() const {
    if constexpr (PiecesWithDeadEnds<Pieces>) {
      return pieces_.dead_end_limit();
    } else {
      return 0;
    }
  }

  /// The dead ends from a piece to where the ways part.
  void mark_passage([[maybe_unused]] Piece piece) {
    if constexpr (PiecesWithDeadEnds<Pieces>) {
      while (pieces_.is_dead_end(piece) && !scratch_.is_passage(piece)) {
        scratch_.set_passage(piece);
        piece = pieces_.way_out(piece);
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

  void expand(const Node& node) {
    ++stats_.expanded;
    if constexpr (!std::same_as<O, NoObserver>) observer_.expanded(middle(node.right, node.left));
    const Room room = pieces_.open(node.piece);
    if (in_line(node)) {
      see_all(node, room);
    } else {
      see_cone(node, room);
    }
  }

  /// The root lies on the line of the side: from the side's end that is nearest to it all of the
  /// piece is in view, or from itself where it lies on the side.
  void see_all(const Node& node, const Room& room) {
    Cell root = node.root;
    double g = node.g;
    if (!on_side(point(root), node.right, node.left)) {
      const Place from = position(root);
      const bool right = length(from, position(node.right)) < length(from, position(node.left));
      const Cell end = right ? node.right : node.left;
      if (!can_bend(root, end, right ? right_turn : left_turn)) return;
      g += length(from, position(end));
      if (!bend(end, g, root)) return;
      root = end;
    }
    if (holds_goal(room)) offer_goal(g + length(position(root), goal_), root);
    pieces_.for_each_exit(room, [&](Cell right, Cell left, Piece beyond) {
      if (right == node.left && left == node.right) return;  // where it came in
      succeed(root, g, right, left, right, left, beyond);
    });
  }

  /// The root sees the piece between two rays; what lies behind them is in view from an end of the
  /// side, where a path may bend there.
  void see_cone(const Node& node, const Room& room) {
    const bool bends_right =
        node.right == node.right_ray && can_bend(node.root, node.right, right_turn);
    const bool bends_left = node.left == node.left_ray && can_bend(node.root, node.left, left_turn);
    const Place from = position(node.root);
    const double by_right = bends_right ? node.g + length(from, position(node.right)) : infinity;
    const double by_left = bends_left ? node.g + length(from, position(node.left)) : infinity;
    if (holds_goal(room)) {
      const Point root = point(node.root);
      if (orientation(root, space_.corner(node.right_ray), query_.goal) < 0) {
        if (bends_right && bend(node.right, by_right, node.root)) {
          offer_goal(by_right + length(position(node.right), goal_), node.right);
        }
      } else if (orientation(root, space_.corner(node.left_ray), query_.goal) > 0) {
        if (bends_left && bend(node.left, by_left, node.root)) {
          offer_goal(by_left + length(position(node.left), goal_), node.left);
        }
      } else {
        offer_goal(node.g + length(from, goal_), node.root);
      }
    }
    pieces_.for_each_exit(room, [&](Cell right, Cell left, Piece beyond) {
      if (right == node.left && left == node.right) return;  // where it came in
      const int right_of_right = side_of(node.root, node.right_ray, right);
      const int left_of_right = side_of(node.root, node.right_ray, left);
      const int right_of_left = side_of(node.root, node.left_ray, right);
      const int left_of_left = side_of(node.root, node.left_ray, left);
      const bool on_ray =
          (right_of_right == 0 && left_of_right == 0) || (right_of_left == 0 && left_of_left == 0);
      if (on_ray) succeed(node.root, node.g, right, left, right, left, beyond);  // bends at its end
      if ((right_of_right < 0 || left_of_right < 0) && bends_right &&
          bend(node.right, by_right, node.root)) {
        succeed(node.right, by_right, right, left, right,
                left_of_right > 0 ? straight_on(node.root, node.right, left) : left, beyond);
      }
      if (left_of_right > 0 && right_of_left < 0) {
        succeed(node.root, node.g, right, left, right_of_right >= 0 ? right : node.right_ray,
                left_of_left <= 0 ? left : node.left_ray, beyond);
      }
      if ((left_of_left > 0 || right_of_left > 0) && bends_left &&
          bend(node.left, by_left, node.root)) {
        succeed(node.left, by_left, right, left,
                right_of_left < 0 ? straight_on(node.root, node.left, right) : right, left, beyond);
      }
    });
  }

  /// A point on the ray from a root through a corner, as far behind the corner: what lies beyond
  /// that ray the root has in view itself. A start off the lattice has no such point on it; all up
  /// to `otherwise` is in view then.
  static Cell straight_on(Cell root, Cell corner, Cell otherwise) {
    return root == at_start ? otherwise : corner + (corner - root);
  }

  /// Whether a string from a root may turn at a corner: of the four cells around it only the one
  /// that it would lie against is blocked.
  bool can_bend(Cell root, Cell corner, Turn turn) const {
    const auto sign = [](double x) { return (x > 0) - (x < 0); };
    const Point to = space_.corner(corner), from = point(root);
    const Cell d{sign(to.x() - from.x()), sign(to.y() - from.y())};
    const Cell across = turn == right_turn ? Cell{d.y, -d.x} : Cell{-d.y, d.x};
    const Cell against = d.x == 0 || d.y == 0 ? across - d : across;
    const auto is_free = [&](int x, int y) {
      return grid_.is_free(corner + Cell{x > 0 ? 0 : -1, y > 0 ? 0 : -1});
    };
    return !is_free(against.x, against.y) && is_free(-against.x, against.y) &&
           is_free(against.x, -against.y) && is_free(-against.x, -against.y);
  }

  /// Notes a way to a corner; false where another one is known that is as short. Of equal ways the
  /// first will do: what lies behind the corner for another, the first one's parent has in view, or
  /// it is not a taut way. Without this, rows of aligned corners give each path 2^n times.
  bool bend(Cell corner, double g, Cell from) {
    const std::uint32_t root = id(corner);
    if (scratch_.reached(root)) {
      const IntervalScratch::Root& known = scratch_.root(root);
      if (g >= known.g * (1 - tolerance)) {
        return known.parent == id(from) && g <= known.g * (1 + tolerance);
      }
    }
    scratch_.set_root(root, g, id(from));
    return true;
  }

  bool is_stale(const Node& node) const {
    return node.root != at_start && scratch_.root(id(node.root)).g * (1 + tolerance) < node.g;
  }

  void succeed(Cell root, double g, Cell right, Cell left, Cell right_ray, Cell left_ray,
               Piece piece) {
    if (leads_nowhere(piece)) return;
    Node node{0, g, root, piece, right, left, right_ray, left_ray};
    node.f = g + estimate(node);
    if (node.f >= best_) return;
    ++stats_.generated;
    if constexpr (!std::same_as<O, NoObserver>) observer_.generated(middle(right, left));
    scratch_.successors.push_back(node);
  }

  void offer_goal(double total, Cell root) {
    if (total >= best_) return;
    best_ = total;
    best_root_ = root;
  }

  /// Length of the shortest way from the root through the visible part of the side to the goal; to
  /// the goal's mirror image where root and goal lie on the same side of the line.
  double estimate(const Node& node) const {
    const Place from = position(node.root);
    const Place right = position(node.right), left = position(node.left);
    Place goal = goal_;
    if (const double behind = area(right, left, goal); behind > 0) {
      const double dx = left.x - right.x, dy = left.y - right.y;
      const double twice = 2 * behind / (dx * dx + dy * dy);
      goal = {goal.x + twice * dy, goal.y - twice * dx};
    }
    const auto by = [&](Place end, Place ray, bool is_end) {
      // From a start off the lattice, where a ray cuts the side is known to rounding only; this is
      // never too much.
      if (!is_end && node.root == at_start) return length(from, goal);
      if (!is_end) {
        const double dx = ray.x - from.x, dy = ray.y - from.y;
        const double t = (dx * (from.y - right.y) - dy * (from.x - right.x)) /
                         (dx * (left.y - right.y) - dy * (left.x - right.x));
        end = {right.x + t * (left.x - right.x), right.y + t * (left.y - right.y)};
      }
      return length(from, end) + length(end, goal);
    };
    const Place right_ray = position(node.right_ray), left_ray = position(node.left_ray);
    if (area(from, right_ray, goal) < 0) return by(right, right_ray, node.right == node.right_ray);
    if (area(from, left_ray, goal) > 0) return by(left, left_ray, node.left == node.left_ray);
    return length(from, goal);
  }

  /// Calls `visit(piece)` once for every piece that holds a point, on its border too.
  template <class Visit>
  void for_each_around(const Point& p, const Visit& visit) const {
    const Place place = in_cells(p);
    const Cell near{static_cast<int>(std::floor(place.x)), static_cast<int>(std::floor(place.y))};
    pieces_.for_each_near(near, [&](Piece piece) {
      if (pieces_.holds(piece, p, [&](Cell corner) { return space_.corner(corner); })) visit(piece);
    });
  }
  bool holds_goal(const Room& room) const {
    return std::find(goal_rooms_.begin(), goal_rooms_.end(), room) != goal_rooms_.end();
  }

  bool on_side(const Point& p, Cell right, Cell left) const {
    const Point a = space_.corner(right), b = space_.corner(left);
    return Segment{a, b}.box().contains(p) && orientation(a, b, p) == 0;
  }
  bool in_line(const Node& node) const { return side_of(node.root, node.right, node.left) == 0; }

  /// Where a corner lies of the ray from a root through another: left is positive.
  int side_of(Cell root, Cell ray, Cell corner) const {
    if (root == at_start) {
      return orientation(query_.start, space_.corner(ray), space_.corner(corner));
    }
    const std::int64_t area = turn(root, ray, corner);
    return (area > 0) - (area < 0);
  }

  /// Coordinates in cells from the map's lower left corner; rounded, so for lengths alone.
  struct Place {
    double x, y;
  };
  Place in_cells(const Point& p) const {
    const Point origin = space_.corner({0, 0});
    const double side = space_.frame().resolution;
    return {(p.x() - origin.x()) / side, (p.y() - origin.y()) / side};
  }
  Place position(Cell root) const {
    return root == at_start ? start_ : Place{double(root.x), double(root.y)};
  }
  static double length(Place a, Place b) {
    const double dx = a.x - b.x, dy = a.y - b.y;
    return std::sqrt(dx * dx + dy * dy);
  }
  static double area(Place a, Place b, Place c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  std::uint32_t id(Cell root) const {
    if (root == at_start) return corners_;
    return static_cast<std::uint32_t>(root.y) * columns_ + static_cast<std::uint32_t>(root.x);
  }
  Cell corner_of(std::uint32_t id) const {
    return {static_cast<int>(id % columns_), static_cast<int>(id / columns_)};
  }
  Point point(Cell root) const { return root == at_start ? query_.start : space_.corner(root); }
  Point middle(Cell right, Cell left) const {
    return lerp(space_.corner(right), space_.corner(left), 0.5);
  }

  const CellSpace& space_;
  const OccupancyGrid& grid_;
  const Pieces& pieces_;
  const Query& query_;
  IntervalScratch& scratch_;
  O& observer_;
  Statistics& stats_;
  std::uint32_t columns_;
  std::uint32_t corners_;  // their number, and the start's id
  Place start_, goal_;
  std::vector<Room> goal_rooms_;
  double best_ = infinity;
  Cell best_root_ = at_start;
};

}  // namespace tutavia::detail
