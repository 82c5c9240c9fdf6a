// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <utility>

#include "tutavia/grid/cell.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// search_grid: the frame of every search on a grid.

namespace tutavia::detail {

/// A path found on a grid.
struct GridPath {
  /// From the goal's cell back to the start's, in memory of the search. The straight segments
  /// between successive cells are free.
  std::span<const Cell> cells{};
  std::optional<double> cost{};  ///< minimised cost; default: length of the route
};

/// The core of a search on a grid: `run(linked, context)` finds a path between the cells to which
/// start and goal are linked.
template <class G, class S, class O>
concept GridSearch = requires(const G& search, const GridQuery& linked,
                              SearchContext<S, O>& context) {
  { search.run(linked, context) } -> std::same_as<Expected<GridPath, Failure>>;
};

/// A search that follows the steps of a StepRule, whatever they are. Others rely on the regularity
/// of a movement rule.
template <class G>
concept AnyStepSearch = G::takes_any_steps;

/// Searches a grid. Start and goal are linked to it; unless both are cells, the straight segment
/// between them may be tried first.
///
/// Errors: those of `check_query`; `invalid_option` if the search needs a movement rule and the
/// space has none; `unreachable_at_resolution`, also if no node near start or goal can be reached
/// from it; those of the search.
template <LinkedSpace S, Observer O, GridSearch<S, O> Search>
Expected<Route, Failure> search_grid(const S& space, const Query& query, O& observer,
                                     const Search& search,
                                     StraightSegment straight = StraightSegment::tried_first) {
  if constexpr (GridSpace<S> && !AnyStepSearch<Search>) {
    if (auto valid = check_has_rule(space); !valid) return std::move(valid).unexpected();
  }
  auto linked = link_to_grid(space, query, straight);
  if (!linked) return std::move(linked).unexpected();
  const Frame& frame = space.frame();
  SearchContext<S, O> context{space, query, observer};
  GridPath path;
  if (!linked->is_straight) {
    auto found = search.run(*linked, context);
    if (!found) {
      return Unexpected{
          grid_failure(std::move(found.error()), context.statistics, frame.resolution)};
    }
    path = *found;
  }
  Route route{.curve = path_through(path.cells, *linked, query, frame),
              .stats = context.statistics};
  route.cost = path.cost.value_or(route.curve.length());
  return route;
}

}  // namespace tutavia::detail
