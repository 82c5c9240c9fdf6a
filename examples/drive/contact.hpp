// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "tutavia/geometry/polygon.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/motion/differential_drive.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// The judge of contacts: how near a robot comes to obstacles, over continuous time.
///
/// Of what the library's controllers compute it shares `moved`, distances between points and
/// segments, and the map's edges: not the distances of arcs, and nothing about time.

namespace drive_program {

using namespace tutavia;

/// A robot that keeps a twist for some time.
struct Motion {
  Pose from{};
  Twist twist{};
  double duration = 0;  ///< [s]

  Pose at(double time) const { return moved(from, twist, time); }
};

/// The least distance between the path of a robot's centre and an obstacle, and when.
struct Approach {
  double distance = std::numeric_limits<double>::infinity();  ///< [m]; not above 0: they meet
  double time = 0;                                            ///< since the motion began [s]
};

namespace judge {

/// By how much a computed approach may exceed the least one [m].
inline constexpr double tolerance = 1e-10;

inline double distance_between(const Segment& s, const Segment& t) {
  if (tutavia::detail::segments_intersect(s.a, s.b, t.a, t.b)) return 0;
  return std::min({distance(s.a, t), distance(s.b, t), distance(t.a, s), distance(t.b, s)});
}

/// Finds the approach to a core (an edge, or a point) with a radius, by halving time. In the frame
/// of the obstacle the robot's path within an interval is nearer to its chord than an eighth of the
/// bound on its acceleration times the squared length of the interval.
class LeastDistance {
 public:
  LeastDistance(const Motion& motion, const Point& velocity, const Segment& core, double radius)
      : motion_(motion), velocity_(velocity), core_(core), radius_(radius) {}

  /// The approach, if it is below `cap`; else one at or above it.
  Approach below(double cap) {
    best_ = {std::min(cap, std::numeric_limits<double>::max()), 0};
    const Point a = relative(0), b = relative(motion_.duration);
    consider(a, 0);
    consider(b, motion_.duration);
    descend(a, 0, b, motion_.duration, 0);
    return best_;
  }

 private:
  static constexpr int most_halvings = 48;

  Point relative(double time) const {
    const Point p = motion_.at(time).position;
    return {p.x() - time * velocity_.x(), p.y() - time * velocity_.y()};
  }
  void consider(const Point& p, double time) {
    const double d = distance(p, core_) - radius_;
    if (d < best_.distance) best_ = {d, time};
  }
  void descend(const Point& a, double from, const Point& b, double to, int depth) {
    const double length = to - from;
    const double deviation = std::abs(motion_.twist.v * motion_.twist.omega) * length * length / 8;
    const double least = distance_between({a, b}, core_) - radius_ - deviation;
    if (!(least < best_.distance - tolerance) || depth == most_halvings) return;
    const double middle = 0.5 * (from + to);
    const Point m = relative(middle);
    consider(m, middle);
    descend(a, from, m, middle, depth + 1);
    descend(m, middle, b, to, depth + 1);
  }

  Motion motion_;
  Point velocity_;
  Segment core_;
  double radius_;
  Approach best_{};
};

}  // namespace judge

/// The approach to an obstacle whose shape is where it was when the motion began. At or above `cap`
/// it is not exact. The error is at most 1e-10 m.
inline Approach approach(const Motion& motion, const MovingObstacle& obstacle,
                         double cap = std::numeric_limits<double>::infinity()) {
  const auto to_core = [&](const Segment& core, double radius, double below) {
    return judge::LeastDistance(motion, obstacle.velocity, core, radius).below(below);
  };
  if (const Disc* disc = std::get_if<Disc>(&obstacle.shape)) {
    return to_core({disc->center, disc->center}, disc->radius, cap);
  }
  const Polygon& polygon = std::get<Polygon>(obstacle.shape);
  Approach best{cap, 0};
  const auto consider = [&](const Point& a, const Point& b) {
    const Approach found = to_core({a, b}, 0, best.distance);
    if (found.distance < best.distance) best = found;
  };
  tutavia::detail::for_each_edge(polygon.outer, consider);
  for (const Ring& hole : polygon.holes) tutavia::detail::for_each_edge(hole, consider);
  if (best.distance > 0 && contains(polygon, motion.from.position)) return {0, 0};
  return best;
}

/// The approach to the obstacles of a map. At or above `cap` it is not exact.
template <FeatureSpace S>
Approach approach(const S& map, const Motion& motion, double cap) {
  const double length = std::abs(motion.twist.v) * motion.duration;
  const Box around = Box::around({motion.from.position}).inflated(length + cap);
  Approach best{cap, 0};
  map.for_each_feature(around, [&](const Segment& core, double radius) {
    const Approach found =
        judge::LeastDistance(motion, Point(0, 0), core, radius).below(best.distance);
    if (found.distance < best.distance) best = found;
  });
  if (best.distance > 0 && map.is_inside(motion.from.position)) return {0, 0};
  return best;
}

}  // namespace drive_program
