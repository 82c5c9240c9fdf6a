// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tutavia/geometry/piece.hpp"
#include "tutavia/geometry/pose.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// The motion of a robot with differential drive: twists, their arcs, and limits.

namespace tutavia {

/// A command: how fast the robot drives and turns.
struct Twist {
  double v = 0;      ///< along its heading [m/s], negative backwards
  double omega = 0;  ///< [rad/s], left turns positive

  bool is_zero() const { return v == 0 && omega == 0; }
};

/// What a robot with differential drive can do. The defaults are those of Roesmann et al. 2012 for
/// a slow indoor robot. Speeds change from one command to the next by at most the acceleration
/// times the period of control.
struct DriveLimits {
  double max_speed = 0.4;                 ///< [m/s]
  double max_backward_speed = 0;          ///< [m/s]; 0: the robot does not reverse
  double max_angular_speed = 0.3;         ///< [rad/s]
  double max_acceleration = 0.5;          ///< and deceleration [m/s^2]
  double max_angular_acceleration = 0.5;  ///< [rad/s^2]

  /// The greatest speed in either direction [m/s].
  double fastest() const { return std::max(max_speed, max_backward_speed); }
};

/// Errors: `invalid_option` for a limit that is not positive and finite (0 is valid for the
/// backward speed alone).
inline Expected<void, Failure> validate(const DriveLimits& limits) {
  const auto check = [](double value, bool may_be_zero) {
    return std::isfinite(value) && (value > 0 || (may_be_zero && value == 0));
  };
  const auto invalid = [](const char* name) {
    return fail(PlanError::invalid_option, std::string(name) + " must be positive and finite");
  };
  if (!check(limits.max_speed, false)) return invalid("max_speed");
  if (!check(limits.max_backward_speed, true)) return invalid("max_backward_speed");
  if (!check(limits.max_angular_speed, false)) return invalid("max_angular_speed");
  if (!check(limits.max_acceleration, false)) return invalid("max_acceleration");
  if (!check(limits.max_angular_acceleration, false)) return invalid("max_angular_acceleration");
  return {};
}

/// The path of a robot that keeps a twist for some time [s]: a segment, an arc, or a point if it
/// turns on the spot. An arc of more than a full turn is cut to a full turn, which covers it.
inline Piece path_of(const Pose& from, const Twist& twist, double time) {
  const Point& p = from.position;
  const Point ahead{std::cos(from.heading), std::sin(from.heading)};
  const double sweep = twist.omega * time;
  if (twist.v == 0 || sweep == 0) {
    return Segment{p, twist.v == 0 ? p : detail::offset_along(p, twist.v * time, ahead)};
  }
  const double signed_radius = twist.v / twist.omega;
  const Point center{p.x() - signed_radius * ahead.y(), p.y() + signed_radius * ahead.x()};
  const double quarter = std::copysign(std::numbers::pi / 2, signed_radius);
  const double full = 2 * std::numbers::pi;
  Arc arc = Arc::around(center, std::abs(signed_radius), from.heading - quarter,
                        std::clamp(sweep, -full, full));
  arc.a = p;
  return arc;
}

/// Where a robot that keeps a twist is after some time [s].
inline Pose moved(const Pose& from, const Twist& twist, double time) {
  const double turn = twist.omega * time;
  // The chord of an arc has the direction halfway, and is shorter than the arc by sin(x) / x.
  const double half = 0.5 * turn;
  const double shortening = std::abs(half) < 1e-4 ? 1 - half * half / 6 : std::sin(half) / half;
  const double chord = twist.v * time * shortening;
  const Point direction{std::cos(from.heading + half), std::sin(from.heading + half)};
  return {detail::offset_along(from.position, chord, direction), from.heading + turn};
}

}  // namespace tutavia
