// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "tutavia/plan/failure.hpp"

/// \file
/// SpeedLimits: the kinematic limits of a robot along a curve.

namespace tutavia {

/// Kinematic limits of a robot. All but the speeds at the ends must be positive; all but the jerk
/// and the curvature rate must be finite.
struct SpeedLimits {
  double max_speed = 1;           ///< [m/s]
  double max_acceleration = 0.5;  ///< along the curve [m/s^2]
  double max_deceleration = 0.5;  ///< along the curve, as a positive number [m/s^2]
  double max_lateral_acceleration =
      0.5;  ///< across the curve: speed squared times curvature [m/s^2]
  /// Limit on the change of the acceleration along the curve [m/s^3]; infinity allows jumps.
  double max_jerk = std::numeric_limits<double>::infinity();
  /// Limit on the change of the curvature [1/(m s)], on curves of segments, arcs and clothoids;
  /// infinity allows jumps. A car whose front wheels turn by r rad/s keeps it if it is
  /// r / wheelbase.
  double max_curvature_rate = std::numeric_limits<double>::infinity();
  double start_speed = 0;  ///< [m/s]
  double end_speed = 0;    ///< upper bound at the end [m/s]
};

/// Errors: `invalid_option` for limits out of range.
inline Expected<void, Failure> validate(const SpeedLimits& limits) {
  const auto is_positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (!is_positive(limits.max_speed))
    return fail(PlanError::invalid_option, "max_speed must be positive and finite");
  if (!is_positive(limits.max_acceleration))
    return fail(PlanError::invalid_option, "max_acceleration must be positive and finite");
  if (!is_positive(limits.max_deceleration))
    return fail(PlanError::invalid_option, "max_deceleration must be positive and finite");
  if (!is_positive(limits.max_lateral_acceleration))
    return fail(PlanError::invalid_option, "max_lateral_acceleration must be positive and finite");
  if (!(limits.max_jerk > 0)) return fail(PlanError::invalid_option, "max_jerk must be positive");
  if (!(limits.max_curvature_rate > 0))
    return fail(PlanError::invalid_option, "max_curvature_rate must be positive");
  if (!(0 <= limits.start_speed && limits.start_speed <= limits.max_speed)) {
    return fail(PlanError::invalid_option, "start_speed must lie between 0 and max_speed");
  }
  if (!(limits.end_speed >= 0))
    return fail(PlanError::invalid_option, "end_speed must not be negative");
  return {};
}

}  // namespace tutavia
