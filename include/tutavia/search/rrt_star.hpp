// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/tree/rewired_tree.hpp"

/// \file
/// RrtStar: a random tree whose paths become the shortest ones.

namespace tutavia {

/// A random tree, each node of which has the best parent near it at all times.
///
/// The path gets shorter as long as there are iterations left and tends, with probability 1, to the
/// shortest one that has room around it; it is never longer after more of them. An observer that is
/// `AnytimeObserver` is told of every better one, and where the budget ends before the iterations
/// do, the best path so far is the answer. Where start and goal see each other it is the straight
/// line. Same seed, same tree. Source: Karaman and Frazzoli 2011, "Sampling-based algorithms for
/// optimal motion planning".
///
/// Errors: `invalid_option`; what is wrong with start or goal; `budget_exhausted` where there is no
/// path after all iterations or at the end of the budget, with the tree's distance from the goal in
/// the detail; `cancelled`.
struct RrtStar {
  static constexpr std::string_view name = "rrt_star";
  using Scratch = detail::RewiredTreeScratch;

  /// Longest step [m], at most the diagonal of the bounds; none: a 25th of their longer side. Edges
  /// to the k nearest may be longer.
  std::optional<double> step{};
  double goal_bias = 0.05;  ///< share of iterations that grow towards the goal until it is reached
  std::uint32_t iterations = 3000;
  detail::Neighbours neighbours = detail::Neighbours::k_nearest;
  double rewire_factor = 1.1;  ///< theory wants more than 1

  template <FreeSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    return detail::search_with_rewired_tree(*this, space, query, scratch, observer,
                                            [](auto& growth, double) { return growth.sample(); });
  }
};

}  // namespace tutavia
