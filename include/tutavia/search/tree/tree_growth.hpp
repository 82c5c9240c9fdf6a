// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/core/random.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/plan/statistics.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/tree/search_tree.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// What the searches that grow trees by sampling have in common.

namespace tutavia::detail {

/// Memory of a search that grows one tree, and the tree that it grew last.
struct TreeScratch {
  SearchTree tree;

  void clear() { tree.clear(); }
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    tree.for_each_edge(visit);
  }
};

/// The step of a tree that was given none: a 25th of the bounds' longer side. Any will do in bounds
/// of one point.
inline double default_step(const Box& bounds) {
  const double side = std::max(bounds.width(), bounds.height());
  return side > 0 ? side / 25 : 1;
}

/// The options of a search that grows trees; what they are, see Rrt. It may have a `goal_bias`.
template <class T>
concept TreeOptions = requires(const T& options) {
  { options.step } -> std::same_as<const std::optional<double>&>;
  { options.iterations } -> std::same_as<const std::uint32_t&>;
};

/// Checks the options that all trees have, and the query.
template <TreeOptions Options, FreeSpace S>
Expected<void, Failure> check_growth(const Options& options, const S& space, const Query& query) {
  const Box& bounds = space.bounds();
  const double most = distance(bounds.min, bounds.max);
  if (options.step && !(*options.step > 0 && *options.step <= most)) {
    return fail(PlanError::invalid_option, "step must be positive and at most " +
                                               std::to_string(most) +
                                               " m, the diagonal of the bounds");
  }
  if constexpr (requires { options.goal_bias; }) {
    if (!(options.goal_bias >= 0 && options.goal_bias <= 1)) {
      return fail(PlanError::invalid_option, "goal_bias must lie in [0, 1]");
    }
  }
  if (options.iterations == 0) {
    return fail(PlanError::invalid_option, "iterations must be positive");
  }
  return check_query(space, query);
}

/// The path that needs no search: straight from start to goal.
template <FreeSpace S>
std::optional<Route> straight_route(const S& space, const Query& query) {
  if (query.start != query.goal && !space.segment_free(query.start, query.goal)) {
    return std::nullopt;
  }
  Route route;
  route.curve.push_back(Segment{query.start, query.goal});
  route.cost = route.curve.length();
  return route;
}

/// The point on the way to a target that is at most a step away: the target itself where it is.
inline Point steer(const Point& from, const Point& target, double step) {
  const double gap = distance(from, target);
  return gap <= step ? target : lerp(from, target, step / gap);
}

/// One search that grows trees: where it samples, how it steps and when it has to end.
template <FreeSpace S, Observer O>
class TreeGrowth {
 public:
  TreeGrowth(const S& space, const Query& query, const std::optional<double>& step, O& observer,
             const Statistics& before = {})
      : context_{space, query, observer, before},
        bounds_(space.bounds()),
        step_(step ? *step : default_step(bounds_)),
        random_(query.seed) {}

  const S& space() const { return context_.space; }
  const Query& query() const { return context_.query; }
  const Box& bounds() const { return bounds_; }
  double step() const { return step_; }
  Random& random() { return random_; }
  const Statistics& stats() const { return context_.statistics; }

  /// Begins the next iteration and counts it. Errors: what the budget says.
  Expected<void, Failure> next_iteration() {
    if (auto within = context_.check_budget(); !within) return within;
    ++context_.statistics.expanded;
    return {};
  }

  /// Uniform over the bounds; blocked points, too: they are only directions to grow in.
  Point sample() {
    const double x = random_.uniform(bounds_.min.x(), bounds_.max.x());
    const double y = random_.uniform(bounds_.min.y(), bounds_.max.y());
    return {x, y};
  }
  Point sample(double goal_bias) { return random_.uniform() < goal_bias ? query().goal : sample(); }

  /// A step from a node towards a target, if that leads to another point and is free.
  std::optional<Point> step_towards(const SearchTree& tree, SearchTree::Node from,
                                    const Point& target) {
    const Point start = tree.position(from), end = steer(start, target, step_);
    if (end == start || !space().segment_free(start, end)) return std::nullopt;
    return end;
  }

  SearchTree::Node add(SearchTree& tree, SearchTree::Node parent, const Point& p, double cost) {
    context_.observer.expanded(tree.position(parent));
    context_.count_generated(p);
    return tree.add(parent, p, cost);
  }

  /// Why there is no path, from what ended the search; how near the tree came is told.
  Failure failure(Failure failure, const SearchTree& tree) const {
    const Point nearest = tree.position(tree.points().nearest(query().goal));
    failure.detail = "no path after " + std::to_string(stats().expanded) +
                     " iterations; the tree comes within " +
                     std::to_string(distance(nearest, query().goal)) + " m of the goal";
    failure.stats = stats();
    return failure;
  }

  void tell_improved(const std::vector<Point>& way, double cost) {
    if constexpr (AnytimeObserver<O>) context_.observer.improved(Curve::polyline(way), cost);
  }

 private:
  SearchContext<S, O> context_;
  Box bounds_;
  double step_;
  Random random_;
};

}  // namespace tutavia::detail
