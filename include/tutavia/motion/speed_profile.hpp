// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/core/error.hpp"
#include "tutavia/geometry/curve.hpp"

/// \file
/// SpeedProfile: the fastest way along a curve within limits.

namespace tutavia {

/// What a robot can do. All but the speeds at the ends must be positive and finite.
struct SpeedLimits {
  double speed = 1;           ///< [m/s]
  double acceleration = 0.5;  ///< along the curve [m/s^2]
  double braking = 0.5;       ///< along the curve, as a positive number [m/s^2]
  double lateral = 0.5;       ///< across the curve: speed squared times curvature [m/s^2]
  double start_speed = 0;     ///< [m/s]
  double end_speed = 0;       ///< at most this at the end [m/s]
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

/// A curve with the speed along it: as fast as the limits allow, which hold everywhere on the
/// curve, not only at samples.
///
/// The curve is cut into intervals, each with a bound on its curvature in closed form and so on its
/// speed. Over the square of the speed a constant acceleration is a straight line: one pass forward
/// and one backward give the speeds at the ends of the intervals, and within an interval the robot
/// accelerates, keeps its speed and brakes. At corners, where the direction jumps, it stops. O(n)
/// for n pieces.
///
/// Source: Bobrow, Dubowsky and Gibson 1985, "Time-optimal control of robotic manipulators along
/// specified paths", for accelerations that do not depend on the place.
class SpeedProfile {
 public:
  /// `invalid_option` for limits that are out of range and for a start speed from which the robot
  /// cannot brake in time, `invalid_input` for a curve that is empty or cannot be followed at any
  /// speed: one with a cusp.
  static Expected<SpeedProfile, Failure> build(Curve curve, const SpeedLimits& limits);

  const Curve& curve() const { return curve_; }
  /// Of the whole way [s].
  double duration() const {
    return phases_.empty() ? 0 : phases_.back().time + phases_.back().duration;
  }
  /// The state at a time; before the start and after the end, the states there.
  TimedPoint at(double time) const;
  /// The states at equal steps of time, at most `step` apart, both ends included. \pre step > 0
  std::vector<TimedPoint> sample(double step) const;

 private:
  /// A stretch of constant acceleration.
  struct Phase {
    double time, s, speed, acceleration, duration;

    /// Arc length at t after its start.
    double s_after(double t) const { return s + t * (speed + 0.5 * acceleration * t); }
  };
  /// A stretch with a limit on the square of the speed.
  struct Interval {
    double length, limit;
  };

  static const char* invalid_option(const SpeedLimits& limits);
  static std::vector<Interval> intervals(const Curve& curve, const SpeedLimits& limits);
  /// Squares of the speed limits where intervals meet and at both ends.
  static std::vector<double> joint_limits(const Curve& curve, const SpeedLimits& limits,
                                          const std::vector<Interval>& intervals);
  void append(double from, double to, const Interval& interval, const SpeedLimits& limits);
  void append_phase(double length, double from, double to, double acceleration);

  /// Pieces along which the curvature changes are cut into several intervals.
  template <class P>
  static constexpr std::size_t parts_of(const P&) {
    return std::is_same_v<P, Segment> || std::is_same_v<P, Arc> ? 1 : 8;
  }

  Curve curve_;
  std::vector<Phase> phases_;
};

inline const char* SpeedProfile::invalid_option(const SpeedLimits& limits) {
  const auto is_positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (!is_positive(limits.speed)) return "speed must be positive and finite";
  if (!is_positive(limits.acceleration)) return "acceleration must be positive and finite";
  if (!is_positive(limits.braking)) return "braking must be positive and finite";
  if (!is_positive(limits.lateral)) return "lateral must be positive and finite";
  if (!(0 <= limits.start_speed && limits.start_speed <= limits.speed)) {
    return "start_speed must lie between 0 and speed";
  }
  if (!(limits.end_speed >= 0)) return "end_speed must not be negative";
  return nullptr;
}

inline std::vector<SpeedProfile::Interval> SpeedProfile::intervals(const Curve& curve,
                                                                   const SpeedLimits& limits) {
  std::vector<Interval> result;
  const auto add = [&](double length, double curvature) {
    result.push_back({length, std::min(limits.speed * limits.speed, limits.lateral / curvature)});
  };
  for (const Piece& piece : curve.pieces()) {
    std::visit(
        [&](const auto& p) {
          const std::size_t parts = parts_of(p);
          if (parts == 1) return add(p.length(), max_curvature(p));
          for (std::size_t i = 0; i < parts; ++i) {
            const auto part = p.part(double(i) / double(parts), double(i + 1) / double(parts));
            add(part.length(), max_curvature(part));
          }
        },
        piece);
  }
  return result;
}

inline std::vector<double> SpeedProfile::joint_limits(const Curve& curve, const SpeedLimits& limits,
                                                      const std::vector<Interval>& intervals) {
  std::vector<double> squares(intervals.size() + 1, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    squares[i] = std::min(squares[i], intervals[i].limit);
    squares[i + 1] = intervals[i].limit;
  }
  squares.back() = std::min(squares.back(), limits.end_speed * limits.end_speed);
  Point before = Point::Zero();
  std::size_t at = 0;
  for (const Piece& piece : curve.pieces()) {
    const auto direction = [&](bool end) {
      return std::visit(
          [&](const auto& p) -> Point { return end ? p.end_direction() : p.start_direction(); },
          piece);
    };
    if (!is_null(direction(false))) {
      const bool is_corner =
          !is_null(before) && std::abs(deflection(before, direction(false))) > 1e-6;
      if (is_corner) squares[at] = 0;
      before = direction(true);
    }
    at += std::visit([](const auto& p) { return parts_of(p); }, piece);
  }
  return squares;
}

inline Expected<SpeedProfile, Failure> SpeedProfile::build(Curve curve, const SpeedLimits& limits) {
  if (const char* option = invalid_option(limits)) return fail(PlanError::invalid_option, option);
  if (curve.empty()) return fail(PlanError::invalid_input, "the curve is empty");
  const std::vector<Interval> stretches = intervals(curve, limits);
  std::vector<double> squares = joint_limits(curve, limits, stretches);
  const double start = limits.start_speed * limits.start_speed;
  for (std::size_t i = stretches.size(); i-- > 0;) {
    squares[i] = std::min(squares[i], squares[i + 1] + 2 * limits.braking * stretches[i].length);
  }
  if (start > squares[0] * (1 + 1e-12)) {
    return fail(PlanError::invalid_option, "start_speed is too high to brake from: at most " +
                                               std::to_string(std::sqrt(squares[0])) + " m/s");
  }
  squares[0] = std::min(start, squares[0]);
  SpeedProfile profile;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Interval& stretch = stretches[i];
    if (stretch.length > 0 && !(stretch.limit > 0)) {
      return fail(PlanError::invalid_input, "the curve has a cusp, where nothing can follow it");
    }
    squares[i + 1] =
        std::min(squares[i + 1], squares[i] + 2 * limits.acceleration * stretch.length);
    profile.append(squares[i], squares[i + 1], stretch, limits);
  }
  profile.curve_ = std::move(curve);
  return profile;
}

/// Accelerates from one square of the speed to the largest that leaves room to brake to the other.
inline void SpeedProfile::append(double from, double to, const Interval& interval,
                                 const SpeedLimits& limits) {
  if (!(interval.length > 0)) return;
  const double a = limits.acceleration, b = limits.braking;
  const double reachable = (b * from + a * to + 2 * a * b * interval.length) / (a + b);
  const double peak = std::max({std::min(reachable, interval.limit), from, to});
  const double up = (peak - from) / (2 * a), down = (peak - to) / (2 * b);
  append_phase(up, from, peak, a);
  append_phase(interval.length - up - down, peak, peak, 0);
  append_phase(down, peak, to, -b);
}

inline void SpeedProfile::append_phase(double length, double from, double to, double acceleration) {
  if (!(length > 0)) return;
  const double speed = std::sqrt(from), mean = 0.5 * (speed + std::sqrt(to));
  if (!(mean > 0)) return;
  const double s = phases_.empty() ? 0 : phases_.back().s_after(phases_.back().duration);
  phases_.push_back({duration(), s, speed, acceleration, length / mean});
}

inline TimedPoint SpeedProfile::at(double time) const {
  TimedPoint state;
  state.time = std::clamp(time, 0.0, duration());
  if (!phases_.empty()) {
    const auto after =
        std::upper_bound(phases_.begin() + 1, phases_.end(), state.time,
                         [](double t, const Phase& phase) { return t < phase.time; });
    const Phase& phase = *(after - 1);
    const double t = std::min(state.time - phase.time, phase.duration);
    state.s = phase.s_after(t);
    state.speed = std::max(0.0, phase.speed + phase.acceleration * t);
    state.acceleration = phase.acceleration;
  }
  const CurvePoint place = curve_.at(state.s);
  state.position = place.position;
  state.heading = place.heading;
  state.curvature = place.curvature;
  return state;
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
