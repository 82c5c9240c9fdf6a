// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// ChangedZones: which tangent edges pass near changed obstacles.

namespace tutavia::detail {

/// Boxes in which obstacles have changed, clipped to what can affect edges within the bounds of a
/// space.
class ChangedZones {
 public:
  /// `margin`: the distance up to which an obstacle can affect an edge [m].
  ChangedZones(std::span<const Box> changed, const Box& bounds, double margin) {
    for (const Box& box : changed) {
      const Box zone = box.inflated(margin);
      const Point low = zone.min.cwiseMax(bounds.min), high = zone.max.cwiseMin(bounds.max);
      if (!(low.x() <= high.x() && low.y() <= high.y())) continue;
      zones_.push_back({0.5 * (low + high), 0.5 * (high - low)});
    }
  }

  /// Whether the segment from a to b meets one of the boxes, grown by the margin and by `radius`
  /// [m] on every side; exact up to rounding.
  bool are_near(const Point& a, const Point& b, double radius) const {
    const double dx = b.x() - a.x(), dy = b.y() - a.y();
    const double width = std::abs(dx), height = std::abs(dy);
    return std::any_of(zones_.begin(), zones_.end(), [&](const Zone& zone) {
      const double x = a.x() - zone.center.x(), y = a.y() - zone.center.y();
      const double half_width = zone.half.x() + radius, half_height = zone.half.y() + radius;
      return std::abs(2 * x + dx) <= 2 * half_width + width &&
             std::abs(2 * y + dy) <= 2 * half_height + height &&
             std::abs(dx * y - dy * x) <= half_width * height + half_height * width;
    });
  }

 private:
  struct Zone {
    Point center, half;
  };
  std::vector<Zone> zones_;
};

}  // namespace tutavia::detail
