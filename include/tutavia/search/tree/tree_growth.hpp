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
/// TreeGrowth: sampling, steering and the budget of random-tree searches.

namespace tutavia::detail {

/// Memory of a search with one tree. Holds the tree of the last query.
struct TreeScratch {
  SearchTree tree;

  void clear() { tree.clear(); }
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    tree.for_each_edge(visit);
  }
};

/// The default step: 1/25 of the bounds' longer side (arbitrary for degenerate bounds).
inline double default_step(const Box& bounds) {
  const double side = std::max(bounds.width(), bounds.height());
  return side > 0 ? side / 25 : 1;
}

/// The options of a random-tree search; see Rrt. `goal_bias` is optional.
template <class T>
concept TreeOptions = requires(const T& options) {
  { options.step } -> std::same_as<const std::optional<double>&>;
  { options.max_iterations } -> std::same_as<const std::uint32_t&>;
};

/// Checks the options that all random trees share, then the query.
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
  if (options.max_iterations == 0) {
    return fail(PlanError::invalid_option, "max_iterations must be positive");
  }
  return check_query(space, query);
}

/// The straight segment from start to goal, if it is free.
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

/// The point at most one step from `from` towards a target; the target itself if it is that near.
inline Point steer(const Point& from, const Point& target, double step) {
  const double gap = distance(from, target);
  return gap <= step ? target : lerp(from, target, step / gap);
}

/// One random-tree search: how it samples and steers, and when it ends.
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

  /// Counts an iteration. Errors: those of the budget.
  Expected<void, Failure> next_iteration() {
    if (auto within = context_.check_budget(); !within) return within;
    ++context_.statistics.expanded;
    return {};
  }

  /// Uniform over the bounds. The point may be blocked; it only gives a direction.
  Point sample() {
    const double x = random_.uniform(bounds_.min.x(), bounds_.max.x());
    const double y = random_.uniform(bounds_.min.y(), bounds_.max.y());
    return {x, y};
  }
  Point sample(double goal_bias) { return random_.uniform() < goal_bias ? query().goal : sample(); }

  /// The end of a step from a node towards a target; empty if it is blocked or does not move.
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

  /// Completes the failure of a search with the number of iterations and the tree's distance from
  /// the goal.
  Failure failure(Failure failure, const SearchTree& tree) const {
    const Point nearest = tree.position(tree.points().nearest(query().goal));
    failure.detail = "no path after " + std::to_string(stats().expanded) +
                     " iterations; the tree comes within " +
                     std::to_string(distance(nearest, query().goal)) + " m of the goal";
    failure.stats = stats();
    return failure;
  }

  void notify_improved(const std::vector<Point>& path, double cost) {
    if constexpr (AnytimeObserver<O>) context_.observer.improved(Curve::polyline(path), cost);
  }

 private:
  SearchContext<S, O> context_;
  Box bounds_;
  double step_;
  Random random_;
};

}  // namespace tutavia::detail
