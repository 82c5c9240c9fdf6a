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
/// BezierSmoother: corners of a curve rounded by cubic Bezier pieces.

namespace tutavia {

/// Rounds every corner between two pieces of a curve by a cubic Bezier piece that begins on the one
/// and ends on the other, at equal distances from the corner.
///
/// A corner takes `trim` of its two pieces, at most half of each, and half as much again and again
/// until the Bezier piece is proved; after eight halvings the corner stays. Where the Bezier piece
/// meets the others, and within, the direction changes continuously. Guarantees: the ends are
/// exact, the new pieces and what is left of the others are proved at the space's safety radius,
/// and the result is never longer than its input. O(n) for n corners.
///
/// Source: Yang et al., "Improved A* based on fused Theta*", equations (12) to (17); where the
/// control points lie it does not say, see docs/algorithms.md.
struct BezierSmoother {
  static constexpr std::string_view name = "bezier";

  /// Most of a piece that a corner takes; in spacings of the space's grid, in metres where it has
  /// none.
  double trim = 1.5;
  /// How far the inner control points go from the ends of the piece towards the corner, in (0, 1].
  double fullness = 2.0 / 3;

  /// Errors: `invalid_option` for a trim that is negative or not a number and a fullness out of
  /// range, `invalid_input` for a curve that is not free, what the budget says.
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
    // What is left of a piece lies on it but for rounding; where that is too much, the piece stays.
    for (std::size_t i = 0; i < count;) {
      if (i % 64 == 0) {
        if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
      }
      if (is_rest_free(space, input.pieces()[i], corners[i], corners[i + 1])) {
        ++i;
      } else {
        corners[i] = corners[i + 1] = {};
        if (i > 0) --i;  // there is more left of the one before, too
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
  /// The piece that takes a corner's place, from a parameter of the piece before it to one of the
  /// piece after it.
  struct Rounding {
    bool is_round = false;
    double from = 1, to = 0;
    CubicBezier piece{{Point::Zero(), Point::Zero(), Point::Zero(), Point::Zero()}};
  };
  /// A place on a piece, and the direction of travel there.
  struct CurveLocation {
    double parameter;
    Point position, direction;
  };

  /// The place at arc length s of a piece of length `total`.
  static CurveLocation location(const Piece& piece, double s, double total) {
    return piece.visit([&](const auto& p) {
      const double t = detail::parameter_at(p, s, total, s / total);
      Point direction = p.derivative(t);
      const double speed = direction.norm();
      if (speed > 0) direction = {direction.x() / speed, direction.y() / speed};
      return CurveLocation{t, p.point(t), direction};
    });
  }

  /// The rounding of the joint before piece i.
  template <ClearanceSpace S>
  Rounding round(const S& space, const Curve& curve, std::size_t i) const {
    const Piece &in = curve.pieces()[i - 1], &out = curve.pieces()[i];
    const double before = curve.length_before(i) - curve.length_before(i - 1);
    const double after = curve.length_before(i + 1) - curve.length_before(i);
    const Point u = in.visit([](const auto& p) -> Point { return p.end_direction(); });
    const Point v = out.visit([](const auto& p) -> Point { return p.start_direction(); });
    // Straight on, or straight back: nothing to round.
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

  /// Whether a piece is free without what the corners before and after it take.
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
