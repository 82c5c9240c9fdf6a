// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/smooth/route/input_checks.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// HomotopyRefine: replaces a curve by a shorter path in any homotopy class.

namespace tutavia {

/// Replaces a curve by the globally shortest path if that is shorter. A taut string cannot find
/// that path, because it keeps the obstacles on the same sides as the route. Searches the tangent
/// graph, bounded by the curve's own length.
///
/// Guarantees: the ends are exact; the result is the input or a proved shorter path. The result is
/// the input if the search runs out of time or expansions.
///
/// Example: examples/smoothers.cpp.
struct HomotopyRefine {
  static constexpr std::string_view name = "homotopy_refine";

  /// Upper bound on the expansions of the search.
  std::uint64_t max_expansions = std::numeric_limits<std::uint64_t>::max();

  /// Errors: `invalid_input` for a curve that is not free; `cancelled`; `budget_exhausted` while
  /// the curve is checked.
  template <FeatureSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    if (const auto free = detail::check_free(space, input, budget); !free)
      return Unexpected{free.error()};
    if (input.empty()) return input;
    Query query{.start = input.start(), .goal = input.end(), .budget = budget};
    query.budget.max_expansions = std::min(budget.max_expansions, max_expansions);
    TangentGraph::Scratch scratch;
    NoObserver no_observer;
    auto route = TangentGraph{.bound = input.length()}.search(space, query, scratch, no_observer);
    if (route && route->curve.length() < input.length()) return std::move(route->curve);
    if (!route && route.error().code == PlanError::cancelled) return Unexpected{route.error()};
    return input;
  }
};

}  // namespace tutavia
