// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/geometry/curvature.hpp"
#include "tutavia/geometry/piece.hpp"

/// \file
/// Curve: a chain of pieces, addressed by arc length.

namespace tutavia {

/// The state of a curve at one arc length.
struct CurvePoint {
  double s = 0;  ///< arc length from the start [m]
  Point position = Point::Zero();
  double heading = 0;    ///< direction of travel in (-pi, pi] [rad]
  double curvature = 0;  ///< 1/m, left turns positive
};

/// Largest magnitude of the curvature of a piece of any kind [1/m].
inline double max_curvature(const Piece& piece) {
  return piece.visit([](const auto& p) { return max_curvature(p); });
}

namespace detail {

/// Whether the parameter of a piece is not proportional to its arc length.
template <class P>
inline constexpr bool has_varying_speed = false;
template <std::size_t Degree>
inline constexpr bool has_varying_speed<Bezier<Degree>> = true;

/// The state of a piece at parameter t, with arc length 0.
template <class P>
CurvePoint state(const P& piece, double t) {
  Point direction = piece.derivative(t);
  if (is_zero(direction)) {
    direction = t < 0.5 ? piece.start_direction() : piece.end_direction();
  }
  return {0, piece.point(t), heading(direction), curvature(piece, t)};
}

/// The parameter of arc length s on a piece of length `total`: Newton's method from `guess`, kept
/// within a bracket.
template <class P>
double parameter_at(const P& piece, double s, double total, double guess) {
  if (!(total > 0)) return 0;
  if (s >= total) return 1;
  if constexpr (has_varying_speed<P>) {
    const P local = piece.relative_to(piece.start());
    double low = 0, high = 1, t = 0 < guess && guess < 1 ? guess : s / total;
    for (int i = 0; i < 60; ++i) {
      const double error = local.length_to(t) - s;
      if (std::abs(error) <= 1e-13 * total) break;
      if (error > 0) {
        high = t;
      } else {
        low = t;
      }
      const double next = t - error / local.derivative(t).norm();
      t = low < next && next < high ? next : 0.5 * (low + high);
    }
    return t;
  } else {
    return s / total;
  }
}

}  // namespace detail

/// A chain of pieces; each starts exactly at the end of the previous one. Arc length runs from 0 to
/// length(); values outside are clamped. Where two pieces meet, the later one counts.
class Curve {
 public:
  /// The point of a curve nearest to a given point.
  struct Nearest {
    double s = 0;  ///< arc length from the start [m]
    Point position = Point::Zero();
    double distance = 0;  ///< [m]
  };

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
    ends_.push_back(length() + piece.visit([](const auto& p) { return p.length(); }));
    pieces_.push_back(piece);
  }

  const std::vector<Piece>& pieces() const { return pieces_; }
  bool empty() const { return pieces_.empty(); }
  double length() const { return ends_.empty() ? 0.0 : ends_.back(); }
  /// Arc length at the start of piece i; the length of the curve for i = number of pieces.
  double length_before(std::size_t i) const { return i == 0 ? 0.0 : ends_[i - 1]; }

  /// \pre not empty
  Point start() const { return start_of(pieces_.front()); }
  /// \pre not empty
  Point end() const { return end_of(pieces_.back()); }

  /// The curve at arc length s.
  /// \pre not empty
  CurvePoint at(double s) const {
    const auto [i, t] = locate(s);
    CurvePoint result =
        pieces_[i].visit([parameter = t](const auto& p) { return detail::state(p, parameter); });
    result.s = std::clamp(s, 0.0, length());
    return result;
  }
  Point point(double s) const { return at(s).position; }
  double heading(double s) const { return at(s).heading; }
  double curvature(double s) const { return at(s).curvature; }

  /// The index of the piece at arc length s, and its parameter there.
  std::pair<std::size_t, double> locate(double s) const {
    TUTAVIA_ASSERT(!empty());
    s = std::clamp(s, 0.0, length());
    auto i =
        static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end(), s) - ends_.begin());
    if (i == pieces_.size()) {  // the end of the last piece with a positive length
      while (i > 1 && ends_[i - 2] == length()) --i;
      return {i - 1, 1.0};
    }
    const double local = s - length_before(i), total = ends_[i] - length_before(i);
    return {i, pieces_[i].visit([&](const auto& p) {
              return detail::parameter_at(p, local, total, local / total);
            })};
  }

  /// The point of the curve nearest to `p`; the one with the least arc length in case of a tie. In
  /// closed form on segments and arcs, by branch and bound on other pieces (tolerance: see
  /// Bezier::nearest_parameter).
  /// \pre not empty
  Nearest nearest(const Point& p) const {
    TUTAVIA_ASSERT(!empty());
    Nearest best{0, start(), distance(p, start())};
    std::size_t nearest_piece = 0;
    double parameter = 0;
    const auto consider = [&](std::size_t i, const auto& piece) {
      if constexpr (requires { piece.deviation(); }) {
        const Segment chord{piece.start(), piece.end()};
        if (distance(p, chord) - piece.deviation() > best.distance) return;
      }
      const double t = piece.nearest_parameter(p);
      const Point position = piece.point(t);
      const double gap = distance(p, position);
      if (gap < best.distance) {
        best = {0, position, gap};
        nearest_piece = i;
        parameter = t;
      }
    };
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      pieces_[i].visit([&](const auto& piece) { consider(i, piece); });
    }
    const double local =
        pieces_[nearest_piece].visit([&](const auto& piece) { return piece.length_to(parameter); });
    best.s = std::min(length_before(nearest_piece) + local, ends_[nearest_piece]);
    return best;
  }

  /// The curves before and after arc length s; they meet exactly. A side without length is a single
  /// point. If two pieces meet within 1e-12 of the length from s, the curve is split there, so that
  /// no tiny pieces arise.
  /// \pre not empty
  std::pair<Curve, Curve> split(double s) const {
    auto [i, t] = locate(s);
    s = std::clamp(s, 0.0, length());
    const double behind = s - length_before(i), ahead = ends_[i] - s;
    if (std::min(behind, ahead) <= 1e-12 * length()) t = behind < ahead ? 0 : 1;
    Curve first, second;
    for (std::size_t k = 0; k < i; ++k) first.push_back(pieces_[k]);
    pieces_[i].visit([&, cut = t](const auto& piece) {
      if (cut > 0) first.push_back(piece.part(0, cut));
      if (cut < 1) second.push_back(piece.part(cut, 1));
    });
    for (std::size_t k = i + 1; k < pieces_.size(); ++k) second.push_back(pieces_[k]);
    if (first.empty()) first.push_back(Segment{start(), start()});
    if (second.empty()) second.push_back(Segment{end(), end()});
    return {std::move(first), std::move(second)};
  }

  /// The curve from its end to its start.
  Curve reversed() const {
    Curve result;
    result.reserve(pieces_.size());
    for (std::size_t i = pieces_.size(); i-- > 0;) {
      pieces_[i].visit([&](const auto& piece) { result.push_back(piece.reversed()); });
    }
    return result;
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
  std::vector<Piece> pieces_;
  std::vector<double> ends_;  // arc length at the end of each piece
};

/// The waypoints of a curve: its start and the end of every piece.
inline std::vector<Point> waypoints(const Curve& curve) {
  std::vector<Point> points;
  if (curve.empty()) return points;
  points.reserve(curve.pieces().size() + 1);
  points.push_back(curve.start());
  for (const Piece& piece : curve.pieces()) points.push_back(end_of(piece));
  return points;
}

}  // namespace tutavia
