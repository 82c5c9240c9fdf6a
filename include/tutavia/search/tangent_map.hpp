// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/core/error.hpp"
#include "tutavia/geometry/bitangent.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/passing_radius.hpp"

/// \file
/// TangentMap: what shortest paths of a disc turn around, and the ways between.

namespace tutavia {

/// The circles of a space: of the safety radius around obstacle vertices, larger ones around discs,
/// a few rounding errors more than needed so that doubles prove what touches them. With `prepare`
/// also the proved ways between them, for many queries. Immutable: one object serves any number of
/// threads.
///
/// Nodes are circles passed on one side: an even number has the circle on the left of the path, the
/// next one the same circle on the right.
class TangentMap {
 public:
  using Node = std::uint32_t;
  static constexpr Node none = std::numeric_limits<Node>::max();

  /// The circles alone. O(n log n) for n obstacle edges.
  template <FeatureSpace S>
  explicit TangentMap(const S& space);

  /// The circles and all proved ways between them: O(n^2) for n vertices, seconds for thousands.
  /// Errors: what the budget says.
  template <FeatureSpace S>
  static Expected<TangentMap, Failure> prepare(const S& space, const Budget& budget = {});

  Node nodes() const { return static_cast<Node>(2 * circles_.size()); }
  SidedCircle circle(Node node) const {
    const Circle& circle = circles_[node / 2];
    return {circle.center, circle.radius, side(node)};
  }
  /// Whether a path may touch a node's circle while it runs in a direction (a unit vector): where
  /// no edge of the circle's vertex comes nearer.
  bool touches(Node node, const Point& direction) const;

  /// Calls `visit(node)` for all nodes to which there may be a way from a circle, that of the node
  /// `from` or of none; a quick look drops most that cannot be touched.
  template <class Visit>
  void for_each_candidate(const SidedCircle& at, Node from, Visit visit) const;

  bool is_prepared() const { return !first_way_.empty(); }
  /// The nodes that a proved way leads to. \pre prepared
  std::span<const Node> ways(Node node) const {
    return {ways_.data() + first_way_[node], first_way_[node + 1] - first_way_[node]};
  }
  /// Whether it may be one of this space: it has as many circles, of these sizes.
  template <FeatureSpace S>
  bool matches(const S& space) const {
    return TangentMap(space).circles_ == circles_;
  }
  /// In bytes.
  std::size_t memory() const {
    return circles_.size() * sizeof(Circle) + edges_.size() * sizeof(Point) +
           (ways_.size() + first_way_.size()) * sizeof(Node);
  }

 private:
  struct Circle {
    Point center;
    double radius;
    std::uint32_t first_edge, last_edge;  // the directions of the vertex's edges, in edges_
    bool operator==(const Circle&) const = default;
  };

  static int side(Node node) { return node % 2 == 0 ? 1 : -1; }
  bool may_touch(const Circle& circle, int side, const Point& between, double radii) const;

  std::vector<Circle> circles_;
  std::vector<Point> edges_;
  std::vector<Node> ways_;
  std::vector<std::uint32_t> first_way_;  // of each node, and one past the last
};

template <FeatureSpace S>
TangentMap::TangentMap(const S& space) {
  struct End {
    Point vertex, direction;
    double radius;
  };
  std::vector<End> ends;
  space.for_each_feature(space.bounds().inflated(2 * space.safety_radius()),
                         [&](const Segment& core, double radius) {
                           const double grown = passing_radius(space, radius);
                           const Point d = core.b - core.a;
                           const double length = d.norm();
                           const Point unit = length > 0 ? Point(d / length) : d;
                           ends.push_back({core.a, unit, grown});
                           if (length > 0) ends.push_back({core.b, -unit, grown});
                         });
  const auto before = [](const End& a, const End& b) {
    if (a.vertex.x() != b.vertex.x()) return a.vertex.x() < b.vertex.x();
    if (a.vertex.y() != b.vertex.y()) return a.vertex.y() < b.vertex.y();
    return a.radius < b.radius;
  };
  const auto sorts_before = [&](const End& a, const End& b) {
    if (before(a, b) || before(b, a)) return before(a, b);
    return heading(a.direction) < heading(b.direction);
  };
  std::sort(ends.begin(), ends.end(), sorts_before);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const bool is_new = i == 0 || before(ends[i - 1], ends[i]);
    const auto edge = static_cast<std::uint32_t>(edges_.size());
    if (is_new) circles_.push_back({ends[i].vertex, ends[i].radius, edge, edge});
    if (is_null(ends[i].direction)) continue;
    edges_.push_back(ends[i].direction);
    circles_.back().last_edge = edge + 1;
  }
}

inline bool TangentMap::touches(Node node, const Point& direction) const {
  const Circle& circle = circles_[node / 2];
  for (std::uint32_t e = circle.first_edge; e < circle.last_edge; ++e) {
    if (side(node) * cross(edges_[e], direction) > 1e-9) return false;
  }
  return true;
}

/// Refuses most directions that `touches` would refuse, and none else, for a way between circles
/// whose centres lie `between` apart and whose radii add up to `radii`: it turns from the line of
/// the centres by an angle of which the sine is radii / distance at most.
inline bool TangentMap::may_touch(const Circle& circle, int side, const Point& between,
                                  double radii) const {
  for (std::uint32_t e = circle.first_edge; e < circle.last_edge; ++e) {
    if (side * cross(edges_[e], between) > 1.25 * radii) return false;
  }
  return true;
}

template <class Visit>
void TangentMap::for_each_candidate(const SidedCircle& at, Node from, Visit visit) const {
  for (Node i = 0; i < circles_.size(); ++i) {
    const Circle& circle = circles_[i];
    const Point between{circle.center.x() - at.center.x(), circle.center.y() - at.center.y()};
    const double radii = circle.radius + at.radius;
    const bool is_near = between.squaredNorm() < 16 * radii * radii;
    if (!is_near && from != none && !may_touch(circles_[from / 2], at.side, between, radii)) {
      continue;
    }
    for (const int side : {1, -1}) {
      const Node node = 2 * i + (side > 0 ? 0 : 1);
      if (node != from && (is_near || may_touch(circle, side, between, radii))) visit(node);
    }
  }
}

template <FeatureSpace S>
Expected<TangentMap, Failure> TangentMap::prepare(const S& space, const Budget& budget) {
  TangentMap map(space);
  std::vector<std::pair<Node, Node>> ways;
  for (Node from = 0; from < map.nodes(); ++from) {
    if (from % 16 == 0) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "preparing tangents");
    }
    const SidedCircle circle = map.circle(from);
    map.for_each_candidate(circle, from, [&](Node to) {
      if (to / 2 <= from / 2) return;  // found from there, the other way round
      const auto way = bitangent(circle, map.circle(to));
      if (!way || !map.touches(from, way->direction) || !map.touches(to, way->direction)) return;
      if (!is_proved_free(space, Segment{way->from, way->to})) return;
      ways.emplace_back(from, to);
      ways.emplace_back(to ^ 1u, from ^ 1u);
    });
  }
  std::sort(ways.begin(), ways.end());
  map.first_way_.assign(map.nodes() + std::size_t{1}, 0);
  for (const auto& [from, to] : ways) {
    ++map.first_way_[from + std::size_t{1}];
    map.ways_.push_back(to);
  }
  for (std::size_t i = 1; i < map.first_way_.size(); ++i)
    map.first_way_[i] += map.first_way_[i - 1];
  return map;
}

}  // namespace tutavia
