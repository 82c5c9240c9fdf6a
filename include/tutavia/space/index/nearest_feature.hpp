// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// nearest_feature: the nearest of many edges and discs, by queries of growing radius.

namespace tutavia::detail {

/// A cheap test whether a feature lies farther than a limit to one side of a segment's line. Most
/// features in the box of a slanted segment do.
class SideTest {
 public:
  explicit SideTest(const Segment& s) {
    const double length = s.length();
    if (!(length > 0)) return;
    normal_ = {(s.a.y() - s.b.y()) / length, (s.b.x() - s.a.x()) / length};
    offset_ = normal_.x() * s.a.x() + normal_.y() * s.a.y();
  }
  explicit SideTest(const Arc&) {}

  bool operator()(const Segment& core, double limit) const {
    const double a = side(core.a), b = side(core.b);
    return (a > limit && b > limit) || (a < -limit && b < -limit);
  }

 private:
  double side(const Point& p) const { return normal_.x() * p.x() + normal_.y() * p.y() - offset_; }

  Point normal_{0, 0};  // zero: the test never holds
  double offset_ = 0;
};

/// The feature nearest to a piece, if nearer than `cap` (see ClearanceSpace).
///
/// `features(reach, visit)` calls `visit(core, radius, obstacle, edge)` for every feature within
/// `reach` of the piece (an edge with radius 0, or a point with one), and perhaps for others;
/// `visit` returns the distance beyond which features no longer matter. Reaches grow from
/// `first_reach` until a feature is found or the window holds all of `extent`. Ties go to the
/// feature with the lower obstacle number, then edge number.
template <class P, class Features>
NearestObstacle nearest_feature(const P& piece, double cap, double first_reach, const Box& extent,
                                const Features& features) {
  const Box box = piece.box();
  const SideTest beside(piece);
  double reach = std::min(cap, first_reach);
  while (true) {
    // A feature found within reach is the nearest. If the window holds all features, so is any
    // found.
    const bool complete =
        reach >= cap || box.inflated(reach).contains(extent) || extent.width() < 0;
    if (complete) reach = cap;
    NearestObstacle best{reach, 0, NearestObstacle::none, 0};
    features(reach, [&](const Segment& core, double radius, std::uint32_t obstacle,
                        std::uint32_t edge) {
      if (beside(core, best.distance + radius)) return best.distance;
      const ClosestApproach approach = closest_approach(piece, core);
      const double distance = approach.distance - radius;
      const bool lower = obstacle != best.obstacle ? obstacle < best.obstacle : edge < best.edge;
      if (distance < best.distance ||
          (distance == best.distance && lower && best.obstacle != NearestObstacle::none)) {
        best = {distance, approach.parameter, obstacle, edge};
      }
      return best.distance;
    });
    if (best.obstacle != NearestObstacle::none) return best;
    if (complete) return {cap, 0, NearestObstacle::none, 0};
    reach = reach > 0 ? std::min(cap, 4 * reach) : cap;
  }
}

}  // namespace tutavia::detail
