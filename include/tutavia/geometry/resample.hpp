// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/geometry/curve.hpp"

/// \file
/// resample: the states of a curve at a fixed step of arc length.

namespace tutavia {

namespace detail {

/// A position on a piece that moves forward. Only the arc length since the last position is
/// measured, which keeps quadrature cheap.
struct PieceWalk {
  double t = 0;  ///< parameter
  double s = 0;  ///< measured arc length at t [m]

  /// The state of a piece of length `total` at the arc length `to`. \pre to >= s
  template <class P>
  CurvePoint go_to(const P& piece, double to, double total) {
    if constexpr (has_varying_speed<P>) {
      const P rest = piece.relative_to(piece.start()).part(t, 1);
      const double guess = (to - s) / rest.derivative(0).norm();
      const double u = parameter_at(rest, to - s, total - s, guess);
      t += u * (1 - t);
      s += rest.length_to(u);
    } else {
      t = to / total;
    }
    return state(piece, t);
  }
};

}  // namespace detail

/// The states of a curve at the arc lengths 0, ds, 2 ds, ... and at its end [m]; the last step is
/// the remainder (one below 1e-9 ds is merged with the previous step). A single state if the curve
/// is one point. Linear in pieces and samples; `Curve::sample` uses equal steps instead.
/// \pre the curve is finite and not empty, ds > 0
inline std::vector<CurvePoint> resample(const Curve& curve, double ds) {
  TUTAVIA_ASSERT(!curve.empty() && ds > 0);
  const double length = curve.length();
  const double whole = std::fmax(std::ceil(length / ds - 1e-9), 1.0);
  const std::size_t count = length > 0 ? static_cast<std::size_t>(whole) : 0;
  std::vector<CurvePoint> states;
  states.reserve(count + 1);
  std::size_t piece = 0;
  detail::PieceWalk walk;
  for (std::size_t k = 0; k < count; ++k) {
    const double s = static_cast<double>(k) * ds;
    if (s >= length) break;  // only if ds is within rounding of 0
    while (curve.length_before(piece + 1) <= s) ++piece, walk = {};
    const double before = curve.length_before(piece);
    const double total = curve.length_before(piece + 1) - before;
    const auto go = [&](const auto& p) { return walk.go_to(p, s - before, total); };
    states.push_back(curve.pieces()[piece].visit(go));
    states.back().s = s;
  }
  states.push_back(curve.at(length));
  return states;
}

}  // namespace tutavia
