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
/// BSplineSmoother: a cubic B-spline along a pruned polyline.

namespace tutavia {

/// Removes redundant nodes (`prune`) and runs a clamped uniform cubic B-spline along the remaining
/// ones. Auxiliary control points on the legs keep straight parts straight and corners as tight as
/// necessary.
///
/// If a piece cannot be proved, its corners are tightened by halving their reach; after six
/// halvings the polyline's corner stays. Curvature is continuous except at such corners, whose
/// neighbourhood is straight. Guarantees: the ends are exact, every piece is proved at the space's
/// safety radius, and the result is never longer than its input.
///
/// Source: the improved RRT* of MM Science Journal, October 2023 (RRTS), equation (1);
/// docs/algorithms.md decides the details that it leaves open.
///
/// Example: examples/smoothers.cpp.
struct BSplineSmoother {
  static constexpr std::string_view name = "b_spline";

  /// Distance of the auxiliary control points from a corner, at most a third of the leg. In units
  /// of the grid's resolution, or in metres if the space has no grid.
  double reach = 3;
  /// Whether redundant nodes are removed first; switch off for routes with deliberate detours.
  bool prune = true;

  /// Errors: `invalid_option` for a reach that is not positive; `invalid_input` for a curve that is
  /// not free or not of segments and arcs; those of the budget.
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
