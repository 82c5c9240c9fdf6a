// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"
#include "tutavia/search/tangent/sight_sectors.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/index/passing_radius.hpp"

/// \file
/// TangentCircles: the circles around which shortest paths of a disc turn.

namespace tutavia::detail {

/// The circles of a space: of the safety radius around obstacle vertices, larger ones around discs.
/// Vertices where the outline goes straight on have none. At safety radius 0 a circle is the vertex
/// itself where a path may touch it, and tiny where it may not (ends of walls). Their order depends
/// on their centres and radii alone. For nodes see TangentVisibilityGraph.
class TangentCircles {
 public:
  using Node = std::uint32_t;
  static constexpr Node none = std::numeric_limits<Node>::max();

  struct Circle {
    Point center;
    double radius;
    std::uint32_t first_edge, last_edge;  ///< range of the directions of the vertex's edges
    bool operator==(const Circle&) const = default;
  };

  /// O(n log n) for n obstacle edges.
  template <FeatureSpace S>
  explicit TangentCircles(const S& space);

  std::size_t size() const { return circles_.size(); }
  const Circle& operator[](std::size_t i) const { return circles_[i]; }
  Node nodes() const { return static_cast<Node>(2 * circles_.size()); }
  OrientedCircle of(Node node) const {
    const Circle& circle = circles_[node / 2];
    return {circle.center, circle.radius, side(node)};
  }

  /// Whether a path may touch a node's circle while it runs in a direction; see
  /// TangentVisibilityGraph.
  bool touches(Node node, const Point& direction) const;
  /// Calls `visit(node)` for the nodes to which there may be an edge; see TangentVisibilityGraph.
  template <class Visit>
  void for_each_candidate(const OrientedCircle& at, Node from, const SightSectors& sight,
                          Visit visit) const;
  /// For each circle, the index of the equal circle in `others`; `none` if there is none.
  std::vector<Node> indices_in(const TangentCircles& others) const;

  bool operator==(const TangentCircles&) const = default;
  std::size_t memory() const {
    return circles_.size() * sizeof(Circle) + edges_.size() * sizeof(Point);
  }

 private:
  /// An obstacle edge, seen from one of its ends.
  struct End {
    Point vertex, other;
    double radius;

    bool is_before(const End& end) const {
      return std::tuple(vertex.x(), vertex.y(), radius) <
             std::tuple(end.vertex.x(), end.vertex.y(), end.radius);
    }
    Point direction() const {
      const Point d = other - vertex;
      const double length = d.norm();
      return length > 0 ? Point(d / length) : d;
    }
  };

  static int side(Node node) { return node % 2 == 0 ? 1 : -1; }
  /// At which radius a path turns around an obstacle vertex or a disc.
  template <FeatureSpace S>
  static double turning_radius(const S& space, const Point& center, double radius);
  /// Whether two edges at a vertex make a straight line, so that no path turns around it.
  static bool is_straight(const End& a, const End& b) {
    return orientation(a.other, a.vertex, b.other) == 0 &&
           (a.other - a.vertex).dot(b.other - b.vertex) < 0;
  }
  /// Whether the edges of a circle's vertex tell how paths may touch it. Where a point may pass
  /// between obstacles that touch at a vertex, they do not.
  static bool limits_directions(const Circle& circle) {
    return circle.radius > 0 || circle.last_edge - circle.first_edge <= 2;
  }
  bool may_touch(const Circle& circle, int side, const Point& between, double radii) const;

  std::vector<Circle> circles_;
  std::vector<Point> edges_;
};

template <FeatureSpace S>
double TangentCircles::turning_radius(const S& space, const Point& center, double radius) {
  const double passing = passing_radius(space, radius);
  return passing > 0 || space.is_free(center) ? passing : 4 * space.distance_error_bound();
}

template <FeatureSpace S>
TangentCircles::TangentCircles(const S& space) {
  std::vector<End> ends;
  space.for_each_feature(space.bounds().inflated(2 * space.safety_radius()),
                         [&](const Segment& core, double radius) {
                           ends.push_back({core.a, core.b, radius});
                           if (core.a != core.b) ends.push_back({core.b, core.a, radius});
                         });
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    if (a.is_before(b) || b.is_before(a)) return a.is_before(b);
    return heading(a.direction()) < heading(b.direction());
  });
  for (std::size_t i = 0, next = 0; i < ends.size(); i = next) {
    for (next = i + 1; next < ends.size() && !ends[i].is_before(ends[next]);) ++next;
    if (next - i == 2 && is_straight(ends[i], ends[i + 1])) continue;
    const auto first = static_cast<std::uint32_t>(edges_.size());
    for (std::size_t k = i; k < next; ++k) {
      if (ends[k].other != ends[k].vertex) edges_.push_back(ends[k].direction());
    }
    circles_.push_back({ends[i].vertex, turning_radius(space, ends[i].vertex, ends[i].radius),
                        first, static_cast<std::uint32_t>(edges_.size())});
  }
}

inline bool TangentCircles::touches(Node node, const Point& direction) const {
  const Circle& circle = circles_[node / 2];
  if (!limits_directions(circle)) return true;
  for (std::uint32_t e = circle.first_edge; e < circle.last_edge; ++e) {
    if (side(node) * cross(edges_[e], direction) > 1e-9) return false;
  }
  return true;
}

/// A fast filter for the edge between two circles: rejects most directions that `touches` would
/// reject, and no others. `between` is the vector between the centres, and `radii` the sum of the
/// radii, at most a quarter of its length. The edge deviates from the line of centres by an angle
/// whose sine is at most radii / distance.
inline bool TangentCircles::may_touch(const Circle& circle, int side, const Point& between,
                                      double radii) const {
  if (!limits_directions(circle)) return true;
  const double limit = 1.25 * radii + 2e-9 * (std::abs(between.x()) + std::abs(between.y()));
  for (std::uint32_t e = circle.first_edge; e < circle.last_edge; ++e) {
    if (side * cross(edges_[e], between) > limit) return false;
  }
  return true;
}

template <class Visit>
void TangentCircles::for_each_candidate(const OrientedCircle& at, Node from,
                                        const SightSectors& sight, Visit visit) const {
  for (Node i = 0; i < circles_.size(); ++i) {
    const Circle& circle = circles_[i];
    const Point between{circle.center.x() - at.center.x(), circle.center.y() - at.center.y()};
    const double radii = circle.radius + at.radius;
    const bool is_near = between.squaredNorm() < 16 * radii * radii;
    if (!is_near && sight.hides(between, circle.radius)) continue;
    if (!is_near && from != none && !may_touch(circles_[from / 2], at.side, between, radii)) {
      continue;
    }
    for (const int side : {1, -1}) {
      const Node node = 2 * i + (side > 0 ? 0 : 1);
      if (node != from && (is_near || may_touch(circle, side, between, radii))) visit(node);
    }
  }
}

/// Both are sorted in the same way, so one pass finds all.
inline std::vector<TangentCircles::Node> TangentCircles::indices_in(
    const TangentCircles& others) const {
  const auto key = [](const Circle& c) { return std::tuple(c.center.x(), c.center.y(), c.radius); };
  std::vector<Node> indices(circles_.size(), none);
  auto other = others.circles_.begin();
  for (std::size_t i = 0; i < circles_.size(); ++i) {
    while (other != others.circles_.end() && key(*other) < key(circles_[i])) ++other;
    if (other == others.circles_.end()) break;
    if (key(*other) == key(circles_[i])) {
      indices[i] = static_cast<Node>(other - others.circles_.begin());
    }
  }
  return indices;
}

}  // namespace tutavia::detail
