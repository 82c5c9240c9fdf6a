// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// Bitangents and arcs of oriented circles.

namespace tutavia::detail {

/// A circle and its side of a path around it: 1 to the left (the path turns left around it), -1 to
/// the right. With radius 0 it is a point on the path, on either side.
struct OrientedCircle {
  Point center = Point::Zero();
  double radius = 0;  ///< [m]
  int side = 1;

  /// The point where a path in the direction of the unit vector `d` touches the circle.
  Point touch(const Point& d) const {
    return offset_along(center, -side * radius, perpendicular(d));
  }
};

/// A tangent segment from one circle to another.
struct TangentLine {
  Point from = Point::Zero(), to = Point::Zero();  ///< the points of contact
  Point direction = Point::Zero();                 ///< unit vector
  double length = 0;                               ///< [m]
};

/// The tangent from `a` to `b` that keeps both circles on their sides. None if one circle lies too
/// far inside the other, or both are the same point.
///
/// With D from centre to centre and k the difference of the signed radii, D = length d + k n for
/// the direction d and its left normal n.
inline std::optional<TangentLine> tangent_line(const OrientedCircle& a, const OrientedCircle& b) {
  const Point between{b.center.x() - a.center.x(), b.center.y() - a.center.y()};
  const double k = b.side * b.radius - a.side * a.radius;
  const double apart = between.norm();
  if (!(apart > 0) || apart < std::abs(k)) return std::nullopt;
  TangentLine result;
  result.length = std::sqrt((apart - std::abs(k)) * (apart + std::abs(k)));
  const double along = result.length / apart, aside = k / apart;
  const Point u{between.x() / apart, between.y() / apart};
  result.direction = {along * u.x() + aside * u.y(), along * u.y() - aside * u.x()};
  result.from = a.touch(result.direction);
  result.to = b.touch(result.direction);
  return result;
}

/// Calls `visit(arc)` for the arcs, of about half a circle at most, of a path around a circle from
/// `in` to `out`. `turn` (left positive [rad]) selects the number of full turns. No arcs at radius
/// 0, or if `in` and `out` lie within `tolerance` of each other and the path does not go all
/// around.
template <class Visit>
void for_each_arc(const OrientedCircle& circle, const Point& in, const Point& out, double turn,
                  double tolerance, Visit visit) {
  if (circle.radius == 0 || (distance(in, out) <= tolerance && std::abs(turn) < 1)) return;
  const double least = turn_angle(in - circle.center, out - circle.center);
  constexpr double full = 2 * std::numbers::pi;
  const double sweep = least + full * std::round((turn - least) / full);
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / 3.15)));
  Point at = in;
  for (int i = 0; i < count; ++i) {
    Arc arc = Arc::around(circle.center, circle.radius, heading(at - circle.center), sweep / count);
    arc.a = at;
    if (i + 1 == count) arc.b = out;
    at = arc.b;
    visit(arc);
  }
}

}  // namespace tutavia::detail
