// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <type_traits>

#include "tutavia/certify/certificate.hpp"
#include "tutavia/geometry/curvature.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// PathMetrics: length, smoothness and clearance of a path.

namespace tutavia {

/// Metrics of one path. Turns are counted in runs: consecutive corners and curved pieces in the
/// same direction, without a straight piece between them, are one turn. In a polyline every vertex
/// is a turn.
struct PathMetrics {
  double length = 0;               ///< [m]
  std::size_t turning_points = 0;  ///< turns of more than half a degree
  double turning_angle = 0;        ///< sum of the magnitudes of all changes of heading [rad]
  /// Sum of pi - |turn| over the turning points [rad]: the figure that the DSP paper prints (in
  /// degrees) as "total turning angle". It favours few turns, not gentle ones.
  double interior_angle_sum = 0;
  /// Largest turn between two consecutive pieces [rad]; 0 for a smooth path.
  double max_joint_deflection = 0;
  /// Largest curvature of the pieces [1/m]; corners between pieces do not count. Infinite at cusps.
  double max_curvature = 0;
  /// Largest jump of the curvature between two consecutive pieces [1/m]; 0 up to rounding if the
  /// curvature is continuous.
  double max_curvature_jump = 0;
  double min_clearance = 0;  ///< the proved lower bound [m]
  /// Over arc length [m]; empty unless the caller computes it.
  std::optional<double> mean_clearance{};
};

namespace detail {

/// Adds up changes of heading along a curve.
class TurnCounter {
 public:
  explicit TurnCounter(PathMetrics& metrics) : metrics_(metrics) {}

  void turn(double angle) {
    // Where a smooth path goes on straight, rounding alone decides on the direction.
    constexpr double rounding = 1e-9;
    if (angle * run_ < 0 && std::abs(angle) > rounding) end_run();
    run_ += angle;
    metrics_.turning_angle += std::abs(angle);
  }
  void corner(double angle) {
    metrics_.max_joint_deflection = std::max(metrics_.max_joint_deflection, std::abs(angle));
    turn(angle);
  }
  void end_run() {
    constexpr double least = 0.5 * std::numbers::pi / 180;
    if (std::abs(run_) > least) {
      ++metrics_.turning_points;
      metrics_.interior_angle_sum += std::numbers::pi - std::abs(run_);
    }
    run_ = 0;
  }

 private:
  PathMetrics& metrics_;
  double run_ = 0;
};

/// The parameters between which a piece turns in one direction only, by less than half a turn: its
/// ends, its inflections (roots of B' x B'', a quadratic polynomial for a cubic Bezier) and the
/// eighths.
template <class P>
auto turning_intervals(const P& piece) {
  std::array<double, 11> t{0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1, 1, 1};
  if constexpr (std::is_same_v<P, CubicBezier>) {
    const auto value = [&](double s) {
      return cross(piece.derivative(s), piece.second_derivative(s));
    };
    const double f0 = value(0), f1 = value(1), middle = value(0.5);
    const double a = 2 * (f0 + f1 - 2 * middle), b = f1 - f0 - a, discriminant = b * b - 4 * a * f0;
    if (discriminant > 0) {
      const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
      for (const double root : {q / a, f0 / q}) {
        if (0 < root && root < 1) (root == q / a ? t[9] : t[10]) = root;
      }
    }
    std::sort(t.begin(), t.end());
  }
  return t;
}

}  // namespace detail

/// Length, turning and curvature of a curve; clearances stay unset. Where the gear of a vehicle
/// changes (`gears`, one per piece), its heading goes on: that is no corner, but ends a run.
inline PathMetrics measure(const Curve& curve, std::span<const Gear> gears = {}) {
  PathMetrics metrics;
  metrics.length = curve.length();
  detail::TurnCounter turns(metrics);
  Point heading = Point::Zero();  // at the end of the previous pieces
  double bend = 0;                // their curvature there
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    if (i > 0 && !gears.empty() && gears[i] != gears[i - 1]) {
      turns.end_run();
      heading = Point::Zero();
    }
    curve.pieces()[i].visit([&](const auto& piece) {
      using P = std::decay_t<decltype(piece)>;
      if (detail::is_zero(piece.start_direction())) return;  // a single point
      if (!detail::is_zero(heading)) {
        turns.corner(turn_angle(heading, piece.start_direction()));
        const double jump = std::abs(curvature(piece, 0) - bend);
        metrics.max_curvature_jump = std::max(metrics.max_curvature_jump, jump);
      }
      metrics.max_curvature = std::max(metrics.max_curvature, max_curvature(piece));
      if constexpr (std::is_same_v<P, Segment>) {
        turns.end_run();
      } else if constexpr (std::is_same_v<P, Arc>) {
        turns.turn(piece.sweep);
      } else if constexpr (std::is_same_v<P, Clothoid>) {
        const double inflection = -piece.start_curvature / (piece.sharpness * piece.arc_length);
        const double before = 0 < inflection && inflection < 1 ? piece.turn_to(inflection) : 0;
        turns.turn(before);
        turns.turn(piece.turn_to(1) - before);
      } else {
        Point before = piece.start_direction();
        for (const double t : detail::turning_intervals(piece)) {
          const Point after = t < 1 ? piece.derivative(t) : piece.end_direction();
          if (t == 0 || detail::is_zero(after)) continue;
          turns.turn(turn_angle(before, after));
          before = after;
        }
      }
      heading = piece.end_direction();
      bend = curvature(piece, 1);
    });
  }
  turns.end_run();
  return metrics;
}

/// The same, with the certified minimum clearance.
inline PathMetrics measure(const Curve& curve, const Certificate& certificate,
                           std::span<const Gear> gears = {}) {
  PathMetrics metrics = measure(curve, gears);
  metrics.min_clearance = certificate.lower;
  return metrics;
}

namespace detail {

/// The mean clearance over arc length [m], from 256 exact clearances. On a large grid this takes
/// many times as long as the search. \pre the curve is not empty
template <ClearanceSpace S>
double mean_clearance(const S& space, const Curve& curve) {
  constexpr std::size_t samples = 256;
  double sum = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const double s = curve.length() * (static_cast<double>(i) + 0.5) / samples;
    sum += space.clearance(curve.point(s)) / samples;
  }
  return sum;
}

}  // namespace detail

}  // namespace tutavia
