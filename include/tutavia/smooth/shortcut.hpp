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
/// Shortcut: straight lines between joints that see each other.

namespace tutavia {

/// Greedy shortcuts: from each joint kept, goes straight to a late joint that it sees. The nodes
/// that a grid path passes count as joints.
///
/// Looks ahead in doubling steps until a joint is out of sight, then bisects: O(n log n) lines of
/// sight for n joints. Sight need not be monotone along a path, so the joint found is not always
/// the last one in sight; every line taken was tested. Never longer than its input.
struct Shortcut {
  static constexpr std::string_view name = "shortcut";

  /// Errors: `invalid_input` for a curve that is not free, what the budget says.
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
