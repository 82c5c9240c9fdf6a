// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string_view>
#include <vector>

#include "tutavia/geometry/pose.hpp"

/// \file
/// Band: poses with the times between them, and what they cost.

namespace tutavia {

/// Poses and the time from each to the next. Headings do not jump by full turns.
struct Band {
  std::vector<Pose> poses;
  std::vector<double> intervals;  ///< [s], one fewer than poses

  bool empty() const { return poses.empty(); }
  void clear() {
    poses.clear();
    intervals.clear();
  }
  /// [s]
  double duration() const { return std::accumulate(intervals.begin(), intervals.end(), 0.0); }
};

/// The terms of a band's cost.
enum class BandTerm : std::uint8_t {
  length,
  time,
  speed,
  angular_speed,
  acceleration,
  angular_acceleration,
  non_holonomic,
  clearance,
  via_point,
};
inline constexpr std::size_t band_terms = 9;

constexpr std::string_view to_string(BandTerm term) {
  constexpr std::array<std::string_view, band_terms> names{
      "length",        "time",         "speed",
      "angular_speed", "acceleration", "angular_acceleration",
      "non_holonomic", "clearance",    "via_point"};
  return names[static_cast<std::size_t>(term)];
}

/// The weights of the squared terms. Those of non-holonomic motion, time and clearance are the
/// defaults of Roesmann et al. 2012. Theirs for the limits (2, 1, 1, 1) allow 40 % more than the
/// greatest speed where time presses; these allow 3 %.
struct BandWeights {
  double length = 1;                ///< per m^2 of a step
  double time = 1;                  ///< per s^2 of an interval
  double speed = 20;                ///< per (m/s)^2 beyond the limit
  double angular_speed = 20;        ///< per (rad/s)^2 beyond the limit
  double acceleration = 5;          ///< per (m/s^2)^2 beyond the limit
  double angular_acceleration = 5;  ///< per (rad/s^2)^2 beyond the limit
  double non_holonomic = 1000;      ///< per m^2 of motion across the heading
  double clearance = 50;            ///< per m^2 that an obstacle is too near
  double via_point = 1;             ///< per m^2 of distance to a via point
};

/// A band's cost, term by term.
struct BandCost {
  std::array<double, band_terms> terms{};

  double operator[](BandTerm term) const { return terms[static_cast<std::size_t>(term)]; }
  double& operator[](BandTerm term) { return terms[static_cast<std::size_t>(term)]; }
  double total() const { return std::accumulate(terms.begin(), terms.end(), 0.0); }
};

}  // namespace tutavia
