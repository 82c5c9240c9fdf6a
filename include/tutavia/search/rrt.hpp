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
/// Rrt: a path, found by a tree that grows at random.

namespace tutavia {

/// A tree from the start that takes steps towards random points until one of them ends within a
/// step of the goal and in sight of it.
///
/// A path is found with a probability that tends to 1 as iterations are allowed, where there is one
/// with room around it; it is the first one, not a short one. Where start and goal see each other
/// it is the straight line. Same seed, same tree. Source: LaValle 1998, "Rapidly-exploring random
/// trees: a new tool for path planning".
///
/// Errors: `invalid_option`; what is wrong with start or goal; `budget_exhausted` after all
/// iterations, with the tree's distance from the goal in the detail, and for what the budget says;
/// `cancelled`. That there is no path cannot be known.
struct Rrt {
  static constexpr std::string_view name = "rrt";
  using Scratch = detail::TreeScratch;

  /// Longest edge [m], at most the diagonal of the bounds; none: a 25th of their longer side.
  std::optional<double> step{};
  double goal_bias = 0.05;          ///< share of iterations that grow towards the goal
  std::uint32_t iterations = 3000;  ///< at most

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
    for (std::uint32_t i = 0; i < iterations; ++i) {
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
      const auto way = tree.way_to(node);
      growth.tell_improved(way, tree.cost(node));
      return Route{Curve::polyline(way), tree.cost(node), growth.stats()};
    }
    return Unexpected{growth.failure({.code = PlanError::budget_exhausted}, tree)};
  }
};

}  // namespace tutavia
