// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/theta_search.hpp"
#include "tutavia/search/node_placement.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Lazy Theta*: Theta* that tests few lines of sight.

namespace tutavia {

/// Lazy Theta*: Theta* that takes a line of sight for granted until the cell is expanded, so that
/// it tests one per cell and not one per neighbour. Paths about as long; guarantees and errors as
/// for ThetaStar. Source: Nash, Koenig and Tovey 2010, "Lazy Theta*: any-angle path planning and
/// path length analysis in 3D".
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
