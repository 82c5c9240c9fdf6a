// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "tutavia/core/random.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// Similarity: worlds and paths rotated, translated and scaled.

namespace tutavia::test {

/// x -> scale R x + shift, with R a rotation, mirrored or not.
struct Similarity {
  double scale = 1, angle = 0;
  Point shift = Point::Zero();
  bool mirrored = false;

  static Similarity random(Random& random) {
    return {std::exp(random.uniform(-2, 2)), random.uniform(-3, 3),
            Point(random.uniform(-30, 30), random.uniform(-30, 30)), random.below(2) == 0};
  }

  Point operator()(const Point& p) const {
    const double c = std::cos(angle), s = std::sin(angle), y = mirrored ? -p.y() : p.y();
    return scale * Point(c * p.x() - s * y, s * p.x() + c * y) + shift;
  }
  std::vector<Point> operator()(std::vector<Point> points) const {
    for (Point& p : points) p = (*this)(p);
    return points;
  }
  /// Bounds become a box far outside the transformed ones, so that they have no effect.
  Workspace operator()(const Workspace& world) const {
    Workspace result{.bounds = {}, .safety_radius = scale * world.safety_radius};
    const Box wide = world.bounds.inflated(2 * (world.bounds.width() + world.bounds.height()));
    for (const Point& p : {wide.min, wide.max, Point(wide.min.x(), wide.max.y()),
                           Point(wide.max.x(), wide.min.y())}) {
      result.bounds.include((*this)(p));
    }
    for (const Obstacle& obstacle : world.obstacles) {
      if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
        result.obstacles.push_back(Disc{(*this)(disc->center), scale * disc->radius});
        continue;
      }
      Polygon polygon = std::get<Polygon>(obstacle);
      polygon.outer = (*this)(polygon.outer);
      for (Ring& hole : polygon.holes) hole = (*this)(hole);
      result.obstacles.push_back(std::move(polygon));
    }
    return result;
  }
};

}  // namespace tutavia::test
