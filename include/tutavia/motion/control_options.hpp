// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "tutavia/motion/differential_drive.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// ControlOptions: what a controller has to know of its robot.

namespace tutavia {

/// The robot's limits, the rhythm of its commands, and how far its odometry may err.
///
/// A command issued at time t takes effect at `t + latency` and then holds for one period. The
/// robot's true pose lies within the error bounds of the odometry at all times.
struct ControlOptions {
  DriveLimits limits{};
  double period = 0.1;        ///< between two commands [s]
  double latency = 0;         ///< until a command takes effect [s]
  double position_error = 0;  ///< bound on the odometry's error of position [m]
  double heading_error = 0;   ///< and of heading [rad]
  /// For how many periods a motion must be safe before the robot brakes. 1 is as safe as any other
  /// number; with more, the robot slows down earlier.
  int hold = 3;
};

/// The distance from obstacles that a MotionGate demands at full speed [m], for a safety radius:
/// what a path has to keep for the robot to follow it.
inline double demanded_clearance(double safety_radius, const ControlOptions& control) {
  const DriveLimits& limits = control.limits;
  const double braking = std::max(limits.fastest() / limits.max_acceleration,
                                  limits.max_angular_speed / limits.max_angular_acceleration);
  const double reach =
      limits.fastest() * (control.latency + control.period * control.hold + 0.5 * braking);
  const double error = control.position_error + control.heading_error * reach;
  return safety_radius * (1 + 1e-3) + 3 * error;
}

/// Errors: `invalid_option`, which names the option.
inline Expected<void, Failure> validate(const ControlOptions& options) {
  if (auto valid = validate(options.limits); !valid) return valid;
  const auto is_length = [](double x) { return x >= 0 && std::isfinite(x); };
  const auto invalid = [](const char* rule) { return fail(PlanError::invalid_option, rule); };
  if (!(options.period > 0 && std::isfinite(options.period)))
    return invalid("period must be positive and finite");
  const DriveLimits& limits = options.limits;
  if (!(limits.fastest() <= 1e4 * options.period * limits.max_acceleration &&
        limits.max_angular_speed <= 1e4 * options.period * limits.max_angular_acceleration)) {
    return invalid(
        "max_acceleration and max_angular_acceleration must stop the robot within 10000 "
        "periods");
  }
  if (!is_length(options.latency)) return invalid("latency must be finite and not negative");
  if (!(options.latency <= 64 * options.period))
    return invalid("latency must not exceed 64 periods");
  if (!is_length(options.position_error))
    return invalid("position_error must be finite and not negative");
  if (!is_length(options.heading_error))
    return invalid("heading_error must be finite and not negative");
  if (options.hold < 1 || options.hold > 1000) return invalid("hold must lie between 1 and 1000");
  return {};
}

}  // namespace tutavia
