// SPDX-License-Identifier: MIT
#pragma once

#include "tutavia/space/concepts.hpp"

/// \file
/// passing_radius: the radius at which constructed paths pass an obstacle.

namespace tutavia::detail {

/// The radius of the circle on which constructed paths go around an obstacle vertex (`radius` 0) or
/// a disc [m]: `radius` plus the safety radius plus a margin large enough to prove tangents and
/// arcs free in double precision. At safety radius 0 paths bend at the vertices themselves.
template <ClearanceSpace S>
double passing_radius(const S& space, double radius) {
  if (radius == 0 && space.safety_radius() == 0) return 0;
  return radius + space.safety_radius() + 4 * space.distance_error_bound();
}

}  // namespace tutavia::detail
