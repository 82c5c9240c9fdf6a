// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "support/catch.hpp"
#include "support/free_route.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"

/// \file
/// check_route: checks the cost of a route.

namespace tutavia::test {

/// Checks one result against the length in the explicit graph: equal within `tolerance`, and a
/// route in free space from start to goal.
template <class S>
void check_route(const S& space, const Query& query, const Expected<Route, Failure>& route,
                 const std::optional<double>& expected, double tolerance) {
  REQUIRE(route.has_value() == expected.has_value());
  if (!route) {
    CHECK(route.error().code == PlanError::unreachable_at_resolution);
    return;
  }
  CHECK(route->cost == Approx(*expected).epsilon(0).margin(tolerance));
  CHECK(route->curve.start() == query.start);
  CHECK(route->curve.end() == query.goal);
  CHECK(is_free(space, *route));
}

}  // namespace tutavia::test
