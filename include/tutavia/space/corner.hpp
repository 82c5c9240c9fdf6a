// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// Corner: what shortest paths bend around.

namespace tutavia {

/// A convex corner of an obstacle, or a disc.
struct Corner {
  Point position = Point::Zero();  ///< the vertex, or the disc's centre
  double radius = 0;               ///< 0 for a vertex, else the disc's radius [m]
  double exterior_angle = 0;       ///< by how much the boundary turns there [rad]; 2 pi for a disc
  std::uint32_t id = 0;            ///< the same corner has the same id in every answer
};

}  // namespace tutavia
