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
/// JerkLimitedProfile: a drive with a limit on the change of its acceleration.

namespace tutavia::detail {

/// A drive over intervals with speed limits, whose acceleration changes by `max_jerk` per second at
/// most and is 0 at both ends.
///
/// It is the average, over a window of time T, of a drive in phases of constant acceleration
/// between -b and a. So its acceleration, an average of theirs, lies between -b and a, and changes
/// by (a + b) / T = max_jerk per second at most. The limits on the speed hold for the average,
/// because the drive that is averaged keeps each of them as far beyond both ends of its interval as
/// the window can reach. At the ends that drive keeps its speed (or stands) for a time T.
///
/// A smaller acceleration has a shorter window, which pays on short ways: accelerations a, b are
/// tried with factors 1, 1/sqrt(2), 1/2, ... until the time grows.
///
/// Source: Biagiotti and Melchiorri 2012, "FIR filters for online trajectory planning with time-
/// and frequency-domain specifications" (averages of a trajectory bound its next derivative).
class JerkLimitedProfile {
 public:
  struct Limits {
    double max_acceleration, max_deceleration, max_jerk;  // [m/s^2], [m/s^3]
    double start_speed, end_speed;                        // [m/s]; the latter at most
  };

  /// From place `s` [m] on. None where this scheme cannot brake from the start speed in time.
  /// O(n log n) for n intervals. \pre some interval has a length
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

/// Speed limits along a line, each of them widened.
class WidenedLimits {
 public:
  /// Widens the limit of each interval, v, by `reach(v)` on both sides.
  template <class Reach>
  WidenedLimits(std::span<const SpeedInterval> intervals, const Reach& reach) {
    using Event = std::tuple<double, bool, double>;  // place, whether it ends there, limit
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
    for (const auto& [place, ends, limit] : events) {
      if (place > last && !limits.empty()) parts_.push_back({last, place, *limits.begin()});
      if (place > last || limits.empty()) last = place;
      if (ends) {
        limits.erase(limits.find(limit));
      } else {
        limits.insert(limit);
      }
    }
  }

  /// The limits between two places.
  std::vector<SpeedInterval> between(double from, double to) const {
    std::vector<SpeedInterval> result;
    for (const Part& part : parts_) {
      const double length = std::min(part.to, to) - std::max(part.from, from);
      if (length > 0) result.push_back({length, part.limit});
    }
    return result;
  }
  /// The least of them.
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

/// While the average is at a place with limit v, the window holds a moment at which the averaged
/// drive is there, at v or less. So it drives at v + max(a, b) T at most while the window lasts,
/// and its way from the average to either end of the window is at most T / 2 times that.
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
  // The average leaves the start, and comes to the end, when the window's middle is there.
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
