// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>

#include "tutavia/core/expected.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/grid/cell.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/statistics.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// SearchContext: what one search is given, and what it counts.

namespace tutavia::detail {

/// One query on a space, who observes its search and what the search has cost. A place is a point,
/// or a cell of a space with a grid.
template <FreeSpace S, Observer O>
struct SearchContext {
  const S& space;
  const Query& query;
  O& observer;
  Statistics statistics{};

  /// To be asked before every expansion; the clock is read once in `every` of them. Errors: what
  /// the budget says.
  Expected<void, Failure> check_budget(std::uint64_t every = 256) const {
    return detail::check_budget(query.budget, statistics.expanded, every);
  }

  /// Counts a node that is expanded.
  template <class Place>
  void count_expanded(const Place& place) {
    ++statistics.expanded;
    if constexpr (is_observed) observer.expanded(point(place));
  }

  /// Counts a node that is labelled, or labelled anew.
  template <class Place>
  void count_generated(const Place& place) {
    ++statistics.generated;
    if constexpr (is_observed) observer.generated(point(place));
  }

 private:
  static constexpr bool is_observed = !std::same_as<O, NoObserver>;

  static const Point& point(const Point& p) { return p; }
  Point point(Cell cell) const { return space.frame().point(cell); }
};

}  // namespace tutavia::detail
