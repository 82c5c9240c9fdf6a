// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/tree/tree_growth.hpp"

/// \file
/// Rrt: a path found by growing a random tree.

namespace tutavia {

/// Grows a tree from the start by steps towards random points, until a node lies within one step of
/// the goal and sees it.
///
/// If there is a path with room around it, the probability of finding one tends to 1 with the
/// number of iterations. The result is the first path found, not a short one. If start and goal see
/// each other, the result is the straight line. The same seed gives the same tree.
///
/// Errors: `invalid_option`; those of `check_query`; `budget_exhausted` after all iterations or at
/// the end of the budget, with the tree's distance from the goal in the detail; `cancelled`. It
/// cannot prove that no path exists.
///
/// Source: LaValle 1998, "Rapidly-exploring random trees: a new tool for path planning".
///
/// Example: examples/searches_among_polygons.cpp.
struct Rrt {
  static constexpr std::string_view name = "rrt";
  using Scratch = detail::TreeScratch;

  /// Longest edge [m], at most the diagonal of the bounds. Default: 1/25 of the bounds' longer
  /// side.
  std::optional<double> step{};
  double goal_bias = 0.05;              ///< share of iterations that grow towards the goal
  std::uint32_t max_iterations = 3000;  ///< at most

  template <FreeSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (auto valid = detail::check_growth(*this, space, query); !valid) {
      return std::move(valid).unexpected();
    }
    detail::SearchTree& tree = scratch.tree;
    tree.reset(space.bounds(), query.start);
    if (auto straight = detail::straight_route(space, query)) return std::move(*straight);
    detail::TreeGrowth growth(space, query, step, observer);
    const auto add = [&](detail::SearchTree::Node parent, const Point& p) {
      return growth.add(tree, parent, p, distance(tree.position(parent), p));
    };
    for (std::uint32_t i = 0; i < max_iterations; ++i) {
      if (auto next = growth.next_iteration(); !next) {
        return Unexpected{growth.failure(std::move(next.error()), tree)};
      }
      const Point target = growth.sample(goal_bias);
      const detail::SearchTree::Node nearest = tree.points().nearest(target);
      const auto end = growth.step_towards(tree, nearest, target);
      if (!end) continue;
      detail::SearchTree::Node node = add(nearest, *end);
      if (*end != query.goal) {
        if (distance(*end, query.goal) > growth.step()) continue;
        if (!space.segment_free(*end, query.goal)) continue;
        node = add(node, query.goal);
      }
      const auto path = tree.path_to(node);
      growth.notify_improved(path, tree.cost(node));
      return Route{Curve::polyline(path), tree.cost(node), growth.stats()};
    }
    return Unexpected{growth.failure({.code = PlanError::budget_exhausted}, tree)};
  }
};

}  // namespace tutavia
