// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

/// \file
/// TrapezoidalProfile: a motion along a line in phases of constant acceleration.

namespace tutavia::detail {

/// An interval of a line with a limit on the squared speed.
struct SpeedInterval {
  double length = 0;  ///< [m]
  double limit = 0;   ///< [m^2/s^2]
};

/// The state of a motion at one time, or its average over a time span.
struct ProfileState {
  double s = 0;             ///< [m]
  double speed = 0;         ///< [m/s]
  double acceleration = 0;  ///< [m/s^2]
};

/// The limits on the squared speed at the interval boundaries: the smaller one of the adjacent
/// limits.
inline std::vector<double> boundary_speed_limits(std::span<const SpeedInterval> intervals) {
  std::vector<double> limits(intervals.size() + 1, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    limits[i] = std::min(limits[i], intervals[i].limit);
    limits[i + 1] = intervals[i].limit;
  }
  return limits;
}

/// Backward pass: the largest squared speed at each interval boundary from which all later limits
/// can still be met. `limits` has one entry per boundary. O(n).
inline std::vector<double> backward_pass(std::span<const SpeedInterval> intervals,
                                         std::vector<double> limits, double braking) {
  for (std::size_t i = intervals.size(); i-- > 0;) {
    limits[i] = std::min(limits[i], limits[i + 1] + 2 * braking * intervals[i].length);
  }
  return limits;
}

/// A motion in phases of constant acceleration, built from its start on.
class TrapezoidalProfile {
 public:
  /// An empty motion that will start at this time and position.
  explicit TrapezoidalProfile(double time = 0, double s = 0) : time_(time), s_(s) {}

  /// Appends the fastest motion over intervals: within each it accelerates, keeps the limit and
  /// brakes. `squares` is the result of `backward_pass`; its first entry is the squared speed at
  /// the start. Returns the squared speed at the end. O(n).
  double drive(std::span<const SpeedInterval> intervals, std::span<const double> squares,
               double acceleration, double braking);
  /// Appends a phase of constant speed, which may be 0.
  void keep(double speed, double duration) {
    if (!(duration > 0)) return;
    phases_.push_back({time_, s_, speed, 0, duration});
    extend();
  }

  double end_time() const { return time_; }
  /// The state at a time, clamped to the time span of the motion.
  ProfileState at(double time) const;
  /// Averages over the time from `from` to `to`. \pre from < to, both within the motion
  ProfileState mean(double from, double to) const;

 private:
  struct Phase {
    double time, s, speed, acceleration, duration;

    double speed_after(double t) const { return std::max(0.0, speed + acceleration * t); }
    double s_after(double t) const { return s + t * (speed + 0.5 * acceleration * t); }
  };

  void append(double length, double from, double to, double acceleration);
  void extend() {
    time_ += phases_.back().duration;
    s_ = phases_.back().s_after(phases_.back().duration);
  }
  std::vector<Phase>::const_iterator phase_at(double time) const {
    return std::upper_bound(phases_.begin() + 1, phases_.end(), time,
                            [](double t, const Phase& phase) { return t < phase.time; }) -
           1;
  }

  std::vector<Phase> phases_;
  double time_, s_;  // at the end of the phases
};

/// Within an interval, the squared speed rises to the largest value from which braking to the next
/// boundary is possible.
inline double TrapezoidalProfile::drive(std::span<const SpeedInterval> intervals,
                                        std::span<const double> squares, double acceleration,
                                        double braking) {
  const double a = acceleration, b = braking;
  double from = squares[0];
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const double length = intervals[i].length;
    const double to = std::min(squares[i + 1], from + 2 * a * length);
    if (length > 0) {
      const double reachable = (b * from + a * to + 2 * a * b * length) / (a + b);
      const double peak = std::max({std::min(reachable, intervals[i].limit), from, to});
      const double up = (peak - from) / (2 * a), down = (peak - to) / (2 * b);
      append(up, from, peak, a);
      append(length - up - down, peak, peak, 0);
      append(down, peak, to, -b);
    }
    from = to;
  }
  return from;
}

inline void TrapezoidalProfile::append(double length, double from, double to, double acceleration) {
  if (!(length > 0)) return;
  const double speed = std::sqrt(from), mean = 0.5 * (speed + std::sqrt(to));
  if (!(mean > 0)) return;
  phases_.push_back({time_, s_, speed, acceleration, length / mean});
  extend();
}

inline ProfileState TrapezoidalProfile::at(double time) const {
  if (phases_.empty()) return {s_, 0, 0};
  const Phase& phase = *phase_at(time);
  const double t = std::clamp(time - phase.time, 0.0, phase.duration);
  return {phase.s_after(t), phase.speed_after(t), phase.acceleration};
}

/// A sum over phases with weights that add up to 1, so that averages lie within the range of their
/// terms although times are rounded.
inline ProfileState TrapezoidalProfile::mean(double from, double to) const {
  ProfileState sum;
  double weight = 0;
  for (auto phase = phase_at(from); phase != phases_.end() && phase->time < to; ++phase) {
    const double in = std::max(from - phase->time, 0.0);
    const double out = std::min(to - phase->time, phase->duration);
    const double length = out - in, middle = 0.5 * (in + out);
    if (!(length > 0)) continue;
    weight += length;
    sum.s += length * (phase->s_after(middle) + phase->acceleration * length * length / 24);
    sum.speed += length * phase->speed_after(middle);
    sum.acceleration += length * phase->acceleration;
  }
  if (!(weight > 0)) return at(from);
  return {sum.s / weight, sum.speed / weight, sum.acceleration / weight};
}

}  // namespace tutavia::detail
