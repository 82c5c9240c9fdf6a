// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <variant>

#include "tutavia/geometry/point.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// MovingObstacle: an obstacle with a velocity.

namespace tutavia {

/// An obstacle that keeps its shape, does not turn, and moves at constant velocity; or stands.
struct MovingObstacle {
  Obstacle shape{};                ///< where it is now
  Point velocity = Point::Zero();  ///< [m/s]

  MovingObstacle() = default;
  MovingObstacle(Obstacle shape_now) : shape(std::move(shape_now)) {}  // NOLINT: implicit
  MovingObstacle(Obstacle shape_now, const Point& per_second)
      : shape(std::move(shape_now)), velocity(per_second) {}
  /// Takes `{x, y}`, and `{}` as standing: a Point made from `{}` would have no value.
  MovingObstacle(Obstacle shape_now, const double (&per_second)[2])  // NOLINT: braces
      : shape(std::move(shape_now)), velocity(per_second[0], per_second[1]) {}

  bool stands() const { return detail::is_zero(velocity); }
};

/// An obstacle moved by a vector [m].
inline Obstacle translated(Obstacle obstacle, const Point& by) {
  if (Disc* disc = std::get_if<Disc>(&obstacle)) {
    disc->center += by;
    return obstacle;
  }
  Polygon& polygon = std::get<Polygon>(obstacle);
  for (Point& p : polygon.outer) p += by;
  for (Ring& hole : polygon.holes) {
    for (Point& p : hole) p += by;
  }
  return obstacle;
}

/// Where a moving obstacle is after some time [s].
inline Obstacle at_time(const MovingObstacle& obstacle, double time) {
  return translated(obstacle.shape, Point(time * obstacle.velocity));
}

}  // namespace tutavia
