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
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/risk_zone.hpp"
#include "tutavia/search/tree/rewired_tree.hpp"
#include "tutavia/search/tree/tree_growth.hpp"

/// \file
/// SafeRrtStar: RRT* that keeps away from obstacles where it can.

namespace tutavia {

/// The improved RRT* with risk zones: grey zones around the obstacles that a path keeps out of, or
/// is short in.
///
/// First a tree of RRT* grows outside the zones; where it finds no path, or start or goal lies in a
/// zone, another one grows in all of free space, for paths that cost their length plus the weighted
/// risk along them (`RiskZone`). Then nodes that the path can do without are dropped, which makes
/// it neither longer nor costlier. The method's last stage is a smoother:
/// `Planner{SafeRrtStar{}, BSplineSmoother{.prune = false}}`, whose curve may enter the grey zone.
///
/// The cost of the route is its length plus the weighted risk. All else is as with `RrtStar`; an
/// observer is told of better paths before nodes are dropped. Source: the improved RRT* of MM
/// Science Journal, October 2023 (RRTS); what it leaves open is decided in docs/algorithms.md.
struct SafeRrtStar {
  static constexpr std::string_view name = "safe_rrt_star";
  using Scratch = detail::RewiredTreeScratch;

  /// Longest step [m], at most the diagonal of the bounds; none: a 25th of their longer side.
  std::optional<double> step{};
  double goal_bias = 0.05;  ///< share of iterations that grow towards the goal until it is reached
  std::uint32_t iterations = 3000;  ///< of either tree
  detail::Neighbours neighbours = detail::Neighbours::k_nearest;
  double rewire_factor = 1.1;  ///< theory wants more than 1
  /// Width of the risk zones [m]; none: as `step` without a value.
  std::optional<double> risk_width{};
  double risk_weight = 1;
  bool keep_out = true;  ///< of the zones, where there is a path outside of them
  bool prune = true;     ///< drop the nodes that the path can do without

  /// The zones as they are in a space.
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

/// What of a space lies outside its risk zones.
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

/// Drops nodes of a path between which the straight way is free and costs no more, and gives the
/// path and its cost.
template <FreeSpace S, EdgeCost Price>
Route pruned(const S& space, const std::vector<Point>& path, const Price& edge_cost, bool prune) {
  struct Node {
    Point place;
    double cost;  // of the way there
  };
  const auto cost = [&](const Point& p, const Point& q) { return edge_cost(p, q, distance(p, q)); };
  std::vector<Node> nodes;
  nodes.reserve(path.size());
  for (const Point& p : path) {
    nodes.push_back({p, nodes.empty() ? 0 : nodes.back().cost + cost(nodes.back().place, p)});
  }
  if (prune) {
    remove_redundant(nodes, [&](const Node& a, const Node& b) {
      return space.segment_free(a.place, b.place) && cost(a.place, b.place) <= b.cost - a.cost;
    });
  }
  Route route;
  std::vector<Point> kept;
  for (const Node& node : nodes) {
    if (!kept.empty()) route.cost += cost(kept.back(), node.place);
    kept.push_back(node.place);
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
  if (auto straight = detail::straight_route(outside, query)) return std::move(*straight);

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
    if (route || !detail::check_budget(query.budget, route.error().stats.expanded)) return route;
    spent = route.error().stats;
  }
  const auto cost = [&](const Point& p, const Point& q, double) {
    return risk_zone.cost(space, p, q);
  };
  return grow(space, cost, spent);
}

}  // namespace tutavia
