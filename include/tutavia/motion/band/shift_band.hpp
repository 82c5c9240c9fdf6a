// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/motion/timed_elastic_band.hpp"

/// \file
/// shift_band: an optimised band, moved on with the robot.

namespace tutavia::detail {

/// Drops the poses that the robot has passed, begins at its pose, and ends at `target`. The heading
/// there is kept if the band is free to turn at its end. False, and nothing changed, if the robot
/// or the target is too far from the band.
inline bool shift_band(const TimedElasticBand& teb, const Pose& robot, const CurvePoint& target,
                       bool free_end_heading, Band& band) {
  std::size_t nearest = 0;
  const std::size_t few = std::min<std::size_t>(band.poses.size(), 10);
  for (std::size_t i = 1; i < few; ++i) {
    if (distance(robot.position, band.poses[i].position) <
        distance(robot.position, band.poses[nearest].position)) {
      nearest = i;
    }
  }
  if (band.poses.size() < nearest + 4 ||
      distance(robot.position, band.poses[nearest].position) >= 0.3 ||
      distance(target.position, band.poses.back().position) >= 0.5) {
    return false;
  }
  const auto passed = static_cast<std::ptrdiff_t>(nearest);
  band.poses.erase(band.poses.begin(), band.poses.begin() + passed);
  band.intervals.erase(band.intervals.begin(), band.intervals.begin() + passed);
  const auto near = [](double heading, double reference) {
    return reference + std::remainder(heading - reference, 2 * std::numbers::pi);
  };
  const Pose& next = band.poses[1];
  band.intervals[0] =
      std::clamp(distance(robot.position, next.position) / teb.limits.max_speed,
                 0.1 * teb.reference_interval, teb.reference_interval + teb.hysteresis);
  band.poses[0] = {robot.position, near(robot.heading, next.heading)};
  Pose& back = band.poses.back();
  back.position = target.position;
  if (!free_end_heading) {
    back.heading = near(target.heading, band.poses[band.poses.size() - 2].heading);
  }
  return true;
}

}  // namespace tutavia::detail
