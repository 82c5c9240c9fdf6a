// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string_view>
#include <utility>

#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"

/// \file
/// FirstOf: a second search where the first one finds no path.

namespace tutavia {

/// Two searches. The second runs where the first found no path and has not proved that there is
/// none: on `unreachable_at_resolution` and `not_proved`. The answer is then the second's, with the
/// counts of both.
///
///     FirstOf{AStar{}, TangentGraph{}}   // A* on the lattice, the exact search where that fails
///
/// `Route::found_by` names the search that found the path. The searches share the query's budget.
/// Errors: those of the first but for the two above; those of the second.
///
/// Example: examples/searches_among_polygons.cpp.
template <class First, class Second>
struct FirstOf {
  static constexpr std::string_view name = "first_of";
  static constexpr bool plans_vehicles = PlansVehicles<First> || PlansVehicles<Second>;
  struct Scratch {
    typename First::Scratch first;
    typename Second::Scratch second;
  };

  First first{};
  Second second{};

  template <class S, Observer O = NoObserver>
  requires Searcher<First, S> && Searcher<Second, S> Expected<Route, Failure> search(
      const S& space, const Query& query, Scratch& scratch, O& observer)
  const {
    auto route = first.search(space, query, scratch.first, observer);
    if (route) {
      if (route->found_by.empty()) route->found_by = First::name;
      return route;
    }
    const Failure& failure = route.error();
    if (failure.code != PlanError::unreachable_at_resolution &&
        failure.code != PlanError::not_proved) {
      return route;
    }
    Query rest = query;
    rest.budget.max_expansions -= std::min(failure.stats.expanded, rest.budget.max_expansions);
    auto exact = second.search(space, rest, scratch.second, observer);
    if (exact && exact->found_by.empty()) exact->found_by = Second::name;
    Statistics& stats = exact ? exact->stats : exact.error().stats;
    stats.expanded += failure.stats.expanded;
    stats.generated += failure.stats.generated;
    return exact;
  }
};

template <class First, class Second>
FirstOf(First, Second) -> FirstOf<First, Second>;

}  // namespace tutavia
