// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/tree/tree_growth.hpp"

/// \file
/// RrtConnect: a path found by two random trees that grow towards each other.

namespace tutavia {

namespace detail {

/// Memory of a search with a tree from each end. Holds the trees of the last query.
struct TwoTreesScratch {
  SearchTree from_start, from_goal;

  void clear() {
    from_start.clear();
    from_goal.clear();
  }
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    from_start.for_each_edge(visit);
    from_goal.for_each_edge(visit);
  }
};

}  // namespace detail

/// Grows a tree from the start and one from the goal. In turn, one tree takes a step towards a
/// random point, and the other takes steps towards the new node until it reaches it or is blocked.
///
/// Mostly much faster than `Rrt`, with the same guarantees: it finds the first path, not a short
/// one. Errors as for `Rrt`; the distance in the detail is that of the start's tree from the goal.
///
/// Source: Kuffner and LaValle 2000, "RRT-Connect: an efficient approach to single-query path
/// planning".
///
/// Example: examples/searches_among_polygons.cpp.
struct RrtConnect {
  static constexpr std::string_view name = "rrt_connect";
  using Scratch = detail::TwoTreesScratch;

  /// Longest edge [m], at most the diagonal of the bounds. Default: 1/25 of the bounds' longer
  /// side.
  std::optional<double> step{};
  std::uint32_t max_iterations = 3000;  ///< at most

  template <FreeSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (auto valid = detail::check_growth(*this, space, query); !valid) {
      return std::move(valid).unexpected();
    }
    scratch.from_start.reset(space.bounds(), query.start);
    scratch.from_goal.reset(space.bounds(), query.goal);
    if (auto straight = detail::straight_route(space, query)) return std::move(*straight);
    detail::TreeGrowth growth(space, query, step, observer);
    detail::SearchTree *tree = &scratch.from_start, *other = &scratch.from_goal;
    for (std::uint32_t i = 0; i < max_iterations; ++i, std::swap(tree, other)) {
      if (auto next = growth.next_iteration(); !next) {
        return Unexpected{growth.failure(std::move(next.error()), scratch.from_start)};
      }
      if (!extend(growth, *tree, growth.sample())) continue;
      const Point meeting = tree->position(last(*tree));
      while (extend(growth, *other, meeting)) {
        if (other->position(last(*other)) != meeting) continue;
        Route route{Curve::polyline(path(scratch)), 0, growth.stats()};
        route.cost = route.curve.length();
        growth.notify_improved(path(scratch), route.cost);
        return route;
      }
    }
    return Unexpected{growth.failure({.code = PlanError::budget_exhausted}, scratch.from_start)};
  }

 private:
  static detail::SearchTree::Node last(const detail::SearchTree& tree) {
    return static_cast<detail::SearchTree::Node>(tree.size() - 1);
  }

  /// Adds a step towards a target to a tree. Returns whether it is free.
  template <FreeSpace S, Observer O>
  static bool extend(detail::TreeGrowth<S, O>& growth, detail::SearchTree& tree,
                     const Point& target) {
    const detail::SearchTree::Node nearest = tree.points().nearest(target);
    const auto end = growth.step_towards(tree, nearest, target);
    if (end) growth.add(tree, nearest, *end, distance(tree.position(nearest), *end));
    return end.has_value();
  }

  /// The path through the last nodes of both trees, which have the same position.
  static std::vector<Point> path(const detail::TwoTreesScratch& scratch) {
    std::vector<Point> path = scratch.from_start.path_to(last(scratch.from_start));
    const std::vector<Point> rest = scratch.from_goal.path_to(last(scratch.from_goal));
    path.insert(path.end(), rest.rbegin() + 1, rest.rend());
    return path;
  }
};

}  // namespace tutavia
