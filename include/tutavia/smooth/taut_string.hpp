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

/// The shortest curve of all that a path can be pulled into without crossing an obstacle (its
/// homotopy class): straight pieces that touch circles of the safety radius around obstacle
/// vertices, and arcs of these circles; discs have circles around them, too. So the curve has no
/// corners, but at safety radius 0, where it bends at vertices.
///
/// Pulls one bend of the string after another and proves what takes its place; a pull that cannot
/// be proved is not made. So the string is in free space all the time, never longer than its input,
/// and when the deadline passes while it is pulled it is returned as far as it is. Every circle
/// keeps a few rounding errors more than the safety radius, which is what its length exceeds the
/// shortest by. Where free space is no wider than these (a start or goal at the safety radius, a
/// gap of twice the radius, at radius 0 walls and points that may not be touched) a pull past it
/// cannot be proved, and corners of the route stay. Shorter ways on the other side of an obstacle
/// are not looked for. O(log m + k h) per pull for m obstacle edges, k vertices between the string
/// before and after and h of them on it; routes of grid searches take 1 to 2 pulls per bend.
struct TautString {
  static constexpr std::string_view name = "taut_string";

  /// Errors: `invalid_input` for a curve that is no polyline or not free, `cancelled`,
  /// `budget_exhausted` while the route is checked.
  template <FeatureSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    const auto nodes = detail::free_polyline(space, input, budget, "the taut string");
    if (!nodes) return Unexpected{nodes.error()};
    if (nodes->empty()) return input;
    detail::TautStringSolver<S> string(space, *nodes, budget);
    if (string.pull() == PlanError::cancelled) {
      return fail(PlanError::cancelled, "while pulling a string");
    }
    return string.curve();
  }
};

}  // namespace tutavia
