// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/space/concepts.hpp"

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

/// A space that knows its obstacles' corners: `for_each_corner(box, visit)` calls `visit(corner)`
/// for every convex corner in the box and every disc whose box meets it.
template <class S>
concept CornerSpace = ClearanceSpace<S> && requires(const S& s, const Box& box) {
  s.for_each_corner(box, [](const Corner&) {});
};

}  // namespace tutavia
