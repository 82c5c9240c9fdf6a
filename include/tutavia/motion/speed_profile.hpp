// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/motion/profile/curve_limits.hpp"
#include "tutavia/motion/profile/jerk_limited.hpp"
#include "tutavia/motion/profile/trapezoidal.hpp"
#include "tutavia/motion/speed_limits.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// SpeedProfile: the speed along a curve within limits.

namespace tutavia {

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
/// With a finite `max_curvature_rate` the robot drives along a clothoid only as fast as it can
/// steer. Where the curvature jumps it stops, and stands until its wheels have turned; so they do
/// at a cusp, where a vehicle changes its gear. For a VehiclePath, give its curve.
///
/// Source: Bobrow, Dubowsky and Gibson 1985, "Time-optimal control of robotic manipulators along
/// specified paths", for accelerations that do not depend on the position.
///
/// Example: examples/10_speed_profile.cpp.
class SpeedProfile {
 public:
  /// The state of the robot at one time.
  struct State {
    double time = 0;  ///< [s]
    double s = 0;     ///< arc length from the start [m]
    Point position = Point::Zero();
    double heading = 0;       ///< of the motion [rad]
    double curvature = 0;     ///< 1/m, left turns positive; where it jumps, that of either side
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

  /// Drives from stop to stop. False if the robot cannot brake from the start speed.
  bool drive(const detail::CurveLimits& along, std::span<const double> squares,
             const SpeedLimits& limits);
  detail::ProfileState state_at(double time) const;

  Curve curve_;
  double duration_ = 0;
  detail::TrapezoidalProfile phases_;  // without a jerk limit
  std::vector<Leg> legs_;              // with a jerk limit
};

inline Expected<SpeedProfile, Failure> SpeedProfile::build(Curve curve, const SpeedLimits& limits) {
  if (auto valid = validate(limits); !valid) return std::move(valid).unexpected();
  if (curve.empty()) return fail(PlanError::invalid_input, "the curve is empty");
  const auto along = detail::CurveLimits::of(curve, limits);
  if (!along.is_known) {
    return fail(PlanError::invalid_option,
                "max_curvature_rate is for curves of segments, arcs and clothoids");
  }
  for (const detail::SpeedInterval& interval : along.intervals) {
    if (interval.length > 0 && !(interval.limit > 0)) {
      return fail(PlanError::invalid_input, "the curve has a cusp, where nothing can follow it");
    }
  }
  std::vector<double> squares =
      detail::backward_pass(along.intervals, along.squares, limits.max_deceleration);
  const double start = limits.start_speed * limits.start_speed;
  if (start > squares[0] * (1 + 1e-12)) {
    return fail(PlanError::invalid_option, "start_speed is too high to brake from: at most " +
                                               std::to_string(std::sqrt(squares[0])) + " m/s");
  }
  squares[0] = std::min(start, squares[0]);
  SpeedProfile profile;
  if (!profile.drive(along, squares, limits)) {
    return fail(PlanError::invalid_option,
                "start_speed is too high to brake from with so little jerk");
  }
  profile.curve_ = std::move(curve);
  return profile;
}

inline bool SpeedProfile::drive(const detail::CurveLimits& along, std::span<const double> squares,
                                const SpeedLimits& limits) {
  const std::span<const detail::SpeedInterval> intervals = along.intervals;
  double s = 0, length = 0;
  for (std::size_t first = 0, i = 0; i < intervals.size(); ++i) {
    length += intervals[i].length;
    const bool is_last = i + 1 == intervals.size();
    if (!is_last && along.squares[i + 1] > 0) continue;
    const auto leg = intervals.subspan(first, i + 1 - first);
    if (std::isinf(limits.max_jerk)) {
      phases_.drive(leg, squares.subspan(first, leg.size() + 1), limits.max_acceleration,
                    limits.max_deceleration);
      phases_.keep(0, along.waits[i + 1]);
      duration_ = phases_.end_time();
    } else {
      if (length > 0) {
        auto drive =
            detail::JerkLimitedProfile::over(leg, s,
                                             {.max_acceleration = limits.max_acceleration,
                                              .max_deceleration = limits.max_deceleration,
                                              .max_jerk = limits.max_jerk,
                                              .start_speed = s == 0 ? limits.start_speed : 0,
                                              .end_speed = is_last ? limits.end_speed : 0});
        if (!drive) return false;
        legs_.push_back({duration_, std::move(*drive)});
        duration_ += legs_.back().drive.duration();
      }
      duration_ += along.waits[i + 1];
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
