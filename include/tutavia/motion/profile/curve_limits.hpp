// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>
#include <vector>

#include "tutavia/geometry/curvature.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/motion/profile/trapezoidal.hpp"
#include "tutavia/motion/speed_limits.hpp"

/// \file
/// CurveLimits: how fast a robot may be where on a curve.

namespace tutavia::detail {

/// The limits on the speed along a curve, by intervals, and its stops.
struct CurveLimits {
  std::vector<SpeedInterval> intervals{};
  std::vector<double> squares{};  ///< limits on the squared speed at the interval boundaries
  std::vector<double> waits{};    ///< how long the robot stands there while it steers [s]
  bool is_known = true;           ///< false if a piece has no known bound on its curvature's change

  static CurveLimits of(const Curve& curve, const SpeedLimits& limits);

 private:
  /// Pieces along which the curvature changes are cut into several intervals.
  template <class P>
  static constexpr std::size_t parts_of(const P&) {
    return std::is_same_v<P, Segment> || std::is_same_v<P, Arc> ? 1 : 8;
  }
  template <class P>
  void add_intervals(const P& piece, const SpeedLimits& limits);
  void add_stops(const Curve& curve, const SpeedLimits& limits);
};

template <class P>
void CurveLimits::add_intervals(const P& piece, const SpeedLimits& limits) {
  double most = limits.max_speed * limits.max_speed;
  if (std::isfinite(limits.max_curvature_rate)) {
    if constexpr (std::is_same_v<P, Clothoid>) {
      const double most_there = limits.max_curvature_rate / std::abs(piece.sharpness);
      most = std::min(most, most_there * most_there);
    } else if constexpr (!std::is_same_v<P, Segment> && !std::is_same_v<P, Arc>) {
      is_known = false;
    }
  }
  const auto add = [&](const P& part) {
    intervals.push_back(
        {part.length(), std::min(most, limits.max_lateral_acceleration / max_curvature(part))});
  };
  const std::size_t parts = parts_of(piece);
  if (parts == 1) return add(piece);
  for (std::size_t i = 0; i < parts; ++i) {
    add(piece.part(double(i) / double(parts), double(i + 1) / double(parts)));
  }
}

/// The robot stops where the direction jumps and, with a limit on the curvature's change, where the
/// curvature jumps. At a cusp the steering that turned a vehicle to one side turns it to the other.
inline void CurveLimits::add_stops(const Curve& curve, const SpeedLimits& limits) {
  double largest = 0;
  for (const Piece& piece : curve.pieces()) {
    largest = std::max(largest, piece.visit([](const auto& p) { return max_curvature(p); }));
  }
  Point before = Point::Zero();
  double bend = 0;
  std::size_t at = 0;
  for (const Piece& piece : curve.pieces()) {
    piece.visit([&](const auto& p) {
      const Point direction = p.start_direction();
      if (!is_zero(direction)) {
        const double turn = is_zero(before) ? 0.0 : std::abs(turn_angle(before, direction));
        if (turn > std::numbers::pi - 1e-6) bend = -bend;
        const double steered = is_zero(before) ? 0.0 : std::abs(curvature(p, 0) - bend);
        const double takes = steered / limits.max_curvature_rate;
        const double wait = steered > 1e-9 * largest && takes > 1e-9 ? takes : 0.0;  // or rounding
        if (turn > 1e-6 || wait > 0) squares[at] = 0;
        waits[at] = std::max(waits[at], wait);
        before = p.end_direction();
        bend = curvature(p, 1);
      }
      at += parts_of(p);
    });
  }
}

inline CurveLimits CurveLimits::of(const Curve& curve, const SpeedLimits& limits) {
  CurveLimits result;
  for (const Piece& piece : curve.pieces()) {
    piece.visit([&](const auto& p) { result.add_intervals(p, limits); });
  }
  result.squares = boundary_speed_limits(result.intervals);
  result.squares.back() = std::min(result.squares.back(), limits.end_speed * limits.end_speed);
  result.waits.assign(result.squares.size(), 0);
  result.add_stops(curve, limits);
  return result;
}

}  // namespace tutavia::detail
