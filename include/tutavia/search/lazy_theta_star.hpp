// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/theta_search.hpp"
#include "tutavia/search/node_placement.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Lazy Theta*: Theta* with fewer line-of-sight tests.

namespace tutavia {

/// Lazy Theta*: Theta* that assumes a line of sight until the cell is expanded. It tests one line
/// of sight per cell instead of one per neighbour. Paths are about as long as those of ThetaStar;
/// guarantees and errors are the same.
///
/// Source: Nash, Koenig and Tovey 2010, "Lazy Theta*: any-angle path planning and path length
/// analysis in 3D".
///
/// Example: examples/searches_on_cells.cpp.
struct LazyThetaStar {
  static constexpr std::string_view name = "lazy_theta_star";
  using Scratch = detail::ThetaScratch;

  NodePlacement nodes = NodePlacement::cell_centre;

  template <LineOfSightSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    return detail::theta_search<detail::SightTest::at_expansion>(space, query, nodes, scratch,
                                                                 observer);
  }
};

}  // namespace tutavia
