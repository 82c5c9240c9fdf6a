// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// ChangedZones: which ways pass where obstacles have changed.

namespace tutavia::detail {

/// Boxes where obstacles have changed, as far as it matters to ways within the bounds of a space.
class ChangedZones {
 public:
  /// `margin`: how far from an obstacle a way may lie and yet depend on it [m].
  ChangedZones(std::span<const Box> changed, const Box& bounds, double margin) {
    for (const Box& box : changed) {
      const Box zone = box.inflated(margin);
      const Point low = zone.min.cwiseMax(bounds.min), high = zone.max.cwiseMin(bounds.max);
      if (!(low.x() <= high.x() && low.y() <= high.y())) continue;
      zones_.push_back({0.5 * (low + high), 0.5 * (high - low)});
    }
  }

  /// Whether the segment from a to b meets such a box, grown by the margin and by `radius` [m] on
  /// every side; right but for rounding.
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
