// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/core/error.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/pull/grid_nodes.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Shortcut: straight lines between joints that see each other.

namespace tutavia {

/// The joints of a curve: its start and the end of every piece.
inline std::vector<Point> joints(const Curve& curve) {
  std::vector<Point> points;
  if (curve.empty()) return points;
  points.reserve(curve.pieces().size() + 1);
  points.push_back(curve.start());
  for (const Piece& piece : curve.pieces()) points.push_back(end_of(piece));
  return points;
}

/// Greedy shortcuts: from each joint kept, goes straight to a late joint that it sees. The nodes
/// that a grid path passes count as joints.
///
/// Looks ahead in doubling steps until a joint is out of sight, then bisects: O(n log n) lines of
/// sight for n joints. Sight need not be monotone along a path, so the joint found is not always
/// the last one in sight; every line taken was tested. Never longer than its input.
struct Shortcut {
  static constexpr std::string_view name = "shortcut";

  /// Errors: what the budget says.
  template <FreeSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    const Curve curve = split_at_nodes(space, input);
    const std::vector<Point> points = joints(curve);
    Curve result;
    for (std::size_t i = 0; i + 1 < points.size();) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while taking shortcuts");
      const auto sees = [&](std::size_t j) { return space.segment_free(points[i], points[j]); };
      const std::size_t last = farthest(i, points.size() - 1, sees);
      const Piece& original = curve.pieces()[i];
      if (last > i + 1 || (!std::holds_alternative<Segment>(original) && sees(last))) {
        result.push_back(Segment{points[i], points[last]});
      } else {
        result.push_back(original);
      }
      i = last;
    }
    return result;
  }

 private:
  /// A joint after i (no later than `end`) that is in sight, or i + 1.
  template <class Sees>
  static std::size_t farthest(std::size_t i, std::size_t end, const Sees& sees) {
    std::size_t seen = i + 1, hidden = end + 1;
    for (std::size_t step = 2; seen < end && hidden > end; step *= 2) {
      const std::size_t probe = std::min(i + step, end);
      (sees(probe) ? seen : hidden) = probe;
    }
    while (seen + 1 < hidden && hidden <= end) {
      const std::size_t middle = seen + (hidden - seen) / 2;
      (sees(middle) ? seen : hidden) = middle;
    }
    return seen;
  }
};

}  // namespace tutavia
