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
/// Failure: a code for programs and a detail for people.

namespace tutavia {

/// Why there is no plan.
enum class PlanError {
  start_blocked,              ///< the start lies in an obstacle or its safety zone
  goal_blocked,               ///< the goal does
  start_out_of_bounds,        ///< the start lies outside the workspace
  goal_out_of_bounds,         ///< the goal does
  unreachable,                ///< proved: there is no path
  unreachable_at_resolution,  ///< no path on the lattice, or no way onto it; a finer one may have
                              ///< one
  not_proved,                 ///< a path was found, but its safety could not be proved
  budget_exhausted,           ///< the deadline or the limit of expansions was reached
  cancelled,                  ///< stopped on request
  invalid_option,             ///< an option is out of range; the detail names it
  invalid_input,              ///< the input is malformed; the detail names object and index
  limit_exceeded,             ///< the request is too large; the detail has needed and allowed sizes
};

/// The name of the code, as in result files: "start_blocked", ...
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

/// The code for a query that its budget ended.
constexpr PlanError to_error(Budget::End end) {
  return end == Budget::End::cancelled ? PlanError::cancelled : PlanError::budget_exhausted;
}

}  // namespace detail

/// The reason why there is no plan, with details.
struct Failure {
  PlanError code = PlanError::invalid_input;
  std::string detail{};  ///< one line for people
  /// start_blocked and goal_blocked: the signed clearance there [m]
  std::optional<double> clearance{};
  /// start_blocked and goal_blocked: index of the nearest obstacle
  std::optional<std::size_t> obstacle{};
  /// start_blocked and goal_blocked: the nearest point of free space, if found
  std::optional<Eigen::Vector2d> nearest_safe_point{};
  Statistics stats{};
};

inline std::ostream& operator<<(std::ostream& out, const Failure& failure) {
  out << to_string(failure.code);
  if (!failure.detail.empty()) out << ": " << failure.detail;
  return out;
}

/// Makes the error of an Expected: `return fail(PlanError::unreachable, "...")`.
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
