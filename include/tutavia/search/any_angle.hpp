// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/core/statistics.hpp"
#include "tutavia/core/zeroed_array.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/query.hpp"
#include "tutavia/search/rectangle_mesh.hpp"
#include "tutavia/search/route.hpp"
#include "tutavia/search/row_runs.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// AnyAngle: the shortest path of a point among blocked cells.

namespace tutavia {

/// Memory of an any-angle search.
class AnyAngleScratch {
 public:
  /// A side of the rectangle to be entered next, and the part of it that a root sees.
  struct Node {
    double f = 0;            ///< least length of a path by it [cells]
    double g = 0;            ///< length of the path to the root [cells]
    std::uint32_t root = 0;  ///< the corner where the path bends last
    std::uint32_t sequence = 0;
    Cell right{}, left{};          ///< the side's ends, as seen from the rectangle left behind
    Cell right_ray{}, left_ray{};  ///< corners on the rays that bound what the root sees of it
    Cell piece{};                  ///< a cell of the rectangle to be entered

    friend bool operator<(const Node& a, const Node& b) {  // for std::push_heap: worse < better
      if (a.f != b.f) return a.f > b.f;
      if (a.g != b.g) return a.g < b.g;
      return a.sequence > b.sequence;
    }
  };

  /// What is known of a corner at which paths bend.
  struct Root {
    double g;
    std::uint32_t parent;
    std::uint32_t query;
  };

  void begin(std::size_t corners) {
    if (roots_.size() < corners || query_ == std::numeric_limits<std::uint32_t>::max()) {
      roots_ = ZeroedArray<Root>(corners);
      query_ = 0;
    }
    ++query_;
    open_.clear();
    sequence_ = 0;
  }

  bool reached(std::uint32_t corner) const { return roots_[corner].query == query_; }
  const Root& root(std::uint32_t corner) const { return roots_[corner]; }
  void set_root(std::uint32_t corner, double g, std::uint32_t parent) {
    roots_[corner] = {g, parent, query_};
  }

  bool empty() const { return open_.empty(); }
  double least_f() const { return open_.front().f; }
  void push(Node node) {
    node.sequence = sequence_++;
    open_.push_back(node);
    std::push_heap(open_.begin(), open_.end());
  }
  Node pop() {
    std::pop_heap(open_.begin(), open_.end());
    const Node node = open_.back();
    open_.pop_back();
    return node;
  }

  std::vector<Node> successors;

 private:
  ZeroedArray<Root> roots_;
  std::vector<Node> open_;
  std::uint32_t query_ = 0;
  std::uint32_t sequence_ = 0;
};

namespace detail {

/// One query. Corners (x, y) are those of cells, the lower left one of cell (x, y).
template <class Pieces, Observer O>
class AnyAngleSearch {
 public:
  AnyAngleSearch(const CellSpace& space, const Pieces& pieces, const Query& query,
                 AnyAngleScratch& scratch, O& observer, Statistics& stats)
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
    scratch_.begin(corners_);
    begin();
    while (!scratch_.empty() && scratch_.least_f() < best_) {
      Node node = scratch_.pop();
      while (true) {
        if (is_stale(node)) break;
        if (is_checked(query_.budget, stats_.expanded)) {
          if (auto failure = exceeded(query_.budget, stats_.expanded)) return failure;
        }
        scratch_.successors.clear();
        expand(node);
        // What would be popped next need not be pushed.
        const auto& next = scratch_.successors;
        if (next.size() == 1 && (scratch_.empty() || next[0].f <= scratch_.least_f()) &&
            next[0].f < best_) {
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
    for (std::uint32_t root = best_root_; root != corners_; root = scratch_.root(root).parent) {
      const Point p = point(root);
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
  using Node = AnyAngleScratch::Node;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double tolerance = 1e-13;  // lengths as equal as rounding lets them be

  /// From the start to all sides of the rectangles that hold it.
  void begin() {
    const auto pieces = pieces_around(query_.start);
    for (const CellBox& box : pieces) {
      if (holds(box, query_.goal)) offer_goal(length(start_, goal_), corners_);
      pieces_.for_each_exit(box, [&](Cell right, Cell left, Cell piece) {
        // Sides through the start lead to rectangles that hold it as well.
        if (on_side(query_.start, right, left)) return;
        succeed(corners_, 0, right, left, right, left, piece);
      });
    }
    for (const Node& node : scratch_.successors) scratch_.push(node);
    scratch_.successors.clear();
  }

  void expand(const Node& node) {
    ++stats_.expanded;
    if constexpr (!std::same_as<O, NoObserver>) {
      observer_.expanded(lerp(space_.corner(node.right), space_.corner(node.left), 0.5));
    }
    const CellBox box = pieces_.box(node.piece);
    if (in_line(node)) {
      see_all(node, box);
    } else {
      see_cone(node, box);
    }
  }

  /// The root lies on the line of the side: from the side's end that is nearest to it all of the
  /// rectangle is in view, or from itself where it lies on the side.
  void see_all(const Node& node, const CellBox& box) {
    std::uint32_t root = node.root;
    double g = node.g;
    if (!on_side(point(root), node.right, node.left)) {
      const auto from = position(root);
      const bool right = length(from, position(node.right)) < length(from, position(node.left));
      const Cell end = right ? node.right : node.left;
      if (!is_corner(end)) return;  // on either side of the line there is more to see
      g += length(from, position(end));
      if (!bend(end, g, root)) return;
      root = id(end);
    }
    if (holds(box, query_.goal)) offer_goal(g + length(position(root), goal_), root);
    pieces_.for_each_exit(box, [&](Cell right, Cell left, Cell piece) {
      if (right == node.left && left == node.right) return;  // where it came in
      succeed(root, g, right, left, right, left, piece);
    });
  }

  /// The root sees the rectangle between two rays; behind them lie parts that are in view from an
  /// end of the side, where that is a corner and not cut off.
  void see_cone(const Node& node, const CellBox& box) {
    const std::optional<double> by_right = bend_at(node, node.right, node.right_ray);
    const std::optional<double> by_left = bend_at(node, node.left, node.left_ray);
    if (holds(box, query_.goal)) {
      const Point root = point(node.root);
      if (orientation(root, space_.corner(node.right_ray), query_.goal) < 0) {
        if (by_right && bend(node.right, *by_right, node.root)) {
          offer_goal(*by_right + length(position(node.right), goal_), id(node.right));
        }
      } else if (orientation(root, space_.corner(node.left_ray), query_.goal) > 0) {
        if (by_left && bend(node.left, *by_left, node.root)) {
          offer_goal(*by_left + length(position(node.left), goal_), id(node.left));
        }
      } else {
        offer_goal(node.g + length(position(node.root), goal_), node.root);
      }
    }
    pieces_.for_each_exit(box, [&](Cell right, Cell left, Cell piece) {
      if (right == node.left && left == node.right) return;  // where it came in
      const int right_of_right = side_of(node.root, node.right_ray, right);
      const int left_of_right = side_of(node.root, node.right_ray, left);
      const int right_of_left = side_of(node.root, node.left_ray, right);
      const int left_of_left = side_of(node.root, node.left_ray, left);
      const bool on_ray =
          (right_of_right == 0 && left_of_right == 0) || (right_of_left == 0 && left_of_left == 0);
      if (on_ray) succeed(node.root, node.g, right, left, right, left, piece);  // bends at its end
      if (right_of_right < 0 && by_right && bend(node.right, *by_right, node.root)) {
        succeed(id(node.right), *by_right, right, left, right, left, piece);
      }
      if (left_of_right > 0 && right_of_left < 0) {
        succeed(node.root, node.g, right, left, right_of_right >= 0 ? right : node.right_ray,
                left_of_left <= 0 ? left : node.left_ray, piece);
      }
      if (left_of_left > 0 && by_left && bend(node.left, *by_left, node.root)) {
        succeed(id(node.left), *by_left, right, left, right, left, piece);
      }
    });
  }

  /// The length to an end of a node's side, if a path may bend there.
  std::optional<double> bend_at(const Node& node, Cell end, Cell ray) const {
    if (end != ray || !is_corner(end)) return std::nullopt;
    return node.g + length(position(node.root), position(end));
  }

  /// Notes a way to a corner; false where another one is known that is as short. Of equal ways the
  /// first will do: what lies behind the corner for another, the first one's parent has in view, or
  /// it is not a taut way. Without this, rows of aligned corners give each path 2^n times.
  bool bend(Cell corner, double g, std::uint32_t from) {
    const std::uint32_t root = id(corner);
    if (scratch_.reached(root)) {
      const AnyAngleScratch::Root& known = scratch_.root(root);
      if (g >= known.g * (1 - tolerance)) {
        return known.parent == from && g <= known.g * (1 + tolerance);
      }
    }
    scratch_.set_root(root, g, from);
    return true;
  }

  bool is_stale(const Node& node) const {
    return node.root != corners_ && scratch_.root(node.root).g * (1 + tolerance) < node.g;
  }

  void succeed(std::uint32_t root, double g, Cell right, Cell left, Cell right_ray, Cell left_ray,
               Cell piece) {
    Node node{0, g, root, 0, right, left, right_ray, left_ray, piece};
    node.f = g + estimate(node);
    if (node.f >= best_) return;
    ++stats_.generated;
    if constexpr (!std::same_as<O, NoObserver>) {
      observer_.generated(lerp(space_.corner(right), space_.corner(left), 0.5));
    }
    scratch_.successors.push_back(node);
  }

  void offer_goal(double total, std::uint32_t root) {
    if (total >= best_) return;
    best_ = total;
    best_root_ = root;
  }

  /// Length of the shortest way from the root through the visible part of the side to the goal; to
  /// the goal's mirror image where root and goal lie on the same side of the line.
  double estimate(const Node& node) const {
    const bool level = node.right.y == node.left.y;
    const auto along = [&](Place p) { return level ? p.x : p.y; };
    const auto across = [&](Place p) { return level ? p.y : p.x; };
    const Place from = position(node.root);
    const double line = across(position(node.right));
    const auto cut = [&](Cell end, Cell ray) {
      if (end == ray) return along(position(end));
      const Place through = position(ray);
      const double t = (line - across(from)) / (across(through) - across(from));
      return along(from) + t * (along(through) - along(from));
    };
    const double u = along(from), rise = std::abs(across(from) - line);
    const double goal_u = along(goal_), goal_rise = std::abs(across(goal_) - line);
    const double a = cut(node.right, node.right_ray), b = cut(node.left, node.left_ray);
    const double sum = rise + goal_rise;
    const double crossing = rise == 0 ? u : sum == 0 ? goal_u : u + (goal_u - u) * rise / sum;
    const double at = std::clamp(crossing, std::min(a, b), std::max(a, b));
    return hypotenuse(at - u, rise) + hypotenuse(goal_u - at, goal_rise);
  }

  /// Rectangles that hold a point, on their border too.
  std::vector<CellBox> pieces_around(const Point& p) const {
    std::vector<CellBox> boxes;
    const Place place = in_cells(p);
    const Cell near{static_cast<int>(std::floor(place.x)), static_cast<int>(std::floor(place.y))};
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell cell = near + Cell{dx, dy};
        if (!grid_.contains(cell) || !grid_.is_free(cell)) continue;
        if (!holds({cell.x, cell.y, cell.x + 1, cell.y + 1}, p)) continue;
        const CellBox box = pieces_.box(cell);
        const bool known = std::any_of(boxes.begin(), boxes.end(), [&](const CellBox& other) {
          return other.x0 == box.x0 && other.y0 == box.y0;
        });
        if (!known) boxes.push_back(box);
      }
    }
    return boxes;
  }

  bool holds(const CellBox& box, const Point& p) const {
    const Point low = space_.corner({box.x0, box.y0}), high = space_.corner({box.x1, box.y1});
    return low.x() <= p.x() && p.x() <= high.x() && low.y() <= p.y() && p.y() <= high.y();
  }
  bool on_side(const Point& p, Cell right, Cell left) const {
    const Point a = space_.corner(right), b = space_.corner(left);
    return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
           std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
  }
  bool in_line(const Node& node) const {
    const Point root = point(node.root), end = space_.corner(node.right);
    return node.right.y == node.left.y ? root.y() == end.y() : root.x() == end.x();
  }

  /// Where a corner lies of the ray from a root through another: left is positive.
  int side_of(std::uint32_t root, Cell ray, Cell corner) const {
    if (root == corners_) {
      return orientation(query_.start, space_.corner(ray), space_.corner(corner));
    }
    const Cell from = cell(root);
    const std::int64_t turn = (std::int64_t{ray.x} - from.x) * (std::int64_t{corner.y} - from.y) -
                              (std::int64_t{ray.y} - from.y) * (std::int64_t{corner.x} - from.x);
    return (turn > 0) - (turn < 0);
  }

  /// Whether a blocked cell, or what lies beyond the map, touches a corner.
  bool is_corner(Cell corner) const {
    return !grid_.is_free(corner) || !grid_.is_free(corner + Cell{-1, 0}) ||
           !grid_.is_free(corner + Cell{0, -1}) || !grid_.is_free(corner + Cell{-1, -1});
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
  static Place position(Cell corner) { return {double(corner.x), double(corner.y)}; }
  Place position(std::uint32_t root) const {
    return root == corners_ ? start_ : position(cell(root));
  }
  static double hypotenuse(double dx, double dy) { return std::sqrt(dx * dx + dy * dy); }
  static double length(Place a, Place b) { return hypotenuse(a.x - b.x, a.y - b.y); }

  std::uint32_t id(Cell corner) const {
    return static_cast<std::uint32_t>(corner.y) * columns_ + static_cast<std::uint32_t>(corner.x);
  }
  Cell cell(std::uint32_t corner) const {
    return {static_cast<int>(corner % columns_), static_cast<int>(corner / columns_)};
  }
  Point point(std::uint32_t root) const {
    return root == corners_ ? query_.start : space_.corner(cell(root));
  }

  const CellSpace& space_;
  const OccupancyGrid& grid_;
  const Pieces& pieces_;
  const Query& query_;
  AnyAngleScratch& scratch_;
  O& observer_;
  Statistics& stats_;
  std::uint32_t columns_;
  std::uint32_t corners_;  // their number, and the root that stands for the start
  Place start_, goal_;
  double best_ = infinity;
  std::uint32_t best_root_ = 0;
};

}  // namespace detail

/// A shortest path of a point among blocked cells, by any angles; it bends at corners of cells.
///
/// The path may slide along blocked cells and touch their corners, but does not pass between two
/// blocked cells that share a side or only a corner. Optimal to rounding (1e-12 relative): what is
/// in view is decided by exact arithmetic. Start and goal may lie anywhere, on a corner where two
/// blocked cells touch they are reached from either side. For safety radius 0, else
/// `invalid_option`; so is a mesh of another size (one of another grid of the same size is not
/// noticed). Errors: those of `check_query`; `unreachable` (proved); what the budget says.
///
/// A search over sides of rectangles and the parts of them that a bend of the path has in view.
/// Source: Harabor, Grastien, Oz and Aksakalli 2016, "Optimal any-angle pathfinding in practice"
/// (Anya); Cui, Harabor and Grastien 2017, "Compromise-free pathfinding on a navigation mesh"
/// (Polyanya).
struct AnyAngle {
  static constexpr std::string_view name = "any_angle";
  using Scratch = AnyAngleScratch;
  using Prepared = RectangleMesh;

  std::shared_ptr<const RectangleMesh> mesh{};  ///< none: rows are looked at as they come

  /// The mesh of a space's cells.
  static std::shared_ptr<const RectangleMesh> prepare(const CellSpace& space) {
    return std::make_shared<const RectangleMesh>(RectangleMesh::build(space.cells()));
  }

  template <Observer O = NoObserver>
  Expected<Route, Failure> search(const CellSpace& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (space.safety_radius() != 0) {
      return fail(PlanError::invalid_option, "any_angle is defined for safety radius 0");
    }
    if (auto failure = check_query(space, query)) return Unexpected{std::move(*failure)};
    if (mesh == nullptr) return search_in(RowRuns(space.cells()), space, query, scratch, observer);
    if (mesh->width() != space.cells().width() || mesh->height() != space.cells().height()) {
      return fail(PlanError::invalid_option, "any_angle needs the mesh prepared for this grid");
    }
    return search_in(*mesh, space, query, scratch, observer);
  }

 private:
  template <class Pieces, Observer O>
  static Expected<Route, Failure> search_in(const Pieces& pieces, const CellSpace& space,
                                            const Query& query, Scratch& scratch, O& observer) {
    Route route;
    detail::AnyAngleSearch<Pieces, O> search(space, pieces, query, scratch, observer, route.stats);
    if (auto failure = search.run()) {
      failure->stats = route.stats;
      return Unexpected{std::move(*failure)};
    }
    route.curve = search.curve();
    route.cost = route.curve.length();
    return route;
  }
};

}  // namespace tutavia
