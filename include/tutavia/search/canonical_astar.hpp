// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/search/astar.hpp"

/// \file
/// Canonical A*: A* that generates only one of many equal paths.

namespace tutavia {

/// AStar with its default options, under the name of the canonical ordering that it follows.
///
/// Source: Sturtevant and Rabin 2016, "Canonical orderings on grids".
///
/// Example: examples/searches_on_cells.cpp.
struct CanonicalAStar {
  static constexpr std::string_view name = "canonical_astar";
  using Scratch = AStar::Scratch;

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    return AStar{.successors = AStar::Successors::canonical}.search(space, query, scratch,
                                                                    observer);
  }
};

}  // namespace tutavia
