// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// Distances by brute force in long double, independent of the library's index and geometry.

namespace tutavia::test {

using Real = long double;

inline Real reference_distance(const Point& p, const Point& a, const Point& b) {
  const Real ux = Real(b.x()) - a.x(), uy = Real(b.y()) - a.y();
  const Real vx = Real(p.x()) - a.x(), vy = Real(p.y()) - a.y();
  const Real square = ux * ux + uy * uy;
  Real t = square > 0 ? (ux * vx + uy * vy) / square : 0;
  t = std::clamp<Real>(t, 0, 1);
  return std::hypot(vx - t * ux, vy - t * uy);
}

/// Crossings of a horizontal ray to the right, and turns around p, of one ring.
struct ReferenceWinding {
  int number = 0;
  int crossings = 0;
};

inline ReferenceWinding reference_winding(const Ring& ring, const Point& p) {
  ReferenceWinding result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if ((a.y() <= p.y()) == (b.y() <= p.y())) continue;
    const Real x = a.x() + (Real(p.y()) - a.y()) * (Real(b.x()) - a.x()) / (Real(b.y()) - a.y());
    if (x <= p.x()) continue;
    result.number += b.y() > a.y() ? 1 : -1;
    ++result.crossings;
  }
  return result;
}

inline bool reference_inside(const Polygon& polygon, const Point& p) {
  const ReferenceWinding outer = reference_winding(polygon.outer, p);
  if (outer.number == 0 && outer.crossings % 2 == 0) return false;
  return std::none_of(polygon.holes.begin(), polygon.holes.end(), [&](const Ring& hole) {
    const ReferenceWinding inner = reference_winding(hole, p);
    return inner.number != 0 && inner.crossings % 2 != 0;
  });
}

/// Signed distance from p to the nearest obstacle, for points off the edges.
inline Real reference_clearance(const Workspace& world, const Point& p) {
  Real result = std::numeric_limits<Real>::infinity();
  for (const Obstacle& obstacle : world.obstacles) {
    if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
      result = std::min(result, reference_distance(p, disc->center, disc->center) - disc->radius);
      continue;
    }
    const Polygon& polygon = std::get<Polygon>(obstacle);
    Real edge = std::numeric_limits<Real>::infinity();
    const auto include = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        edge = std::min(edge, reference_distance(p, ring[i], ring[(i + 1) % ring.size()]));
      }
    };
    include(polygon.outer);
    for (const Ring& hole : polygon.holes) include(hole);
    result = std::min(result, reference_inside(polygon, p) ? -edge : edge);
  }
  return result;
}

/// The least clearance among many points of a piece, its ends included.
inline Real sampled_clearance(const Workspace& world, const Piece& piece, int per_piece = 32) {
  Real result = std::numeric_limits<Real>::infinity();
  for (int i = 0; i <= per_piece; ++i) {
    const double t = static_cast<double>(i) / per_piece;
    const Point p = piece.visit([&](const auto& any) -> Point { return any.point(t); });
    result = std::min(result, reference_clearance(world, p));
  }
  return result;
}

/// The least clearance among many points of a curve, those between pieces included.
inline Real sampled_clearance(const Workspace& world, const Curve& curve, int per_piece = 32) {
  Real result = std::numeric_limits<Real>::infinity();
  for (const Piece& piece : curve.pieces()) {
    result = std::min(result, sampled_clearance(world, piece, per_piece));
  }
  return result;
}

}  // namespace tutavia::test
