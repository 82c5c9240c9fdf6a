// SPDX-License-Identifier: MIT
#pragma once

#include "tutavia/space/concepts.hpp"

/// \file
/// How closely constructed paths pass an obstacle.

namespace tutavia::detail {

/// The radius of the circle on which constructed paths go around an obstacle vertex (`radius` 0) or
/// a disc [m]: the safety radius more, and so much that doubles prove tangents and arcs of it free.
/// At safety radius 0 paths bend at the vertices themselves.
template <ClearanceSpace S>
double passing_radius(const S& space, double radius) {
  if (radius == 0 && space.safety_radius() == 0) return 0;
  return radius + space.safety_radius() + 4 * space.distance_error_bound();
}

}  // namespace tutavia::detail
