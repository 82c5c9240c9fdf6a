// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/tangent/step_off_zone.hpp"
#include "tutavia/search/tangent/tangent_search.hpp"
#include "tutavia/search/tangent_visibility_graph.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// TangentGraph: the shortest path of a disc or a point among polygons and discs.

namespace tutavia {

/// The shortest path of a disc or a point among polygons and discs, or among the blocked cells of a
/// grid. Exact, except that its circles exceed the safety radius by a few rounding errors.
///
/// Such a path consists of straight edges tangent to circles, and of arcs of these circles. The
/// circles have the safety radius and lie around obstacle vertices; those around discs are larger.
/// The search is A* over the edges. Edges are generated when an edge before them is expanded, and
/// proved when they are popped. Polygons may have holes, touch, overlap, contain one another or
/// have no area. A gap of twice the radius, up to the same rounding errors, counts as closed. The
/// route is smooth and lies in free space. If start or goal lies within rounding of the safety
/// radius, the route may begin or end with a segment of a few rounding errors. O(m n) edges are
/// generated for n vertices and m expansions; with prepared tangents, only the proved edges.
///
/// At safety radius 0 it is the visibility graph of the vertices (Lozano-Perez and Wesley 1979, "An
/// algorithm for planning collision-free paths among polyhedral obstacles"). The route is a
/// polyline that may touch obstacles and pass between two that touch, wherever `segment_free`
/// allows it. It goes around discs, and around the ends of walls, which may not be touched, at a
/// few rounding errors.
///
/// Source: Pocchiola and Vegter 1996, "The visibility complex" (the graph of tangents); Hart,
/// Nilsson and Raphael 1968 (A*).
///
/// Example: examples/searches_among_polygons.cpp.
struct TangentGraph {
  static constexpr std::string_view name = "tangent_graph";
  using Scratch = detail::TangentScratch;
  using Prepared = TangentVisibilityGraph;

  /// Upper bound on the path length [m]; longer paths are not searched.
  double bound = std::numeric_limits<double>::infinity();
  /// The tangents of the space, for many queries on it; null: computed during the search.
  std::shared_ptr<const TangentVisibilityGraph> tangents{};

  /// The tangents of a space. Errors: those of `TangentVisibilityGraph::prepare`.
  template <FeatureSpace S>
  static Expected<std::shared_ptr<const TangentVisibilityGraph>, Failure> prepare(
      const S& space, const Budget& budget = {}) {
    auto map = TangentVisibilityGraph::prepare(space, budget);
    if (!map) return std::move(map).unexpected();
    return std::make_shared<const TangentVisibilityGraph>(std::move(*map));
  }

  /// Errors: `invalid_option` for a bound that is NaN and for tangents that are not prepared; those
  /// of `check_query`; `unreachable`, also if no path is within the bound; `not_proved` if start or
  /// goal lies within rounding of the safety radius and no path can be proved for that reason;
  /// those of the budget. Tangents of another space are not detected;
  /// `TangentVisibilityGraph::matches` checks for it.
  template <FeatureSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const;

 private:
  /// The search between valid ends.
  template <FeatureSpace S, Observer O>
  Expected<Route, Failure> search_tangents(const S& space, const Query& query,
                                           const TangentVisibilityGraph& map, Scratch& scratch,
                                           O& observer) const;
  /// The same where an end touches a safety zone: from points a few rounding errors beside the
  /// ends.
  template <FeatureSpace S, Observer O>
  Expected<Route, Failure> search_beside(const S& space, const Query& query,
                                         const TangentVisibilityGraph& map, Scratch& scratch,
                                         O& observer, Failure failure) const;
};

template <FeatureSpace S, Observer O>
Expected<Route, Failure> TangentGraph::search(const S& space, const Query& query, Scratch& scratch,
                                              O& observer) const {
  if (std::isnan(bound)) return fail(PlanError::invalid_option, "bound is not a number");
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
  auto found = search_tangents(space, query, map, scratch, observer);
  if (found || found.error().code != PlanError::not_proved) return found;
  return search_beside(space, query, map, scratch, observer, std::move(found.error()));
}

template <FeatureSpace S, Observer O>
Expected<Route, Failure> TangentGraph::search_tangents(const S& space, const Query& query,
                                                       const TangentVisibilityGraph& map,
                                                       Scratch& scratch, O& observer) const {
  detail::SearchContext<S, O> context{space, query, observer};
  detail::TangentSearch search(context, map, bound, scratch);
  if (auto found = search.run(); !found) {
    found.error().stats = context.statistics;
    return std::move(found).unexpected();
  }
  Route route{.curve = search.curve(), .stats = context.statistics};
  route.cost = route.curve.length();
  return route;
}

template <FeatureSpace S, Observer O>
Expected<Route, Failure> TangentGraph::search_beside(const S& space, const Query& query,
                                                     const TangentVisibilityGraph& map,
                                                     Scratch& scratch, O& observer,
                                                     Failure failure) const {
  const auto step_off = [&](const Point& end) {
    return detail::touches_zone(space, map, end) ? detail::step_off_zone(space, end)
                                                 : std::optional<Point>(end);
  };
  const auto start = step_off(query.start), goal = step_off(query.goal);
  if (!start || !goal) return Unexpected{std::move(failure)};
  Query beside = query;
  beside.start = *start;
  beside.goal = *goal;
  beside.budget.max_expansions -= std::min(failure.stats.expanded, beside.budget.max_expansions);
  auto found = search_tangents(space, beside, map, scratch, observer);
  Statistics& stats = found ? found->stats : found.error().stats;
  stats.expanded += failure.stats.expanded;
  stats.generated += failure.stats.generated;
  if (!found) return found;
  Curve curve;
  if (*start != query.start) curve.push_back(Segment{query.start, *start});
  for (const Piece& piece : found->curve.pieces()) curve.push_back(piece);
  if (*goal != query.goal) curve.push_back(Segment{*goal, query.goal});
  found->curve = std::move(curve);
  found->cost = found->curve.length();
  return found;
}

}  // namespace tutavia
