// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "tutavia/geometry/point.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// step_off_zone: a point beside one that touches a safety zone.

namespace tutavia::detail {

/// A point from which tangents can be proved, a few rounding errors away from `p`: `p` itself, or
/// the one of 16 around it that has the most clearance, if it has more than `p` needs and the
/// segment to it is free.
template <FeatureSpace S>
std::optional<Point> step_off_zone(const S& space, const Point& p) {
  const double error = space.distance_error_bound();
  const double needed = space.safety_radius() + 8 * error;
  if (space.clearance(p) >= needed) return p;
  constexpr std::array<std::array<int, 2>, 16> directions{{{5, 0},
                                                           {5, 2},
                                                           {4, 4},
                                                           {2, 5},
                                                           {0, 5},
                                                           {-2, 5},
                                                           {-4, 4},
                                                           {-5, 2},
                                                           {-5, 0},
                                                           {-5, -2},
                                                           {-4, -4},
                                                           {-2, -5},
                                                           {0, -5},
                                                           {2, -5},
                                                           {4, -4},
                                                           {5, -2}}};
  std::optional<Point> best;
  double most = needed;
  for (const auto& [x, y] : directions) {
    const Point q{p.x() + 8 * error * x, p.y() + 8 * error * y};
    const double clearance = space.clearance(q);
    if (!(clearance >= most) || !space.segment_free(p, q)) continue;
    most = clearance;
    best = q;
  }
  return best;
}

}  // namespace tutavia::detail
