// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "tutavia/core/random.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// Random worlds with all difficulties for geometry.

namespace tutavia::test {

/// Draws obstacles: convex and star-shaped polygons, holes, discs, crossing rings, slivers without
/// area and single points; flipped, closed twice, with repeated points; overlapping at random.
class WorldGenerator {
 public:
  explicit WorldGenerator(std::uint64_t seed) : random_(seed) {}

  /// A third of the worlds is snapped to a lattice of half a metre, so that edges touch and
  /// vertices coincide; safety radii reach from 0 (one in ten) to a tenth of the world.
  Workspace workspace() {
    snapped_ = random_.below(3) == 0;
    const double size = random_.uniform(4, 16);
    Workspace world;
    const Point origin = random_.below(8) == 0 ? Point(1e4, -2e4) : Point(0, 0);
    world.bounds = {snap(origin), snap(origin + Point(size, size))};
    const std::uint64_t kind = random_.below(10);
    world.safety_radius = kind == 0   ? 0.0
                          : kind == 1 ? 0.5
                                      : std::max(1e-6, size * std::pow(random_.uniform(), 2) / 10);
    const std::uint64_t count = random_.below(14);
    for (std::uint64_t i = 0; i < count; ++i) world.obstacles.push_back(obstacle(world.bounds));
    return world;
  }

  /// A point within the world's bounds, sometimes on their border or on the snapping lattice.
  Point point(const Workspace& world) {
    const Box& b = world.bounds;
    Point p{random_.uniform(b.min.x(), b.max.x()), random_.uniform(b.min.y(), b.max.y())};
    if (random_.below(16) == 0) p.x() = b.min.x();
    return snapped_ ? snap(p).cwiseMax(b.min).cwiseMin(b.max) : p;
  }

  /// One more obstacle for the last world, snapped if that world is.
  Obstacle obstacle(const Box& bounds) {
    const double size = bounds.width() * random_.uniform(0.02, 0.2);
    const Point centre{random_.uniform(bounds.min.x(), bounds.max.x()),
                       random_.uniform(bounds.min.y(), bounds.max.y())};
    switch (random_.below(9)) {
      case 0:
        return Disc{snap(centre), snapped_ ? std::round(2 * size) / 2 : size};
      case 1:
        return Polygon{ring(centre, {size, size}, 0, 1)};  // a single point
      case 2:
        return Polygon{finish({centre, centre + Point(size, random_.uniform(-size, size))})};
      case 3: {  // any points in any order: edges cross
        Ring points;
        for (int i = 0; i < 5; ++i) {
          points.push_back(centre +
                           Point{random_.uniform(-size, size), random_.uniform(-size, size)});
        }
        return Polygon{finish(std::move(points))};
      }
      case 4: {
        const Ring outer = ring(centre, {2 * size, 2 * size}, 0, 8);
        return Polygon{outer, {ring(centre, {0.4 * size, 1.2 * size}, 0, 6)}};
      }
      case 5: {  // an axis-aligned rectangle
        const Point half{size, size * random_.uniform(0.1, 1)};
        return Polygon{finish({centre - half, centre + Point(half.x(), -half.y()), centre + half,
                               centre + Point(-half.x(), half.y())})};
      }
      case 6:
        return Polygon{ring(centre, {0.3 * size, size}, 0, 9)};  // star-shaped
      default:
        return Polygon{ring(centre, {size, size}, 0, 3 + random_.below(6))};
    }
  }

  /// The vertex for the last world: on the lattice if that world is snapped.
  Point snap(const Point& p) const {
    return snapped_ ? Point(std::round(2 * p.x()) / 2, std::round(2 * p.y()) / 2) : p;
  }

  Random& random() { return random_; }

 private:
  /// A ring around `centre` at random increasing angles, with radii in the given range.
  Ring ring(const Point& centre, std::pair<double, double> radii, double start,
            std::uint64_t count) {
    Ring points;
    for (std::uint64_t i = 0; i < count; ++i) {
      const double angle = start + 2 * std::numbers::pi *
                                       (static_cast<double>(i) + 0.8 * random_.uniform()) /
                                       static_cast<double>(count);
      const double radius = random_.uniform(radii.first, radii.second);
      points.push_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
    }
    return finish(std::move(points));
  }

  /// Snaps a ring and adds the irregularities that readers accept.
  Ring finish(Ring points) {
    for (Point& p : points) p = snap(p);
    if (random_.below(3) == 0) std::reverse(points.begin(), points.end());
    if (random_.below(5) == 0) points.insert(points.begin() + 1, points.front());
    if (random_.below(5) == 0) points.push_back(points.front());
    return points;
  }

  Random random_;
  bool snapped_ = false;
};

}  // namespace tutavia::test
