// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "tutavia/geometry/bezier.hpp"
#include "tutavia/geometry/clothoid.hpp"
#include "tutavia/geometry/curvature.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// ClothoidPair: corners rounded by two spirals, with curvature from 0 to a peak and back to 0.

namespace tutavia::detail {

/// A clothoid that leaves a straight line and turns by `turn` until its radius is 1. In units of
/// that radius.
///
/// Source: Meek and Walton 1992, "Clothoid spline transition spirals".
struct UnitClothoid {
  double turn = 0;               ///< [rad]
  Point end = Point::Zero();     ///< relative to its start: along the line and across it
  Point centre = Point::Zero();  ///< of its last circle, in the same axes, less 1 across

  /// \pre 0 <= turn < pi
  static UnitClothoid turning(double turn) {
    UnitClothoid spiral{.turn = turn};
    if (!(turn > 0)) return spiral;
    spiral.end = Clothoid::from({0, 0}, 0, 0, 0.5 / turn, 2 * turn).b;
    const double half_sine = std::sin(0.5 * turn);
    spiral.centre = {spiral.end.x() - std::sin(turn), spiral.end.y() - 2 * half_sine * half_sine};
    return spiral;
  }
};

/// Two mirror-image spirals that together replace a corner, in units of the radius where they meet.
struct ClothoidPair {
  double leg = 0;   ///< from the corner to their ends on its legs
  double drop = 0;  ///< from the corner to the point where they meet

  /// For clothoids and a corner that turns by `turn` [rad]. \pre 0 < turn < pi
  static ClothoidPair of_clothoids(double turn) {
    const Point end = UnitClothoid::turning(turn / 2).end;
    return {end.x() + end.y() * std::tan(turn / 2), end.y() / std::cos(turn / 2)};
  }
  /// For cubic Bezier pieces and a corner that turns by `turn` [rad]. \pre 0 < turn < pi
  static ClothoidPair of_beziers(double turn);
};

/// The two cubic Bezier spirals that round a corner, for consumers that support Bezier curves only:
/// from corner - leg * in to corner + leg * out, for unit vectors `in` and `out`. Position,
/// direction and curvature are continuous. The curvature is 0 on the legs, largest where the two
/// meet, and monotone in between.
///
/// Source: Yang and Sukkarieh 2010, "An analytical continuous-curvature path-smoothing algorithm",
/// section III, with c1 = (c2 + 4) (c2 + 1) = 7.2353 for its 7.2364, so that the two meet in the
/// middle. \pre in and out differ, and are not opposite
inline std::array<CubicBezier, 2> bezier_spirals(const Point& corner, const Point& in,
                                                 const Point& out, double leg) {
  constexpr double c2 = 0.5797958971132712;  // 2 (sqrt(6) - 1) / 5
  constexpr double c3 = (c2 + 4) / ((c2 + 4) * (c2 + 1) + 6);
  const double g = c2 * c3 * leg, h = c3 * leg;
  const Point a = offset_along(corner, -leg, in), b = offset_along(corner, leg, out);
  const Point before = offset_along(a, g + h, in), after = offset_along(b, -g - h, out);
  const Point middle = lerp(before, after, 0.5);
  return {CubicBezier{{a, offset_along(a, g, in), before, middle}},
          CubicBezier{{middle, after, offset_along(b, -g, out), b}}};
}

inline ClothoidPair ClothoidPair::of_beziers(double turn) {
  const auto spirals = bezier_spirals({0, 0}, {1, 0}, {std::cos(turn), std::sin(turn)}, 1);
  const double peak = curvature(spirals[0], 1);
  return {peak, peak * spirals[0].end().norm()};
}

}  // namespace tutavia::detail
