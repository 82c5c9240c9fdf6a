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

/// How often a ring winds around a point, and on which side of it an odd-even count puts it.
struct Winding {
  int number = 0;    ///< signed turns around the point
  bool odd = false;  ///< parity of the crossings of a ray
};

/// Winding of `ring` around a point that is not on it; decided by exact predicates.
inline Winding winding(const Ring& ring, const Point& p) {
  Winding result;
  for_each_edge(ring, [&](const Point& a, const Point& b) {
    const bool a_above = a.y() > p.y(), b_above = b.y() > p.y();
    if (a_above == b_above) return;
    const int side = orientation(a, b, p);
    if (side != (b_above ? 1 : -1)) return;  // the edge crosses the ray on p's other side
    result.number += side;
    result.odd = !result.odd;
  });
  return result;
}

/// Whether a point off the polygon's edges lies in its solid part. A ring that crosses itself is
/// read so that an obstacle never shrinks: its outer ring encloses what the non-zero or the
/// odd-even rule encloses, a hole only what both do.
inline bool contains(const Polygon& polygon, const Point& p) {
  const Winding outer = winding(polygon.outer, p);
  if (outer.number == 0 && !outer.odd) return false;
  for (const Ring& hole : polygon.holes) {
    const Winding inner = winding(hole, p);
    if (inner.number != 0 && inner.odd) return false;
  }
  return true;
}

}  // namespace tutavia
