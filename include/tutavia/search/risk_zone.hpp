// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// RiskZone: a zone around obstacles and the cost of travelling in it.

namespace tutavia {

namespace detail {

/// A number that differs from `value` by at most `error`.
struct ValueWithError {
  double value = 0;
  double error = 0;
};

}  // namespace detail

/// A zone along the boundary of free space. The risk in it falls from 1 at the safety radius to 0
/// at distance `width` beyond.
///
/// A path costs its length plus `weight` times the integral of the risk along it.
///
/// Source: the improved RRT* of MM Science Journal, October 2023 (RRTS). This is a precise form of
/// its "safety cost" (docs/algorithms.md).
///
/// Example: examples/searches_among_polygons.cpp.
struct RiskZone {
  double width = 2;   ///< [m], positive
  double weight = 1;  ///< [m of length per m at risk 1], not negative
  /// Error bound of the integral along a path, as a share of the path's length; positive.
  double tolerance = 0.01;

  /// `invalid_option` for a width, weight or tolerance outside its range.
  Expected<void, Failure> check() const {
    const auto invalid = [](std::string detail) {
      return fail(PlanError::invalid_option, std::move(detail));
    };
    if (!(width > 0 && std::isfinite(width)))
      return invalid("the risk zone's width must be positive");
    if (!(weight >= 0 && std::isfinite(weight))) {
      return invalid("the risk zone's weight must not be negative");
    }
    if (!(tolerance > 0)) return invalid("the risk zone's tolerance must be positive");
    return {};
  }

  /// The risk at a free point, in [0, 1].
  template <ClearanceSpace S>
  double risk(const S& space, const Point& p) const {
    const double reach = space.safety_radius() + width;
    const double depth = reach - space.nearest(Segment{p, p}, reach).distance;
    return std::clamp(depth / width, 0.0, 1.0);
  }

  /// Whether a free segment stays outside the zone.
  template <ClearanceSpace S>
  bool is_outside(const S& space, const Point& p, const Point& q) const {
    const double reach = space.safety_radius() + width;
    return !(space.nearest(Segment{p, q}, reach).distance < reach);
  }

  /// The integral of the risk along a free segment [m], by the trapezoidal rule on parts that are
  /// halved until the error is small enough.
  ///
  /// The risk changes by at most 1 / width per metre. Let f and g be its values at the ends of a
  /// part of length h. Then its integral differs from h (f + g) / 2 by at most
  /// (h^2 / width^2 - (g - f)^2) width / 4. The bound is 0 on a path straight towards or away from
  /// an obstacle.
  template <ClearanceSpace S>
  detail::ValueWithError integral(const S& space, const Point& p, const Point& q) const {
    if (is_outside(space, p, q)) return {};
    const Segment segment{p, q};
    const double length = segment.length();
    return integral(space, length, [&](double s) { return segment.point(s / length); });
  }

  /// The same along a curve.
  template <ClearanceSpace S>
  detail::ValueWithError integral(const S& space, const Curve& curve) const {
    if (curve.empty()) return {};
    return integral(space, curve.length(), [&](double s) { return curve.point(s); });
  }

  /// The length of a free curve inside the zone [m]. Parts that the zone's boundary may cross are
  /// halved down to a ten-thousandth of the length and then count half.
  template <ClearanceSpace S>
  detail::ValueWithError length_inside(const S& space, const Curve& curve) const {
    detail::ValueWithError sum;
    if (!curve.empty()) add_inside(space, curve, 0, curve.length(), sum);
    return sum;
  }

  /// The cost of a free segment: length plus weighted risk.
  template <ClearanceSpace S>
  double cost(const S& space, const Point& p, const Point& q) const {
    const double length = distance(p, q);
    return weight == 0 ? length : length + weight * integral(space, p, q).value;
  }

 private:
  template <ClearanceSpace S, class PointAt>
  detail::ValueWithError integral(const S& space, double length, const PointAt& point_at) const {
    const auto risk_at = [&](double s) { return risk(space, point_at(s)); };
    detail::ValueWithError sum;
    add_risk(risk_at, 0, length, risk_at(0), risk_at(length), 1e-6 * length, sum);
    return sum;
  }

  /// Adds the integral from arc length a to b, where the risk is f and g.
  template <class RiskAt>
  void add_risk(const RiskAt& risk_at, double a, double b, double f, double g, double least,
                detail::ValueWithError& sum) const {
    const double h = b - a;
    const double error = std::max(0.0, h * h / (width * width) - (g - f) * (g - f)) * width / 4;
    if (error <= tolerance * h || h < least) {
      sum.value += h * (f + g) / 2;
      sum.error += error;
      return;
    }
    const double middle = a + h / 2, value = risk_at(middle);
    add_risk(risk_at, a, middle, f, value, least, sum);
    add_risk(risk_at, middle, b, value, g, least, sum);
  }

  /// Adds the length inside the zone between two arc lengths: all or nothing if the midpoint is far
  /// enough from the zone's boundary, else by halves.
  template <ClearanceSpace S>
  void add_inside(const S& space, const Curve& curve, double a, double b,
                  detail::ValueWithError& sum) const {
    const double h = b - a, middle = a + h / 2, boundary = space.safety_radius() + width;
    const Point p = curve.point(middle);
    const double clearance = space.nearest(Segment{p, p}, boundary + h).distance;
    if (clearance >= boundary + h / 2) return;
    if (clearance <= boundary - h / 2) {
      sum.value += h;
    } else if (h < 1e-4 * curve.length()) {
      sum.value += h / 2;
      sum.error += h / 2;
    } else {
      add_inside(space, curve, a, middle, sum);
      add_inside(space, curve, middle, b, sum);
    }
  }
};

}  // namespace tutavia
