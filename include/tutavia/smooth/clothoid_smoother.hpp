// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/smooth/route/input_checks.hpp"
#include "tutavia/smooth/string/clothoid_string.hpp"
#include "tutavia/smooth/taut_string.hpp"

/// \file
/// ClothoidSmoother: paths of continuous curvature.

namespace tutavia {

/// Moves a taut string away from the obstacles by a fraction of the safety radius and uses that
/// margin to make its curvature continuous. Every bend becomes a pair of mirrored spirals or, for
/// large turns, an arc between two spirals.
///
/// A polyline is first pulled taut. A curve of segments and arcs (a taut string, the path of a
/// tangent graph) is used directly. If a widened bend collides, its margin is halved until it fits,
/// down to the original arc or corner; then `max_curvature_jump` or `max_joint_deflection` of the
/// metrics is not 0. Cubic Bezier spirals support only the symmetric pair, without an arc between.
///
/// Guarantees: the ends are exact; all pieces are proved at the safety radius; the radii of bends
/// are at least those of the string's arcs and `min_turning_radius`. The length exceeds that of a
/// taut string by at most the clearance budget times its own total turn, and by more only if
/// `min_turning_radius` requires wider bends. O(n) proofs for n bends.
///
/// Source: Meek and Walton 1992, "Clothoid spline transition spirals"; Yang and Sukkarieh 2010 for
/// the Bezier pieces; see docs/algorithms.md.
///
/// Example: examples/smoothers.cpp.
struct ClothoidSmoother {
  static constexpr std::string_view name = "clothoid";

  /// The pieces along which the curvature changes.
  enum class Spirals {
    clothoids,     ///< curvature is linear in arc length
    cubic_beziers  ///< for consumers without clothoids; see bezier_spirals
  };

  /// Largest distance by which the string is moved away from the safety zones, in safety radii. At
  /// safety radius 0 in units of the grid's resolution, or in metres if the space has no grid.
  double clearance_budget = 0.1;
  /// Lower bound on the turning radius [m]. Bends around tighter safety zones are widened
  /// to it. Smoothing fails if a wider bend is not free or the segments between bends are too
  /// short.
  std::optional<double> min_turning_radius{};
  Spirals spirals = Spirals::clothoids;

  /// Errors: `invalid_option` for options that are negative or not finite; `invalid_input` for a
  /// curve that is not free or has pieces other than segments and arcs; `not_proved` if the turning
  /// radius cannot be kept; those of the budget.
  template <FeatureSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    for (const auto& [value, option] :
         {std::pair{clearance_budget, "clearance_budget"},
          std::pair{min_turning_radius.value_or(0), "min_turning_radius"}}) {
      if (!(value >= 0 && std::isfinite(value))) {
        return fail(PlanError::invalid_option,
                    std::string(option) + " must be finite and not negative");
      }
    }
    auto string = taut(space, input, budget);
    if (!string || string->empty()) return string;
    const double unit =
        space.safety_radius() > 0 ? space.safety_radius() : detail::length_unit(space);
    detail::ClothoidString<S> spiral_string(space, *string,
                                            {.margin = clearance_budget * unit,
                                             .min_turning_radius = min_turning_radius.value_or(0),
                                             .has_beziers = spirals == Spirals::cubic_beziers});
    if (auto widened = spiral_string.widen(budget); !widened) {
      if (widened.error().code == PlanError::not_proved && spiral_string.was_gentle())
        return string;
      return std::move(widened).unexpected();
    }
    return spiral_string.curve();
  }

 private:
  template <FeatureSpace S>
  static Expected<Curve, Failure> taut(const S& space, const Curve& input, const Budget& budget) {
    bool has_arcs = false;
    for (const Piece& piece : input.pieces()) {
      if (piece.holds<Segment>()) continue;
      if (!piece.holds<Arc>()) {
        return fail(PlanError::invalid_input,
                    "the clothoid smoother takes curves of segments and arcs");
      }
      has_arcs = true;
    }
    if (!has_arcs) return TautString{}.smooth(space, input, budget);
    if (const auto free = detail::check_free(space, input, budget); !free)
      return Unexpected{free.error()};
    return input;
  }
};

}  // namespace tutavia
