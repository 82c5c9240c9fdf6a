// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/numeric/closest_parameter.hpp"
#include "tutavia/geometry/numeric/quadrature.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// Quadratic and cubic Bezier pieces.

namespace tutavia {

/// A Bezier piece with Degree + 1 control points; parameter t in [0, 1].
template <std::size_t Degree>
struct Bezier {
  static_assert(Degree == 2 || Degree == 3);

  std::array<Point, Degree + 1> points;

  const Point& start() const { return points.front(); }
  const Point& end() const { return points.back(); }

  /// De Casteljau's algorithm; exact at both ends, error below 12 u M elsewhere.
  Point point(double t) const {
    if (t == 1) return end();
    auto p = points;
    for (std::size_t level = Degree; level > 0; --level) {
      for (std::size_t i = 0; i < level; ++i) p[i] = detail::lerp(p[i], p[i + 1], t);
    }
    return p[0];
  }

  Point derivative(double t) const {
    std::array<Point, Degree> d;
    for (std::size_t i = 0; i < Degree; ++i) d[i] = points[i + 1] - points[i];
    for (std::size_t level = Degree - 1; level > 0; --level) {
      for (std::size_t i = 0; i < level; ++i) d[i] = detail::lerp(d[i], d[i + 1], t);
    }
    return {Degree * d[0].x(), Degree * d[0].y()};
  }

  Point second_derivative(double t) const {
    const Point first = second_difference(0), last = second_difference(Degree - 2);
    const Point between = detail::lerp(first, last, t);
    return {Degree * (Degree - 1) * between.x(), Degree * (Degree - 1) * between.y()};
  }

  /// Direction of travel at the start, also if control points coincide; zero only for a single
  /// point.
  Point start_direction() const {
    for (std::size_t i = 1; i <= Degree; ++i) {
      if (points[i] != start()) return points[i] - start();
    }
    return Point::Zero();
  }

  /// Direction of travel at the end; see `start_direction`.
  Point end_direction() const {
    for (std::size_t i = Degree; i-- > 0;) {
      if (points[i] != end()) return end() - points[i];
    }
    return Point::Zero();
  }

  /// Arc length, by quadrature (relative error about 1e-12, cusps and hairpins included).
  double length() const { return length_within(1e-13 * polygon_length(), 60); }

  /// Arc length from the start to parameter t.
  double length_to(double t) const { return t == 1 ? length() : head(t).length(); }

  /// Box of the control points, which contains the piece.
  Box box() const {
    Box box;
    for (const Point& p : points) box.include(p);
    return box;
  }

  bool is_finite() const {
    return std::all_of(points.begin(), points.end(),
                       [](const Point& p) { return tutavia::detail::is_finite(p); });
  }

  /// Parameter of the point nearest to `p`; the smallest one in case of a tie. Its distance exceeds
  /// the minimum by at most 4e-12 of the piece's size plus 2^-44 of the distance; see
  /// detail::ClosestParameter.
  double nearest_parameter(const Point& p) const {
    return detail::ClosestParameter<Bezier>(relative_to(p)).parameter();
  }

  /// Largest distance between the piece and its chord at the same parameter: exact for a quadratic
  /// (|P0 - 2 P1 + P2| / 4), a bound for a cubic (3/4 of the larger second difference).
  double deviation() const {
    if constexpr (Degree == 2) {
      return second_difference(0).norm() / 4;
    } else {
      return 0.75 * std::max(second_difference(0).norm(), second_difference(1).norm());
    }
  }

  /// The part over [0, t].
  Bezier head(double t) const {
    Bezier result = *this;
    for (std::size_t level = 1; level <= Degree; ++level) {
      for (std::size_t i = Degree; i >= level; --i) {
        result.points[i] = detail::lerp(result.points[i - 1], result.points[i], t);
      }
    }
    return result;
  }

  /// The part over [from, to], with the ends point(from) and point(to). \pre 0 <= from <= to <= 1
  ///
  /// Its control points are values of the polar form (Ramshaw 1987): k of them at `to`.
  Bezier part(double from, double to) const {
    if (from == 0 && to == 1) return *this;
    Bezier result;
    for (std::size_t k = 0; k <= Degree; ++k) {
      auto p = points;
      for (std::size_t level = Degree; level > 0; --level) {
        const double t = level > k ? from : to;
        for (std::size_t i = 0; i < level; ++i) p[i] = detail::lerp(p[i], p[i + 1], t);
      }
      result.points[k] = p[0];
    }
    if (from == 0) result.points.front() = start();
    if (from == 1) result.points.fill(end());
    if (to == 0) result.points.fill(start());
    if (to == 1) result.points.back() = end();
    return result;
  }

  Bezier reversed() const {
    Bezier result = *this;
    std::reverse(result.points.begin(), result.points.end());
    return result;
  }

  /// The piece with `p` as the origin. Rounding errors then scale with the size of the piece and
  /// its distance from `p`, not with its coordinates.
  Bezier relative_to(const Point& p) const {
    Bezier result = *this;
    for (Point& q : result.points) q = {q.x() - p.x(), q.y() - p.y()};
    return result;
  }

  /// The parts over [0, 1/2] and [1/2, 1]. Every coordinate gains an error of at most Degree u M.
  std::pair<Bezier, Bezier> halves() const {
    Bezier left, right;
    auto p = points;
    for (std::size_t level = Degree + 1; level-- > 0;) {
      left.points[Degree - level] = p[0];
      right.points[level] = p[level];
      for (std::size_t i = 0; i < level; ++i)
        p[i] = {0.5 * (p[i].x() + p[i + 1].x()), 0.5 * (p[i].y() + p[i + 1].y())};
    }
    return {left, right};
  }

 private:
  double polygon_length() const {
    double sum = 0;
    for (std::size_t i = 0; i < Degree; ++i) sum += distance(points[i], points[i + 1]);
    return sum;
  }

  /// Whether no two legs of the control polygon differ by more than 60 degrees or by a factor of
  /// more than 4: the speed then varies little, and quadrature converges fast.
  bool is_gentle() const {
    for (std::size_t i = 0; i < Degree; ++i) {
      for (std::size_t j = 0; j < Degree; ++j) {
        const Point a = points[i + 1] - points[i], b = points[j + 1] - points[j];
        if (!(16 * b.squaredNorm() >= a.squaredNorm() && a.dot(b) >= 0.5 * a.norm() * b.norm())) {
          return false;
        }
      }
    }
    return true;
  }

  /// Arc length; halves the piece until every part is gentle or shorter than `tolerance`.
  double length_within(double tolerance, int halvings) const {
    const double polygon = polygon_length();
    if (!(polygon > tolerance) || halvings == 0 || !is_finite()) return polygon;
    if (is_gentle()) {
      return detail::integrate([this](double s) { return derivative(s).norm(); }, 0, 1,
                               1e-13 * polygon);
    }
    const auto [left, right] = halves();
    return left.length_within(tolerance, halvings - 1) +
           right.length_within(tolerance, halvings - 1);
  }

  Point second_difference(std::size_t i) const {
    const Point &p = points[i], &q = points[i + 1], &r = points[i + 2];
    return {p.x() - 2 * q.x() + r.x(), p.y() - 2 * q.y() + r.y()};
  }
};

using QuadraticBezier = Bezier<2>;
using CubicBezier = Bezier<3>;

}  // namespace tutavia
