// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/numeric/closest_parameter.hpp"
#include "tutavia/geometry/numeric/quadrature.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// Clothoid: a curve whose curvature is linear in its arc length.

namespace tutavia {

/// The curve from `a` with curvature start_curvature + sharpness s at arc length s (a Cornu or
/// Euler spiral; a circular arc if sharpness is 0, straight if both are 0); parameter t in [0, 1],
/// with s = t arc_length. Its end is stored, so that it joins other pieces without a gap. Rounding
/// may put it off the curve; `evaluation_error()` includes that.
///
/// Points are integrals of the direction, by quadrature: O(1 + turn).
struct Clothoid {
  Point a = Point::Zero();
  Point b = Point::Zero();
  double start_heading = 0;    ///< [rad]
  double start_curvature = 0;  ///< 1/m, left turns positive
  double sharpness = 0;        ///< change of the curvature with arc length [1/m^2]
  double arc_length = 0;       ///< [m], not negative

  /// The largest product of curvature and length that counts as finite [rad].
  static constexpr double max_turn = 64;

  /// The clothoid with its end computed.
  static Clothoid from(const Point& start, double heading, double curvature, double sharpness,
                       double length) {
    Clothoid piece{start, start, heading, curvature, sharpness, length};
    piece.b = piece.on_curve(1);
    return piece;
  }

  const Point& start() const { return a; }
  const Point& end() const { return b; }
  Point point(double t) const { return t == 0 ? a : t == 1 ? b : on_curve(t); }
  Point derivative(double t) const {
    const double angle = start_heading + turn_to(t);
    return {arc_length * std::cos(angle), arc_length * std::sin(angle)};
  }
  Point second_derivative(double t) const {
    const Point d = derivative(t);
    const double turn = curvature_at(t) * arc_length;
    return {-turn * d.y(), turn * d.x()};
  }
  Point start_direction() const { return derivative(0); }
  Point end_direction() const { return derivative(1); }
  double length() const { return arc_length; }
  double length_to(double t) const { return t * arc_length; }
  double curvature_at(double t) const { return start_curvature + sharpness * t * arc_length; }
  /// Change of heading from the start to parameter t [rad], left positive.
  double turn_to(double t) const {
    const double s = t * arc_length;
    return s * (start_curvature + 0.5 * sharpness * s);
  }
  /// Largest magnitude of the curvature [1/m].
  double largest_curvature() const {
    return std::fmax(std::abs(curvature_at(0)), std::abs(curvature_at(1)));
  }

  /// The part over [from, to], with the ends point(from) and point(to). \pre 0 <= from <= to <= 1
  Clothoid part(double from, double to) const {
    return {point(from),        point(to), start_heading + turn_to(from),
            curvature_at(from), sharpness, (to - from) * arc_length};
  }
  Clothoid reversed() const {
    return {b,         a,         start_heading + turn_to(1) + std::numbers::pi, -curvature_at(1),
            sharpness, arc_length};
  }
  std::pair<Clothoid, Clothoid> halves() const {
    const Point middle = on_curve(0.5);
    const double half = 0.5 * arc_length;
    return {{a, middle, start_heading, start_curvature, sharpness, half},
            {middle, b, start_heading + turn_to(0.5), curvature_at(0.5), sharpness, half}};
  }
  /// The piece with `p` as the origin.
  Clothoid relative_to(const Point& p) const {
    Clothoid result = *this;
    result.a = {a.x() - p.x(), a.y() - p.y()};
    result.b = {b.x() - p.x(), b.y() - p.y()};
    return result;
  }

  /// Whether the numbers define a curve: finite, length not negative, turn at most `max_turn`.
  bool is_finite() const {
    return tutavia::detail::is_finite(a) && tutavia::detail::is_finite(b) &&
           std::isfinite(start_heading) && std::isfinite(sharpness) && std::isfinite(arc_length) &&
           arc_length >= 0 && largest_curvature() * arc_length <= max_turn;
  }

  /// Bound on the distance between the curve and its chord at the same parameter, from the bound on
  /// its second derivative.
  double deviation() const { return largest_curvature() * arc_length * arc_length / 8; }
  /// A box that contains the curve up to `evaluation_error()`: that of the ends, grown by the
  /// deviation.
  Box box() const { return Box::around({a, b}).inflated(deviation()); }

  /// Parameter of the point nearest to `p`; the smallest one in case of a tie; see
  /// detail::ClosestParameter.
  double nearest_parameter(const Point& p) const {
    return detail::ClosestParameter<Clothoid>(relative_to(p)).parameter();
  }

  /// A bound on the distance of `point(t)` from the exact curve [m], from rounding of the angles,
  /// sine, cosine, the quadrature and the sum.
  double rounding() const {
    const double angles = 8 + std::abs(start_heading) + largest_curvature() * arc_length;
    return 4 * 0x1p-53 * (detail::max_magnitude(a) + arc_length * angles);
  }
  /// `rounding()` plus the distance between the stored and the computed end [m].
  double evaluation_error() const { return distance(b, on_curve(1)) + rounding(); }

 private:
  Point on_curve(double t) const {
    const double s = t * arc_length;
    // Eight nodes integrate a direction that turns by at most 2/3 to the last digits.
    const double fastest =
        1.5 * std::fmax(std::abs(start_curvature), std::abs(curvature_at(t))) * s;
    const int parts = static_cast<int>(std::ceil(std::fmin(std::fmax(fastest, 1), 1.5 * max_turn)));
    const double half = 0.5 * s / parts;
    double x = 0, y = 0;
    for (int i = 0; i < parts; ++i) {
      for (std::size_t k = 0; k < detail::gauss_nodes.size(); ++k) {
        for (const double side : {-1.0, 1.0}) {
          const double at = half * (2 * i + 1 + side * detail::gauss_nodes[k]);
          const double angle = start_heading + at * (start_curvature + 0.5 * sharpness * at);
          x += detail::gauss_weights[k] * std::cos(angle);
          y += detail::gauss_weights[k] * std::sin(angle);
        }
      }
    }
    return {a.x() + half * x, a.y() + half * y};
  }
};

}  // namespace tutavia
