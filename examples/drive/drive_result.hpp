// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/pose.hpp"
#include "tutavia/motion/drive_command.hpp"

/// \file
/// DriveResult: what came of a drive.

namespace drive_program {

using namespace tutavia;

/// How a drive ended.
enum class Ending {
  reached,    ///< the robot stands at the goal
  stopped,    ///< it stands and found no way on
  timed_out,  ///< the time was over
};

constexpr std::string_view to_string(Ending ending) {
  switch (ending) {
    case Ending::reached:
      return "reached";
    case Ending::stopped:
      return "stopped";
    case Ending::timed_out:
      return "timed out";
  }
  return "unknown";
}

/// The robot at the beginning of a period of control, and what its controller said then.
struct TraceRow {
  double time = 0;  ///< [s]
  Pose pose{};      ///< the true one
  Twist twist{};    ///< in effect
  /// Of the robot's disc in the period that follows, from everything that is there [m].
  double clearance = 0;
  DriveStatus status = DriveStatus::blocked;
};

/// A path that a controller was given, and when [s].
struct FollowedPath {
  double time = 0;
  Curve curve{};
};

/// What came of a drive.
struct DriveResult {
  Ending ending = Ending::timed_out;
  std::string reason{};              ///< one line, if the goal is not reached
  std::size_t own_contacts = 0;      ///< the robot moved, or the obstacle stands
  std::size_t driven_into = 0;       ///< an obstacle drove into the robot, which stood
  std::size_t limit_violations = 0;  ///< commands outside the limits of speed or acceleration
  std::size_t emergencies = 0;       ///< commands with the status `emergency`
  std::size_t replans = 0;           ///< new global paths
  double time = 0;                   ///< [s]
  double length = 0;                 ///< driven [m]
  /// The least gap between the robot's disc and what stands; while the robot moves, between it and
  /// anything [m]. At most 1 m.
  double min_clearance = std::numeric_limits<double>::infinity();
  Pose end{};  ///< where the robot is at last
  /// Whether what stays leaves a way to the goal; not known if nothing looked for one.
  std::optional<bool> is_connected{};
  std::vector<TraceRow> trace{};      ///< if asked for
  std::vector<FollowedPath> paths{};  ///< the same
};

/// Told of the time [s] and the length driven [m] after each period.
using Progress = std::function<void(double time, double length)>;

}  // namespace drive_program
