// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tutavia/geometry/segment.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// critical_corners: the obstacle corners that a path passes closely.

namespace tutavia::detail {

/// The obstacle corners with an exterior angle of at least `min_exterior_angle` [rad], and the
/// discs, whose safety zone comes within `threshold` [m] of the polyline `points`. Ordered by
/// Corner::id, without duplicates. Source: Abdulshaheed 2025 (critical corners), adapted to round
/// zones: distances are measured from the zone's arc around a vertex.
template <CornerSpace S>
std::vector<Corner> critical_corners(const S& space, const std::vector<Point>& points,
                                     double threshold, double min_exterior_angle) {
  std::vector<Corner> corners;
  const double reach = space.safety_radius() + threshold;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Segment leg{points[i], points[i + 1]};
    space.for_each_corner(leg.box().inflated(reach), [&](const Corner& corner) {
      if (corner.exterior_angle >= min_exterior_angle &&
          distance(corner.position, leg) - corner.radius <= reach) {
        corners.push_back(corner);
      }
    });
  }
  const auto by_id = [](const Corner& a, const Corner& b) { return a.id < b.id; };
  const auto same = [](const Corner& a, const Corner& b) { return a.id == b.id; };
  std::sort(corners.begin(), corners.end(), by_id);
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  return corners;
}

}  // namespace tutavia::detail
