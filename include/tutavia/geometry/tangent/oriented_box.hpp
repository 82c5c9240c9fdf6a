// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// OrientedBox: a rectangle of any orientation.

namespace tutavia::detail {

/// The bounding rectangle of points, aligned with the line from the first of them to `end`.
class OrientedBox {
 public:
  /// \pre not empty
  OrientedBox(const std::vector<Point>& points, const Point& end) : origin_(points.front()) {
    const Point direction{end.x() - origin_.x(), end.y() - origin_.y()};
    const double length = direction.norm();
    if (length > 0) along_ = {direction.x() / length, direction.y() / length};
    for (const Point& p : points) box_.include(local(p));
  }

  /// Whether a point lies more than `margin` outside the rectangle. Most points in the axis-aligned
  /// box of a slanted rectangle do.
  bool is_far(const Point& p, double margin) const {
    return !box_.inflated(margin).contains(local(p));
  }

  /// Calls `visit(box)` for axis-aligned boxes that together contain the rectangle: one, or several
  /// along it if their total area, with `margin` around each, is much smaller.
  template <class Visit>
  void for_each_box(double margin, Visit visit) const {
    const double wide = box_.height() + 2 * margin;
    const double slant = std::fmin(std::abs(along_.x()), std::abs(along_.y()));
    const double parts = std::fmin(slant * box_.width() / (4 * wide), 32);
    const int count = parts >= 2 ? static_cast<int>(parts) : 1;
    for (int k = 0; k < count; ++k) {
      const double from = box_.min.x() + box_.width() * k / count;
      const double to = box_.min.x() + box_.width() * (k + 1) / count;
      visit(Box::around({at(from, box_.min.y()), at(to, box_.min.y()), at(from, box_.max.y()),
                         at(to, box_.max.y())}));
    }
  }

 private:
  Point local(const Point& p) const {
    const Point v{p.x() - origin_.x(), p.y() - origin_.y()};
    return {v.dot(along_), cross(along_, v)};
  }
  Point at(double x, double y) const {
    return offset_along(offset_along(origin_, x, along_), y, perpendicular(along_));
  }

  Point origin_;
  Point along_{1, 0};
  Box box_;  // in local coordinates, x along the rectangle
};

}  // namespace tutavia::detail
