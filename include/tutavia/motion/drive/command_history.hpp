// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "tutavia/motion/control_options.hpp"

/// \file
/// CommandHistory: the commands that a robot was given and has not finished yet.

namespace tutavia::detail {

/// The commands issued last, of which some take effect only after the latency.
class CommandHistory {
 public:
  explicit CommandHistory(const ControlOptions& options)
      : period_(options.period),
        latency_(options.latency),
        issued_(static_cast<std::size_t>(std::ceil(options.latency / options.period)) + 1) {}

  const Twist& last() const { return issued_.back(); }
  /// No command moves the robot, now or later.
  bool stands() const {
    return std::all_of(issued_.begin(), issued_.end(), [](const Twist& t) { return t.is_zero(); });
  }
  void add(const Twist& twist) {
    std::rotate(issued_.begin(), issued_.begin() + 1, issued_.end());
    issued_.back() = twist;
  }
  void clear() { std::fill(issued_.begin(), issued_.end(), Twist{}); }

  /// Calls `visit(from, twist, begin, time)` for the motions of a robot, which is at `pose` now,
  /// until a command issued now takes effect. Returns its pose then.
  template <class Visit>
  Pose for_each_under_way(Pose pose, Visit visit) const {
    pose.heading = std::remainder(pose.heading, 2 * std::numbers::pi);
    for (std::size_t i = 0; i < issued_.size(); ++i) {
      const auto age = static_cast<double>(issued_.size() - i);  // in periods
      const double begin = std::max(0.0, latency_ - age * period_);
      const double end = std::max(0.0, latency_ - (age - 1) * period_);
      if (!(end > begin)) continue;
      visit(pose, issued_[i], begin, end - begin);
      pose = moved(pose, issued_[i], end - begin);
    }
    return pose;
  }

 private:
  double period_, latency_;    // [s]
  std::vector<Twist> issued_;  // the newest at the end
};

}  // namespace tutavia::detail
