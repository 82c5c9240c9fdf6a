// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdlib>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// split_at_nodes: splits a grid path at all its grid nodes.

namespace tutavia::detail {

/// The same curve with its straight runs between grid nodes split into single steps. Searches
/// return whole runs; smoothers that choose among a path's nodes need all of them. Curves in spaces
/// without a grid are returned unchanged.
template <FreeSpace S>
Curve split_at_nodes([[maybe_unused]] const S& space, const Curve& curve) {
  if constexpr (!GridSpace<S>) {
    return curve;
  } else {
    const Frame& frame = space.frame();
    const auto on_node = [&](const Point& p, Cell cell) {
      return distance(frame.point(cell), p) <= 1e-9 * frame.resolution;
    };
    Curve result;
    for (const Piece& piece : curve.pieces()) {
      const Segment* run = piece.get_if<Segment>();
      if (run != nullptr) {
        const Cell from = frame.nearest_cell(run->a), to = frame.nearest_cell(run->b);
        const int dx = to.x - from.x, dy = to.y - from.y;
        const int count = std::max(std::abs(dx), std::abs(dy));
        const bool along = dx == 0 || dy == 0 || std::abs(dx) == std::abs(dy);
        if (count > 1 && along && on_node(run->a, from) && on_node(run->b, to)) {
          Point previous = run->a;
          for (int i = 1; i < count; ++i) {
            const Point node = frame.point(from + Cell{dx / count * i, dy / count * i});
            result.push_back(Segment{previous, node});
            previous = node;
          }
          result.push_back(Segment{previous, run->b});
          continue;
        }
      }
      result.push_back(piece);
    }
    return result;
  }
}

}  // namespace tutavia::detail
