// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/predicates.hpp"

/// \file
/// Segment: a straight segment, and distances to it.

namespace tutavia {

/// The segment from `a` to `b`, which may be one point; parameter t in [0, 1].
struct Segment {
  Point a = Point::Zero();
  Point b = Point::Zero();

  const Point& start() const { return a; }
  const Point& end() const { return b; }
  /// Exact at both ends.
  Point point(double t) const {
    return t < 0.5 ? detail::lerp(a, b, t) : detail::lerp(b, a, 1 - t);
  }
  Point derivative(double) const { return b - a; }
  Point second_derivative(double) const { return Point::Zero(); }
  Point start_direction() const { return b - a; }
  Point end_direction() const { return b - a; }

  double length() const { return distance(a, b); }
  /// Arc length from the start to parameter t.
  double length_to(double t) const { return t * length(); }
  Box box() const { return Box::around({a, b}); }
  bool is_finite() const { return tutavia::detail::is_finite(a) && tutavia::detail::is_finite(b); }
  /// The part over [from, to], with the ends point(from) and point(to). \pre 0 <= from <= to <= 1
  Segment part(double from, double to) const {
    return {from == 0 ? a : point(from), to == 1 ? b : point(to)};
  }
  Segment reversed() const { return {b, a}; }
  /// Parameter of the point nearest to `p`.
  double nearest_parameter(const Point& p) const {
    const Point d = b - a;
    const double squared_length = d.squaredNorm();
    const Point v = p - a;
    return squared_length > 0 ? std::clamp(v.dot(d) / squared_length, 0.0, 1.0) : 0.0;
  }
};

/// Distance between `p` and the nearest point of `s` [m]; the error is below 12 u M for coordinates
/// up to M (u = 2^-53): 3 u from the cross product times the longest difference, 2 sqrt(2) M.
inline double distance(const Point& p, const Segment& s) {
  const Point d = s.b - s.a, v = p - s.a;
  const double squared_length = d.squaredNorm(), t = v.dot(d);
  if (!(t > 0)) return v.norm();
  if (t >= squared_length) return distance(p, s.b);
  return std::abs(cross(d, v)) / std::sqrt(squared_length);
}

namespace detail {

/// The closest approach of a piece and another segment.
struct ClosestApproach {
  double distance = 0;   ///< [m]
  double parameter = 0;  ///< of the nearest point of the piece
};

/// The shortest distance between two segments and a parameter of `s` that attains it: 0 if they
/// meet (decided by exact predicates), else with the error of `distance`.
inline ClosestApproach closest_approach(const Segment& s, const Segment& other) {
  if (segments_intersect(s.a, s.b, other.a, other.b)) {
    const Point d = s.b - s.a, e = other.b - other.a, gap_a = other.a - s.a;
    const double at_a = s.nearest_parameter(other.a), at_b = s.nearest_parameter(other.b);
    const double denominator = cross(d, e);
    double parameter = at_a, least = distance(s.point(at_a), other);
    // For nearly collinear segments an end may be closer than the computed crossing.
    for (const double t : {cross(gap_a, e) / denominator, at_b, 0.0, 1.0}) {
      if (!(t >= 0 && t <= 1)) continue;
      const double gap = distance(s.point(t), other);
      if (gap < least) {
        parameter = t;
        least = gap;
      }
    }
    return {0, parameter};
  }
  ClosestApproach best{distance(s.a, other), 0};
  if (const double d = distance(s.b, other); d < best.distance) best = {d, 1};
  if (const double d = distance(other.a, s); d < best.distance) {
    best = {d, s.nearest_parameter(other.a)};
  }
  if (const double d = distance(other.b, s); d < best.distance) {
    best = {d, s.nearest_parameter(other.b)};
  }
  return best;
}

/// Whether `s` keeps a distance of at least `radius` + `margin` from `core`: decided by the
/// computed distance if it differs by more than `error_bound`, else exactly. \pre `radius` and
/// `margin` are not negative
inline bool keeps_distance(const Segment& s, const Segment& core, double radius, double margin,
                           double error_bound) {
  const double gap = closest_approach(s, core).distance - radius - margin;
  if (gap > error_bound) return true;
  if (gap < -error_bound) return false;
  const auto keeps = [&](const Point& p, const Segment& q) {
    return compare_distance(p, q.a, q.b, radius, margin) >= 0;
  };
  return !segments_intersect(s.a, s.b, core.a, core.b) && keeps(s.a, core) && keeps(s.b, core) &&
         keeps(core.a, s) && keeps(core.b, s);
}

}  // namespace detail

}  // namespace tutavia
