// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "tutavia/core/budget.hpp"
#include "tutavia/core/error.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/nearest_free.hpp"

/// \file
/// Query: what a searcher is asked.

namespace tutavia {

/// From where to where, and at what expense. A goal that is left out is an `invalid_input`.
struct Query {
  Point start{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  Point goal{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  Budget budget{};
  std::uint64_t seed = 0;  ///< for searchers that draw random numbers
};

/// Why a point is no place to start or end in `space`, if it is not: out of bounds, or blocked with
/// the clearance there where the space knows it.
template <FreeSpace S>
std::optional<Failure> check_endpoint(const S& space, const Point& p, bool is_start) {
  const bool within = Box(space.bounds()).contains(p);  // false for NaN
  if (within && space.is_free(p)) return std::nullopt;
  const std::string name = is_start ? "start" : "goal";
  Failure failure;
  if (!is_finite(p)) {
    failure.detail = name + " is not a pair of finite coordinates";
    return failure;
  }
  const auto where = name + " (" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ")";
  if (!within) {
    failure.code = is_start ? PlanError::start_out_of_bounds : PlanError::goal_out_of_bounds;
    failure.detail = where + " lies outside the bounds";
    return failure;
  }
  failure.code = is_start ? PlanError::start_blocked : PlanError::goal_blocked;
  failure.detail = where + " lies in an obstacle or its safety zone";
  if constexpr (ClearanceSpace<S>) {
    failure.clearance = space.clearance(p);
    failure.obstacle =
        space.nearest(Segment{p, p}, std::numeric_limits<double>::infinity()).obstacle;
    failure.detail += ": its clearance is " + std::to_string(*failure.clearance) + " m, " +
                      std::to_string(space.safety_radius()) + " m needed";
  }
  if constexpr (FeatureSpace<S>) {
    failure.nearest_safe_point = nearest_free_point(space, p);
    if (const auto& safe = failure.nearest_safe_point) {
      failure.detail += "; the nearest safe point is (" + std::to_string(safe->x()) + ", " +
                        std::to_string(safe->y()) + ")";
    }
  }
  return failure;
}

/// The first reason why a query cannot be answered in `space`, if there is one.
template <FreeSpace S>
std::optional<Failure> check_query(const S& space, const Query& query) {
  if (auto failure = check_endpoint(space, query.start, true)) return failure;
  return check_endpoint(space, query.goal, false);
}

/// Why a search that is defined for the movement rule `no_cut` alone cannot be asked in `space`, if
/// it cannot.
template <GridSpace S>
std::optional<Failure> check_no_cut(const S& space, std::string_view search) {
  if (space.movement() == MovementRule::no_cut) return std::nullopt;
  Failure failure{.code = PlanError::invalid_option, .detail = std::string(search)};
  failure.detail += " is defined for the movement rule no_cut";
  return failure;
}

namespace detail {

/// Whether to look at the budget before an expansion: the clock is read once in `every`.
inline bool is_checked(const Budget& budget, std::uint64_t expanded, std::uint64_t every = 256) {
  return expanded % every == 0 || expanded >= budget.max_expansions;
}

/// What ends a query, if it is to end.
inline std::optional<Failure> exceeded(const Budget& budget, std::uint64_t expanded) {
  if (expanded >= budget.max_expansions) return Failure{.code = PlanError::budget_exhausted};
  if (const auto code = budget.exceeded()) return Failure{.code = *code};
  return std::nullopt;
}

}  // namespace detail

}  // namespace tutavia
