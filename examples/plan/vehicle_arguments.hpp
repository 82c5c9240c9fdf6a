// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tutavia/plan/vehicle.hpp"

/// \file
/// VehicleArguments: the vehicle and the headings that a command line describes.

namespace plan_program {

/// What the command line says of a vehicle. All of it is optional.
struct VehicleArguments {
  std::optional<double> turning_radius{};           ///< [m]
  bool reverse = false;                             ///< --reverse
  std::vector<tutavia::FootprintDisc> footprint{};  ///< empty: not given
  std::optional<double> start_heading{};            ///< in the map's frame [rad]
  /// One per goal on the command line; none for the goals of a map or file.
  std::vector<std::optional<double>> goal_headings{};

  /// Whether anything is given, so that a vehicle is planned for.
  bool is_given() const {
    const bool has_goal_heading =
        std::any_of(goal_headings.begin(), goal_headings.end(),
                    [](const std::optional<double>& heading) { return heading.has_value(); });
    return turning_radius || reverse || !footprint.empty() || start_heading || has_goal_heading;
  }
  std::optional<double> goal_heading(std::size_t i) const {
    return i < goal_headings.size() ? goal_headings[i] : std::nullopt;
  }
};

/// Splits off the heading of X,Y,DEG, in radians; nothing if `text` is X,Y. Throws a UsageError,
/// which names the option, for any other text.
std::optional<double> split_heading(const std::string& option, std::string& text);

/// The R of --turning-radius. Throws UsageError.
double parse_turning_radius(const std::string& text);

/// The discs of --footprint. Throws UsageError.
std::vector<tutavia::FootprintDisc> parse_footprint(const std::string& text);

/// Throws a UsageError if such a vehicle cannot turn on the spot, but has to.
void check_vehicle(const VehicleArguments& vehicle);

}  // namespace plan_program
