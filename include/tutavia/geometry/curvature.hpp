// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/bezier.hpp"
#include "tutavia/geometry/clothoid.hpp"
#include "tutavia/geometry/numeric/polynomial.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/segment.hpp"

/// \file
/// curvature and max_curvature of a piece.

namespace tutavia {

/// Curvature at parameter t [1/m], left turns positive; 0 if the velocity is 0.
template <class P>
double curvature(const P& piece, double t) {
  const Point d = piece.derivative(t);
  const double speed = d.norm();
  return speed > 0 ? cross(d, piece.second_derivative(t)) / speed / speed / speed : 0.0;
}

namespace detail {

/// Whether the legs of the control polygon are parallel, up to `rounding` [m].
template <std::size_t Degree>
bool is_straight(const Bezier<Degree>& piece, double rounding) {
  const auto& p = piece.points;
  double longest = 0, widest = 0;
  for (std::size_t i = 0; i < Degree; ++i) {
    longest = std::fmax(longest, distance(p[i], p[i + 1]));
    for (std::size_t k = 0; k < i; ++k) {
      widest = std::fmax(widest, std::abs(cross(p[i + 1] - p[i], p[k + 1] - p[k])));
    }
  }
  return widest <= rounding * longest;
}

/// Calls `visit(t)` for the parameters between the ends at which the curvature may be extreme. For
/// a parabola: where velocity and acceleration are perpendicular, B' . B'' = 0.
template <class Visit>
void for_each_curvature_extreme(const QuadraticBezier& piece, Visit visit) {
  const Point acceleration = piece.second_derivative(0);
  const double t = -piece.derivative(0).dot(acceleration) / acceleration.squaredNorm();
  if (0 < t && t < 1) visit(t);
}

/// For a cubic: the roots of the derivative of (B' x B'') / |B'|^3, that is (B' x B''') |B'|^2 = 3
/// (B' x B'') (B' . B''), and the minima of the speed. Near a cusp the curvature is largest at the
/// minimum of the speed, where three roots of the first equation lie too close together to be
/// computed well.
template <class Visit>
void for_each_curvature_extreme(const CubicBezier& piece, Visit visit) {
  std::array<Point, 3> legs;
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    legs[i] = piece.points[i + 1] - piece.points[i];
    longest = std::fmax(longest, max_magnitude(legs[i]));
  }
  for (Point& leg : legs) leg = {leg.x() / longest, leg.y() / longest};
  // B' is proportional to a + 2 b t + c t^2.
  const Point a = legs[0], b = offset_along(legs[1], -1, a);
  const Point c = offset_along(offset_along(legs[2], -1, legs[1]), -1, b);
  const Polynomial<3> x{a.x(), 2 * b.x(), c.x()}, y{a.y(), 2 * b.y(), c.y()};
  const Polynomial<3> bend{2 * cross(a, b), 2 * cross(a, c), 2 * cross(b, c)};  // B' x B''
  Polynomial<5> squared_speed = multiply(x, x);
  const Polynomial<5> squared_y = multiply(y, y);
  for (std::size_t i = 0; i < 5; ++i) squared_speed[i] += squared_y[i];
  const Polynomial<4> speed_slope = derivative(squared_speed);  // twice B' . B''
  Polynomial<6> slope = multiply(derivative(bend), squared_speed);
  const Polynomial<6> subtrahend = multiply(bend, speed_slope);
  for (std::size_t i = 0; i < 6; ++i) slope[i] -= 1.5 * subtrahend[i];
  for (const double t : roots_in_unit_interval(speed_slope)) visit(t);
  for (const double t : roots_in_unit_interval(slope)) visit(t);
}

}  // namespace detail

/// Largest magnitude of the curvature of a segment: 0.
inline double max_curvature(const Segment&) { return 0; }

/// Largest magnitude of the curvature of an arc [1/m]; 0 if it is one point.
inline double max_curvature(const Arc& arc) { return arc.length() > 0 ? 1 / arc.radius : 0; }

/// Largest magnitude of the curvature of a clothoid [1/m]; 0 if it is one point.
inline double max_curvature(const Clothoid& clothoid) {
  return clothoid.arc_length > 0 ? clothoid.largest_curvature() : 0;
}

/// Largest magnitude of the curvature of a Bezier piece [1/m]; never NaN. Infinite if the velocity
/// vanishes, at a cusp or at coincident end control points. 0 for a straight piece, even if it
/// reverses: that is a turn, as at a corner. Both are decided up to rounding of the control points.
template <std::size_t Degree>
double max_curvature(const Bezier<Degree>& piece) {
  const double rounding = 8 * 0x1p-53 * piece.box().largest_coordinate();
  if (detail::is_straight(piece, rounding)) return 0;
  double result = 0;
  const auto include = [&](double t) {
    const bool velocity_vanishes = piece.derivative(t).norm() <= Degree * rounding;
    const double here =
        velocity_vanishes ? std::numeric_limits<double>::infinity() : std::abs(curvature(piece, t));
    if (here > result) result = here;
  };
  include(0);
  include(1);
  detail::for_each_curvature_extreme(piece, include);
  return result;
}

}  // namespace tutavia
