// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <utility>

#include "tutavia/search/tangent_graph.hpp"

/// \file
/// find_optimum: the length of the shortest path.

namespace tutavia {

/// The exact length of the shortest path of the disc robot [m]; see TangentGraph. If `bound` is the
/// length of a known path, the search skips all longer ones. It takes milliseconds for hundreds of
/// obstacle vertices and respects the query's budget.
///
/// Errors: those of TangentGraph; `unreachable` if the shortest path is longer than `bound`.
///
/// Example: examples/searches_among_polygons.cpp.
template <FeatureSpace S>
Expected<double, Failure> find_optimum(const S& space, const Query& query,
                                       double bound = std::numeric_limits<double>::infinity()) {
  TangentGraph::Scratch scratch;
  NoObserver no_observer;
  // Despite rounding, a path of length `bound` must be found.
  const TangentGraph search{.bound = bound * (1 + 1e-9)};
  auto route = search.search(space, query, scratch, no_observer);
  if (!route) return Unexpected{std::move(route.error())};
  return route->cost;
}

}  // namespace tutavia
