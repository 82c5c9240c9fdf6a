// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/route/farthest_in_sight.hpp"
#include "tutavia/smooth/route/input_checks.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Shortcut: replaces parts of a path by straight lines between waypoints in sight.

namespace tutavia {

/// Greedy shortcuts: from each kept waypoint straight to a late waypoint in sight. The grid nodes
/// on a grid path count as waypoints.
///
/// Looks ahead in doubling steps until a waypoint is out of sight, then bisects: O(n log n) lines
/// of sight for n waypoints. Sight need not be monotone along a path, so the waypoint found is not
/// always the last one in sight. Every line taken is tested. The result is never longer than its
/// input.
///
/// Example: examples/smoothers.cpp.
struct Shortcut {
  static constexpr std::string_view name = "shortcut";

  /// Errors: `invalid_input` for a curve that is not free; those of the budget.
  template <ClearanceSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    auto curve = detail::free_steps(space, input, budget);
    if (!curve) return curve;
    const std::vector<Point> points = waypoints(*curve);
    Curve result;
    for (std::size_t i = 0; i + 1 < points.size();) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while taking shortcuts");
      const auto sees = [&](std::size_t j) { return space.segment_free(points[i], points[j]); };
      const std::size_t last = detail::farthest_looking_ahead(i, points.size() - 1, sees);
      const Piece& original = curve->pieces()[i];
      if (last > i + 1 || (!original.holds<Segment>() && sees(last))) {
        result.push_back(Segment{points[i], points[last]});
      } else {
        result.push_back(original);
      }
      i = last;
    }
    return result;
  }
};

}  // namespace tutavia
