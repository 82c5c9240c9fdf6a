// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "tutavia/core/random.hpp"
#include "tutavia/geometry/pose.hpp"

/// \file
/// OdometryNoise: errors of odometry within bounds.

namespace drive_program {

using namespace tutavia;

/// Disturbs poses by a slow drift and a jitter. Their sum never exceeds the bounds: the drift is a
/// random walk that stays within 0.7 of them, the jitter is uniform within 0.3.
class OdometryNoise {
 public:
  /// Bounds [m] and [rad]; 0: no error.
  OdometryNoise(double position_error, double heading_error, std::uint64_t seed)
      : position_error_(position_error), heading_error_(heading_error), random_(seed) {}

  /// What odometry reports of a pose; another value at every call.
  Pose disturbed(const Pose& pose) {
    drift_ = within(Point(drift_ + in_disc(0.1)), drift_share);
    turn_ = std::clamp(turn_ + random_.uniform(-0.1, 0.1), -drift_share, drift_share);
    const Point off = within(Point(drift_ + in_disc(1 - drift_share)), almost_one);
    const double turn = turn_ + random_.uniform(-1, 1) * (1 - drift_share);
    return {pose.position + position_error_ * off,
            pose.heading + heading_error_ * std::clamp(turn, -almost_one, almost_one)};
  }

 private:
  static constexpr double drift_share = 0.7;
  static constexpr double almost_one = 1 - 1e-9;  // the rest is for rounding

  static Point within(const Point& p, double radius) {
    const double length = p.norm();
    return length > radius ? Point(radius / length * p) : p;
  }
  Point in_disc(double radius) {
    const double angle = random_.uniform(0, 2 * std::numbers::pi);
    const double distance = radius * std::sqrt(random_.uniform());
    return {distance * std::cos(angle), distance * std::sin(angle)};
  }

  double position_error_;
  double heading_error_;
  Random random_;
  Point drift_ = Point::Zero();  // in units of the bound
  double turn_ = 0;              // the same
};

}  // namespace drive_program
