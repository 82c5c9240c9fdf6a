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
/// SpeedProfile: the speed along a curve within limits.

namespace tutavia {

/// Kinematic limits of a robot. All but the speeds at the ends must be positive; all but the jerk
/// must be finite.
struct SpeedLimits {
  double max_speed = 1;           ///< [m/s]
  double max_acceleration = 0.5;  ///< along the curve [m/s^2]
  double max_deceleration = 0.5;  ///< along the curve, as a positive number [m/s^2]
  double max_lateral_acceleration =
      0.5;  ///< across the curve: speed squared times curvature [m/s^2]
  /// Limit on the change of the acceleration along the curve [m/s^3]; infinity allows jumps.
  double max_jerk = std::numeric_limits<double>::infinity();
  double start_speed = 0;  ///< [m/s]
  double end_speed = 0;    ///< upper bound at the end [m/s]
};

/// A curve with a speed profile. The limits hold everywhere on the curve, not only at samples.
///
/// The curve is cut into intervals. A closed-form bound on the curvature of each interval bounds
/// its speed. At constant acceleration the squared speed is linear in arc length: a backward and a
/// forward pass give the speeds at the interval boundaries, and within an interval the robot
/// accelerates, cruises and brakes. It stops at corners, where the direction jumps. The profile is
/// time-optimal under these bounds. O(n) for n pieces.
///
/// With a finite `max_jerk` the acceleration is continuous, and 0 at both ends and at stops.
/// Between stops the motion is then a moving average of a trapezoidal one (see JerkLimitedProfile).
/// It is slower than the time-optimal motion: on a long straight line from rest to rest, the jerk
/// limit adds (a + b) / max_jerk, twice as much as for the optimum, and the robot slows down
/// somewhat before and after bends. O(n log n) for n pieces.
///
/// Source: Bobrow, Dubowsky and Gibson 1985, "Time-optimal control of robotic manipulators along
/// specified paths", for accelerations that do not depend on the position.
///
/// Example: examples/speed_profile.cpp.
class SpeedProfile {
 public:
  /// The state of the robot at one time.
  struct State {
    double time = 0;  ///< [s]
    double s = 0;     ///< arc length from the start [m]
    Point position = Point::Zero();
    double heading = 0;       ///< [rad]
    double curvature = 0;     ///< 1/m, left turns positive
    double speed = 0;         ///< [m/s]
    double acceleration = 0;  ///< along the curve [m/s^2]
  };

  /// Errors: `invalid_option` for limits out of range and for a start speed from which the robot
  /// cannot brake in time (with a finite jerk: from which this kind of motion cannot);
  /// `invalid_input` for a curve that is empty or has a cusp, which no speed can follow.
  static Expected<SpeedProfile, Failure> build(Curve curve, const SpeedLimits& limits);

  const Curve& curve() const { return curve_; }
  /// Duration of the whole motion [s].
  double duration() const { return duration_; }
  /// The state at a time [s], clamped to the duration.
  State at(double time) const;
  /// The states at equal steps of time, at most `step` apart, both ends included. \pre step > 0
  std::vector<State> sample(double step) const;

 private:
  /// A part of the curve from one stop to the next.
  struct Leg {
    double time;  // at its start
    detail::JerkLimitedProfile drive;
  };

  static Expected<void, Failure> check(const SpeedLimits& limits);
  static std::vector<detail::SpeedInterval> intervals_of(const Curve& curve,
                                                         const SpeedLimits& limits);
  /// The squared speed limits at the interval boundaries.
  static std::vector<double> boundary_speed_limits(
      const Curve& curve, const SpeedLimits& limits,
      const std::vector<detail::SpeedInterval>& intervals);
  /// False if the robot cannot brake from the start speed.
  bool add_legs(std::span<const detail::SpeedInterval> intervals,
                std::span<const double> boundary_speed_limits, const SpeedLimits& limits);
  detail::ProfileState state_at(double time) const;

  /// Pieces along which the curvature changes are cut into several intervals.
  template <class P>
  static constexpr std::size_t parts_of(const P&) {
    return std::is_same_v<P, Segment> || std::is_same_v<P, Arc> ? 1 : 8;
  }

  Curve curve_;
  double duration_ = 0;
  detail::TrapezoidalProfile phases_;  // without a jerk limit
  std::vector<Leg> legs_;              // with a jerk limit
};

inline Expected<void, Failure> SpeedProfile::check(const SpeedLimits& limits) {
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
  if (!(0 <= limits.start_speed && limits.start_speed <= limits.max_speed)) {
    return fail(PlanError::invalid_option, "start_speed must lie between 0 and max_speed");
  }
  if (!(limits.end_speed >= 0))
    return fail(PlanError::invalid_option, "end_speed must not be negative");
  return {};
}

inline std::vector<detail::SpeedInterval> SpeedProfile::intervals_of(const Curve& curve,
                                                                     const SpeedLimits& limits) {
  std::vector<detail::SpeedInterval> result;
  const auto add = [&](double length, double curvature) {
    result.push_back({length, std::min(limits.max_speed * limits.max_speed,
                                       limits.max_lateral_acceleration / curvature)});
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

inline std::vector<double> SpeedProfile::boundary_speed_limits(
    const Curve& curve, const SpeedLimits& limits,
    const std::vector<detail::SpeedInterval>& intervals) {
  std::vector<double> squares = tutavia::detail::boundary_speed_limits(intervals);
  squares.back() = std::min(squares.back(), limits.end_speed * limits.end_speed);
  Point before = Point::Zero();
  std::size_t at = 0;
  for (const Piece& piece : curve.pieces()) {
    const auto direction = [&](bool end) {
      return piece.visit(
          [&](const auto& p) -> Point { return end ? p.end_direction() : p.start_direction(); });
    };
    if (!detail::is_zero(direction(false))) {
      const bool is_corner =
          !detail::is_zero(before) && std::abs(turn_angle(before, direction(false))) > 1e-6;
      if (is_corner) squares[at] = 0;
      before = direction(true);
    }
    at += piece.visit([](const auto& p) { return parts_of(p); });
  }
  return squares;
}

inline Expected<SpeedProfile, Failure> SpeedProfile::build(Curve curve, const SpeedLimits& limits) {
  if (auto valid = check(limits); !valid) return std::move(valid).unexpected();
  if (curve.empty()) return fail(PlanError::invalid_input, "the curve is empty");
  const std::vector<detail::SpeedInterval> intervals = intervals_of(curve, limits);
  for (const detail::SpeedInterval& interval : intervals) {
    if (interval.length > 0 && !(interval.limit > 0)) {
      return fail(PlanError::invalid_input, "the curve has a cusp, where nothing can follow it");
    }
  }
  const std::vector<double> most = boundary_speed_limits(curve, limits, intervals);
  std::vector<double> squares = detail::backward_pass(intervals, most, limits.max_deceleration);
  const double start = limits.start_speed * limits.start_speed;
  if (start > squares[0] * (1 + 1e-12)) {
    return fail(PlanError::invalid_option, "start_speed is too high to brake from: at most " +
                                               std::to_string(std::sqrt(squares[0])) + " m/s");
  }
  squares[0] = std::min(start, squares[0]);
  SpeedProfile profile;
  if (std::isinf(limits.max_jerk)) {
    profile.phases_.drive(intervals, squares, limits.max_acceleration, limits.max_deceleration);
    profile.duration_ = profile.phases_.end_time();
  } else if (!profile.add_legs(intervals, most, limits)) {
    return fail(PlanError::invalid_option,
                "start_speed is too high to brake from with so little jerk");
  }
  profile.curve_ = std::move(curve);
  return profile;
}

inline bool SpeedProfile::add_legs(std::span<const detail::SpeedInterval> intervals,
                                   std::span<const double> boundary_speed_limits,
                                   const SpeedLimits& limits) {
  double s = 0, length = 0;
  for (std::size_t first = 0, i = 0; i < intervals.size(); ++i) {
    length += intervals[i].length;
    const bool is_last = i + 1 == intervals.size();
    if (!is_last && boundary_speed_limits[i + 1] > 0) continue;
    if (length > 0) {
      auto drive = detail::JerkLimitedProfile::over(intervals.subspan(first, i + 1 - first), s,
                                                    {.max_acceleration = limits.max_acceleration,
                                                     .max_deceleration = limits.max_deceleration,
                                                     .max_jerk = limits.max_jerk,
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

inline detail::ProfileState SpeedProfile::state_at(double time) const {
  if (legs_.empty()) return phases_.at(time);
  const auto after = std::upper_bound(legs_.begin() + 1, legs_.end(), time,
                                      [](double t, const Leg& leg) { return t < leg.time; });
  const Leg& leg = *(after - 1);
  return leg.drive.at(std::clamp(time - leg.time, 0.0, leg.drive.duration()));
}

inline SpeedProfile::State SpeedProfile::at(double time) const {
  State point;
  point.time = std::clamp(time, 0.0, duration());
  const detail::ProfileState state = state_at(point.time);
  // The sum of the intervals may differ from the length by rounding.
  point.s = time >= duration() ? curve_.length() : std::min(state.s, curve_.length());
  point.speed = state.speed;
  point.acceleration = state.acceleration;
  const CurvePoint on_curve = curve_.at(point.s);
  point.position = on_curve.position;
  point.heading = on_curve.heading;
  point.curvature = on_curve.curvature;
  return point;
}

inline std::vector<SpeedProfile::State> SpeedProfile::sample(double step) const {
  TUTAVIA_ASSERT(step > 0);
  const auto count = static_cast<std::size_t>(std::ceil(duration() / step));
  std::vector<State> states;
  states.reserve(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    states.push_back(at(duration() * static_cast<double>(i) / static_cast<double>(count)));
  }
  states.push_back(at(duration()));
  return states;
}

}  // namespace tutavia
