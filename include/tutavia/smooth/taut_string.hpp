// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/route/input_checks.hpp"
#include "tutavia/smooth/string/taut_string_solver.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// TautString: the shortest curve in the homotopy class of a path.

namespace tutavia {

/// The shortest curve in the homotopy class of a path: the path can be pulled into it without
/// crossing an obstacle. It consists of segments tangent to circles and of arcs of these circles.
/// The circles have the safety radius and lie around obstacle vertices; discs have circles around
/// them, too. The curve has no corners, except at safety radius 0, where it bends at vertices.
///
/// Bends are pulled one after another. A pull is made only if its result is proved, so every
/// intermediate string is collision-free and never longer than the input. If the deadline passes,
/// the current string is returned. Circles exceed the safety radius by a few rounding errors, and
/// so does the length exceed the optimum. If free space is no wider than that, a pull cannot be
/// proved and corners of the route stay: at a start or goal at the safety radius, in a gap of twice
/// the radius, and, at radius 0, at walls and points that may not be touched. The homotopy class
/// never changes; for shorter routes on the other side of an obstacle see HomotopyRefine. O(log m +
/// k h) per pull for m obstacle edges, k vertices between the strings before and after the pull,
/// and h of them on the string. Routes of grid searches take 1 to 2 pulls per bend.
///
/// Example: examples/smoothers.cpp.
struct TautString {
  static constexpr std::string_view name = "taut_string";

  /// Errors: `invalid_input` for a curve that is not free or not of segments and arcs; `cancelled`;
  /// `budget_exhausted` while the route is checked.
  template <FeatureSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    const auto nodes = detail::free_polyline(space, input, budget, "the taut string");
    if (!nodes) return Unexpected{nodes.error()};
    if (nodes->empty()) return input;
    detail::TautStringSolver<S> string(space, *nodes, budget);
    const auto pulled = string.pull();
    if (!pulled && pulled.error().code == PlanError::cancelled) {
      return fail(PlanError::cancelled, "while pulling a string");
    }
    return string.curve();
  }
};

}  // namespace tutavia
