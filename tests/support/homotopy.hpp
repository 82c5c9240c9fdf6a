// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <variant>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// Whether two curves pass the obstacles on the same sides.

namespace tutavia::test {

/// Points along a curve, 32 on each curved piece.
inline std::vector<Point> outline(const Curve& curve) {
  std::vector<Point> points{curve.start()};
  for (const Piece& piece : curve.pieces()) {
    const int steps = piece.holds<Segment>() ? 1 : 32;
    for (int i = 1; i <= steps; ++i) {
      points.push_back(
          piece.visit([&](const auto& p) -> Point { return p.point(double(i) / steps); }));
    }
  }
  return points;
}

/// The winding number of a closed polyline around a point.
inline long winding(const std::vector<Point>& loop, const Point& p) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point a = loop[i] - p, b = loop[(i + 1) % loop.size()] - p;
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::lround(sum / (2 * std::numbers::pi));
}

/// Whether the loop along one curve and back along the other winds around no obstacle, as it does
/// for any two curves of one homotopy class.
inline bool winds_around_nothing(const Workspace& world, const Curve& a, const Curve& b) {
  std::vector<Point> loop = outline(a), back = outline(b);
  loop.insert(loop.end(), back.rbegin(), back.rend());
  const auto all_clear = [&](const Ring& ring) {
    return std::all_of(ring.begin(), ring.end(),
                       [&](const Point& p) { return winding(loop, p) == 0; });
  };
  return std::all_of(world.obstacles.begin(), world.obstacles.end(), [&](const Obstacle& obstacle) {
    if (const Disc* disc = std::get_if<Disc>(&obstacle)) return all_clear({disc->center});
    const Polygon& polygon = std::get<Polygon>(obstacle);
    return all_clear(polygon.outer) &&
           std::all_of(polygon.holes.begin(), polygon.holes.end(), all_clear);
  });
}

}  // namespace tutavia::test
