// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/predicates.hpp"

/// \file
/// Polygon with holes, and which points it contains.

namespace tutavia {

/// A closed chain of points; the first point may or may not be repeated at the end, and either
/// orientation will do.
using Ring = std::vector<Point>;

/// A solid area with holes. Rings may touch or cross themselves: see `contains`.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes{};
};

/// Calls `visit(a, b)` for every edge of the ring, the closing one included; an edge between equal
/// points is left out. A ring of one distinct point has the single edge (p, p).
template <class Visit>
void for_each_edge(const Ring& ring, Visit visit) {
  if (ring.empty()) return;
  bool any = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[i + 1 < ring.size() ? i + 1 : 0];
    if (a == b) continue;
    visit(a, b);
    any = true;
  }
  if (!any) visit(ring.front(), ring.front());
}

/// Twice the signed area of a ring, positive when it runs counterclockwise.
inline double signed_area_twice(const Ring& ring) {
  double sum = 0;
  for_each_edge(ring, [&](const Point& a, const Point& b) {
    sum += cross(a - ring.front(), b - ring.front());
  });
  return sum;
}

/// How often `ring` winds around a point that is not on it, counterclockwise positive; decided by
/// exact predicates. Its parity is that of the crossings of any ray from the point.
inline int winding_number(const Ring& ring, const Point& p) {
  int result = 0;
  for_each_edge(ring, [&](const Point& a, const Point& b) {
    const bool a_above = a.y() > p.y(), b_above = b.y() > p.y();
    if (a_above == b_above) return;
    const int side = orientation(a, b, p);
    if (side != (b_above ? 1 : -1)) return;  // the edge crosses the ray on p's other side
    result += side;
  });
  return result;
}

/// Whether a point off the polygon's edges lies in its solid part. A ring that crosses itself is
/// read so that an obstacle never shrinks: its outer ring encloses what the non-zero rule encloses
/// (all that the even-odd rule does, and more), a hole only what the even-odd rule does.
inline bool contains(const Polygon& polygon, const Point& p) {
  if (winding_number(polygon.outer, p) == 0) return false;
  for (const Ring& hole : polygon.holes) {
    if (winding_number(hole, p) % 2 != 0) return false;
  }
  return true;
}

}  // namespace tutavia
