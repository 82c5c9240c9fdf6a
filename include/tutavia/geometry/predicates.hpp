// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "tutavia/geometry/numeric/exact_number.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// Exact geometric predicates: a floating-point filter first, exact arithmetic if it cannot decide.
///
/// Coordinates must be finite and either 0 or within [2^-400, 2^400] in magnitude, so that products
/// neither overflow nor vanish.

namespace tutavia {

namespace detail {
int exact_orientation(const Point& a, const Point& b, const Point& c);
}

/// Sign of the area of the triangle a, b, c: 1 if c lies left of the line from a to b, -1 if it
/// lies right, 0 if the three are collinear. Always exact.
/// Source: Shewchuk 1997, "Adaptive precision floating-point arithmetic", section 4 (the filter).
inline int orientation(const Point& a, const Point& b, const Point& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double determinant = left - right;
  constexpr double u = 0x1p-53;
  const double bound = (3 + 16 * u) * u * (std::abs(left) + std::abs(right));
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  if (left == 0 && right == 0) return 0;  // exact: nothing underflows
  return detail::exact_orientation(a, b, c);
}

namespace detail {

/// Whether the closed segments a-b and c-d have a point in common. Always exact; each may be a
/// single point.
inline bool segments_intersect(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (std::max(a.x(), b.x()) < std::min(c.x(), d.x()) ||
      std::max(c.x(), d.x()) < std::min(a.x(), b.x()) ||
      std::max(a.y(), b.y()) < std::min(c.y(), d.y()) ||
      std::max(c.y(), d.y()) < std::min(a.y(), b.y())) {
    return false;
  }
  // The boxes meet, so collinear segments meet as well, and straddling each other is sufficient.
  return orientation(a, b, c) * orientation(a, b, d) <= 0 &&
         orientation(c, d, a) * orientation(c, d, b) <= 0;
}

/// Sign of dist(p, segment a-b) - (radius + margin), computed exactly.
/// \pre `radius` and `margin` are not negative
inline int compare_distance(const Point& p, const Point& a, const Point& b, double radius,
                            double margin) {
  using Number = ExactNumber;
  const Number limit = Number(radius) + margin;
  const auto compare_points = [&](const Point& q) {
    const Number dx = Number(p.x()) - q.x(), dy = Number(p.y()) - q.y();
    return (dx * dx + dy * dy - limit * limit).sign();
  };
  const Number ux = Number(b.x()) - a.x(), uy = Number(b.y()) - a.y();
  const Number vx = Number(p.x()) - a.x(), vy = Number(p.y()) - a.y();
  const Number along = ux * vx + uy * vy, squared_length = ux * ux + uy * uy;
  if (along.sign() <= 0) return compare_points(a);
  if ((along - squared_length).sign() >= 0) return compare_points(b);
  const Number area = ux * vy - uy * vx;
  return (area * area - limit * limit * squared_length).sign();
}

inline int exact_orientation(const Point& a, const Point& b, const Point& c) {
  using Number = ExactNumber;
  return ((Number(a.x()) - c.x()) * (Number(b.y()) - c.y()) -
          (Number(a.y()) - c.y()) * (Number(b.x()) - c.x()))
      .sign();
}

}  // namespace detail

}  // namespace tutavia
