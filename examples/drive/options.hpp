// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "../plan/options.hpp"

/// \file
/// The command line of tutavia-drive.

namespace drive_program {

/// What drives the robot.
enum class ControllerKind {
  band,     ///< LocalPlanner
  pursuit,  ///< PathFollower
};

constexpr std::string_view to_string(ControllerKind kind) {
  return kind == ControllerKind::band ? "band" : "pursuit";
}

/// The options as given. An empty text means that the option was not given.
struct Arguments {
  plan_program::Arguments input{};  ///< the map, the start and the goal
  std::optional<double> heading{};  ///< at the start [rad]; default: along the path
  ControllerKind controller = ControllerKind::band;
  std::uint64_t seed = 0;              ///< of the obstacles and the noise
  std::size_t obstacles = 0;           ///< that appear
  double noise = 0;                    ///< bound on the odometry's error [m] and [rad]
  double latency = 0;                  ///< until a command takes effect [s]
  std::optional<double> time_limit{};  ///< simulated [s]
  std::string csv{};
  std::string svg{};
};

/// Reads the command line. For --help it prints the help and returns nothing. Throws UsageError.
std::optional<Arguments> parse_command_line(int argc, const char* const* argv);

}  // namespace drive_program
