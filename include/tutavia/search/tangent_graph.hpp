// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/open_heap.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/tangent_map.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// TangentGraph: the shortest path of a disc among polygons and discs.

namespace tutavia {

namespace detail {

/// What a tangent search keeps between queries: memory.
class TangentScratch {
 public:
  struct Entry {
    double key;
    std::uint32_t sequence, parent, node;
    bool is_proved;                                          // the way, not the arc before it
    friend bool operator<(const Entry& a, const Entry& b) {  // worse < better
      return a.key != b.key ? a.key > b.key : a.sequence > b.sequence;
    }
  };
  /// A way that was taken, to where it touches a circle (or to the goal).
  struct Arrival {
    detail::TangentLine way;
    double cost;  // up to there
    std::uint32_t node, parent, next;
    double turn;  // around the circle before
  };

  detail::OpenHeap<Entry> open;
  std::vector<Arrival> arrivals;
  std::vector<std::uint32_t> first;  // arrival of each node
};

}  // namespace detail

/// The shortest path of a disc among polygons and discs: exact, but for a few rounding errors that
/// its circles are larger than the safety radius.
///
/// Such a path is made of straight ways that touch circles of the safety radius around obstacle
/// vertices (around discs: larger ones) and of arcs of these circles. A* over these ways, from one
/// to the next: they are made when a way before them is expanded, and proved when their turn comes.
/// Polygons may have holes, touch, overlap, lie in one another or have no area. A gap of twice the
/// radius, within the same rounding errors, counts as closed. The route is
/// smooth and lies in free space. For n vertices of which m ways are expanded, O(m n) of them are
/// looked at; with prepared tangents only those that ways lead to.
///
/// Source: Pocchiola and Vegter 1996, "The visibility complex" (the graph of tangents); Hart,
/// Nilsson and Raphael 1968 (A*).
struct TangentGraph {
  static constexpr std::string_view name = "tangent_graph";
  using Scratch = detail::TangentScratch;
  using Prepared = TangentVisibilityGraph;

  /// Paths longer than this are not looked for [m].
  double bound = std::numeric_limits<double>::infinity();
  /// Of the space, for many queries on it; none: tangents are found as they are wanted.
  std::shared_ptr<const TangentVisibilityGraph> tangents{};

  /// The tangents of a space. Errors: those of `TangentVisibilityGraph::prepare`.
  template <FeatureSpace S>
  static Expected<std::shared_ptr<const TangentVisibilityGraph>, Failure> prepare(
      const S& space, const Budget& budget = {}) {
    auto map = TangentVisibilityGraph::prepare(space, budget);
    if (!map) return std::move(map).unexpected();
    return std::make_shared<const TangentVisibilityGraph>(std::move(*map));
  }

  /// Errors: `invalid_option` for a bound that is not a number, for tangents that are not prepared
  /// and at safety radius 0, where obstacles may not be touched (tangents of another space are not
  /// noticed: see `TangentVisibilityGraph::matches`); what is wrong with start or goal;
  /// `unreachable`, also when there is no path within the bound; `not_proved` where start or goal
  /// lies within rounding of the safety radius and no path can be proved for that; what the budget
  /// says.
  template <FeatureSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const;
};

namespace detail {

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
    // A path that leaves or meets a safety zone at its rim, which only exact arcs could follow.
    for (const Point& end : {query_.start, query_.goal}) {
      if (space_.clearance(end) < space_.safety_radius() + 8 * space_.distance_error_bound()) {
        return fail(PlanError::not_proved,
                    "start or goal touches a safety zone, and no path from there can be proved");
      }
    }
    return fail(PlanError::unreachable, "no path among the obstacles");
  }

  /// The path that the last arrival ends.
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
      for_each_arc(circle, at, arrival.way.from, arrival.turn, space_.distance_error_bound(),
                   [&](const Arc& arc) {
                     curve.push_back(arc);
                     at = arc.b;
                   });
      curve.push_back(Segment{at, arrival.way.to});
      at = arrival.way.to;
    }
    return curve;
  }

 private:
  static constexpr TangentVisibilityGraph::Node none = TangentVisibilityGraph::none;

  /// The goal is a node more; the start has none.
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

  /// A way on from an arrival, the turn before it and the cost at its end.
  struct Step {
    TangentLine way;
    double turn, cost;
  };
  std::optional<Step> step(const TangentScratch::Arrival& from, std::uint32_t node) const {
    const OrientedCircle circle = circle_of(from.node);
    const auto way = tangent_line(circle, circle_of(node));
    if (!way || !touches(from.node, way->direction) || !touches(node, way->direction)) {
      return std::nullopt;
    }
    const double turn =
        circle.radius > 0 ? turn_between(circle, from.way.direction, way->direction) : 0;
    return Step{*way, turn, from.cost + circle.radius * turn + way->length};
  }

  void expand(std::uint32_t index) {
    const TangentScratch::Arrival from = scratch_.arrivals[index];
    context_.count_expanded(from.way.to);
    if (from.node != none && map_.is_prepared()) {
      for (const TangentVisibilityGraph::Node node : map_.ways(from.node))
        generate(index, from, node, true);
    } else {
      map_.for_each_candidate(
          circle_of(from.node), from.node,
          [&](TangentVisibilityGraph::Node node) { generate(index, from, node, false); });
    }
    generate(index, from, goal_node(), false);
  }

  /// Puts a way on from an arrival into the open list.
  void generate(std::uint32_t index, const TangentScratch::Arrival& from,
                TangentVisibilityGraph::Node node, bool is_proved) {
    const auto next = step(from, node);
    if (!next) return;
    const double key = next->cost + distance(next->way.to, query_.goal);
    if (key > bound_) return;
    scratch_.open.push({key, sequence_++, index, node, is_proved});
    context_.count_generated(next->way.to);
  }

  /// Whether an arrival at the same circle gets there by its arc at no more cost.
  bool is_dominated(std::uint32_t node, const Step& step) const {
    const OrientedCircle circle = circle_of(node);
    for (std::uint32_t i = scratch_.first[node]; i != none; i = scratch_.arrivals[i].next) {
      const TangentScratch::Arrival& other = scratch_.arrivals[i];
      const double turn = turn_between(circle, other.way.direction, step.way.direction);
      if (other.cost + circle.radius * turn > step.cost * (1 + 1e-12)) continue;
      if (is_arc_free(circle, other.way.to, step.way.to, turn)) return true;
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

  /// Takes a way, if it is proved and worth it.
  bool arrive(const TangentScratch::Entry& entry) {
    const TangentScratch::Arrival from = scratch_.arrivals[entry.parent];
    const Step next = *step(from, entry.node);
    if (is_dominated(entry.node, next)) return false;
    if (!entry.is_proved && !space_.segment_free(next.way.from, next.way.to)) {
      return false;
    }
    const OrientedCircle circle = circle_of(from.node);
    if (!is_arc_free(circle, from.way.to, next.way.from, next.turn)) return false;
    const auto index = static_cast<std::uint32_t>(scratch_.arrivals.size());
    scratch_.arrivals.push_back({next.way, next.cost, entry.node, entry.parent,
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
  std::uint32_t sequence_ = 0;
};

}  // namespace detail

template <FeatureSpace S, Observer O>
Expected<Route, Failure> TangentGraph::search(const S& space, const Query& query, Scratch& scratch,
                                              O& observer) const {
  if (std::isnan(bound)) return fail(PlanError::invalid_option, "bound is not a number");
  if (!(space.safety_radius() > 0)) {
    return fail(PlanError::invalid_option, "tangent_graph needs a positive safety radius");
  }
  if (auto valid = check_query(space, query); !valid) return std::move(valid).unexpected();
  Route route;
  if (query.start == query.goal) {
    route.curve.push_back(Segment{query.start, query.goal});
    return route;
  }
  if (tangents != nullptr && !tangents->is_prepared()) {
    return fail(PlanError::invalid_option, "tangents must be prepared");
  }
  const std::optional<TangentVisibilityGraph> own =
      tangents == nullptr ? std::optional<TangentVisibilityGraph>(TangentVisibilityGraph(space))
                          : std::nullopt;
  const TangentVisibilityGraph& map = own ? *own : *tangents;
  detail::SearchContext<S, O> context{space, query, observer};
  detail::TangentSearch search(context, map, bound, scratch);
  if (auto found = search.run(); !found) {
    found.error().stats = context.statistics;
    return std::move(found).unexpected();
  }
  route.stats = context.statistics;
  route.curve = search.curve();
  route.cost = route.curve.length();
  return route;
}

}  // namespace tutavia
