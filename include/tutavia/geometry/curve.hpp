// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/bezier.hpp"
#include "tutavia/geometry/segment.hpp"

/// \file
/// Curve: a chain of pieces, addressed by arc length.

namespace tutavia {

/// One part of a curve. Every kind has start(), end(), point(t), derivative(t),
/// second_derivative(t), start_direction(), end_direction(), length(), length_to(t), box(),
/// is_finite() and, where it is not straight or circular, deviation() and halves().
using Piece = std::variant<Segment, QuadraticBezier, CubicBezier, Arc>;

/// What a curve does at one place.
struct CurvePoint {
  double s = 0;  ///< arc length from the start [m]
  Point position = Point::Zero();
  double heading = 0;    ///< direction of travel in (-pi, pi] [rad]
  double curvature = 0;  ///< 1/m, left turns positive
};

/// Start of a piece of any kind.
inline Point start_of(const Piece& piece) {
  return std::visit([](const auto& p) -> Point { return p.start(); }, piece);
}

/// End of a piece of any kind.
inline Point end_of(const Piece& piece) {
  return std::visit([](const auto& p) -> Point { return p.end(); }, piece);
}

/// Curvature at parameter t [1/m], left turns positive; 0 where the piece stands still.
template <class P>
double curvature(const P& piece, double t) {
  const Point d = piece.derivative(t);
  const double speed = d.norm();
  return speed > 0 ? cross(d, piece.second_derivative(t)) / (speed * speed * speed) : 0.0;
}

/// A chain of pieces, each starting exactly where the one before ends. Arc length runs from 0 to
/// length(); places outside are clamped. At a joint the later piece counts.
class Curve {
 public:
  Curve() = default;

  /// The polyline through `points`; a single point gives a curve of length 0.
  static Curve polyline(std::span<const Point> points) {
    Curve curve;
    curve.reserve(points.size());
    if (points.size() == 1) curve.push_back(Segment{points[0], points[0]});
    for (std::size_t i = 1; i < points.size(); ++i) {
      curve.push_back(Segment{points[i - 1], points[i]});
    }
    return curve;
  }

  void reserve(std::size_t pieces) {
    pieces_.reserve(pieces);
    ends_.reserve(pieces);
  }

  /// \pre the piece starts where the curve ends
  void push_back(const Piece& piece) {
    TUTAVIA_ASSERT(pieces_.empty() || start_of(piece) == end());
    ends_.push_back(length() + std::visit([](const auto& p) { return p.length(); }, piece));
    pieces_.push_back(piece);
  }

  const std::vector<Piece>& pieces() const { return pieces_; }
  bool empty() const { return pieces_.empty(); }
  double length() const { return ends_.empty() ? 0.0 : ends_.back(); }

  /// \pre not empty
  Point start() const { return start_of(pieces_.front()); }
  /// \pre not empty
  Point end() const { return end_of(pieces_.back()); }

  /// The curve at arc length s.
  /// \pre not empty
  CurvePoint at(double s) const {
    const auto [i, t] = locate(s);
    CurvePoint result = std::visit([t = t](const auto& p) { return state(p, t); }, pieces_[i]);
    result.s = std::clamp(s, 0.0, length());
    return result;
  }
  Point point(double s) const { return at(s).position; }
  double heading(double s) const { return at(s).heading; }
  double curvature(double s) const { return at(s).curvature; }

  /// The piece that holds arc length s, and the parameter there.
  std::pair<std::size_t, double> locate(double s) const {
    TUTAVIA_ASSERT(!empty());
    s = std::clamp(s, 0.0, length());
    auto i =
        static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end(), s) - ends_.begin());
    if (i == pieces_.size()) {  // the end: of the last piece that has a length
      while (i > 1 && ends_[i - 2] == length()) --i;
      return {i - 1, 1.0};
    }
    const double local = s - (i == 0 ? 0.0 : ends_[i - 1]);
    const double total = ends_[i] - (i == 0 ? 0.0 : ends_[i - 1]);
    return {i, std::visit([&](const auto& p) { return parameter(p, local, total); }, pieces_[i])};
  }

  /// States at equal steps of arc length, at most `step` apart, both ends included.
  /// \pre not empty, step > 0
  std::vector<CurvePoint> sample(double step) const {
    TUTAVIA_ASSERT(step > 0);
    const auto count = static_cast<std::size_t>(std::ceil(length() / step));
    std::vector<CurvePoint> states;
    states.reserve(count + 1);
    for (std::size_t i = 0; i < count; ++i) {
      states.push_back(at(length() * static_cast<double>(i) / static_cast<double>(count)));
    }
    states.push_back(at(length()));
    return states;
  }

 private:
  template <class P>
  static CurvePoint state(const P& piece, double t) {
    Point direction = piece.derivative(t);
    if (is_null(direction)) {
      direction = t < 0.5 ? piece.start_direction() : piece.end_direction();
    }
    return {0, piece.point(t), tutavia::heading(direction), tutavia::curvature(piece, t)};
  }

  /// The parameter at which a piece of length `total` has the arc length s: Newton's method, kept
  /// within a bracket.
  template <class P>
  static double parameter(const P& piece, double s, double total) {
    if (!(total > 0)) return 0;
    if (s >= total) return 1;
    double low = 0, high = 1, t = s / total;
    if constexpr (!std::is_same_v<P, Segment> && !std::is_same_v<P, Arc>) {
      for (int i = 0; i < 60; ++i) {
        const double error = piece.length_to(t) - s;
        if (std::abs(error) <= 1e-13 * total) break;
        (error > 0 ? high : low) = t;
        const double next = t - error / piece.derivative(t).norm();
        t = low < next && next < high ? next : 0.5 * (low + high);
      }
    }
    return t;
  }

  std::vector<Piece> pieces_;
  std::vector<double> ends_;  // arc length at the end of each piece
};

}  // namespace tutavia
