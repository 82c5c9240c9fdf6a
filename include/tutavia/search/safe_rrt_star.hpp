// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/core/parts/remove_redundant.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/neighbours.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/risk_zone.hpp"
#include "tutavia/search/tree/rewired_tree.hpp"
#include "tutavia/search/tree/tree_growth.hpp"

/// \file
/// SafeRrtStar: RRT* that prefers to stay away from obstacles.

namespace tutavia {

/// RRT* with risk zones around the obstacles. Paths avoid the zones, or spend little length in
/// them.
///
/// The first tree grows outside the zones. If it finds no path, or start or goal lies in a zone, a
/// second tree grows in all of free space; its path cost is length plus weighted risk (`RiskZone`).
/// Redundant nodes are then removed, which makes the path neither longer nor costlier. The method's
/// last stage is a smoother: `Planner{SafeRrtStar{}, BSplineSmoother{}}`. The planner treats the
/// zones as obstacles where the route stays outside of them; the route names them (`risk_width`).
///
/// The cost of the route is its length plus the weighted risk. All else is as for `RrtStar`; an
/// observer receives improved paths before nodes are removed.
///
/// Source: the improved RRT* of MM Science Journal, October 2023 (RRTS); docs/algorithms.md decides
/// the details that it leaves open.
///
/// Example: examples/searches_among_polygons.cpp.
struct SafeRrtStar {
  static constexpr std::string_view name = "safe_rrt_star";
  using Scratch = detail::RewiredTreeScratch;

  /// Longest step [m], at most the diagonal of the bounds. Default: 1/25 of the bounds' longer
  /// side.
  std::optional<double> step{};
  double goal_bias = 0.05;  ///< share of iterations that grow towards the goal until it is reached
  std::uint32_t max_iterations = 3000;  ///< of each tree
  Neighbours neighbours = Neighbours::k_nearest;
  double rewire_factor = 1.1;  ///< asymptotic optimality needs more than 1
  /// Width of the risk zones [m]. Default: that of `step`.
  std::optional<double> risk_width{};
  double risk_weight = 1;
  bool keep_out = true;  ///< whether to try a tree outside the zones first
  bool prune = true;     ///< whether to remove redundant nodes

  /// The risk zone for a space.
  template <FreeSpace S>
  RiskZone zone(const S& space) const {
    return {.width = risk_width ? *risk_width : detail::default_step(space.bounds()),
            .weight = risk_weight};
  }

  template <ClearanceSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const;
};

namespace detail {

/// The part of a space outside its risk zones.
template <ClearanceSpace S>
class OutsideRiskZone {
 public:
  OutsideRiskZone(const S& space, const RiskZone& zone) : space_(space), zone_(zone) {}

  const Box& bounds() const { return space_.bounds(); }
  bool is_free(const Point& p) const { return segment_free(p, p); }
  bool segment_free(const Point& p, const Point& q) const {
    return space_.segment_free(p, q) && zone_.is_outside(space_, p, q);
  }

 private:
  const S& space_;
  const RiskZone& zone_;
};

/// Removes nodes of a path if the straight edge that replaces them is free and costs no more.
/// Returns the path and its cost.
template <FreeSpace S, EdgeCost CostOf>
Route pruned(const S& space, const std::vector<Point>& path, const CostOf& edge_cost, bool prune) {
  struct Node {
    Point position;
    double cost;  // of the path from the start
  };
  const auto cost = [&](const Point& p, const Point& q) { return edge_cost(p, q, distance(p, q)); };
  std::vector<Node> nodes;
  nodes.reserve(path.size());
  for (const Point& p : path) {
    nodes.push_back({p, nodes.empty() ? 0 : nodes.back().cost + cost(nodes.back().position, p)});
  }
  if (prune) {
    remove_redundant(nodes, [&](const Node& a, const Node& b) {
      return space.segment_free(a.position, b.position) &&
             cost(a.position, b.position) <= b.cost - a.cost;
    });
  }
  Route route;
  std::vector<Point> kept;
  for (const Node& node : nodes) {
    if (!kept.empty()) route.cost += cost(kept.back(), node.position);
    kept.push_back(node.position);
  }
  route.curve = Curve::polyline(kept);
  return route;
}

}  // namespace detail

template <ClearanceSpace S, Observer O>
Expected<Route, Failure> SafeRrtStar::search(const S& space, const Query& query, Scratch& scratch,
                                             O& observer) const {
  if (auto valid = detail::check_optimal_growth(*this, space, query); !valid) {
    return std::move(valid).unexpected();
  }
  const RiskZone risk_zone = zone(space);
  if (auto valid = risk_zone.check(); !valid) return std::move(valid).unexpected();
  const detail::OutsideRiskZone outside(space, risk_zone);
  scratch.tree.reset(space.bounds(), query.start);
  const auto with_zone = [&](Expected<Route, Failure> route) {
    if (route) {
      route->risk_width = risk_zone.width;
      route->risk_weight = risk_zone.weight;
    }
    return route;
  };
  if (auto straight = detail::straight_route(outside, query))
    return with_zone(std::move(*straight));

  const auto grow = [&](const auto& where, const auto& edge_cost,
                        const Statistics& before) -> Expected<Route, Failure> {
    detail::TreeGrowth growth(where, query, step, observer, before);
    detail::RewiredTree tree(growth, {neighbours, rewire_factor}, edge_cost, scratch);
    auto found = detail::grow(tree, growth, *this, [&](double) { return growth.sample(); });
    if (!found) return found;
    Route route = detail::pruned(where, waypoints(found->curve), edge_cost, prune);
    route.stats = found->stats;
    return route;
  };
  Statistics spent;
  if (keep_out && outside.is_free(query.start) && outside.is_free(query.goal)) {
    auto route = grow(outside, detail::LengthCost{}, spent);
    if (route || !detail::check_budget(query.budget, route.error().stats.expanded)) {
      return with_zone(std::move(route));
    }
    spent = route.error().stats;
  }
  const auto cost = [&](const Point& p, const Point& q, double) {
    return risk_zone.cost(space, p, q);
  };
  return with_zone(grow(space, cost, spent));
}

}  // namespace tutavia
