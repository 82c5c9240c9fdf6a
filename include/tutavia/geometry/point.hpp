// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <string>

#include "tutavia/core/parts/number_text.hpp"
#include "tutavia/core/version.hpp"

/// \file
/// Point: the vector type of the whole library, and operations that Eigen lacks.

namespace tutavia {

/// A point or a vector of the plane [m].
using Point = Eigen::Vector2d;

/// z component of the cross product a x b; positive when b lies to the left of a.
inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

namespace detail {

/// The point at fraction t from a to b. Coordinates are written out, as often in this module: each
/// kind of Eigen expression adds some 30 ms to the compilation of every file that includes this
/// header.
inline Point lerp(const Point& a, const Point& b, double t) {
  return {a.x() + t * (b.x() - a.x()), a.y() + t * (b.y() - a.y())};
}

/// The point p + s v.
inline Point offset_along(const Point& p, double s, const Point& v) {
  return {p.x() + s * v.x(), p.y() + s * v.y()};
}

/// Whether both coordinates are 0.
inline bool is_zero(const Point& v) { return v.x() == 0 && v.y() == 0; }

}  // namespace detail

/// Distance between two points.
inline double distance(const Point& a, const Point& b) {
  const double dx = a.x() - b.x(), dy = a.y() - b.y();
  return std::sqrt(dx * dx + dy * dy);
}

namespace detail {

/// `v` turned by +90 degrees.
inline Point perpendicular(const Point& v) { return {-v.y(), v.x()}; }

/// The angle of the vector (x, y) in (-pi, pi] [rad]; 0 for the zero vector, whatever the signs of
/// its zeros.
inline double angle(double y, double x) {
  if (y == 0) return x < 0 ? std::numbers::pi : 0.0;
  return std::atan2(y, x);
}

}  // namespace detail

/// Direction of a vector in (-pi, pi] [rad]; 0 for the zero vector.
inline double heading(const Point& v) { return detail::angle(v.y(), v.x()); }

/// The angle by which `from` turns into `to`, in (-pi, pi] [rad], left positive.
inline double turn_angle(const Point& from, const Point& to) {
  return detail::angle(cross(from, to), from.dot(to));
}

namespace detail {

inline bool is_finite(const Point& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); }

/// "(1.5, -2)"; see number_text.
inline std::string to_text(const Point& p) {
  std::string text = "(";
  return text.append(number_text(p.x())).append(", ").append(number_text(p.y())).append(")");
}

/// The larger of the two coordinates' magnitudes.
inline double max_magnitude(const Point& p) { return std::fmax(std::abs(p.x()), std::abs(p.y())); }

}  // namespace detail

}  // namespace tutavia
