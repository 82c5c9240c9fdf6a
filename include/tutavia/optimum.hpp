// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <utility>

#include "tutavia/search/tangent_graph.hpp"

/// \file
/// find_optimum: how long the shortest path is.

namespace tutavia {

/// The length of the shortest path of the disc [m], exact: see TangentGraph. Give the length of a
/// known path as `bound`: the search then looks at nothing that is longer. It takes milliseconds
/// for hundreds of obstacle vertices and keeps within the query's budget.
///
/// Errors: those of TangentGraph; `unreachable` where the shortest path is longer than `bound`.
template <FeatureSpace S>
Expected<double, Failure> find_optimum(const S& space, const Query& query,
                                       double bound = std::numeric_limits<double>::infinity()) {
  TangentGraph::Scratch scratch;
  NoObserver no_observer;
  // A path of the bound's own length is to be found whatever its rounding.
  const TangentGraph search{.bound = bound * (1 + 1e-9)};
  auto route = search.search(space, query, scratch, no_observer);
  if (!route) return Unexpected{std::move(route.error())};
  return route->cost;
}

}  // namespace tutavia
