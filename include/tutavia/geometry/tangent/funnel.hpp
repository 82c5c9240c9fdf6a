// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/predicates.hpp"

/// \file
/// The shortest path through portals.

namespace tutavia::detail {

/// The shortest path through portals in turn, each given by its right end and its left end as seen
/// by who crosses it: a funnel of two chains that part at an apex. Its points, which repeat where
/// portals share an end. Exact: bends are decided by exact orientations. Linear in the portals.
/// Source: Lee and Preparata 1984, "Euclidean shortest paths in the presence of rectilinear
/// barriers".
inline std::vector<Point> pull_through(const std::vector<std::pair<Point, Point>>& portals,
                                       const Point& start, const Point& goal) {
  std::vector<Point> path{start};
  std::deque<Point> funnel{start};  // from the end of the left chain by the apex to the right end
  std::size_t apex = 0;
  // A new end takes off what its chain would have to bend outwards for.
  const auto add_right = [&](const Point& p) {
    while (funnel.size() > 1) {
      const std::size_t last = funnel.size() - 1;
      if (last > apex) {  // on the right chain: it stays convex
        if (orientation(funnel[last - 1], funnel[last], p) < 0) break;
        funnel.pop_back();
      } else {  // the apex is the right end: it moves along the left chain
        if (orientation(funnel[apex], funnel[apex - 1], p) <= 0) break;
        funnel.pop_back();
        --apex;
        path.push_back(funnel[apex]);
      }
    }
    funnel.push_back(p);
  };
  const auto add_left = [&](const Point& p) {
    while (funnel.size() > 1) {
      if (apex > 0) {
        if (orientation(funnel[1], funnel[0], p) > 0) break;
        funnel.pop_front();
        --apex;
      } else {
        if (orientation(funnel[0], funnel[1], p) >= 0) break;
        funnel.pop_front();
        path.push_back(funnel[0]);
      }
    }
    funnel.push_front(p);
    ++apex;
  };
  for (const auto& [right, left] : portals) {
    add_right(right);
    add_left(left);
  }
  add_right(goal);
  for (std::size_t i = apex + 1; i < funnel.size(); ++i) path.push_back(funnel[i]);
  return path;
}

}  // namespace tutavia::detail
