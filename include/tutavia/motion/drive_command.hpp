// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "tutavia/geometry/point.hpp"
#include "tutavia/motion/differential_drive.hpp"

/// \file
/// DriveCommand: what a controller tells a robot, and why; MotionProof: whether a motion is safe.

namespace tutavia {

/// What a controller does in one period of control.
enum class DriveStatus {
  driving,        ///< the command is what the controller wants, and proved
  slowed,         ///< only a lower speed is proved; the blocker says why
  stopping,       ///< no other motion is proved: brakes, which is
  emergency,      ///< an obstacle came within the stopping distance: brakes as hard as it can
  blocked,        ///< stands; no motion is proved, or no path is known: plan again
  arrived,        ///< stands at the end of the path
  invalid_input,  ///< odometry or an obstacle is not a number: brakes
};

constexpr std::string_view to_string(DriveStatus status) {
  switch (status) {
    case DriveStatus::driving:
      return "driving";
    case DriveStatus::slowed:
      return "slowed";
    case DriveStatus::stopping:
      return "stopping";
    case DriveStatus::emergency:
      return "emergency";
    case DriveStatus::blocked:
      return "blocked";
    case DriveStatus::arrived:
      return "arrived";
    case DriveStatus::invalid_input:
      return "invalid_input";
  }
  return "unknown";
}

/// What is in the way of a motion, and when.
struct Blocker {
  enum class Kind : std::uint8_t {
    none,
    map,       ///< an obstacle of the map
    bounds,    ///< the map's bounds
    observed,  ///< an obstacle given to the control step
  };

  Kind kind = Kind::none;
  std::uint32_t obstacle = std::numeric_limits<std::uint32_t>::max();  ///< its index, if it has one
  double time = 0;              ///< from now until the robot would come too close [s]
  Point point = Point::Zero();  ///< where the robot would be then
};

/// The verdict on one motion of a robot.
struct MotionProof {
  bool proved = false;
  Blocker blocker{};  ///< if not proved
};

/// The command for one period of control.
struct DriveCommand {
  Twist twist{};
  DriveStatus status = DriveStatus::blocked;
  Blocker blocker{};  ///< for `slowed`, `stopping`, `emergency` and `blocked`
};

}  // namespace tutavia
