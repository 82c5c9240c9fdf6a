// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include "support/vehicle_checker.hpp"
#include "tutavia/geometry/vehicle_path.hpp"

/// \file
/// broken_steering_limit: whether a path can be driven with the wheels turning meanwhile alone.

namespace tutavia::test {

/// The steering limit that a path breaks, if any: turning radius, sharpness, a curvature that jumps
/// or is not 0 at the ends and at cusps. All from the numbers of the pieces.
inline std::string broken_steering_limit(const VehiclePath& path, double radius, double sharpness) {
  if (!(largest_curvature(path) <= 1 / Real(radius))) return "turning radius";
  const double rounding = 1e-12 / radius;
  double before = 0;
  for (std::size_t i = 0; i < path.gears.size(); ++i) {
    double first = 0, last = 0;
    if (const Arc* arc = path.curve.pieces()[i].get_if<Arc>(); arc != nullptr && arc->sweep != 0) {
      first = last = std::copysign(1 / arc->radius, arc->sweep);
    } else if (const Clothoid* spiral = path.curve.pieces()[i].get_if<Clothoid>()) {
      first = spiral->start_curvature;
      last = first + spiral->sharpness * spiral->arc_length;
      if (std::abs(spiral->sharpness) > sharpness * (1 + 1e-12)) return "sharpness";
    }
    const bool is_cusp = i > 0 && path.gears[i] != path.gears[i - 1];
    if (is_cusp && std::abs(before) > rounding) return "curvature before a cusp";
    if (std::abs(first - (is_cusp ? 0 : before)) > rounding) return "curvature jumps";
    before = last;
  }
  return std::abs(before) > rounding ? "curvature at the end" : "";
}

}  // namespace tutavia::test
