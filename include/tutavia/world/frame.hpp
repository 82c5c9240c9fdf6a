// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "tutavia/geometry/point.hpp"
#include "tutavia/grid/cell.hpp"

/// \file
/// Frame: the position and size of grid cells in the plane.

namespace tutavia {

/// Maps grid cells to the plane: the reference point of cell (x, y) is origin + resolution (x, y).
/// On a lattice that point is the node itself.
struct Frame {
  Point origin = Point::Zero();
  double resolution = 1;  ///< distance between neighbours [m]

  Point point(Cell cell) const {
    return {origin.x() + resolution * cell.x, origin.y() + resolution * cell.y};
  }

  /// The cell whose reference point is nearest to `p`.
  /// \pre `p` lies within 2^30 cells of the origin
  Cell nearest_cell(const Point& p) const {
    return {static_cast<int>(std::lround((p.x() - origin.x()) / resolution)),
            static_cast<int>(std::lround((p.y() - origin.y()) / resolution))};
  }
};

}  // namespace tutavia
