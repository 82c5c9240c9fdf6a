// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tutavia/core/parts/compiler.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/search/mesh/interval_scratch.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// IntervalGeometry: visibility between roots and sides, and distance estimates.

namespace tutavia::detail {

/// The corners, roots and sides of one query. A root is a corner or the start, which may lie
/// anywhere. Visibility is exact; lengths are rounded.
class IntervalGeometry {
 public:
  enum class Turn { right, left };
  /// Coordinates in cells from the map's lower left corner. Rounded, so used for lengths only.
  struct CellPoint {
    double x, y;
  };

  static constexpr Cell at_start{std::numeric_limits<int>::min(),
                                 std::numeric_limits<int>::min()};  // the root at the start

  IntervalGeometry(const CellSpace& space, const Query& query)
      : space_(space),
        cells_(space.cells()),
        query_(query),
        columns_(static_cast<std::uint32_t>(cells_.width()) + 1),
        corners_(columns_ * (static_cast<std::uint32_t>(cells_.height()) + 1)),
        start_(in_cells(query.start)),
        goal_(in_cells(query.goal)) {}

  /// The number of corners, which is also the start's id.
  std::uint32_t corners() const { return corners_; }
  /// The id of a root.
  std::uint32_t id(Cell root) const {
    if (root == at_start) return corners_;
    return static_cast<std::uint32_t>(root.y) * columns_ + static_cast<std::uint32_t>(root.x);
  }
  Cell corner_of(std::uint32_t id) const {
    return {static_cast<int>(id % columns_), static_cast<int>(id / columns_)};
  }
  Point point(Cell root) const { return root == at_start ? query_.start : space_.corner(root); }
  /// The middle of a side.
  Point middle(Cell right, Cell left) const {
    return lerp(space_.corner(right), space_.corner(left), 0.5);
  }

  CellPoint start() const { return start_; }
  CellPoint goal() const { return goal_; }
  CellPoint in_cells(const Point& p) const {
    const Point origin = space_.corner({0, 0});
    const double side = space_.frame().resolution;
    return {(p.x() - origin.x()) / side, (p.y() - origin.y()) / side};
  }
  CellPoint position(Cell root) const {
    return root == at_start ? start_ : CellPoint{double(root.x), double(root.y)};
  }
  static double length(CellPoint a, CellPoint b) {
    const double dx = a.x - b.x, dy = a.y - b.y;
    return std::sqrt(dx * dx + dy * dy);
  }
  /// Twice the signed area of a triangle.
  static double area(CellPoint a, CellPoint b, CellPoint c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  /// Length of the shortest path from the root through the visible part of the side to the goal. If
  /// root and goal lie on the same side of the line, the goal is mirrored.
  double estimate(const IntervalNode& node) const {
    const CellPoint from = position(node.root);
    const CellPoint right = position(node.right), left = position(node.left);
    CellPoint goal = goal_;
    if (const double behind = area(right, left, goal); behind > 0) {
      const double dx = left.x - right.x, dy = left.y - right.y;
      const double twice = 2 * behind / (dx * dx + dy * dy);
      goal = {goal.x + twice * dy, goal.y - twice * dx};
    }
    const auto via = [&](CellPoint end, CellPoint ray, bool is_end) {
      // From a start off the lattice, the intersection of a ray and the side is rounded; this bound
      // never overestimates.
      if (!is_end && node.root == at_start) return length(from, goal);
      if (!is_end) {
        const double dx = ray.x - from.x, dy = ray.y - from.y;
        const double t = (dx * (from.y - right.y) - dy * (from.x - right.x)) /
                         (dx * (left.y - right.y) - dy * (left.x - right.x));
        end = {right.x + t * (left.x - right.x), right.y + t * (left.y - right.y)};
      }
      return length(from, end) + length(end, goal);
    };
    const CellPoint right_ray = position(node.right_ray), left_ray = position(node.left_ray);
    if (area(from, right_ray, goal) < 0) return via(right, right_ray, node.right == node.right_ray);
    if (area(from, left_ray, goal) > 0) return via(left, left_ray, node.left == node.left_ray);
    return length(from, goal);
  }

  /// Whether a point lies on a side, its ends included.
  bool on_side(const Point& p, Cell right, Cell left) const {
    const Point a = space_.corner(right), b = space_.corner(left);
    return Segment{a, b}.box().contains(p) && orientation(a, b, p) == 0;
  }

  /// The side of the ray from a root through another corner on which a corner lies: left is
  /// positive.
  TUTAVIA_ALWAYS_INLINE int side_of(Cell root, Cell ray, Cell corner) const {
    if (root == at_start) {
      return orientation(query_.start, space_.corner(ray), space_.corner(corner));
    }
    const std::int64_t area = turn(root, ray, corner);
    return (area > 0) - (area < 0);
  }

  /// A point on the ray from a root through a corner, as far behind the corner as the root is
  /// before it. Beyond that ray, the root's own view begins. For a start off the lattice there is
  /// no such lattice point: returns `otherwise`, and everything up to it counts as visible.
  static Cell behind_on_ray(Cell root, Cell corner, Cell otherwise) {
    return root == at_start ? otherwise : corner + (corner - root);
  }

  /// Whether a taut path from a root may turn at a corner: of the four cells around it, only the
  /// inner one is blocked.
  bool can_bend(Cell root, Cell corner, Turn turn) const {
    const auto sign = [](double x) { return (x > 0) - (x < 0); };
    const Point to = space_.corner(corner), from = point(root);
    const Cell d{sign(to.x() - from.x()), sign(to.y() - from.y())};
    const Cell across = turn == Turn::right ? Cell{d.y, -d.x} : Cell{-d.y, d.x};
    const Cell inner = d.x == 0 || d.y == 0 ? across - d : across;
    const auto is_free = [&](int x, int y) {
      return cells_.is_free(corner + Cell{x > 0 ? 0 : -1, y > 0 ? 0 : -1});
    };
    return !is_free(inner.x, inner.y) && is_free(-inner.x, inner.y) && is_free(inner.x, -inner.y) &&
           is_free(-inner.x, -inner.y);
  }

 private:
  const CellSpace& space_;
  const OccupancyGrid& cells_;
  const Query& query_;
  std::uint32_t columns_;
  std::uint32_t corners_;
  CellPoint start_, goal_;
};

}  // namespace tutavia::detail
