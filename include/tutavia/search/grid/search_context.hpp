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
/// SearchContext: the space, query, observer and statistics of one search.

namespace tutavia::detail {

/// The inputs of one search and its statistics. A node is given as a point, or as a cell of a space
/// with a grid.
template <FreeSpace S, Observer O>
struct SearchContext {
  const S& space;
  const Query& query;
  O& observer;
  Statistics statistics{};

  /// Call before every expansion; reads the clock once in `every` expansions. Errors: those of the
  /// budget.
  Expected<void, Failure> check_budget(std::uint64_t every = 256) const {
    return detail::check_budget(query.budget, statistics.expanded, every);
  }

  /// Counts an expanded node.
  template <class Node>
  void count_expanded(const Node& node) {
    ++statistics.expanded;
    if constexpr (is_observed) observer.expanded(point(node));
  }

  /// Counts a node that is labelled, for the first time or again.
  template <class Node>
  void count_generated(const Node& node) {
    ++statistics.generated;
    if constexpr (is_observed) observer.generated(point(node));
  }

 private:
  static constexpr bool is_observed = !std::same_as<O, NoObserver>;

  static const Point& point(const Point& p) { return p; }
  Point point(Cell cell) const { return space.frame().point(cell); }
};

}  // namespace tutavia::detail
