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
/// TangentVisibilityGraph: the circles that shortest paths of a disc turn around, and their
/// tangents.

namespace tutavia {

/// The circles of a space: of the safety radius around obstacle vertices, larger ones around discs.
/// They exceed what is needed by a few rounding errors, so that paths touching them can be proved
/// free in doubles. After `prepare` it also has all proved tangent edges between the circles, for
/// many queries. `updated` adapts them to a space in which some obstacles were added, removed or
/// moved. Immutable: one object serves any number of threads.
///
/// A node is a circle passed on one side. Even nodes have the circle on the left of the path; the
/// odd node after each is the same circle on the right.
///
/// Example: examples/searches_among_polygons.cpp.
class TangentVisibilityGraph {
 public:
  using Node = detail::TangentCircles::Node;
  static constexpr Node none = detail::TangentCircles::none;

  /// Finds the circles only. O(n log n) for n obstacle edges.
  template <FeatureSpace S>
  explicit TangentVisibilityGraph(const S& space)
      : conditions_{space.bounds().min, space.bounds().max, space.safety_radius(),
                    space.distance_error_bound()},
        circles_(space) {}

  /// Finds the circles and all proved edges between them. O(n^2) for n vertices, seconds for
  /// thousands. Errors: those of the budget.
  template <FeatureSpace S>
  static Expected<TangentVisibilityGraph, Failure> prepare(const S& space,
                                                           const Budget& budget = {});

  /// Returns the same graph as `prepare(after)`, in the same order, without proving again the edges
  /// that stay away from the changes. O(n^2) fast tests for n vertices; takes a twentieth of the
  /// time of `prepare` if one of 1000 polygons moves.
  ///
  /// `changed` must cover every obstacle that only one of the two spaces has, and both positions of
  /// an obstacle that moved; `changed_boxes` computes it for two workspaces. If `changed` misses an
  /// obstacle, the result contains edges that were never verified. Falls back to `prepare` if the
  /// bounds, the safety radius or the largest coordinate differ, if there are more than
  /// `most_boxes` boxes, or if this graph is not prepared. Errors: those of the budget.
  template <FeatureSpace S>
  Expected<TangentVisibilityGraph, Failure> updated(const S& after, std::span<const Box> changed,
                                                    const Budget& budget = {}) const;
  static constexpr std::size_t most_boxes = 32;

  Node nodes() const { return circles_.nodes(); }
  detail::OrientedCircle circle(Node node) const { return circles_.of(node); }
  /// Whether a path that runs in a direction (a unit vector) may touch a node's circle: true if no
  /// edge of the circle's vertex comes nearer to the path.
  bool touches(Node node, const Point& direction) const {
    return circles_.touches(node, direction);
  }

  /// Calls `visit(node)` for all nodes to which there may be an edge from a circle. `from` is the
  /// circle's node, or `none`; `sight` has looked from the circle, or hides nothing. Fast tests
  /// drop most nodes that cannot be touched or are hidden.
  template <class Visit>
  void for_each_candidate(const detail::OrientedCircle& at, Node from,
                          const detail::SightSectors& sight, Visit visit) const {
    circles_.for_each_candidate(at, from, sight, visit);
  }

  bool is_prepared() const { return !first_edge_.empty(); }
  /// The nodes at the ends of a node's proved edges. \pre prepared
  std::span<const Node> edges(Node node) const {
    return {edges_.data() + first_edge_[node], first_edge_[node + 1] - first_edge_[node]};
  }
  /// Whether this may be the graph of a space: compares the circles.
  template <FeatureSpace S>
  bool matches(const S& space) const {
    return TangentVisibilityGraph(space).circles_ == circles_;
  }
  /// Compares circles, edges, bounds and safety radius.
  bool operator==(const TangentVisibilityGraph&) const = default;
  /// In bytes.
  std::size_t memory() const {
    return circles_.memory() + (edges_.size() + first_edge_.size()) * sizeof(Node);
  }

 private:
  using Edge = std::pair<Node, Node>;

  /// The conditions on which all proofs depend.
  struct ProofConditions {
    Point lower, upper;  // of the bounds
    double safety_radius, distance_error_bound;
    bool operator==(const ProofConditions&) const = default;
  };

  /// The edges that both graphs have, with the node numbers of `other`, without those whose circles
  /// are `is_affected(first, second)`.
  template <class IsAffected>
  std::vector<Edge> edges_kept_in(const TangentVisibilityGraph& other,
                                  const IsAffected& is_affected) const;
  /// Adds the edge between two nodes in both directions, if it is free. \pre from < to
  template <FeatureSpace S>
  void find_edge(const S& space, Node from, Node to, std::vector<Edge>& edges) const;
  /// \pre sorted
  void set_edges(const std::vector<Edge>& edges);

  ProofConditions conditions_;
  detail::TangentCircles circles_;
  std::vector<Node> edges_;
  std::vector<std::uint32_t> first_edge_;  // of each node, and one past the last
};

template <FeatureSpace S>
void TangentVisibilityGraph::find_edge(const S& space, Node from, Node to,
                                       std::vector<Edge>& edges) const {
  const auto tangent = detail::tangent_line(circle(from), circle(to));
  if (!tangent || !touches(from, tangent->direction) || !touches(to, tangent->direction)) return;
  // The space's own test is a proof too, and stops at the first obstacle on the edge.
  if (!space.segment_free(tangent->from, tangent->to)) return;
  edges.emplace_back(from, to);
  edges.emplace_back(to ^ 1u, from ^ 1u);
}

inline void TangentVisibilityGraph::set_edges(const std::vector<Edge>& edges) {
  first_edge_.assign(nodes() + std::size_t{1}, 0);
  edges_.reserve(edges.size());
  for (const auto& [from, to] : edges) {
    ++first_edge_[from + std::size_t{1}];
    edges_.push_back(to);
  }
  for (std::size_t i = 1; i < first_edge_.size(); ++i) first_edge_[i] += first_edge_[i - 1];
}

template <FeatureSpace S>
Expected<TangentVisibilityGraph, Failure> TangentVisibilityGraph::prepare(const S& space,
                                                                          const Budget& budget) {
  TangentVisibilityGraph map(space);
  std::vector<Edge> edges;
  detail::SightSectors sight;
  for (Node from = 0; from < map.nodes(); ++from) {
    if (from % 16 == 0) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "preparing tangents");
    }
    if (from % 2 == 0) sight.look_from(space, map.circle(from), map.circles_.size());
    map.for_each_candidate(map.circle(from), from, sight, [&](Node to) {
      // Edges to earlier circles were found from those circles, in reverse.
      if (to / 2 > from / 2) map.find_edge(space, from, to, edges);
    });
  }
  std::sort(edges.begin(), edges.end());
  map.set_edges(edges);
  return map;
}

template <class IsAffected>
std::vector<TangentVisibilityGraph::Edge> TangentVisibilityGraph::edges_kept_in(
    const TangentVisibilityGraph& other, const IsAffected& is_affected) const {
  const std::vector<Node> indices = circles_.indices_in(other.circles_);
  std::vector<Edge> kept;
  kept.reserve(edges_.size());
  for (Node from = 0; from < nodes(); ++from) {
    const Node new_from = indices[from / 2];
    if (new_from == none) continue;
    for (const Node to : edges(from)) {
      const Node new_to = indices[to / 2];
      const auto [first, second] = std::minmax({from / 2, to / 2});
      if (new_to == none || is_affected(circles_[first], circles_[second])) continue;
      kept.emplace_back(2 * new_from + from % 2, 2 * new_to + to % 2);
    }
  }
  return kept;
}

/// The verdict on an edge is exact. It changes only if an obstacle that one space alone has comes
/// within the safety radius of the edge, contains it, or has one of its circles. Then the edge
/// meets that obstacle's box, grown by a circle's radius. The edge stays within the larger of its
/// two radii of the line of centres, so all pairs whose line of centres comes near a box are tested
/// again.
template <FeatureSpace S>
Expected<TangentVisibilityGraph, Failure> TangentVisibilityGraph::updated(
    const S& after, std::span<const Box> changed, const Budget& budget) const {
  TangentVisibilityGraph map(after);
  if (!is_prepared() || map.conditions_ != conditions_ || changed.size() > most_boxes) {
    return prepare(after, budget);
  }
  const detail::ChangedZones zones(changed, after.bounds(),
                                   after.safety_radius() + 8 * after.distance_error_bound());
  // Always in the same order, as rounding might distinguish an edge from its reverse.
  const auto is_affected = [&](const auto& first, const auto& second) {
    return zones.are_near(first.center, second.center, std::max(first.radius, second.radius));
  };

  const std::vector<Edge> kept = edges_kept_in(map, is_affected);
  std::vector<Edge> found;
  for (Node i = 0; i < map.circles_.size(); ++i) {
    if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "updating tangents");
    for (Node j = i + 1; j < map.circles_.size(); ++j) {
      if (!is_affected(map.circles_[i], map.circles_[j])) continue;
      for (const Node from : {2 * i, 2 * i + 1}) {
        for (const Node to : {2 * j, 2 * j + 1}) map.find_edge(after, from, to, found);
      }
    }
  }
  std::sort(found.begin(), found.end());

  std::vector<Edge> all(kept.size() + found.size());
  std::merge(kept.begin(), kept.end(), found.begin(), found.end(), all.begin());
  map.set_edges(all);
  return map;
}

}  // namespace tutavia
