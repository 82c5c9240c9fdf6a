// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <initializer_list>
#include <limits>

#include "tutavia/geometry/point.hpp"

/// \file
/// Box: an axis-aligned rectangle.

namespace tutavia {

/// The closed rectangle [min.x, max.x] x [min.y, max.y]. The default is empty: it contains nothing
/// and grows with `include`.
struct Box {
  Point min = Point::Constant(std::numeric_limits<double>::infinity());
  Point max = Point::Constant(-std::numeric_limits<double>::infinity());

  static Box around(std::initializer_list<Point> points) {
    Box box;
    for (const Point& p : points) box.include(p);
    return box;
  }

  void include(const Point& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }

  bool contains(const Point& p) const {
    return min.x() <= p.x() && p.x() <= max.x() && min.y() <= p.y() && p.y() <= max.y();
  }
  bool contains(const Box& other) const { return contains(other.min) && contains(other.max); }

  /// Grown by `margin` on every side (shrunk where it is negative).
  Box inflated(double margin) const {
    return {min - Point::Constant(margin), max + Point::Constant(margin)};
  }

  double width() const { return max.x() - min.x(); }
  double height() const { return max.y() - min.y(); }

  /// The largest coordinate's magnitude.
  double magnitude() const { return std::fmax(max_magnitude(min), max_magnitude(max)); }
};

}  // namespace tutavia
