// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
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

/// What is wrong with options that all trees have, or with the query.
template <FreeSpace S>
std::optional<Failure> check_growth(const S& space, const Query& query,
                                    const std::optional<double>& step, double goal_bias,
                                    std::uint32_t iterations) {
  const auto invalid = [](std::string detail) {
    return Failure{.code = PlanError::invalid_option, .detail = std::move(detail)};
  };
  const Box& bounds = space.bounds();
  const double most = distance(bounds.min, bounds.max);
  if (step && !(*step > 0 && *step <= most)) {
    return invalid("step must be positive and at most " + std::to_string(most) +
                   " m, the diagonal of the bounds");
  }
  if (!(goal_bias >= 0 && goal_bias <= 1)) return invalid("goal_bias must lie in [0, 1]");
  if (iterations == 0) return invalid("iterations must be positive");
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
inline Point steered(const Point& from, const Point& target, double step) {
  const double gap = distance(from, target);
  return gap <= step ? target : lerp(from, target, step / gap);
}

/// One search that grows trees: where it samples, how it steps and when it has to end.
template <FreeSpace S, Observer O>
class TreeGrowth {
 public:
  TreeGrowth(const S& space, const Query& query, const std::optional<double>& step, O& observer,
             const Statistics& stats = {})
      : space_(space),
        query_(query),
        bounds_(space.bounds()),
        step_(step ? *step : default_step(bounds_)),
        random_(query.seed),
        observer_(observer),
        stats_(stats) {}

  const S& space() const { return space_; }
  const Query& query() const { return query_; }
  const Box& bounds() const { return bounds_; }
  double step() const { return step_; }
  Random& random() { return random_; }
  const Statistics& stats() const { return stats_; }

  /// To be asked before every iteration: what ends the search, if it is to end. Counts the
  /// iteration.
  std::optional<Failure> next_iteration() {
    if (is_checked(query_.budget, stats_.expanded)) {
      if (auto failure = exceeded(query_.budget, stats_.expanded)) return failure;
    }
    ++stats_.expanded;
    return std::nullopt;
  }

  /// Uniform over the bounds; blocked points, too: they are only directions to grow in.
  Point sample() {
    const double x = random_.uniform(bounds_.min.x(), bounds_.max.x());
    const double y = random_.uniform(bounds_.min.y(), bounds_.max.y());
    return {x, y};
  }
  Point sample(double goal_bias) { return random_.uniform() < goal_bias ? query_.goal : sample(); }

  /// A step from a node towards a target, if that leads to another point and is free.
  std::optional<Point> step_towards(const SearchTree& tree, SearchTree::Node from,
                                    const Point& target) {
    const Point start = tree.position(from), end = steered(start, target, step_);
    if (end == start || !space_.segment_free(start, end)) return std::nullopt;
    return end;
  }

  SearchTree::Node add(SearchTree& tree, SearchTree::Node parent, const Point& p, double cost) {
    ++stats_.generated;
    observer_.expanded(tree.position(parent));
    observer_.generated(p);
    return tree.add(parent, p, cost);
  }

  /// Why there is no path, from what ended the search; how near the tree came is told.
  Failure failure(Failure failure, const SearchTree& tree) const {
    const Point nearest = tree.position(tree.points().nearest(query_.goal));
    failure.detail = "no path after " + std::to_string(stats_.expanded) +
                     " iterations; the tree comes within " +
                     std::to_string(distance(nearest, query_.goal)) + " m of the goal";
    failure.stats = stats_;
    return failure;
  }

  void tell_improved(const std::vector<Point>& way, double cost) {
    if constexpr (AnytimeObserver<O>) observer_.improved(Curve::polyline(way), cost);
  }

 private:
  const S& space_;
  const Query& query_;
  Box bounds_;
  double step_;
  Random random_;
  O& observer_;
  Statistics stats_;
};

}  // namespace tutavia::detail
