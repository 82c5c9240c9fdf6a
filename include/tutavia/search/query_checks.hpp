// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "tutavia/core/budget.hpp"
#include "tutavia/core/parts/number_text.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/nearest_free.hpp"

/// \file
/// Checks before and during a search: endpoints, movement rule, budget.

namespace tutavia {

namespace detail {

/// The failure for a point that is not a valid start (or goal), without details from the space.
inline Failure endpoint_failure(const Point& p, bool is_start, bool is_within_bounds) {
  Failure failure;
  failure.detail = is_start ? "start" : "goal";
  if (!is_finite(p)) {
    failure.detail += " is not a pair of finite coordinates";
    return failure;
  }
  failure.detail.append(" ").append(to_text(p));
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
  failure.detail.append(": its clearance is ").append(number_text(clearance));
  failure.detail.append(" m, ").append(number_text(safety_radius)).append(" m needed");
}

inline void add_nearest_safe_point(Failure& failure, const std::optional<Point>& safe) {
  failure.nearest_safe_point = safe;
  if (!safe) return;
  failure.detail.append("; the nearest safe point is ").append(to_text(*safe));
}

/// Checks that a query may start (or end) at a point. Errors: the point lies out of bounds or is
/// blocked. For a blocked point the failure has its clearance if the space measures clearance.
template <FreeSpace S>
Expected<void, Failure> check_endpoint(const S& space, const Point& p, bool is_start) {
  const bool within = space.bounds().contains(p);  // false for NaN
  if (within && space.is_free(p)) return {};
  Failure failure = endpoint_failure(p, is_start, within);
  if (!within) return Unexpected{std::move(failure)};
  if constexpr (ClearanceSpace<S>) {
    add_clearance(failure, space.clearance(p), space.safety_radius());
    failure.obstacle =
        space.nearest(Segment{p, p}, std::numeric_limits<double>::infinity()).obstacle;
  }
  if constexpr (FeatureSpace<S>) {
    add_nearest_safe_point(failure, nearest_free_point(space, p));
  }
  return Unexpected{std::move(failure)};
}

}  // namespace detail

/// Checks a query without headings: its start, then its goal. Errors: `invalid_option` for a query
/// with headings; those of `check_endpoint`.
template <FreeSpace S>
Expected<void, Failure> check_query(const S& space, const Query& query) {
  if (query.start_heading || query.goal_heading) {
    return fail(PlanError::invalid_option,
                std::string(query.start_heading ? "start_heading" : "goal_heading") +
                    ": this search plans no headings; use hybrid_astar (HybridAStar)");
  }
  if (auto start = detail::check_endpoint(space, query.start, true); !start) return start;
  return detail::check_endpoint(space, query.goal, false);
}

namespace detail {

/// Returns `invalid_option` if the space has no movement rule, but steps of each node's own.
template <GridSpace S>
Expected<void, Failure> check_has_rule(const S& space) {
  if (space.movement() != MovementRule::by_edge) return {};
  return fail(
      PlanError::invalid_option,
      "this search needs the same movement rule everywhere; on a lattice with the edge rule "
      "paper_strict use astar, dijkstra, weighted_astar, penalty_astar, ssa_astar, "
      "theta_star, lazy_theta_star or a random tree");
}

/// Returns `invalid_option` unless the space has the movement rule `no_cut`.
template <GridSpace S>
Expected<void, Failure> check_no_cut(const S& space, std::string_view search) {
  if (space.movement() == MovementRule::no_cut) return {};
  return fail(PlanError::invalid_option,
              std::string(search) + " is defined for the movement rule no_cut");
}

/// Checks the budget after `expanded` expansions. Errors: those of the budget.
inline Expected<void, Failure> check_budget(const Budget& budget, std::uint64_t expanded) {
  if (expanded >= budget.max_expansions) return fail(PlanError::budget_exhausted);
  if (const auto code = budget.exceeded()) return fail(*code);
  return {};
}

/// The same for a call before every expansion: reads the clock once in `every` calls.
inline Expected<void, Failure> check_budget(const Budget& budget, std::uint64_t expanded,
                                            std::uint64_t every) {
  if (expanded % every != 0 && expanded < budget.max_expansions) return {};
  return check_budget(budget, expanded);
}

}  // namespace detail

}  // namespace tutavia
