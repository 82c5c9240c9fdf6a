// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/geometry/bezier.hpp"

/// \file
/// Conversion of cubic B-splines to Bezier pieces.

namespace tutavia {

namespace detail {

/// The clamped uniform knots 0, 0, 0, 0, 1, 2, ... of a cubic B-spline with n control points.
inline double clamped_knot(std::size_t i, std::size_t n) {
  return static_cast<double>(i < 3 ? 0 : i > n ? n - 3 : i - 3);
}

/// The blossom of the spline's span k at (u, v, w): de Boor's algorithm with one argument per
/// level.
inline Point blossom(std::span<const Point> control, std::size_t k, double u, double v, double w) {
  std::array<Point, 4> p{control[k], control[k + 1], control[k + 2], control[k + 3]};
  const std::array<double, 3> arguments{u, v, w};
  for (std::size_t level = 1; level <= 3; ++level) {
    for (std::size_t i = 3; i >= level; --i) {
      const double from = clamped_knot(k + i, control.size());
      const double to = clamped_knot(k + i + 4 - level, control.size());
      p[i] = lerp(p[i - 1], p[i], (arguments[level - 1] - from) / (to - from));
    }
  }
  return p[3];
}

}  // namespace detail

/// The Bezier pieces of the cubic B-spline with clamped uniform knots: one for every four
/// consecutive control points, in whose convex hull it lies. The spline starts exactly at the first
/// control point and ends exactly at the last one, in the directions of the first and last leg.
/// Pieces meet exactly, with continuous curvature up to rounding. Its length is at most that of its
/// control polygon.
/// Source: Boehm 1980, "Inserting new knots into B-spline curves". \pre four points or more
inline std::vector<CubicBezier> bezier_pieces(std::span<const Point> control) {
  TUTAVIA_ASSERT(control.size() >= 4);
  std::vector<CubicBezier> pieces;
  pieces.reserve(control.size() - 3);
  Point at = control.front();
  for (std::size_t k = 0; k + 3 < control.size(); ++k) {
    const auto a = static_cast<double>(k), b = a + 1;
    const bool last = k + 4 == control.size();
    pieces.push_back(
        {{at, detail::blossom(control, k, a, a, b), detail::blossom(control, k, a, b, b),
          last ? control.back() : detail::blossom(control, k, b, b, b)}});
    at = pieces.back().end();
  }
  return pieces;
}

}  // namespace tutavia
