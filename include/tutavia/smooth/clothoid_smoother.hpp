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
/// ClothoidSmoother: a path of continuous curvature.

namespace tutavia {

/// Takes a taut string away from the obstacles by a part of the safety radius, and uses that room
/// to make its curvature continuous: every bend becomes a pair of mirrored spirals or, where it
/// turns far, an arc between two.
///
/// A polyline is pulled taut first; a curve of segments and arcs (a taut string, the path of a
/// tangent graph) is taken as it is. A bend for which the room is not free gets half of it, and
/// half of that, and in the end stays the arc or the corner that it was: `max_curvature_jump` and
/// `max_joint_deflection` of the metrics tell. Cubic Beziers know the pair alone.
///
/// Guarantees: the ends are exact; all pieces are proved at the safety radius; the bends' radii are
/// no less than those of the string's arcs and than `min_turning_radius`. The length exceeds that
/// of a taut string by the clearance budget times its own turning angle at most, more only where
/// `min_turning_radius` asks for wider bends. O(n) proofs for n bends.
///
/// Source: Meek and Walton 1992, "Clothoid spline transition spirals"; Yang and Sukkarieh 2010 for
/// the Bezier pieces; see docs/algorithms.md.
struct ClothoidSmoother {
  static constexpr std::string_view name = "clothoid";

  /// The pieces along which the curvature changes.
  enum class Spirals {
    clothoids,     ///< the curvature grows evenly with arc length
    cubic_beziers  ///< for users who know no clothoids; see bezier_spirals
  };

  /// How far the string may be taken from the safety zones, in safety radii; where the safety
  /// radius is 0, in spacings of the space's grid (in metres where it has none).
  double clearance_budget = 0.1;
  /// [m]. Bends around obstacles of which the zone is rounder than that are taken wider,
  /// and where that is not free or the ways between bends are too short, smoothing fails.
  std::optional<double> min_turning_radius{};
  Spirals spirals = Spirals::clothoids;

  /// Errors: `invalid_option` for options that are negative or not finite, `invalid_input` for a
  /// curve that is not free or has other pieces than segments and arcs, `not_proved` where the
  /// turning radius cannot be kept, what the budget says.
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
    if (auto failure = spiral_string.widen(budget)) {
      if (failure->code == PlanError::not_proved && spiral_string.was_gentle()) return string;
      return Unexpected{std::move(*failure)};
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
