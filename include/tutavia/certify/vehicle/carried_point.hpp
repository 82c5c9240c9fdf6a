// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/clothoid.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/geometry/vehicle_path.hpp"

/// \file
/// carried: the path of a point that a vehicle carries along a piece of its path.

namespace tutavia::detail {

/// `p` plus an offset given ahead and to the left, for a direction of travel.
inline Point carried_from(const Point& p, double direction, const Point& offset) {
  const double cosine = std::cos(direction), sine = std::sin(direction);
  return {p.x() + (cosine * offset.x() - sine * offset.y()),
          p.y() + (sine * offset.x() + cosine * offset.y())};
}

/// The path of a point at `offset`, ahead and to the left in the direction of travel. Along a
/// segment it is a segment.
inline Segment carried(const Segment& segment, const Point& offset) {
  const double direction = travel_direction(segment, 0);
  return {carried_from(segment.a, direction, offset), carried_from(segment.b, direction, offset)};
}

/// Along an arc it is an arc around the same centre.
inline Arc carried(const Arc& arc, const Point& offset) {
  const double side = turning_side(arc);
  const double outwards = arc.radius - side * offset.y(), onwards = side * offset.x();
  const double ahead = travel_direction(arc, 0);
  return {carried_from(arc.a, ahead, offset),
          carried_from(arc.b, ahead + arc.sweep, offset),
          arc.center,
          std::sqrt(outwards * outwards + onwards * onwards),
          arc.start_angle + angle(onwards, outwards),
          arc.sweep};
}

/// The path of a point that is carried along a clothoid; refined by halving (see Divisible).
struct CarriedClothoid {
  Clothoid axis;
  Point offset;

  Point start() const { return carried_from(axis.start(), travel_direction(axis, 0), offset); }
  Point end() const { return carried_from(axis.end(), travel_direction(axis, 1), offset); }
  Point point(double t) const {
    return carried_from(axis.point(t), travel_direction(axis, t), offset);
  }
  bool is_finite() const { return axis.is_finite() && tutavia::detail::is_finite(offset); }

  /// Bound on the distance between the path and its chord at the same parameter. The acceleration
  /// of the point by arc length s of the axis is at most k + d (k^2 + k'), where d is the length of
  /// the offset, k the largest curvature and k' the sharpness.
  double deviation() const {
    const double k = axis.largest_curvature(), length = axis.arc_length;
    return (k + offset.norm() * (k * k + std::abs(axis.sharpness))) * length * length / 8;
  }
  Box box() const { return Box::around({start(), end()}).inflated(deviation()); }
  std::pair<CarriedClothoid, CarriedClothoid> halves() const {
    const auto [first, second] = axis.halves();
    return {{first, offset}, {second, offset}};
  }
};
inline CarriedClothoid carried(const Clothoid& clothoid, const Point& offset) {
  return {clothoid, offset};
}
inline PieceError piece_error(const CarriedClothoid& path, double) {
  return {path.axis.evaluation_error(), path.axis.rounding()};
}

/// A bound on the rounding errors of the paths above, beside those of the piece itself [m]: of
/// angles, sine, cosine, products and sums, for coordinates up to `magnitude`.
template <class P>
double carrying_error(const P& piece, const Point& offset, double magnitude) {
  double angles = 8, reach = offset.norm();
  if constexpr (std::is_same_v<P, Arc>) {
    angles += std::abs(piece.start_angle) + std::abs(piece.sweep);
    reach += piece.radius;
  } else if constexpr (std::is_same_v<P, Clothoid>) {
    angles += std::abs(piece.start_heading) + piece.largest_curvature() * piece.arc_length;
  }
  return 8 * 0x1p-53 * (magnitude + reach * angles);
}

}  // namespace tutavia::detail
