// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/smooth/route/input_checks.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// BezierSmoother: rounds the corners of a curve by cubic Bezier pieces.

namespace tutavia {

/// Rounds every corner between two pieces of a curve by a cubic Bezier piece. Its ends lie on the
/// two pieces, at equal distances from the corner.
///
/// That distance is at first `trim`, but at most half of each piece. It is halved until the Bezier
/// piece is proved; after eight halvings the corner stays. The direction changes continuously
/// within the Bezier piece and at its ends. Guarantees: the ends are exact; the new pieces and the
/// rests of the old ones are proved at the space's safety radius; the result is never longer than
/// its input. O(n) for n corners.
///
/// Source: Yang et al., "Improved A* based on fused Theta*", equations (12) to (17). It does not
/// say where the control points lie; see docs/algorithms.md.
///
/// Example: examples/smoothers.cpp.
struct BezierSmoother {
  static constexpr std::string_view name = "bezier";

  /// Largest length that a corner takes of each piece. In units of the grid's resolution, or in
  /// metres if the space has no grid.
  double trim = 1.5;
  /// Position of the inner control points between the ends of the Bezier piece and the corner, in
  /// (0, 1].
  double fullness = 2.0 / 3;

  /// Errors: `invalid_option` for a trim that is negative or NaN and for a fullness out of range;
  /// `invalid_input` for a curve that is not free; those of the budget.
  template <ClearanceSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    if (!(trim >= 0)) return fail(PlanError::invalid_option, "trim must not be negative");
    if (!(0 < fullness && fullness <= 1)) {
      return fail(PlanError::invalid_option, "fullness must lie in (0, 1]");
    }
    if (const auto free = detail::check_free(space, input, budget); !free)
      return Unexpected{free.error()};
    const std::size_t count = input.pieces().size();
    std::vector<Rounding> corners(count + 1);  // before each piece, and at the end
    for (std::size_t i = 1; i < count; ++i) {
      if (i % 64 == 1) {
        if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
      }
      corners[i] = round(space, input, i);
    }
    // The rest of a piece lies on it up to rounding. If that already makes it unprovable, the whole
    // piece stays.
    for (std::size_t i = 0; i < count;) {
      if (i % 64 == 0) {
        if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
      }
      if (is_rest_free(space, input.pieces()[i], corners[i], corners[i + 1])) {
        ++i;
      } else {
        corners[i] = corners[i + 1] = {};
        if (i > 0) --i;  // the previous piece keeps more of its length, too
      }
    }
    Curve result;
    result.reserve(2 * count);
    for (std::size_t i = 0; i < count; ++i) {
      if (corners[i].is_round) result.push_back(corners[i].piece);
      const double from = corners[i].to, to = corners[i + 1].from;
      if (from < to) {
        input.pieces()[i].visit([&](const auto& p) { result.push_back(p.part(from, to)); });
      }
    }
    return result;
  }

 private:
  /// The piece that replaces a corner, from a parameter of the previous piece to one of the next.
  struct Rounding {
    bool is_round = false;
    double from = 1, to = 0;
    CubicBezier piece{{Point::Zero(), Point::Zero(), Point::Zero(), Point::Zero()}};
  };
  /// A position on a piece, and the direction of travel there.
  struct CurveLocation {
    double parameter;
    Point position, direction;
  };

  /// The position at arc length s of a piece of length `total`.
  static CurveLocation location(const Piece& piece, double s, double total) {
    return piece.visit([&](const auto& p) {
      const double t = detail::parameter_at(p, s, total, s / total);
      Point direction = p.derivative(t);
      const double speed = direction.norm();
      if (speed > 0) direction = {direction.x() / speed, direction.y() / speed};
      return CurveLocation{t, p.point(t), direction};
    });
  }

  /// The rounding of the corner before piece i.
  template <ClearanceSpace S>
  Rounding round(const S& space, const Curve& curve, std::size_t i) const {
    const Piece &in = curve.pieces()[i - 1], &out = curve.pieces()[i];
    const double before = curve.length_before(i) - curve.length_before(i - 1);
    const double after = curve.length_before(i + 1) - curve.length_before(i);
    const Point u = in.visit([](const auto& p) -> Point { return p.end_direction(); });
    const Point v = out.visit([](const auto& p) -> Point { return p.start_direction(); });
    // Nothing to round: straight ahead or straight back.
    if (!(std::abs(cross(u, v)) > 1e-9 * std::abs(u.dot(v))) || before == 0 || after == 0) {
      return {};
    }
    double taken = std::min({trim * detail::length_unit(space), before / 2, after / 2});
    for (int halvings = 0; halvings <= 8 && taken > 0; ++halvings, taken /= 2) {
      const CurveLocation a = location(in, before - taken, before), b = location(out, taken, after);
      if (a.parameter == 1 || b.parameter == 0) break;
      const double handle = fullness * taken;
      const CubicBezier piece{{a.position, detail::offset_along(a.position, handle, a.direction),
                               detail::offset_along(b.position, -handle, b.direction), b.position}};
      if (piece.length() <= 2 * taken && is_proved_free(space, piece)) {
        return {true, a.parameter, b.parameter, piece};
      }
    }
    return {};
  }

  /// Whether the rest of a piece between the roundings at its ends is free.
  template <ClearanceSpace S>
  static bool is_rest_free(const S& space, const Piece& piece, const Rounding& before,
                           const Rounding& after) {
    if (!before.is_round && !after.is_round) return true;
    if (before.to >= after.from) return before.to == after.from;  // nothing is left
    return piece.visit(
        [&](const auto& p) { return is_proved_free(space, p.part(before.to, after.from)); });
  }
};

}  // namespace tutavia
