// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/motion/profile/jerk_limited.hpp"
#include "tutavia/motion/profile/trapezoidal.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// SpeedProfile: how fast to drive along a curve within limits.

namespace tutavia {

/// What a robot can do. All but the speeds at the ends must be positive, all but the jerk finite.
struct SpeedLimits {
  double speed = 1;           ///< [m/s]
  double acceleration = 0.5;  ///< along the curve [m/s^2]
  double braking = 0.5;       ///< along the curve, as a positive number [m/s^2]
  double lateral = 0.5;       ///< across the curve: speed squared times curvature [m/s^2]
  /// How fast the acceleration along the curve may change [m/s^3]; infinity: in jumps.
  double jerk = std::numeric_limits<double>::infinity();
  double start_speed = 0;  ///< [m/s]
  double end_speed = 0;    ///< at most this at the end [m/s]
};

/// What a robot does at one time on its way.
struct TimedPoint {
  double time = 0;  ///< [s]
  double s = 0;     ///< arc length from the start [m]
  Point position = Point::Zero();
  double heading = 0;       ///< [rad]
  double curvature = 0;     ///< 1/m, left turns positive
  double speed = 0;         ///< [m/s]
  double acceleration = 0;  ///< along the curve [m/s^2]
};

/// A curve with the speed along it, within limits that hold everywhere on the curve, not only at
/// samples.
///
/// The curve is cut into intervals, each with a bound on its curvature in closed form and so on its
/// speed. Over the square of the speed a constant acceleration is a straight line: one pass forward
/// and one backward give the speeds at the ends of the intervals, and within an interval the robot
/// accelerates, keeps its speed and brakes. At corners, where the direction jumps, it stops. As
/// fast as these bounds allow; O(n) for n pieces.
///
/// With a finite `jerk` the acceleration is continuous, too, and 0 at both ends and at stops. From
/// stop to stop the robot then drives an average over time of such a motion (see EasedDrive), which
/// takes longer than the fastest motion within the limits: on a long straight line from rest to
/// rest (a + b) / jerk more than without that limit, where the fastest takes half of that; and
/// bends slow it down somewhat before and after them. O(n log n) for n pieces.
///
/// Source: Bobrow, Dubowsky and Gibson 1985, "Time-optimal control of robotic manipulators along
/// specified paths", for accelerations that do not depend on the place.
class SpeedProfile {
 public:
  /// `invalid_option` for limits that are out of range and for a start speed from which the robot
  /// cannot brake in time (with a finite jerk: from which this motion cannot), `invalid_input` for
  /// a curve that is empty or cannot be followed at any speed: one with a cusp.
  static Expected<SpeedProfile, Failure> build(Curve curve, const SpeedLimits& limits);

  const Curve& curve() const { return curve_; }
  /// Of the whole way [s].
  double duration() const { return duration_; }
  /// The state at a time; before the start and after the end, the states there.
  TimedPoint at(double time) const;
  /// The states at equal steps of time, at most `step` apart, both ends included. \pre step > 0
  std::vector<TimedPoint> sample(double step) const;

 private:
  /// A part of the way from one stop to the next.
  struct Leg {
    double time;  // at its start
    detail::EasedDrive drive;
  };

  static const char* invalid_option(const SpeedLimits& limits);
  static std::vector<detail::SpeedStretch> intervals(const Curve& curve, const SpeedLimits& limits);
  /// Squares of the speed limits where intervals meet and at both ends.
  static std::vector<double> joint_limits(const Curve& curve, const SpeedLimits& limits,
                                          const std::vector<detail::SpeedStretch>& intervals);
  /// False where it cannot brake from the start speed.
  bool add_legs(std::span<const detail::SpeedStretch> stretches,
                std::span<const double> joint_limits, const SpeedLimits& limits);
  detail::DriveState state_at(double time) const;

  /// Pieces along which the curvature changes are cut into several intervals.
  template <class P>
  static constexpr std::size_t parts_of(const P&) {
    return std::is_same_v<P, Segment> || std::is_same_v<P, Arc> ? 1 : 8;
  }

  Curve curve_;
  double duration_ = 0;
  detail::DrivePhases phases_;  // without a limit of jerk
  std::vector<Leg> legs_;       // with one
};

inline const char* SpeedProfile::invalid_option(const SpeedLimits& limits) {
  const auto is_positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (!is_positive(limits.speed)) return "speed must be positive and finite";
  if (!is_positive(limits.acceleration)) return "acceleration must be positive and finite";
  if (!is_positive(limits.braking)) return "braking must be positive and finite";
  if (!is_positive(limits.lateral)) return "lateral must be positive and finite";
  if (!(limits.jerk > 0)) return "jerk must be positive";
  if (!(0 <= limits.start_speed && limits.start_speed <= limits.speed)) {
    return "start_speed must lie between 0 and speed";
  }
  if (!(limits.end_speed >= 0)) return "end_speed must not be negative";
  return nullptr;
}

inline std::vector<detail::SpeedStretch> SpeedProfile::intervals(const Curve& curve,
                                                                 const SpeedLimits& limits) {
  std::vector<detail::SpeedStretch> result;
  const auto add = [&](double length, double curvature) {
    result.push_back({length, std::min(limits.speed * limits.speed, limits.lateral / curvature)});
  };
  for (const Piece& piece : curve.pieces()) {
    piece.visit([&](const auto& p) {
      const std::size_t parts = parts_of(p);
      if (parts == 1) return add(p.length(), max_curvature(p));
      for (std::size_t i = 0; i < parts; ++i) {
        const auto part = p.part(double(i) / double(parts), double(i + 1) / double(parts));
        add(part.length(), max_curvature(part));
      }
    });
  }
  return result;
}

inline std::vector<double> SpeedProfile::joint_limits(
    const Curve& curve, const SpeedLimits& limits,
    const std::vector<detail::SpeedStretch>& intervals) {
  std::vector<double> squares = tutavia::detail::joint_limits(intervals);
  squares.back() = std::min(squares.back(), limits.end_speed * limits.end_speed);
  Point before = Point::Zero();
  std::size_t at = 0;
  for (const Piece& piece : curve.pieces()) {
    const auto direction = [&](bool end) {
      return piece.visit(
          [&](const auto& p) -> Point { return end ? p.end_direction() : p.start_direction(); });
    };
    if (!is_null(direction(false))) {
      const bool is_corner =
          !is_null(before) && std::abs(deflection(before, direction(false))) > 1e-6;
      if (is_corner) squares[at] = 0;
      before = direction(true);
    }
    at += piece.visit([](const auto& p) { return parts_of(p); });
  }
  return squares;
}

inline Expected<SpeedProfile, Failure> SpeedProfile::build(Curve curve, const SpeedLimits& limits) {
  if (const char* option = invalid_option(limits)) return fail(PlanError::invalid_option, option);
  if (curve.empty()) return fail(PlanError::invalid_input, "the curve is empty");
  const std::vector<detail::SpeedStretch> stretches = intervals(curve, limits);
  for (const detail::SpeedStretch& stretch : stretches) {
    if (stretch.length > 0 && !(stretch.limit > 0)) {
      return fail(PlanError::invalid_input, "the curve has a cusp, where nothing can follow it");
    }
  }
  const std::vector<double> most = joint_limits(curve, limits, stretches);
  std::vector<double> squares = detail::squares_to_brake_from(stretches, most, limits.braking);
  const double start = limits.start_speed * limits.start_speed;
  if (start > squares[0] * (1 + 1e-12)) {
    return fail(PlanError::invalid_option, "start_speed is too high to brake from: at most " +
                                               std::to_string(std::sqrt(squares[0])) + " m/s");
  }
  squares[0] = std::min(start, squares[0]);
  SpeedProfile profile;
  if (std::isinf(limits.jerk)) {
    profile.phases_.drive(stretches, squares, limits.acceleration, limits.braking);
    profile.duration_ = profile.phases_.end_time();
  } else if (!profile.add_legs(stretches, most, limits)) {
    return fail(PlanError::invalid_option,
                "start_speed is too high to brake from with so little jerk");
  }
  profile.curve_ = std::move(curve);
  return profile;
}

inline bool SpeedProfile::add_legs(std::span<const detail::SpeedStretch> stretches,
                                   std::span<const double> joint_limits,
                                   const SpeedLimits& limits) {
  double s = 0, length = 0;
  for (std::size_t first = 0, i = 0; i < stretches.size(); ++i) {
    length += stretches[i].length;
    const bool is_last = i + 1 == stretches.size();
    if (!is_last && joint_limits[i + 1] > 0) continue;
    if (length > 0) {
      auto drive = detail::EasedDrive::over(stretches.subspan(first, i + 1 - first), s,
                                            {.acceleration = limits.acceleration,
                                             .braking = limits.braking,
                                             .jerk = limits.jerk,
                                             .start_speed = s == 0 ? limits.start_speed : 0,
                                             .end_speed = is_last ? limits.end_speed : 0});
      if (!drive) return false;
      legs_.push_back({duration_, std::move(*drive)});
      duration_ += legs_.back().drive.duration();
    }
    first = i + 1;
    s += length;
    length = 0;
  }
  return true;
}

inline detail::DriveState SpeedProfile::state_at(double time) const {
  if (legs_.empty()) return phases_.at(time);
  const auto after = std::upper_bound(legs_.begin() + 1, legs_.end(), time,
                                      [](double t, const Leg& leg) { return t < leg.time; });
  const Leg& leg = *(after - 1);
  return leg.drive.at(std::clamp(time - leg.time, 0.0, leg.drive.duration()));
}

inline TimedPoint SpeedProfile::at(double time) const {
  TimedPoint point;
  point.time = std::clamp(time, 0.0, duration());
  const detail::DriveState state = state_at(point.time);
  // What the intervals add up to may differ from the length by rounding.
  point.s = time >= duration() ? curve_.length() : std::min(state.s, curve_.length());
  point.speed = state.speed;
  point.acceleration = state.acceleration;
  const CurvePoint place = curve_.at(point.s);
  point.position = place.position;
  point.heading = place.heading;
  point.curvature = place.curvature;
  return point;
}

inline std::vector<TimedPoint> SpeedProfile::sample(double step) const {
  TUTAVIA_ASSERT(step > 0);
  const auto count = static_cast<std::size_t>(std::ceil(duration() / step));
  std::vector<TimedPoint> states;
  states.reserve(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    states.push_back(at(duration() * static_cast<double>(i) / static_cast<double>(count)));
  }
  states.push_back(at(duration()));
  return states;
}

}  // namespace tutavia
