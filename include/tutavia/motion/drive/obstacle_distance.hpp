// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <variant>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/piece.hpp"
#include "tutavia/geometry/polygon.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// Distances from segments and arcs to a single obstacle.

namespace tutavia::detail {

/// The distance from a segment or an arc to an obstacle [m], and the parameter of the nearest point
/// of the piece; not above 0 if they meet or the piece lies inside. Its error is at most
/// `distance_rounding_error` of the largest coordinate, and the arc's evaluation error.
template <class P>
ClosestApproach distance_to(const P& piece, const Obstacle& obstacle) {
  if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
    ClosestApproach found = closest_approach(piece, Segment{disc->center, disc->center});
    found.distance -= disc->radius;
    return found;
  }
  const Polygon& polygon = std::get<Polygon>(obstacle);
  ClosestApproach best{std::numeric_limits<double>::infinity(), 0};
  const auto consider = [&](const Point& a, const Point& b) {
    const ClosestApproach found = closest_approach(piece, Segment{a, b});
    if (found.distance < best.distance) best = found;
  };
  for_each_edge(polygon.outer, consider);
  for (const Ring& hole : polygon.holes) for_each_edge(hole, consider);
  if (best.distance > 0 && contains(polygon, piece.start())) return {-best.distance, 0};
  return best;
}

/// A lower bound of the same distance, rounding included.
template <class P>
ClosestApproach distance_below(const P& piece, const Obstacle& obstacle, double magnitude) {
  ClosestApproach found = distance_to(piece, obstacle);
  found.distance -= distance_rounding_error(magnitude);
  if constexpr (std::is_same_v<P, Arc>) found.distance -= piece.evaluation_error();
  return found;
}

/// The clearance of a point from the map and from observed obstacles, where they are now [m].
template <ClearanceSpace S>
double clearance_among(const S& space, std::span<const MovingObstacle> observed, const Point& p) {
  double least = space.clearance(p);
  for (const MovingObstacle& obstacle : observed) {
    least = std::min(least, distance_to(Segment{p, p}, obstacle.shape).distance);
  }
  return least;
}

/// Whether all numbers of a moving obstacle are such that distances to it can be computed.
inline bool is_valid_obstacle(const MovingObstacle& obstacle) {
  if (!is_finite(obstacle.velocity)) return false;
  if (const Disc* disc = std::get_if<Disc>(&obstacle.shape)) {
    return is_valid_point(disc->center) && is_valid_coordinate(disc->radius) && disc->radius >= 0;
  }
  const Polygon& polygon = std::get<Polygon>(obstacle.shape);
  const auto is_ring = [](const Ring& ring) {
    return !ring.empty() && std::all_of(ring.begin(), ring.end(), is_valid_point);
  };
  return is_ring(polygon.outer) && std::all_of(polygon.holes.begin(), polygon.holes.end(), is_ring);
}

}  // namespace tutavia::detail
