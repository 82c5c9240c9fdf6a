// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "tutavia/geometry/point.hpp"

/// \file
/// Pose: a position and a heading.

namespace tutavia {

/// Where a robot stands and where it faces.
struct Pose {
  Point position = Point::Zero();
  double heading = 0;  ///< [rad]; any turn is allowed

  bool is_finite() const { return detail::is_finite(position) && std::isfinite(heading); }
};

}  // namespace tutavia
