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
/// The curvature of a piece, and where it is largest.

namespace tutavia {

/// Curvature at parameter t [1/m], left turns positive; 0 where the piece stands still.
template <class P>
double curvature(const P& piece, double t) {
  const Point d = piece.derivative(t);
  const double speed = d.norm();
  return speed > 0 ? cross(d, piece.second_derivative(t)) / speed / speed / speed : 0.0;
}

namespace detail {

/// Whether no two legs of the control polygon are further than `rounding` from parallel.
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

/// Where the curvature may be extreme between the ends: for a parabola where the velocity is
/// perpendicular to the acceleration, B' . B'' = 0.
template <class Visit>
void for_each_curvature_extreme(const QuadraticBezier& piece, Visit visit) {
  const Point acceleration = piece.second_derivative(0);
  const double t = -piece.derivative(0).dot(acceleration) / acceleration.squaredNorm();
  if (0 < t && t < 1) visit(t);
}

/// For a cubic: where the derivative of (B' x B'') / |B'|^3 is 0, that is
/// (B' x B''') |B'|^2 = 3 (B' x B'') (B' . B''), and where the piece is slowest. Near a cusp the
/// curvature is largest where the piece is slowest, and there three roots of the former lie too
/// close together to be found well.
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
  Polynomial<5> square = multiply(x, x);
  const Polynomial<5> square_of_y = multiply(y, y);
  for (std::size_t i = 0; i < 5; ++i) square[i] += square_of_y[i];
  const Polynomial<4> square_slope = derivative(square);  // twice B' . B''
  Polynomial<6> slope = multiply(derivative(bend), square);
  const Polynomial<6> subtrahend = multiply(bend, square_slope);
  for (std::size_t i = 0; i < 6; ++i) slope[i] -= 1.5 * subtrahend[i];
  for (const double t : roots_in_unit_interval(square_slope)) visit(t);
  for (const double t : roots_in_unit_interval(slope)) visit(t);
}

}  // namespace detail

/// Largest magnitude of the curvature of a segment: 0.
inline double max_curvature(const Segment&) { return 0; }

/// Largest magnitude of the curvature of an arc [1/m]; 0 where it is one point.
inline double max_curvature(const Arc& arc) { return arc.length() > 0 ? 1 / arc.radius : 0; }

/// Largest magnitude of the curvature of a clothoid [1/m]; 0 where it is one point.
inline double max_curvature(const Clothoid& clothoid) {
  return clothoid.arc_length > 0 ? clothoid.largest_curvature() : 0;
}

/// Largest magnitude of the curvature of a Bezier piece [1/m]; never NaN. Infinite where it comes
/// to a standstill, be it a cusp or control points that coincide at an end. A piece that is
/// straight has 0, even where it turns back: that is turning, as at a corner. Both "straight" and
/// "standstill" mean: as far as the rounding of the control points lets tell.
template <std::size_t Degree>
double max_curvature(const Bezier<Degree>& piece) {
  const double rounding = 8 * 0x1p-53 * piece.box().largest_coordinate();
  if (detail::is_straight(piece, rounding)) return 0;
  double result = 0;
  const auto include = [&](double t) {
    const bool stands = piece.derivative(t).norm() <= Degree * rounding;
    const double here =
        stands ? std::numeric_limits<double>::infinity() : std::abs(curvature(piece, t));
    if (here > result) result = here;
  };
  include(0);
  include(1);
  detail::for_each_curvature_extreme(piece, include);
  return result;
}

}  // namespace tutavia
