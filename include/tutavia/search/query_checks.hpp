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

/// Checks that a query may start (or end) at a point of `space`. Errors: the point is out of
/// bounds, or blocked with the clearance there where the space knows it.
template <FreeSpace S>
Expected<void, Failure> check_endpoint(const S& space, const Point& p, bool is_start) {
  const bool within = space.bounds().contains(p);  // false for NaN
  if (within && space.is_free(p)) return {};
  Failure failure = detail::endpoint_failure(p, is_start, within);
  if (!within) return Unexpected{std::move(failure)};
  if constexpr (ClearanceSpace<S>) {
    detail::add_clearance(failure, space.clearance(p), space.safety_radius());
    failure.obstacle =
        space.nearest(Segment{p, p}, std::numeric_limits<double>::infinity()).obstacle;
  }
  if constexpr (FeatureSpace<S>) {
    detail::add_nearest_safe_point(failure, nearest_free_point(space, p));
  }
  return Unexpected{std::move(failure)};
}

}  // namespace detail

/// Checks that a query may start and end where it says. Errors: those of `check_endpoint`, for the
/// start first.
template <FreeSpace S>
Expected<void, Failure> check_query(const S& space, const Query& query) {
  if (auto start = detail::check_endpoint(space, query.start, true); !start) return start;
  return detail::check_endpoint(space, query.goal, false);
}

namespace detail {

/// Checks the movement rule of `space` for a search that is defined for `no_cut` alone. Errors:
/// `invalid_option`.
template <GridSpace S>
Expected<void, Failure> check_no_cut(const S& space, std::string_view search) {
  if (space.movement() == MovementRule::no_cut) return {};
  return fail(PlanError::invalid_option,
              std::string(search) + " is defined for the movement rule no_cut");
}

/// Checks that a query may go on after so many expansions. Errors: what the budget says.
inline Expected<void, Failure> check_budget(const Budget& budget, std::uint64_t expanded) {
  if (expanded >= budget.max_expansions) return fail(PlanError::budget_exhausted);
  if (const auto code = budget.exceeded()) return fail(*code);
  return {};
}

/// The same before every expansion of a search: the clock is read once in `every` of them.
inline Expected<void, Failure> check_budget(const Budget& budget, std::uint64_t expanded,
                                            std::uint64_t every) {
  if (expanded % every != 0 && expanded < budget.max_expansions) return {};
  return check_budget(budget, expanded);
}

}  // namespace detail

}  // namespace tutavia
