// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "tutavia/geometry/clothoid.hpp"
#include "tutavia/geometry/pose.hpp"
#include "tutavia/geometry/steering_word.hpp"
#include "tutavia/geometry/vehicle_path.hpp"

/// \file
/// ContinuousTurn: turns that begin and end without curvature, and the circle on which they end.

namespace tutavia::detail {

/// The turns of a vehicle whose curvature starts and ends at 0: a clothoid to the largest
/// curvature, an arc, a clothoid back. Whatever the change of heading, called deflection, a turn
/// ends on one circle, whose centre does not depend on it, and leaves that circle by the angle
/// `slope` outwards. A deflection too small for two clothoids of the largest sharpness takes two
/// that are less sharp and end on the circle, too; deflection 0 is a straight move.
///
/// Where full lock would take a turn by more than pi, a smaller curvature is the largest.
///
/// Source: Fraichard and Scheuer 2004, "From Reeds and Shepp's to continuous-curvature paths",
/// section IV.
class ContinuousTurn {
 public:
  /// \pre both limits are positive and finite
  explicit ContinuousTurn(const SteeringLimits& limits)
      : curvature_(std::fmin((1 - 0x1p-50) / limits.min_turning_radius,
                             std::sqrt(std::numbers::pi * limits.max_sharpness))),
        spiral_(curvature_ / limits.max_sharpness),
        spiral_turn_(0.5 * curvature_ * spiral_) {
    const Point end = Clothoid::from(Point::Zero(), 0, 0, curvature_ / spiral_, spiral_).b;
    ahead_ = end.x() - std::sin(spiral_turn_) / curvature_;
    beside_ = end.y() + std::cos(spiral_turn_) / curvature_;
    radius_ = std::sqrt(ahead_ * ahead_ + beside_ * beside_);
    slope_ = std::atan2(ahead_, beside_);
  }

  /// The centre of the circle from a pose: radius() sin(slope) ahead, radius() cos(slope) beside.
  double ahead() const { return ahead_; }
  double beside() const { return beside_; }
  double radius() const { return radius_; }

  /// The length of a turn [m]. \pre 0 <= deflection < 2 pi
  double length(double deflection) const {
    if (deflection < 2 * spiral_turn_) return 2 * half_length(deflection);
    return 2 * spiral_ + (deflection - 2 * spiral_turn_) / curvature_;
  }

  /// Appends a turn from a pose, and returns the pose at its end. The deflection is the length of
  /// the move. If `end` is given, the turn ends there; its numbers stay as they are.
  /// \pre 0 < |move.length| < 2 pi; the move is no straight one
  Pose append(const Pose& from, const SteeringMove& move, VehiclePath& path,
              const std::optional<Point>& end = std::nullopt) const {
    const Gear gear = gear_of(move.length);
    const double deflection = std::abs(move.length);
    const double direction = from.heading + (gear == Gear::forward ? 0 : std::numbers::pi);
    const double side = move.turn() < 0 ? -1 : 1;  // of the centre, for the direction of travel
    const double turned = std::fmin(deflection / 2, spiral_turn_);
    const double length = deflection < 2 * spiral_turn_ ? half_length(deflection) : spiral_;
    const double curvature =
        side * (deflection < 2 * spiral_turn_ ? deflection / length : curvature_);
    const double sharpness = curvature / length;
    const Clothoid in = Clothoid::from(from.position, direction, 0, sharpness, length);
    path.push_back(in, gear);
    double heading = direction + side * turned;
    Point position = in.b;
    const double rest = deflection - 2 * turned;
    if (rest > steering_rounding) {
      const SteeringMove arc{side < 0 ? Steering::right : Steering::left, rest};
      path.push_back(turn_from({position, heading}, arc, 1 / curvature_), gear);
      position = path.curve.end();
      heading += side * rest;
    }
    Clothoid out = Clothoid::from(position, heading, curvature, -sharpness, length);
    if (end) out.b = *end;
    path.push_back(out, gear);
    return {out.b, from.heading + move.turn()};
  }

 private:
  /// The length of one of the two clothoids of a deflection without arc: their chord is that of the
  /// circle. The chord over both lengths is the integral of cos(d / 2 (1 - u^2)) over u in [0, 1],
  /// by its power series. \pre 0 <= deflection <= pi
  double half_length(double deflection) const {
    const double half = 0.5 * deflection, square = half * half;
    double term = 1, chord = 0;
    for (int n = 0; n < 14; ++n) {  // term: (-1)^n half^(2n) / (2n)! times the integral
      chord += term;
      const double k = 2 * n + 1;
      term *= -square / (k * (k + 1)) * (2 * k / (2 * k + 1)) * (2 * (k + 1) / (2 * (k + 1) + 1));
    }
    return radius_ * std::sin(half + slope_) / chord;
  }

  double curvature_;    // the largest [1/m]
  double spiral_;       // length of the sharpest clothoid to it [m]
  double spiral_turn_;  // change of heading along that [rad]
  double ahead_ = 0, beside_ = 0, radius_ = 0, slope_ = 0;
};

}  // namespace tutavia::detail
