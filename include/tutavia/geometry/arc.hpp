// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/segment.hpp"

/// \file
/// Arc: a circular arc, and its distance to a segment.

namespace tutavia {

/// The circular arc around `center` from angle `start_angle` through `sweep` (positive: left turn,
/// at most a full circle); parameter t in [0, 1]. Its ends are stored, so that it joins other
/// pieces without a gap. Rounding may put them off the circle; `evaluation_error()` includes that.
struct Arc {
  Point a = Point::Zero();
  Point b = Point::Zero();
  Point center = Point::Zero();
  double radius = 0;       ///< [m]
  double start_angle = 0;  ///< direction from the centre to `a` [rad]
  double sweep = 0;        ///< [rad], in [-2 pi, 2 pi]

  /// The arc with its ends computed from the angles.
  static Arc around(const Point& center, double radius, double start_angle, double sweep) {
    Arc arc{center, center, center, radius, start_angle, sweep};
    arc.a = arc.on_circle(0);
    arc.b = arc.on_circle(1);
    return arc;
  }

  const Point& start() const { return a; }
  const Point& end() const { return b; }
  Point point(double t) const { return t == 0 ? a : t == 1 ? b : on_circle(t); }
  Point derivative(double t) const {
    const Point d = direction(t);
    return {-sweep * radius * d.y(), sweep * radius * d.x()};
  }
  Point second_derivative(double t) const {
    const Point d = direction(t);
    return {-sweep * sweep * radius * d.x(), -sweep * sweep * radius * d.y()};
  }
  Point start_direction() const { return derivative(0); }
  Point end_direction() const { return derivative(1); }
  double length() const { return radius * std::abs(sweep); }
  double length_to(double t) const { return t * length(); }

  /// The part over [from, to], with the ends point(from) and point(to). \pre 0 <= from <= to <= 1
  Arc part(double from, double to) const {
    const double angle = start_angle + from * sweep;
    return {point(from), point(to), center, radius, angle, (to - from) * sweep};
  }
  Arc reversed() const { return {b, a, center, radius, start_angle + sweep, -sweep}; }

  bool is_finite() const {
    return tutavia::detail::is_finite(a) && tutavia::detail::is_finite(b) &&
           tutavia::detail::is_finite(center) && radius >= 0 && std::isfinite(radius) &&
           std::isfinite(start_angle) && std::abs(sweep) <= 2 * std::numbers::pi;
  }

  /// The parameter of the point of the arc in direction `v` from its centre; outside [0, 1] if
  /// there is none.
  double parameter_towards(const Point& v) const {
    if (sweep == 0) return std::numeric_limits<double>::infinity();
    double turn = std::remainder(heading(v) - start_angle, 2 * std::numbers::pi);
    if (sweep > 0 && turn < 0) turn += 2 * std::numbers::pi;
    if (sweep < 0 && turn > 0) turn -= 2 * std::numbers::pi;
    return turn / sweep;
  }

  /// Parameter of the point nearest to `p`; the smallest one in case of a tie.
  double nearest_parameter(const Point& p) const {
    const double towards = parameter_towards({p.x() - center.x(), p.y() - center.y()});
    double nearest = 0, least = distance(p, a);
    for (const double t : {towards, 1.0}) {
      if (!(t > 0 && t <= 1)) continue;
      const double d = distance(p, point(t));
      if (d < least) {
        nearest = t;
        least = d;
      }
    }
    return nearest;
  }

  /// Calls `visit(t)` for every parameter between the ends at which x or y is extreme: at multiples
  /// of a quarter turn.
  template <class Visit>
  void for_each_extreme(Visit visit) const {
    constexpr double quarter = std::numbers::pi / 2;
    const double end_angle = start_angle + sweep, last = std::fmax(start_angle, end_angle);
    double k = std::ceil(std::fmin(start_angle, end_angle) / quarter);
    for (int count = 0; count < 6 && k * quarter <= last; ++count, ++k) {
      const double t = (k * quarter - start_angle) / sweep;
      if (t > 0 && t < 1) visit(t);
    }
  }

  /// The bounding box, up to `evaluation_error()`.
  Box box() const {
    Box box = Box::around({a, b});
    for_each_extreme([&](double t) { box.include(on_circle(t)); });
    return box;
  }

  /// A bound on the distance of `point(t)` and the ends from the exact circle [m]: the distance of
  /// the stored ends from it, plus rounding of angles, sine, cosine and the sum.
  double evaluation_error() const {
    const double gap = std::fmax(distance(a, on_circle(0)), distance(b, on_circle(1)));
    const double angles = 4 + std::abs(start_angle) + std::abs(sweep);
    return gap + 4 * 0x1p-53 * (detail::max_magnitude(center) + radius * angles);
  }

 private:
  Point direction(double t) const {
    const double angle = start_angle + t * sweep;
    return {std::cos(angle), std::sin(angle)};
  }
  Point on_circle(double t) const {
    const Point d = direction(t);
    return {center.x() + radius * d.x(), center.y() + radius * d.y()};
  }
};

namespace detail {

/// The shortest distance between an arc and a segment, and a parameter of the arc that attains it.
/// In closed form: candidates are the ends of both, the foot of the perpendicular from the centre,
/// and the intersections of line and circle.
inline ClosestApproach closest_approach(const Arc& arc, const Segment& segment) {
  ClosestApproach best{distance(arc.a, segment), 0};
  const auto consider = [&](double distance, double parameter) {
    if (distance < best.distance) best = {distance, parameter};
  };
  consider(distance(arc.b, segment), 1);
  const auto consider_towards = [&](const Point& v, double distance) {
    const double t = arc.parameter_towards(v);
    if (t >= 0 && t <= 1) consider(distance, t);
  };
  for (const Point& end : {segment.a, segment.b}) {
    const Point v = end - arc.center;
    consider_towards(v, std::abs(v.norm() - arc.radius));
  }
  const Point along = segment.b - segment.a, from_centre = segment.a - arc.center;
  const double length = along.norm();
  if (!(length > 0)) return best;
  const Point unit{along.x() / length, along.y() / length};
  const double foot_at = -from_centre.dot(unit);  // position of the foot along the segment
  const double offset = cross(from_centre, unit);
  const Point foot{offset * unit.y(), -offset * unit.x()};  // relative to the centre
  const double height = std::abs(offset);
  if (foot_at >= 0 && foot_at <= length) {
    if (height > 0) {
      consider_towards(foot, std::abs(height - arc.radius));
    } else {
      consider_towards({-unit.y(), unit.x()}, arc.radius);
      consider_towards({unit.y(), -unit.x()}, arc.radius);
    }
  }
  if (height < arc.radius) {
    const double half = std::sqrt((arc.radius - height) * (arc.radius + height));
    for (const double side : {-half, half}) {
      if (foot_at + side < 0 || foot_at + side > length) continue;
      consider_towards({foot.x() + side * unit.x(), foot.y() + side * unit.y()}, 0);
    }
  }
  return best;
}

}  // namespace detail

}  // namespace tutavia
