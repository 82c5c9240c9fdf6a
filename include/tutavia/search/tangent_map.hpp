// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/tangent/changed_zones.hpp"
#include "tutavia/search/tangent/tangent_circles.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// TangentVisibilityGraph: what shortest paths of a disc turn around, and the ways between.

namespace tutavia {

/// The circles of a space: of the safety radius around obstacle vertices, larger ones around discs,
/// a few rounding errors more than needed so that doubles prove what touches them. With `prepare`
/// also the proved ways between them, for many queries; `updated` carries them over to a space in
/// which some obstacles have come, gone or moved. Immutable: one object serves any number of
/// threads.
///
/// Nodes are circles passed on one side: an even number has the circle on the left of the path, the
/// next one the same circle on the right.
class TangentVisibilityGraph {
 public:
  using Node = detail::TangentCircles::Node;
  static constexpr Node none = detail::TangentCircles::none;

  /// The circles alone. O(n log n) for n obstacle edges.
  template <FeatureSpace S>
  explicit TangentVisibilityGraph(const S& space)
      : conditions_{space.bounds().min, space.bounds().max, space.safety_radius(),
                    space.distance_error_bound()},
        circles_(space) {}

  /// The circles and all proved ways between them: O(n^2) for n vertices, seconds for thousands.
  /// Errors: what the budget says.
  template <FeatureSpace S>
  static Expected<TangentVisibilityGraph, Failure> prepare(const S& space,
                                                           const Budget& budget = {});

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
  Expected<TangentVisibilityGraph, Failure> updated(const S& after, std::span<const Box> changed,
                                                    const Budget& budget = {}) const;
  static constexpr std::size_t most_boxes = 32;

  Node nodes() const { return circles_.nodes(); }
  detail::OrientedCircle circle(Node node) const { return circles_.of(node); }
  /// Whether a path may touch a node's circle while it runs in a direction (a unit vector): where
  /// no edge of the circle's vertex comes nearer.
  bool touches(Node node, const Point& direction) const {
    return circles_.touches(node, direction);
  }

  /// Calls `visit(node)` for all nodes to which there may be a way from a circle, that of the node
  /// `from` or of none; a quick look drops most that cannot be touched.
  template <class Visit>
  void for_each_candidate(const detail::OrientedCircle& at, Node from, Visit visit) const {
    circles_.for_each_candidate(at, from, visit);
  }

  bool is_prepared() const { return !first_way_.empty(); }
  /// The nodes that a proved way leads to. \pre prepared
  std::span<const Node> ways(Node node) const {
    return {ways_.data() + first_way_[node], first_way_[node + 1] - first_way_[node]};
  }
  /// Whether it may be one of this space: it has as many circles, of these sizes.
  template <FeatureSpace S>
  bool matches(const S& space) const {
    return TangentVisibilityGraph(space).circles_ == circles_;
  }
  /// The same circles with the same ways, for the same bounds and safety radius.
  bool operator==(const TangentVisibilityGraph&) const = default;
  /// In bytes.
  std::size_t memory() const {
    return circles_.memory() + (ways_.size() + first_way_.size()) * sizeof(Node);
  }

 private:
  using Way = std::pair<Node, Node>;

  /// What the proof of every way depends on.
  struct ProofConditions {
    Point lower, upper;  // of the bounds
    double safety_radius, slack;
    bool operator==(const ProofConditions&) const = default;
  };

  /// The ways of this map that another one has as well, between the same circles there, but for
  /// those that `is_affected(first, second)` says of their circles.
  template <class IsAffected>
  std::vector<Way> ways_kept_in(const TangentVisibilityGraph& other,
                                const IsAffected& is_affected) const;
  /// Adds the way between two nodes, if there is one, both ways round. \pre from < to
  template <FeatureSpace S>
  void find_way(const S& space, Node from, Node to, std::vector<Way>& ways) const;
  /// \pre sorted
  void set_ways(const std::vector<Way>& ways);

  ProofConditions conditions_;
  detail::TangentCircles circles_;
  std::vector<Node> ways_;
  std::vector<std::uint32_t> first_way_;  // of each node, and one past the last
};

template <FeatureSpace S>
void TangentVisibilityGraph::find_way(const S& space, Node from, Node to,
                                      std::vector<Way>& ways) const {
  const auto way = detail::tangent_line(circle(from), circle(to));
  if (!way || !touches(from, way->direction) || !touches(to, way->direction)) return;
  // The space's own test is a proof as well, and done at the first obstacle in the way.
  if (!space.segment_free(way->from, way->to)) return;
  ways.emplace_back(from, to);
  ways.emplace_back(to ^ 1u, from ^ 1u);
}

inline void TangentVisibilityGraph::set_ways(const std::vector<Way>& ways) {
  first_way_.assign(nodes() + std::size_t{1}, 0);
  ways_.reserve(ways.size());
  for (const auto& [from, to] : ways) {
    ++first_way_[from + std::size_t{1}];
    ways_.push_back(to);
  }
  for (std::size_t i = 1; i < first_way_.size(); ++i) first_way_[i] += first_way_[i - 1];
}

template <FeatureSpace S>
Expected<TangentVisibilityGraph, Failure> TangentVisibilityGraph::prepare(const S& space,
                                                                          const Budget& budget) {
  TangentVisibilityGraph map(space);
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

template <class IsAffected>
std::vector<TangentVisibilityGraph::Way> TangentVisibilityGraph::ways_kept_in(
    const TangentVisibilityGraph& other, const IsAffected& is_affected) const {
  const std::vector<Node> places = circles_.places_in(other.circles_);
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
  return kept;
}

/// The verdict on a way is exact, so it differs only where an obstacle that one space alone has
/// comes within the safety radius of the way, holds it, or has one of its circles: the way meets
/// that obstacle's box, grown by a circle's radius. And it stays within the larger of its two radii
/// of the line of the centres. All pairs of which that line comes near a box are looked at anew.
template <FeatureSpace S>
Expected<TangentVisibilityGraph, Failure> TangentVisibilityGraph::updated(
    const S& after, std::span<const Box> changed, const Budget& budget) const {
  TangentVisibilityGraph map(after);
  if (!is_prepared() || map.conditions_ != conditions_ || changed.size() > most_boxes) {
    return prepare(after, budget);
  }
  const detail::ChangedZones zones(changed, after.bounds(),
                                   after.safety_radius() + 8 * after.distance_error_bound());
  // The circles always in the same order, as rounding might tell a way from its way back.
  const auto is_affected = [&](const auto& first, const auto& second) {
    return zones.are_near(first.center, second.center, std::max(first.radius, second.radius));
  };

  const std::vector<Way> kept = ways_kept_in(map, is_affected);
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
