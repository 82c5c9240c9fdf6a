// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "tutavia/motion/control_options.hpp"
#include "tutavia/motion/timed_elastic_band.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// LocalPlannerOptions: how a LocalPlanner follows a path.

namespace tutavia {

/// Options of a LocalPlanner.
struct LocalPlannerOptions {
  ControlOptions control{};
  /// Its limits are those of `control`. A clearance below what the gate demands is raised to that
  /// plus `margin`.
  TimedElasticBand band{.clearance = 0};
  double horizon = 3;           ///< length of a band [m]
  double margin = 0.1;          ///< room that detours leave beyond what the gate demands [m]
  double window = 6;            ///< half the side of the square in which detours are searched [m]
  double goal_tolerance = 0.1;  ///< distance from the end of the path at which to stop [m]
  double switch_gain = 0.5;     ///< how much shorter another way must be to change to it [m]
  double turn_first = 0.9;      ///< heading error beyond which the robot turns on the spot [rad]
  int search_interval = 5;      ///< least number of periods between two searches for detours
};

/// Errors: those of `validate(options.control)`; `invalid_option`, which names the option.
inline Expected<void, Failure> validate(const LocalPlannerOptions& options) {
  if (auto valid = validate(options.control); !valid) return valid;
  const auto invalid = [](const char* rule) { return fail(PlanError::invalid_option, rule); };
  if (!(options.horizon > 0 && std::isfinite(options.horizon)))
    return invalid("horizon must be positive and finite");
  if (!(options.margin >= 0 && std::isfinite(options.margin)))
    return invalid("margin must be finite and not negative");
  if (!(options.window > 0 && std::isfinite(options.window)))
    return invalid("window must be positive and finite");
  if (!(options.goal_tolerance > 0)) return invalid("goal_tolerance must be positive");
  if (!(options.switch_gain >= 0)) return invalid("switch_gain must not be negative");
  if (!(options.turn_first > 0)) return invalid("turn_first must be positive");
  if (options.search_interval < 1) return invalid("search_interval must be at least 1");
  return {};
}

}  // namespace tutavia
