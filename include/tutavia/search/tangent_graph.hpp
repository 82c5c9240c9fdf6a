// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/geometry/bitangent.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/query.hpp"
#include "tutavia/search/route.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// TangentGraph: the shortest path of a disc among polygons and discs.

namespace tutavia {

namespace detail {

/// An obstacle vertex or a disc, and what keeps a path from touching its circle everywhere: the
/// edges that begin at the vertex.
struct TangentCircle {
  Point center;
  double radius;
  std::uint32_t first_edge, last_edge;  // directions of edges, in a list of all
};

/// The circles of a space, none twice.
class TangentCircles {
 public:
  template <FeatureSpace S>
  explicit TangentCircles(const S& space) {
    struct End {
      Point vertex, direction;
      double radius;
    };
    std::vector<End> ends;
    const double margin = 4 * space.slack();
    space.for_each_feature(space.bounds().inflated(2 * space.safety_radius()),
                           [&](const Segment& core, double radius) {
                             const double grown = radius + space.safety_radius() + margin;
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
    std::stable_sort(ends.begin(), ends.end(), before);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const bool is_new = i == 0 || before(ends[i - 1], ends[i]);
      const auto edge = static_cast<std::uint32_t>(edges_.size());
      if (is_new) circles_.push_back({ends[i].vertex, ends[i].radius, edge, edge});
      if (is_null(ends[i].direction)) continue;
      edges_.push_back(ends[i].direction);
      circles_.back().last_edge = edge + 1;
    }
  }

  const std::vector<TangentCircle>& all() const { return circles_; }

  /// A quick look that refuses most ways that `touches` would refuse, none else: for a way between
  /// circles whose centres lie `between` apart and their radii add up to `radii`.
  bool may_touch(const TangentCircle& circle, int side, const Point& between, double radii) const {
    // A way turns from the line of the centres by an angle of which the sine is radii / distance at
    // most.
    for (std::uint32_t e = circle.first_edge; e < circle.last_edge; ++e) {
      if (side * cross(edges_[e], between) > 1.25 * radii) return false;
    }
    return true;
  }

  /// Whether a circle's point in the direction `normal` is none that an edge of its vertex comes
  /// nearer to.
  bool touches(const TangentCircle& circle, const Point& normal) const {
    for (std::uint32_t e = circle.first_edge; e < circle.last_edge; ++e) {
      if (normal.dot(edges_[e]) > 1e-9) return false;
    }
    return true;
  }

 private:
  std::vector<TangentCircle> circles_;
  std::vector<Point> edges_;
};

}  // namespace detail

/// What a tangent search keeps between queries: memory.
class TangentScratch {
 public:
  struct Entry {
    double key;
    std::uint32_t sequence, parent, node;
    friend bool operator<(const Entry& a, const Entry& b) {  // for std::push_heap: worse < better
      return a.key != b.key ? a.key > b.key : a.sequence > b.sequence;
    }
  };
  /// A way that was taken, to where it touches a circle (or to the goal).
  struct Arrival {
    Bitangent way;
    double cost;  // up to there
    std::uint32_t node, parent, next;
    double turn;  // around the circle before
  };

  std::vector<Entry> open;
  std::vector<Arrival> arrivals;
  std::vector<std::uint32_t> first;  // arrival of each node
};

/// The shortest path of a disc among polygons and discs: exact, but for a few rounding errors that
/// its circles are larger than the safety radius.
///
/// Such a path is made of straight ways that touch circles of the safety radius around obstacle
/// vertices (around discs: larger ones) and of arcs of these circles. A* over these ways, from one
/// to the next: they are made when a way before them is expanded, and proved when their turn comes.
/// Polygons may have holes, touch, overlap, lie in one another or have no area. The route is
/// smooth and lies in free space. For n vertices of which m ways are expanded, O(m n) of them are
/// looked at.
///
/// Source: Pocchiola and Vegter 1996, "The visibility complex" (the graph of tangents); Hart,
/// Nilsson and Raphael 1968 (A*).
struct TangentGraph {
  static constexpr std::string_view name = "tangent_graph";
  using Scratch = TangentScratch;

  /// Paths longer than this are not looked for [m].
  double bound = std::numeric_limits<double>::infinity();

  /// Errors: `invalid_option` for a bound that is not a number and at safety radius 0, where
  /// obstacles may not be touched; what is wrong with start or goal; `unreachable`, also when there
  /// is no path within the bound; what the budget says.
  template <FeatureSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const;
};

namespace detail {

template <class S, class O>
class TangentSearch {
 public:
  TangentSearch(const S& space, const Query& query, double bound, TangentScratch& scratch,
                O& observer, Statistics& stats)
      : space_(space),
        query_(query),
        bound_(bound),
        scratch_(scratch),
        observer_(observer),
        stats_(stats),
        circles_(space) {}

  std::optional<Failure> run() {
    scratch_.open.clear();
    scratch_.arrivals.clear();
    scratch_.first.assign(2 * circles_.all().size() + 1, none);
    scratch_.arrivals.push_back(
        {{query_.start, query_.start, Point::Zero(), 0}, 0, none, none, none, 0});
    if (auto failure = exceeded(query_.budget, 0)) return failure;
    expand(0);
    while (!scratch_.open.empty()) {
      if (is_checked(query_.budget, stats_.expanded, 16)) {
        if (auto failure = exceeded(query_.budget, stats_.expanded)) return failure;
      }
      std::pop_heap(scratch_.open.begin(), scratch_.open.end());
      const TangentScratch::Entry entry = scratch_.open.back();
      scratch_.open.pop_back();
      if (!arrive(entry)) continue;
      if (entry.node == goal_node()) return std::nullopt;
      expand(static_cast<std::uint32_t>(scratch_.arrivals.size() - 1));
    }
    return Failure{.code = PlanError::unreachable, .detail = "no path among the obstacles"};
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
      const SidedCircle circle = circle_of(scratch_.arrivals[arrival.parent].node);
      for_each_arc(circle, at, arrival.way.from, arrival.turn, space_.slack(), [&](const Arc& arc) {
        curve.push_back(arc);
        at = arc.b;
      });
      curve.push_back(Segment{at, arrival.way.to});
      at = arrival.way.to;
    }
    return curve;
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t goal_node() const { return static_cast<std::uint32_t>(2 * circles_.all().size()); }
  /// Nodes: every circle passed on its left (even) and on its right, and the goal.
  SidedCircle circle_of(std::uint32_t node) const {
    if (node == none) return {query_.start, 0, 1};
    if (node == goal_node()) return {query_.goal, 0, 1};
    const TangentCircle& circle = circles_.all()[node / 2];
    return {circle.center, circle.radius, node % 2 == 0 ? 1 : -1};
  }
  /// Whether a path may touch a node's circle while it runs in this direction.
  bool touches(std::uint32_t node, const Point& direction) const {
    if (node == none || node == goal_node()) return true;
    const double side = node % 2 == 0 ? -1 : 1;
    return circles_.touches(circles_.all()[node / 2],
                            {-side * direction.y(), side * direction.x()});
  }
  /// The turn around a circle from one direction to another, in [0, 2 pi).
  static double turn_between(const SidedCircle& circle, const Point& from, const Point& to) {
    const double turn = circle.side * deflection(from, to);
    return turn >= 0 ? turn : turn > -1e-9 ? 0 : turn + 2 * std::numbers::pi;
  }

  /// A way on from an arrival, the turn before it and the cost at its end.
  struct Step {
    Bitangent way;
    double turn, cost;
  };
  std::optional<Step> step(const TangentScratch::Arrival& from, std::uint32_t node) const {
    const SidedCircle circle = circle_of(from.node);
    const auto way = bitangent(circle, circle_of(node));
    if (!way || !touches(from.node, way->direction) || !touches(node, way->direction)) {
      return std::nullopt;
    }
    const double turn =
        circle.radius > 0 ? turn_between(circle, from.way.direction, way->direction) : 0;
    return Step{*way, turn, from.cost + circle.radius * turn + way->length};
  }

  void expand(std::uint32_t index) {
    const TangentScratch::Arrival from = scratch_.arrivals[index];
    ++stats_.expanded;
    observer_.expanded(from.way.to);
    const SidedCircle at = circle_of(from.node);
    const auto& all = circles_.all();
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      const Point between{all[i].center.x() - at.center.x(), all[i].center.y() - at.center.y()};
      const double radii = all[i].radius + at.radius;
      const bool is_near = between.squaredNorm() < 16 * radii * radii;
      if (!is_near && from.node != none &&
          !circles_.may_touch(all[from.node / 2], at.side, between, radii)) {
        continue;
      }
      for (const int side : {1, -1}) {
        if (is_near || circles_.may_touch(all[i], side, between, radii)) {
          generate(index, from, 2 * i + (side > 0 ? 0 : 1));
        }
      }
    }
    generate(index, from, goal_node());
  }

  /// Puts a way on from an arrival into the open list.
  void generate(std::uint32_t index, const TangentScratch::Arrival& from, std::uint32_t node) {
    if (node == from.node) return;
    const auto next = step(from, node);
    if (!next) return;
    const double key = next->cost + distance(next->way.to, query_.goal);
    if (key > bound_) return;
    scratch_.open.push_back({key, sequence_++, index, node});
    std::push_heap(scratch_.open.begin(), scratch_.open.end());
    ++stats_.generated;
    observer_.generated(next->way.to);
  }

  /// Whether an arrival at the same circle gets there by its arc at no more cost.
  bool is_dominated(std::uint32_t node, const Step& step) const {
    const SidedCircle circle = circle_of(node);
    for (std::uint32_t i = scratch_.first[node]; i != none; i = scratch_.arrivals[i].next) {
      const TangentScratch::Arrival& other = scratch_.arrivals[i];
      const double turn = turn_between(circle, other.way.direction, step.way.direction);
      if (other.cost + circle.radius * turn > step.cost * (1 + 1e-12)) continue;
      if (is_arc_free(circle, other.way.to, step.way.to, turn)) return true;
    }
    return false;
  }

  bool is_arc_free(const SidedCircle& circle, const Point& in, const Point& out,
                   double turn) const {
    bool free = true;
    for_each_arc(circle, in, out, circle.side * turn, space_.slack(),
                 [&](const Arc& arc) { free = free && is_proved_free(space_, arc); });
    return free;
  }

  /// Takes a way, if it is proved and worth it.
  bool arrive(const TangentScratch::Entry& entry) {
    const TangentScratch::Arrival from = scratch_.arrivals[entry.parent];
    const Step next = *step(from, entry.node);
    if (is_dominated(entry.node, next)) return false;
    if (!is_proved_free(space_, Segment{next.way.from, next.way.to})) return false;
    const SidedCircle circle = circle_of(from.node);
    if (!is_arc_free(circle, from.way.to, next.way.from, next.turn)) return false;
    const auto index = static_cast<std::uint32_t>(scratch_.arrivals.size());
    scratch_.arrivals.push_back({next.way, next.cost, entry.node, entry.parent,
                                 scratch_.first[entry.node], circle.side * next.turn});
    scratch_.first[entry.node] = index;
    return true;
  }

  const S& space_;
  const Query& query_;
  double bound_;
  TangentScratch& scratch_;
  O& observer_;
  Statistics& stats_;
  TangentCircles circles_;
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
  if (auto failure = check_query(space, query)) return Unexpected{std::move(*failure)};
  Route route;
  if (query.start == query.goal) {
    route.curve.push_back(Segment{query.start, query.goal});
    return route;
  }
  detail::TangentSearch<S, O> search(space, query, bound, scratch, observer, route.stats);
  if (auto failure = search.run()) {
    failure->stats = route.stats;
    return Unexpected{std::move(*failure)};
  }
  route.curve = search.curve();
  route.cost = route.curve.length();
  return route;
}

}  // namespace tutavia
