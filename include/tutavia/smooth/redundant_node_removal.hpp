// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/core/parts/remove_redundant.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/route/farthest_in_sight.hpp"
#include "tutavia/smooth/route/input_checks.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// RedundantNodeRemoval: removes redundant nodes, as in the improved RRT* paper.

namespace tutavia {

/// Removes redundant nodes of a polyline. The grid nodes on a grid path count as nodes.
///
/// Guarantees: the ends are exact; every line taken is proved at the space's safety radius; the
/// kept nodes are nodes of the input in the same order; the result is never longer than the input.
/// Sight is not monotone along a path, so a second pass may remove more.
///
/// Source: the improved RRT* of MM Science Journal, October 2023 (RRTS), "removing redundant
/// nodes".
///
/// Example: examples/smoothers.cpp.
struct RedundantNodeRemoval {
  static constexpr std::string_view name = "redundant_node_removal";

  /// How the next kept node is found.
  enum class Scan {
    /// Steps forward from a kept node while the next node is in sight, up to the first hidden one,
    /// as printed in the paper. O(n) lines of sight for n nodes.
    forward,
    /// Steps back from the end of the route, in doubling steps, until a node is in sight; then
    /// bisects towards the hidden node after it. Finds a node in sight whose successor is hidden,
    /// though not always the last one in sight. O(n log n) lines of sight.
    from_far_end,
  };

  Scan scan = Scan::forward;

  /// Errors: `invalid_input` for a curve that is not free or not of segments and arcs; those of the
  /// budget.
  template <ClearanceSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    auto nodes = detail::free_nodes(space, input, budget, "the removal of redundant nodes");
    if (!nodes) return Unexpected{nodes.error()};

    std::optional<Budget::End> exceeded;
    std::size_t looks = 0;
    const auto sees = [&](const Point& a, const Point& b) {
      if (looks++ % 64 == 0 && !exceeded) exceeded = budget.exceeded();
      return !exceeded && space.segment_free(a, b);
    };
    if (scan == Scan::forward) {
      detail::remove_redundant(*nodes, sees);
    } else {
      remove_from_far_end(*nodes, sees);
    }
    if (exceeded) return fail(*exceeded, "while removing redundant nodes");
    return Curve::polyline(*nodes);
  }

 private:
  template <std::predicate<const Point&, const Point&> Sees>
  static void remove_from_far_end(std::vector<Point>& nodes, const Sees& sees) {
    std::size_t kept = 1;
    for (std::size_t i = 0; i + 1 < nodes.size();) {
      i = detail::farthest_looking_back(i, nodes.size() - 1,
                                        [&](std::size_t j) { return sees(nodes[i], nodes[j]); });
      nodes[kept++] = nodes[i];
    }
    if (!nodes.empty()) nodes.resize(kept);
  }
};

}  // namespace tutavia
