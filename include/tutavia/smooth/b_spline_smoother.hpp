// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/smooth/redundant_node_removal.hpp"
#include "tutavia/smooth/route/input_checks.hpp"
#include "tutavia/smooth/spline/corner_spline.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// BSplineSmoother: a pruned polyline as a cubic B-spline.

namespace tutavia {

/// Drops redundant nodes (`prune`) and runs a clamped uniform cubic B-spline along what is left.
/// Helper control points on the legs keep straight parts straight and corners as tight as they have
/// to be.
///
/// A piece that cannot be proved draws its corners tighter, by halves; after six of them a corner
/// stays as it is. Curvature is continuous but at such corners, where the rest is straight.
/// Guarantees: the ends are exact, every piece is proved at the space's safety radius, the result
/// is never longer than its input.
///
/// Source: the improved RRT* of MM Science Journal, October 2023 (RRTS), equation (1); what it
/// leaves open is decided in docs/algorithms.md.
struct BSplineSmoother {
  static constexpr std::string_view name = "b_spline";

  /// How far from a corner its helpers lie, at most a third of the leg; in spacings of the space's
  /// grid, in metres where it has none.
  double reach = 3;
  /// Whether redundant nodes are dropped first; off for routes that go a longer way on purpose.
  bool prune = true;

  /// Errors: `invalid_option` for a reach that is not positive, `invalid_input` for a curve that is
  /// no polyline or not free, what the budget says.
  template <ClearanceSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    if (!(reach > 0)) return fail(PlanError::invalid_option, "reach must be positive");
    if (!prune) {
      const auto nodes = detail::free_polyline(space, input, budget, "the B-spline");
      if (!nodes) return Unexpected{nodes.error()};
      return spline(space, *nodes, budget);
    }
    auto pruned = RedundantNodeRemoval{}.smooth(space, input, budget);
    if (!pruned) return pruned;
    return spline(space, waypoints(*pruned), budget);
  }

 private:
  template <ClearanceSpace S>
  Expected<Curve, Failure> spline(const S& space, const std::vector<Point>& nodes,
                                  const Budget& budget) const {
    if (nodes.empty()) return Curve();
    return detail::CornerSpline(nodes, reach * detail::length_unit(space)).prove(space, budget);
  }
};

}  // namespace tutavia
