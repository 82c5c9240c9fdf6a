// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// nearest_feature: the nearest of many edges and discs, looked for in a growing window.

namespace tutavia::detail {

/// Tells cheaply that a feature lies farther than some distance to one side of a segment's line:
/// most of the features in a slanted segment's box do.
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

  Point normal_{0, 0};  // null: nothing is ever to one side
  double offset_ = 0;
};

/// The feature of `features` nearest to a piece, if nearer than `cap` (see ClearanceSpace).
///
/// `features(reach, visit)` calls `visit(core, radius, obstacle, edge)` for every feature within
/// `reach` of the piece (an edge with radius 0, or a point with one), and perhaps for others;
/// `visit` returns the distance up to which features are still of interest.
/// Windows grow from `first_reach` until they hold the nearest feature or, with it, all of
/// `extent`. Of equally near features the one with the lower numbers is given.
template <class P, class Features>
NearestObstacle nearest_feature(const P& piece, double cap, double first_reach, const Box& extent,
                                const Features& features) {
  const Box box = piece.box();
  const SideTest beside(piece);
  double reach = std::min(cap, first_reach);
  while (true) {
    // What is found within reach is the nearest; once the window holds all, whatever is found is.
    const bool complete =
        reach >= cap || box.inflated(reach).contains(extent) || extent.width() < 0;
    if (complete) reach = cap;
    NearestObstacle best{reach, 0, NearestObstacle::none, 0};
    features(reach, [&](const Segment& core, double radius, std::uint32_t obstacle,
                        std::uint32_t edge) {
      if (beside(core, best.distance + radius)) return best.distance;
      const ClosestApproach found = closest_approach(piece, core);
      const double distance = found.distance - radius;
      const bool lower = obstacle != best.obstacle ? obstacle < best.obstacle : edge < best.edge;
      if (distance < best.distance ||
          (distance == best.distance && lower && best.obstacle != NearestObstacle::none)) {
        best = {distance, found.parameter, obstacle, edge};
      }
      return best.distance;
    });
    if (best.obstacle != NearestObstacle::none) return best;
    if (complete) return {cap, 0, NearestObstacle::none, 0};
    reach = reach > 0 ? std::min(cap, 4 * reach) : cap;
  }
}

}  // namespace tutavia::detail
