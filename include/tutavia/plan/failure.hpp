// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include "tutavia/core/budget.hpp"
#include "tutavia/core/expected.hpp"
#include "tutavia/plan/statistics.hpp"

/// \file
/// Failures are data: a code for programs, a detail for people.

namespace tutavia {

/// Why there is no plan.
enum class PlanError {
  start_blocked,              ///< the start lies in a safety zone or has no free link to the grid
  goal_blocked,               ///< the goal does
  start_out_of_bounds,        ///< the start lies outside the workspace
  goal_out_of_bounds,         ///< the goal does
  unreachable,                ///< proved: the space has no path
  unreachable_at_resolution,  ///< the lattice has no path; a finer one may have
  not_proved,                 ///< a path was found, but its safety could not be proved
  budget_exhausted,           ///< out of time or expansions
  cancelled,                  ///< stopped on request
  invalid_option,             ///< an option has no meaning; the detail names it
  invalid_input,              ///< the input is broken; the detail names object and index
  limit_exceeded,             ///< the request is too large; the detail says needed and allowed
};

/// The code's name, as it stands in result files: "start_blocked", ...
constexpr std::string_view to_string(PlanError code) {
  switch (code) {
    case PlanError::start_blocked:
      return "start_blocked";
    case PlanError::goal_blocked:
      return "goal_blocked";
    case PlanError::start_out_of_bounds:
      return "start_out_of_bounds";
    case PlanError::goal_out_of_bounds:
      return "goal_out_of_bounds";
    case PlanError::unreachable:
      return "unreachable";
    case PlanError::unreachable_at_resolution:
      return "unreachable_at_resolution";
    case PlanError::not_proved:
      return "not_proved";
    case PlanError::budget_exhausted:
      return "budget_exhausted";
    case PlanError::cancelled:
      return "cancelled";
    case PlanError::invalid_option:
      return "invalid_option";
    case PlanError::invalid_input:
      return "invalid_input";
    case PlanError::limit_exceeded:
      return "limit_exceeded";
  }
  return "unknown";
}

namespace detail {

/// The code of a query that its budget has ended.
constexpr PlanError to_error(Budget::End end) {
  return end == Budget::End::cancelled ? PlanError::cancelled : PlanError::budget_exhausted;
}

}  // namespace detail

/// Why there is no plan, and what is known about it.
struct Failure {
  PlanError code = PlanError::invalid_input;
  std::string detail{};  ///< one line for people
  /// start_blocked and goal_blocked: the signed clearance there [m]
  std::optional<double> clearance{};
  /// start_blocked and goal_blocked: index of the obstacle that is nearest there
  std::optional<std::size_t> obstacle{};
  /// start_blocked and goal_blocked: the nearest point of free space, where one was found
  std::optional<Eigen::Vector2d> nearest_safe_point{};
  Statistics stats{};
};

inline std::ostream& operator<<(std::ostream& out, const Failure& failure) {
  out << to_string(failure.code);
  if (!failure.detail.empty()) out << ": " << failure.detail;
  return out;
}

/// Short for the error side of an Expected: `return fail(PlanError::unreachable, "...")`.
inline Unexpected<Failure> fail(PlanError code, std::string detail = {}) {
  Failure failure;
  failure.code = code;
  failure.detail = std::move(detail);
  return {std::move(failure)};
}
inline Unexpected<Failure> fail(Budget::End end, std::string detail = {}) {
  return fail(detail::to_error(end), std::move(detail));
}

}  // namespace tutavia
