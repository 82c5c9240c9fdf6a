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
  Point min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  static Box around(std::initializer_list<Point> points) {
    Box box;
    for (const Point& p : points) box.include(p);
    return box;
  }

  void include(const Point& p) {
    // Not std::fmin and std::fmax, which are function calls; these comparisons ignore NaN, too.
    min = {p.x() < min.x() ? p.x() : min.x(), p.y() < min.y() ? p.y() : min.y()};
    max = {p.x() > max.x() ? p.x() : max.x(), p.y() > max.y() ? p.y() : max.y()};
  }

  bool contains(const Point& p) const {
    return min.x() <= p.x() && p.x() <= max.x() && min.y() <= p.y() && p.y() <= max.y();
  }
  bool contains(const Box& other) const { return contains(other.min) && contains(other.max); }

  /// Whether the boxes share a point, on their borders at least; true where a coordinate is NaN.
  bool meets(const Box& other) const {
    return !(max.x() < other.min.x() || other.max.x() < min.x() || max.y() < other.min.y() ||
             other.max.y() < min.y());
  }

  /// The box grown by `margin` on every side (shrunk if negative).
  Box inflated(double margin) const {
    return {{min.x() - margin, min.y() - margin}, {max.x() + margin, max.y() + margin}};
  }

  /// The point of the box nearest to `p`.
  Point clamp(const Point& p) const {
    return {std::fmin(std::fmax(p.x(), min.x()), max.x()),
            std::fmin(std::fmax(p.y(), min.y()), max.y())};
  }

  double width() const { return max.x() - min.x(); }
  double height() const { return max.y() - min.y(); }

  /// The largest magnitude of a coordinate.
  double largest_coordinate() const {
    return std::fmax(detail::max_magnitude(min), detail::max_magnitude(max));
  }
};

}  // namespace tutavia
