// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/geometry/vehicle_path.hpp"

/// \file
/// CurveSamples: clearance and curvature along a curve, for plots.

namespace tutavia::detail {

/// Clearance and curvature along a curve, by arc length.
struct CurveSamples {
  struct Sample {
    double s;          ///< arc length [m]
    double clearance;  ///< [m]; not finite if it is not known
    double curvature;  ///< magnitude [1/m]; infinite at cusps
  };
  std::vector<Sample> samples{};
  std::vector<double> corners{};  ///< arc lengths of turns by more than half a degree
};

/// Samples a curve at `count` steps and at least eight to each bent piece. The largest curvature of
/// a piece is always among the samples. A change of gear (`gears`, one per piece) is no corner.
template <class ClearanceAt>
CurveSamples sample_curve(const Curve& curve, std::size_t count, const ClearanceAt& clearance_at,
                          std::span<const Gear> gears = {}) {
  constexpr double least_turn = 0.5 * std::numbers::pi / 180;
  CurveSamples result;
  Point before = Point::Zero();  // direction at the end of the piece before
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    if (i > 0 && !gears.empty() && gears[i] != gears[i - 1]) before = Point::Zero();
    curve.pieces()[i].visit([&](const auto& piece) {
      const Point direction = piece.start_direction();
      if (is_zero(direction)) return;  // a single point
      const double from = curve.length_before(i), length = curve.length_before(i + 1) - from;
      if (!is_zero(before) && std::abs(turn_angle(before, direction)) > least_turn) {
        result.corners.push_back(from);
      }
      before = piece.end_direction();
      const double largest = max_curvature(piece);
      const double share = length / curve.length() * static_cast<double>(count);
      const auto steps = static_cast<std::size_t>(std::ceil(std::max(share, largest > 0 ? 8 : 1.)));
      std::size_t bent = result.samples.size();  // the sample with the largest curvature
      for (std::size_t k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(steps);
        const double s = from + t * length;
        const CurvePoint at = curve.at(s);
        const bool is_end = k == 0 || k == steps;
        const double bend = std::abs(is_end ? curvature(piece, t) : at.curvature);
        result.samples.push_back({s, clearance_at(at.position), bend});
        if (bend > result.samples[bent].curvature) bent = result.samples.size() - 1;
      }
      result.samples[bent].curvature = std::max(largest, result.samples[bent].curvature);
    });
  }
  return result;
}

/// The upper end of an axis of curvature: the largest value; or, if that is six times what nine of
/// ten bent samples stay below, or more, then three times that. So neither cusps nor very tight
/// arcs flatten all else.
inline double curvature_limit(std::span<const CurveSamples> curves) {
  std::vector<double> bends;
  for (const CurveSamples& curve : curves) {
    for (const CurveSamples::Sample& sample : curve.samples) {
      if (sample.curvature > 1e-9 && std::isfinite(sample.curvature)) {
        bends.push_back(sample.curvature);
      }
    }
  }
  if (bends.empty()) return 1;
  std::sort(bends.begin(), bends.end());
  const double most = bends.back(), usual = bends[(bends.size() - 1) * 9 / 10];
  return most < 6 * usual ? most : 3 * usual;
}

/// The largest clearance that is known; 1 if none is positive.
inline double clearance_limit(std::span<const CurveSamples> curves) {
  double most = 0;
  for (const CurveSamples& curve : curves) {
    for (const CurveSamples::Sample& sample : curve.samples) {
      if (std::isfinite(sample.clearance)) most = std::max(most, sample.clearance);
    }
  }
  return most > 0 ? most : 1;
}

}  // namespace tutavia::detail
