// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <utility>

#include "tutavia/plan/query.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/search_grid.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/rectangle/rectangle_search.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// REA*: rectangle expansion A*.

namespace tutavia {

/// A* over free rectangles. An interval of cells is expanded at once into the largest free
/// rectangle that grows from it, without visiting the cells inside. Cells on the rectangle's border
/// get their exact octile distances from the interval, and the free intervals beyond its four sides
/// are pushed onto the open list. Optimal in octile distance like A*, with far fewer expansions in
/// open areas. The route runs straight through each rectangle, so it is often shorter than
/// `Route::cost`, which is the minimised octile distance.
///
/// Complete on the grid. `Statistics::expanded` counts rectangles. Linear in the length of the
/// rectangles' borders. Errors: `invalid_option` for any movement rule but `no_cut`; others as for
/// AStar.
///
/// Source: Zhang, Li and Bi 2016, "Rectangle expansion A* pathfinding for grid maps". Completeness
/// and optimality need all four sides and the diagonals out of corners; see docs/algorithms.md.
///
/// Example: examples/searches_on_cells.cpp.
struct ReaStar {
  static constexpr std::string_view name = "rea_star";
  using Scratch = detail::ReaScratch;

  template <ColumnSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const;
};

template <ColumnSpace S, Observer O>
Expected<Route, Failure> ReaStar::search(const S& space, const Query& query, Scratch& scratch,
                                         O& observer) const {
  if (auto valid = detail::check_no_cut(space, name); !valid) return std::move(valid).unexpected();
  return detail::search_grid(space, query, observer, detail::RectangleGridSearch{scratch});
}

}  // namespace tutavia
