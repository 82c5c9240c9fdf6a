// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/tangent/changed_zones.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/index/passing_radius.hpp"

/// \file
/// TangentMap: what shortest paths of a disc turn around, and the ways between.

namespace tutavia {

/// The circles of a space: of the safety radius around obstacle vertices, larger ones around discs,
/// a few rounding errors more than needed so that doubles prove what touches them. With `prepare`
/// also the proved ways between them, for many queries; `updated` carries them over to a space in
/// which some obstacles have come, gone or moved. Immutable: one object serves any number of
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

  /// What `prepare(after)` gives, with the same circles and ways in the same order, but without a
  /// proof of those ways that keep away from the changes. O(n^2) quick looks for n vertices; where
  /// one of 1000 polygons moves, a twentieth of the time.
  ///
  /// `changed` holds every obstacle that only one of the two spaces has, an obstacle that moved in
  /// both places: `changed_boxes` finds them in two workspaces. Where boxes leave one out, there
  /// are ways that no proof stands behind. With other bounds, another safety radius or largest
  /// coordinate, with more than `most_boxes` boxes and for a map that is not prepared, all is
  /// prepared anew.
  /// Errors: what the budget says.
  template <FeatureSpace S>
  Expected<TangentMap, Failure> updated(const S& after, std::span<const Box> changed,
                                        const Budget& budget = {}) const;
  static constexpr std::size_t most_boxes = 32;

  Node nodes() const { return static_cast<Node>(2 * circles_.size()); }
  detail::SidedCircle circle(Node node) const {
    const Circle& circle = circles_[node / 2];
    return {circle.center, circle.radius, side(node)};
  }
  /// Whether a path may touch a node's circle while it runs in a direction (a unit vector): where
  /// no edge of the circle's vertex comes nearer.
  bool touches(Node node, const Point& direction) const;

  /// Calls `visit(node)` for all nodes to which there may be a way from a circle, that of the node
  /// `from` or of none; a quick look drops most that cannot be touched.
  template <class Visit>
  void for_each_candidate(const detail::SidedCircle& at, Node from, Visit visit) const;

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
  /// The same circles with the same ways, for the same bounds and safety radius.
  bool operator==(const TangentMap&) const = default;
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
  using Way = std::pair<Node, Node>;

  /// What the proof of every way depends on.
  struct Setting {
    Point lower, upper;  // of the bounds
    double safety_radius, slack;
    bool operator==(const Setting&) const = default;
  };

  static int side(Node node) { return node % 2 == 0 ? 1 : -1; }
  bool may_touch(const Circle& circle, int side, const Point& between, double radii) const;
  std::vector<Node> places_in(const TangentMap& other) const;
  /// Adds the way between two nodes, if there is one, both ways round. \pre from < to
  template <FeatureSpace S>
  void find_way(const S& space, Node from, Node to, std::vector<Way>& ways) const;
  /// \pre sorted
  void set_ways(const std::vector<Way>& ways);

  Setting setting_;
  std::vector<Circle> circles_;
  std::vector<Point> edges_;
  std::vector<Node> ways_;
  std::vector<std::uint32_t> first_way_;  // of each node, and one past the last
};

template <FeatureSpace S>
TangentMap::TangentMap(const S& space)
    : setting_{space.bounds().min, space.bounds().max, space.safety_radius(), space.slack()} {
  struct End {
    Point vertex, direction;
    double radius;
  };
  std::vector<End> ends;
  space.for_each_feature(space.bounds().inflated(2 * space.safety_radius()),
                         [&](const Segment& core, double radius) {
                           const double grown = detail::passing_radius(space, radius);
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
/// whose centres lie `between` apart and whose radii add up to `radii`, at most a quarter of that:
/// it turns from the line of the centres by an angle of which the sine is radii / distance at most.
inline bool TangentMap::may_touch(const Circle& circle, int side, const Point& between,
                                  double radii) const {
  const double limit = 1.25 * radii + 2e-9 * (std::abs(between.x()) + std::abs(between.y()));
  for (std::uint32_t e = circle.first_edge; e < circle.last_edge; ++e) {
    if (side * cross(edges_[e], between) > limit) return false;
  }
  return true;
}

template <class Visit>
void TangentMap::for_each_candidate(const detail::SidedCircle& at, Node from, Visit visit) const {
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
void TangentMap::find_way(const S& space, Node from, Node to, std::vector<Way>& ways) const {
  const auto way = detail::bitangent(circle(from), circle(to));
  if (!way || !touches(from, way->direction) || !touches(to, way->direction)) return;
  // The space's own test is a proof as well, and done at the first obstacle in the way.
  if (!space.segment_free(way->from, way->to)) return;
  ways.emplace_back(from, to);
  ways.emplace_back(to ^ 1u, from ^ 1u);
}

inline void TangentMap::set_ways(const std::vector<Way>& ways) {
  first_way_.assign(nodes() + std::size_t{1}, 0);
  ways_.reserve(ways.size());
  for (const auto& [from, to] : ways) {
    ++first_way_[from + std::size_t{1}];
    ways_.push_back(to);
  }
  for (std::size_t i = 1; i < first_way_.size(); ++i) first_way_[i] += first_way_[i - 1];
}

template <FeatureSpace S>
Expected<TangentMap, Failure> TangentMap::prepare(const S& space, const Budget& budget) {
  TangentMap map(space);
  std::vector<Way> ways;
  for (Node from = 0; from < map.nodes(); ++from) {
    if (from % 16 == 0) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "preparing tangents");
    }
    map.for_each_candidate(map.circle(from), from, [&](Node to) {
      // From the circle after it the same way is found the other way round.
      if (to / 2 > from / 2) map.find_way(space, from, to, ways);
    });
  }
  std::sort(ways.begin(), ways.end());
  map.set_ways(ways);
  return map;
}

/// For each circle the index of the one in the same place in another map, `none` where it has none.
/// Both have their circles in the same order, so the indices rise.
inline std::vector<TangentMap::Node> TangentMap::places_in(const TangentMap& other) const {
  const auto key = [](const Circle& c) { return std::tuple(c.center.x(), c.center.y(), c.radius); };
  std::vector<Node> places(circles_.size(), none);
  auto its = other.circles_.begin();
  for (std::size_t i = 0; i < circles_.size(); ++i) {
    while (its != other.circles_.end() && key(*its) < key(circles_[i])) ++its;
    if (its == other.circles_.end()) break;
    if (key(*its) == key(circles_[i])) {
      places[i] = static_cast<Node>(its - other.circles_.begin());
    }
  }
  return places;
}

/// The verdict on a way is exact, so it differs only where an obstacle that one space alone has
/// comes within the safety radius of the way, holds it, or has one of its circles: the way meets
/// that obstacle's box, grown by a circle's radius. And it stays within the larger of its two radii
/// of the line of the centres. All pairs of which that line comes near a box are looked at anew.
template <FeatureSpace S>
Expected<TangentMap, Failure> TangentMap::updated(const S& after, std::span<const Box> changed,
                                                  const Budget& budget) const {
  TangentMap map(after);
  if (!is_prepared() || map.setting_ != setting_ || changed.size() > most_boxes) {
    return prepare(after, budget);
  }
  const detail::ChangedZones zones(changed, after.bounds(),
                                   after.safety_radius() + 8 * after.slack());
  // The circles always in the same order, as rounding might tell a way from its way back.
  const auto is_affected = [&](const Circle& first, const Circle& second) {
    return zones.are_near(first.center, second.center, std::max(first.radius, second.radius));
  };

  const std::vector<Node> places = places_in(map);
  std::vector<Way> kept;
  kept.reserve(ways_.size());
  for (Node from = 0; from < nodes(); ++from) {
    const Node at = places[from / 2];
    if (at == none) continue;
    for (const Node to : ways(from)) {
      const Node place = places[to / 2];
      const auto [first, second] = std::minmax({from / 2, to / 2});
      if (place == none || is_affected(circles_[first], circles_[second])) continue;
      kept.emplace_back(2 * at + from % 2, 2 * place + to % 2);
    }
  }

  std::vector<Way> found;
  for (Node i = 0; i < map.circles_.size(); ++i) {
    if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "updating tangents");
    for (Node j = i + 1; j < map.circles_.size(); ++j) {
      if (!is_affected(map.circles_[i], map.circles_[j])) continue;
      for (const Node from : {2 * i, 2 * i + 1}) {
        for (const Node to : {2 * j, 2 * j + 1}) map.find_way(after, from, to, found);
      }
    }
  }
  std::sort(found.begin(), found.end());

  std::vector<Way> all(kept.size() + found.size());
  std::merge(kept.begin(), kept.end(), found.begin(), found.end(), all.begin());
  map.set_ways(all);
  return map;
}

}  // namespace tutavia
