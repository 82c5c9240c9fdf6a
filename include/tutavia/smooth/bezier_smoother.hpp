// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/core/error.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/pull/shortcut.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// BezierSmoother: corners of a polyline rounded by cubic Bezier pieces.

namespace tutavia {

/// Rounds every corner of a polyline by a cubic Bezier piece that begins on one leg and ends on the
/// other, at equal distances from the corner.
///
/// A corner takes `trim` of its legs, at most half of each, and half as much again and again until
/// the piece is proved; after eight halvings the corner stays. Within a piece, and where it meets
/// the legs, the direction changes continuously. Guarantees: the ends are exact, the pieces and
/// what is left of the legs are proved at the space's safety radius, and the result is never longer
/// than its input. O(n) for n corners.
///
/// Source: Yang et al., "Improved A* based on fused Theta*", equations (12) to (17); where the
/// control points lie it does not say, see docs/algorithms.md.
struct BezierSmoother {
  static constexpr std::string_view name = "bezier";

  /// Most of a leg that a corner takes; in spacings of the space's grid, in metres where it has
  /// none.
  double trim = 1.5;
  /// How far the inner control points go from the ends of the piece towards the corner, in (0, 1].
  double fullness = 2.0 / 3;

  /// Errors: `invalid_option` for a trim that is negative or not a number and a fullness out of
  /// range, `invalid_input` for a curve that is no polyline, what the budget says.
  template <ClearanceSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    if (!(trim >= 0)) return fail(PlanError::invalid_option, "trim must not be negative");
    if (!(0 < fullness && fullness <= 1)) {
      return fail(PlanError::invalid_option, "fullness must lie in (0, 1]");
    }
    for (const Piece& piece : input.pieces()) {
      if (!std::holds_alternative<Segment>(piece)) {
        return fail(PlanError::invalid_input, "the Bezier smoother takes polylines only");
      }
    }
    const std::vector<Point> nodes = joints(input);
    std::vector<Rounding> corners(nodes.size());
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      if (i % 64 == 1) {
        if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
      }
      corners[i] = round(space, nodes[i - 1], nodes[i], nodes[i + 1]);
    }
    // What is left of a leg lies on it but for rounding; where that is too much, the leg stays.
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      if (corners[i].out == 0 && corners[i + 1].in == 0) continue;
      const Segment rest = leg(nodes, corners, i);
      if (rest.a != rest.b && !is_proved_free(space, rest)) corners[i] = corners[i + 1] = {};
    }
    Curve result;
    result.reserve(2 * nodes.size());
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      if (i > 0 && corners[i].in > 0) {
        result.push_back(
            piece(nodes[i - 1], nodes[i], nodes[i + 1], corners[i].in, corners[i].out));
      }
      const Segment rest = leg(nodes, corners, i);
      if (rest.a != rest.b || (corners[i].out == 0 && corners[i + 1].in == 0)) {
        result.push_back(rest);
      }
    }
    return result;
  }

 private:
  /// The parts of the legs before and after a corner that its piece takes; 0: the corner stays.
  struct Rounding {
    double in = 0, out = 0;
  };

  template <class S>
  double longest_trim(const S& space) const {
    if constexpr (LinkedSpace<S>) {
      return trim * space.frame().resolution;
    } else {
      return trim;
    }
  }

  CubicBezier piece(const Point& a, const Point& corner, const Point& b, double in,
                    double out) const {
    const Point first = lerp(a, corner, 1 - in), last = lerp(corner, b, out);
    return {{first, lerp(first, corner, fullness), lerp(last, corner, fullness), last}};
  }

  template <class S>
  Rounding round(const S& space, const Point& a, const Point& corner, const Point& b) const {
    const double before = distance(a, corner), after = distance(corner, b);
    const double turn = cross(corner - a, b - corner), along = (corner - a).dot(b - corner);
    // Straight on, or straight back: nothing to round.
    if (std::abs(turn) <= 1e-9 * std::abs(along) || before == 0 || after == 0) return {};
    double taken = std::min({longest_trim(space), before / 2, after / 2});
    for (int halvings = 0; halvings <= 8; ++halvings, taken /= 2) {
      const Rounding rounding{std::min(taken / before, 0.5), std::min(taken / after, 0.5)};
      if (rounding.in == 0 || rounding.out == 0) break;
      if (is_proved_free(space, piece(a, corner, b, rounding.in, rounding.out))) return rounding;
    }
    return {};
  }

  /// What its corners leave of the leg from node i to the next.
  static Segment leg(const std::vector<Point>& nodes, const std::vector<Rounding>& corners,
                     std::size_t i) {
    const Point &a = nodes[i], &b = nodes[i + 1];
    return {corners[i].out > 0 ? lerp(a, b, corners[i].out) : a,
            corners[i + 1].in > 0 ? lerp(a, b, 1 - corners[i + 1].in) : b};
  }
};

}  // namespace tutavia
