// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/open_heap.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/tangent_visibility_graph.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// TangentSearch: A* over the tangent edges of a space.

namespace tutavia::detail {

/// Memory of a tangent search, reused by later queries.
class TangentScratch {
 public:
  struct Entry {
    double key;
    std::uint32_t sequence, parent, node;
    bool is_proved;                                          // the edge, not the arc before it
    friend bool operator<(const Entry& a, const Entry& b) {  // worse < better
      return a.key != b.key ? a.key > b.key : a.sequence > b.sequence;
    }
  };
  /// An edge on the search tree, which ends where it touches a circle (or at the goal).
  struct Arrival {
    TangentLine edge;
    double cost;  // up to the edge's end
    std::uint32_t node, parent, next;
    double turn;  // around the previous circle
  };

  OpenHeap<Entry> open;
  std::vector<Arrival> arrivals;
  std::vector<std::uint32_t> first;  // arrival at each node
};

/// Whether a point lies on the boundary of a safety zone, within rounding, where only exact arcs
/// could follow it. At safety radius 0 only discs and the ends of walls have such zones.
template <FeatureSpace S>
bool touches_zone(const S& space, const TangentVisibilityGraph& map, const Point& p) {
  const double margin = 8 * space.distance_error_bound();
  if (space.safety_radius() > 0) return space.clearance(p) < space.safety_radius() + margin;
  for (TangentVisibilityGraph::Node node = 0; node < map.nodes(); node += 2) {
    const OrientedCircle circle = map.circle(node);
    if (circle.radius > 0 && distance(circle.center, p) < circle.radius + margin) return true;
  }
  return false;
}

template <FeatureSpace S, Observer O>
class TangentSearch {
 public:
  TangentSearch(SearchContext<S, O>& context, const TangentVisibilityGraph& map, double bound,
                TangentScratch& scratch)
      : context_(context),
        space_(context.space),
        query_(context.query),
        map_(map),
        bound_(bound),
        scratch_(scratch) {}

  Expected<void, Failure> run() {
    scratch_.open.clear();
    scratch_.arrivals.clear();
    scratch_.first.assign(map_.nodes() + std::size_t{1}, none);
    scratch_.arrivals.push_back(
        {{query_.start, query_.start, Point::Zero(), 0}, 0, none, none, none, 0});
    if (auto within = context_.check_budget(); !within) return within;
    expand(0);
    while (!scratch_.open.empty()) {
      if (auto within = context_.check_budget(16); !within) return within;
      const TangentScratch::Entry entry = scratch_.open.pop();
      if (!arrive(entry)) continue;
      if (entry.node == goal_node()) return {};
      expand(static_cast<std::uint32_t>(scratch_.arrivals.size() - 1));
    }
    for (const Point& end : {query_.start, query_.goal}) {
      if (touches_zone(space_, map_, end)) {
        return fail(PlanError::not_proved,
                    "start or goal touches a safety zone, and no path from there can be proved");
      }
    }
    return fail(PlanError::unreachable, std::isfinite(bound_)
                                            ? "no path among the obstacles is within `bound`"
                                            : "no path among the obstacles");
  }

  /// The path that ends with the last arrival.
  Curve curve() const {
    std::vector<std::uint32_t> chain;
    for (auto i = static_cast<std::uint32_t>(scratch_.arrivals.size() - 1); i != 0;
         i = scratch_.arrivals[i].parent) {
      chain.push_back(i);
    }
    Curve curve;
    Point at = query_.start;
    for (auto i = chain.rbegin(); i != chain.rend(); ++i) {
      const TangentScratch::Arrival& arrival = scratch_.arrivals[*i];
      const OrientedCircle circle = circle_of(scratch_.arrivals[arrival.parent].node);
      for_each_arc(circle, at, arrival.edge.from, arrival.turn, space_.distance_error_bound(),
                   [&](const Arc& arc) {
                     curve.push_back(arc);
                     at = arc.b;
                   });
      curve.push_back(Segment{at, arrival.edge.to});
      at = arrival.edge.to;
    }
    return curve;
  }

 private:
  static constexpr TangentVisibilityGraph::Node none = TangentVisibilityGraph::none;
  /// With fewer circles, looking around takes longer than it saves.
  static constexpr std::size_t many_circles = 1000;

  /// The goal is one more node; the start has none.
  TangentVisibilityGraph::Node goal_node() const { return map_.nodes(); }
  OrientedCircle circle_of(TangentVisibilityGraph::Node node) const {
    if (node == none) return {query_.start, 0, 1};
    if (node == goal_node()) return {query_.goal, 0, 1};
    return map_.circle(node);
  }
  bool touches(TangentVisibilityGraph::Node node, const Point& direction) const {
    return node == none || node == goal_node() || map_.touches(node, direction);
  }
  /// The turn around a circle from one direction to another, in [0, 2 pi).
  static double turn_between(const OrientedCircle& circle, const Point& from, const Point& to) {
    const double turn = circle.side * turn_angle(from, to);
    return turn >= 0 ? turn : turn > -1e-9 ? 0 : turn + 2 * std::numbers::pi;
  }

  /// An edge that continues an arrival, the turn before it, and the cost at its end.
  struct Step {
    TangentLine edge;
    double turn, cost;
  };
  std::optional<Step> step(const TangentScratch::Arrival& from, std::uint32_t node) const {
    const OrientedCircle circle = circle_of(from.node);
    const auto edge = tangent_line(circle, circle_of(node));
    if (!edge || !touches(from.node, edge->direction) || !touches(node, edge->direction)) {
      return std::nullopt;
    }
    const double turn =
        circle.radius > 0 ? turn_between(circle, from.edge.direction, edge->direction) : 0;
    return Step{*edge, turn, from.cost + circle.radius * turn + edge->length};
  }

  void expand(std::uint32_t index) {
    const TangentScratch::Arrival from = scratch_.arrivals[index];
    context_.count_expanded(from.edge.to);
    if (from.node != none && map_.is_prepared()) {
      for (const TangentVisibilityGraph::Node node : map_.edges(from.node))
        generate(index, from, node, true);
    } else {
      const std::size_t circles = map_.nodes() / 2;
      if (circles >= many_circles) sight_.look_from(space_, circle_of(from.node), circles);
      map_.for_each_candidate(
          circle_of(from.node), from.node, sight_,
          [&](TangentVisibilityGraph::Node node) { generate(index, from, node, false); });
    }
    generate(index, from, goal_node(), false);
  }

  /// Pushes the edge from an arrival to a node onto the open list.
  void generate(std::uint32_t index, const TangentScratch::Arrival& from,
                TangentVisibilityGraph::Node node, bool is_proved) {
    const auto next = step(from, node);
    if (!next) return;
    const double key = next->cost + distance(next->edge.to, query_.goal);
    if (key > bound_) return;
    scratch_.open.push({key, sequence_++, index, node, is_proved});
    context_.count_generated(next->edge.to);
  }

  /// Whether another arrival at the circle reaches the same point by an arc at no more cost.
  bool is_dominated(std::uint32_t node, const Step& step) const {
    const OrientedCircle circle = circle_of(node);
    for (std::uint32_t i = scratch_.first[node]; i != none; i = scratch_.arrivals[i].next) {
      const TangentScratch::Arrival& other = scratch_.arrivals[i];
      const double turn = turn_between(circle, other.edge.direction, step.edge.direction);
      if (other.cost + circle.radius * turn > step.cost * (1 + 1e-12)) continue;
      if (is_arc_free(circle, other.edge.to, step.edge.to, turn)) return true;
    }
    return false;
  }

  bool is_arc_free(const OrientedCircle& circle, const Point& in, const Point& out,
                   double turn) const {
    bool free = true;
    for_each_arc(circle, in, out, circle.side * turn, space_.distance_error_bound(),
                 [&](const Arc& arc) { free = free && is_proved_free(space_, arc); });
    return free;
  }

  /// Adds an arrival for an open entry if it is proved and not dominated.
  bool arrive(const TangentScratch::Entry& entry) {
    const TangentScratch::Arrival from = scratch_.arrivals[entry.parent];
    const Step next = *step(from, entry.node);
    if (is_dominated(entry.node, next)) return false;
    if (!entry.is_proved && !space_.segment_free(next.edge.from, next.edge.to)) {
      return false;
    }
    const OrientedCircle circle = circle_of(from.node);
    if (!is_arc_free(circle, from.edge.to, next.edge.from, next.turn)) return false;
    const auto index = static_cast<std::uint32_t>(scratch_.arrivals.size());
    scratch_.arrivals.push_back({next.edge, next.cost, entry.node, entry.parent,
                                 scratch_.first[entry.node], circle.side * next.turn});
    scratch_.first[entry.node] = index;
    return true;
  }

  SearchContext<S, O>& context_;
  const S& space_;
  const Query& query_;
  const TangentVisibilityGraph& map_;
  double bound_;
  TangentScratch& scratch_;
  SightSectors sight_;
  std::uint32_t sequence_ = 0;
};

}  // namespace tutavia::detail
