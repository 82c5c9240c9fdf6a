// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/nearest_free.hpp"

/// \file
/// What a searcher checks before it searches: endpoints, movement rule, budget.

namespace tutavia {

namespace detail {

/// The failure of a point that is no start (or goal), without what the space knows of it.
inline Failure endpoint_failure(const Point& p, bool is_start, bool is_within_bounds) {
  Failure failure;
  failure.detail = is_start ? "start" : "goal";
  if (!is_finite(p)) {
    failure.detail += " is not a pair of finite coordinates";
    return failure;
  }
  failure.detail += " (" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ")";
  if (is_within_bounds) {
    failure.code = is_start ? PlanError::start_blocked : PlanError::goal_blocked;
    failure.detail += " lies in an obstacle or its safety zone";
  } else {
    failure.code = is_start ? PlanError::start_out_of_bounds : PlanError::goal_out_of_bounds;
    failure.detail += " lies outside the bounds";
  }
  return failure;
}

inline void add_clearance(Failure& failure, double clearance, double safety_radius) {
  failure.clearance = clearance;
  failure.detail += ": its clearance is " + std::to_string(clearance) + " m, " +
                    std::to_string(safety_radius) + " m needed";
}

inline void add_nearest_safe_point(Failure& failure, const std::optional<Point>& safe) {
  failure.nearest_safe_point = safe;
  if (!safe) return;
  failure.detail += "; the nearest safe point is (" + std::to_string(safe->x()) + ", " +
                    std::to_string(safe->y()) + ")";
}

}  // namespace detail

/// Why a point is no place to start or end in `space`, if it is not: out of bounds, or blocked with
/// the clearance there where the space knows it.
template <FreeSpace S>
std::optional<Failure> check_endpoint(const S& space, const Point& p, bool is_start) {
  const bool within = space.bounds().contains(p);  // false for NaN
  if (within && space.is_free(p)) return std::nullopt;
  Failure failure = detail::endpoint_failure(p, is_start, within);
  if (!within) return failure;
  if constexpr (ClearanceSpace<S>) {
    detail::add_clearance(failure, space.clearance(p), space.safety_radius());
    failure.obstacle =
        space.nearest(Segment{p, p}, std::numeric_limits<double>::infinity()).obstacle;
  }
  if constexpr (FeatureSpace<S>) {
    detail::add_nearest_safe_point(failure, nearest_free_point(space, p));
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
  if (const auto end = budget.exceeded()) return Failure{.code = to_error(*end)};
  return std::nullopt;
}

}  // namespace detail

}  // namespace tutavia
