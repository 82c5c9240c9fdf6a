// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/neighbours.hpp"
#include "tutavia/search/tree/rewired_tree.hpp"

/// \file
/// RrtStar: an asymptotically optimal random tree.

namespace tutavia {

/// A random tree that keeps the cheapest nearby parent of every node.
///
/// The path gets shorter while iterations remain. With probability 1 its length tends to that of
/// the shortest path with room around it, and more iterations never lengthen it. An
/// `AnytimeObserver` receives every improved path. If the budget ends before the iterations, the
/// best path so far is the result. If start and goal see each other, the result is the straight
/// line. The same seed gives the same tree.
///
/// Errors: `invalid_option`; those of `check_query`; `budget_exhausted` if no path is known after
/// all iterations or at the end of the budget, with the tree's distance from the goal in the
/// detail; `cancelled`.
///
/// Source: Karaman and Frazzoli 2011, "Sampling-based algorithms for optimal motion planning".
///
/// Example: examples/searches_among_polygons.cpp.
struct RrtStar {
  static constexpr std::string_view name = "rrt_star";
  using Scratch = detail::RewiredTreeScratch;

  /// Longest step [m], at most the diagonal of the bounds. Default: 1/25 of the bounds' longer
  /// side. Edges to the k nearest may be longer.
  std::optional<double> step{};
  double goal_bias = 0.05;  ///< share of iterations that grow towards the goal until it is reached
  std::uint32_t max_iterations = 3000;
  Neighbours neighbours = Neighbours::k_nearest;
  double rewire_factor = 1.1;  ///< asymptotic optimality needs more than 1

  template <FreeSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    return detail::search_with_rewired_tree(*this, space, query, scratch, observer,
                                            [](auto& growth, double) { return growth.sample(); });
  }
};

}  // namespace tutavia
