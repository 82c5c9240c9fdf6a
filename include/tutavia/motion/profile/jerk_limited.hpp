// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "tutavia/motion/profile/trapezoidal.hpp"

/// \file
/// JerkLimitedProfile: a motion along a line with limited jerk.

namespace tutavia::detail {

/// A motion over intervals with speed limits. Its acceleration changes by at most `max_jerk` per
/// second and is 0 at both ends.
///
/// It is the moving average, over a window of time T, of a motion in phases of constant
/// acceleration between -b and a. So its acceleration lies between -b and a and changes by at most
/// (a + b) / T = max_jerk per second. The average keeps the speed limits, because the averaged
/// motion keeps each limit beyond both ends of its interval, as far as the window can extend. At
/// its ends the averaged motion has constant speed (or rests) for a time T.
///
/// A smaller acceleration has a shorter window, which is faster over short distances: accelerations
/// a, b are tried with factors 1, 1/sqrt(2), 1/2, ... until the duration increases.
///
/// Source: Biagiotti and Melchiorri 2012, "FIR filters for online trajectory planning with time-
/// and frequency-domain specifications" (averages of a trajectory bound its next derivative).
class JerkLimitedProfile {
 public:
  struct Limits {
    double max_acceleration, max_deceleration, max_jerk;  // [m/s^2], [m/s^3]
    double start_speed, end_speed;                        // [m/s]; the latter is an upper bound
  };

  /// The motion from position `s` [m] on. None if this scheme cannot brake from the start speed in
  /// time. O(n log n) for n intervals. \pre some interval has a positive length
  static std::optional<JerkLimitedProfile> over(std::span<const SpeedInterval> intervals, double s,
                                                const Limits& limits);

  double duration() const { return phases_.end_time() - 0.5 * window_; }
  /// The state at a time from 0 to `duration`.
  ProfileState at(double time) const {
    return phases_.mean(time - 0.5 * window_, time + 0.5 * window_);
  }

 private:
  static std::optional<JerkLimitedProfile> with(std::span<const SpeedInterval> intervals, double s,
                                                const Limits& limits);

  double window_ = 0;          // [s]
  TrapezoidalProfile phases_;  // from half a window before the start to as much after the end
};

/// Speed limits along a line, each widened on both sides.
class WidenedLimits {
 public:
  /// Widens the limit of each interval, v, by `reach(v)` on both sides.
  template <class Reach>
  WidenedLimits(std::span<const SpeedInterval> intervals, const Reach& reach) {
    using Event = std::tuple<double, bool, double>;  // position, is it an end, limit
    std::vector<Event> events;
    double from = 0;
    for (const SpeedInterval& interval : intervals) {
      const double to = from + interval.length, wide = reach(std::sqrt(interval.limit));
      if (interval.length > 0) {
        events.emplace_back(from - wide, false, interval.limit);
        events.emplace_back(to + wide, true, interval.limit);
      }
      from = to;
    }
    std::sort(events.begin(), events.end());
    std::multiset<double> limits;
    double last = 0;
    for (const auto& [position, ends, limit] : events) {
      if (position > last && !limits.empty()) parts_.push_back({last, position, *limits.begin()});
      if (position > last || limits.empty()) last = position;
      if (ends) {
        limits.erase(limits.find(limit));
      } else {
        limits.insert(limit);
      }
    }
  }

  /// The limits between two positions.
  std::vector<SpeedInterval> between(double from, double to) const {
    std::vector<SpeedInterval> result;
    for (const Part& part : parts_) {
      const double length = std::min(part.to, to) - std::max(part.from, from);
      if (length > 0) result.push_back({length, part.limit});
    }
    return result;
  }
  /// The smallest limit between two positions.
  double least(double from, double to) const {
    double result = std::numeric_limits<double>::infinity();
    for (const Part& part : parts_) {
      if (part.from <= to && part.to >= from) result = std::min(result, part.limit);
    }
    return result;
  }

 private:
  struct Part {
    double from, to, limit;
  };
  std::vector<Part> parts_;
};

inline std::optional<JerkLimitedProfile> JerkLimitedProfile::over(
    std::span<const SpeedInterval> intervals, double s, const Limits& limits) {
  std::optional<JerkLimitedProfile> best;
  for (int k = 0; k < 64; ++k) {
    const double factor = std::exp2(-0.5 * k);
    Limits tried = limits;
    tried.max_acceleration *= factor;
    tried.max_deceleration *= factor;
    auto drive = with(intervals, s, tried);
    if (!drive) continue;
    if (best && !(drive->duration() < best->duration())) break;
    best = std::move(drive);
  }
  return best;
}

/// While the average is at a position with limit v, the averaged motion passes that position at
/// some time within the window, at speed v or less. So its speed within the window is at most v +
/// max(a, b) T, and its distance from the average to either end of the window is at most T / 2
/// times that.
inline std::optional<JerkLimitedProfile> JerkLimitedProfile::with(
    std::span<const SpeedInterval> intervals, double s, const Limits& limits) {
  const double a = limits.max_acceleration, b = limits.max_deceleration,
               window = (a + b) / limits.max_jerk;
  double length = 0, fastest = 0;
  for (const SpeedInterval& interval : intervals) {
    length += interval.length;
    fastest = std::max(fastest, std::sqrt(interval.limit));
  }
  const WidenedLimits widened(intervals, [&](double v) {
    return 0.5 * window * std::min(fastest, v + std::max(a, b) * window);
  });
  // The average leaves the start and reaches the end when the middle of the window does.
  const double start = limits.start_speed, lead = 0.5 * window * start;
  if (!std::isfinite(window) || !(lead < length)) return std::nullopt;
  double end = std::min(limits.end_speed, (length - lead) / window);
  const double tail = 0.5 * window * end;
  end = std::min(end, std::sqrt(widened.least(length - tail, length)));

  const std::vector<SpeedInterval> main = widened.between(lead, length - tail);
  std::vector<double> squares = boundary_speed_limits(main);
  squares.front() = std::min(squares.front(), widened.least(0, lead));
  squares.back() = std::min(squares.back(), end * end);
  squares = backward_pass(main, std::move(squares), b);
  if (start * start > squares[0] * (1 + 1e-12)) return std::nullopt;
  squares[0] = std::min(start * start, squares[0]);

  JerkLimitedProfile drive;
  drive.window_ = window;
  drive.phases_ = TrapezoidalProfile(-0.5 * window, s - lead);
  drive.phases_.keep(start, window);
  const double last = std::sqrt(drive.phases_.drive(main, squares, a, b));
  if (last > 0) drive.phases_.keep(last, std::max(0.0, tail / last - 0.5 * window));
  drive.phases_.keep(last, window);
  return std::isfinite(drive.duration()) ? std::optional(std::move(drive)) : std::nullopt;
}

}  // namespace tutavia::detail
