// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/predicates.hpp"

/// \file
/// Polygon: a polygon with holes, and tests of points and simplicity.

namespace tutavia {

/// A closed chain of points. The first point may be repeated at the end; both orientations are
/// valid.
using Ring = std::vector<Point>;

/// A solid area with holes. Rings may touch or cross themselves: see `contains`.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes{};
};

/// A wall without thickness along a chain of points: a ring that goes there and back.
inline Polygon polyline_obstacle(Ring points) {
  for (std::size_t i = points.size(); i-- > 1;) points.push_back(Point(points[i - 1]));
  return {std::move(points)};
}

namespace detail {

/// Calls `visit(a, b)` for every edge of the ring, the closing one included; an edge between equal
/// points is skipped. A ring of one distinct point has the single edge (p, p).
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

}  // namespace detail

/// Whether a point that lies on no edge is in the solid part of the polygon. For rings that cross
/// themselves, an obstacle never shrinks: the outer ring encloses by the non-zero rule (a superset
/// of the even-odd rule), a hole by the even-odd rule.
inline bool contains(const Polygon& polygon, const Point& p) {
  return detail::winding_number(polygon.outer, p) != 0 &&
         std::none_of(polygon.holes.begin(), polygon.holes.end(),
                      [&](const Ring& hole) { return detail::winding_number(hole, p) % 2 != 0; });
}

namespace detail {

/// Whether all points of a ring lie on one line; decided by exact predicates.
inline bool is_flat(const Ring& ring) {
  const auto other =
      std::find_if(ring.begin(), ring.end(), [&](const Point& p) { return p != ring.front(); });
  return std::all_of(ring.begin(), ring.end(), [&](const Point& p) {
    return other == ring.end() || orientation(ring.front(), *other, p) == 0;
  });
}

/// An edge of a polygon, with its index and that of the next edge along the ring.
struct RingEdge {
  Point a, b;
  std::size_t index;
  std::size_t next;
  double left() const { return std::min(a.x(), b.x()); }
  double right() const { return std::max(a.x(), b.x()); }
};

/// Adds the edges of a ring; false if they are fewer than three.
inline bool add_edges(const Ring& ring, std::vector<RingEdge>& edges) {
  const std::size_t first = edges.size();
  for_each_edge(ring, [&](const Point& a, const Point& b) {
    edges.push_back({a, b, edges.size(), edges.size() + 1});
  });
  if (edges.size() > first) edges.back().next = first;
  return edges.size() - first >= 3;
}

/// Whether a, b and c lie on one line, a and c on the same side of b.
inline bool folds_back(const Point& a, const Point& b, const Point& c) {
  const auto side = [](double from, double to) { return from < to ? 1 : from > to ? -1 : 0; };
  return orientation(a, b, c) == 0 && (side(b.x(), a.x()) * side(b.x(), c.x()) > 0 ||
                                       side(b.y(), a.y()) * side(b.y(), c.y()) > 0);
}

/// Whether two edges meet other than at a shared corner of their ring.
inline bool edges_conflict(const RingEdge& x, const RingEdge& y) {
  if (x.next == y.index) return folds_back(x.a, x.b, y.b);
  if (y.next == x.index) return folds_back(y.a, y.b, x.b);
  return segments_intersect(x.a, x.b, y.a, y.b);
}

}  // namespace detail

/// Whether the polygon's edges meet at the corners of their rings and nowhere else; decided by
/// exact predicates. Rings without area are not simple. O(n log n) unless very many edges share
/// abscissas.
inline bool is_simple(const Polygon& polygon) {
  using detail::RingEdge;
  std::vector<RingEdge> edges;
  if (!detail::add_edges(polygon.outer, edges)) return false;
  for (const Ring& hole : polygon.holes) {
    if (!detail::add_edges(hole, edges)) return false;
  }
  std::sort(edges.begin(), edges.end(), [](const RingEdge& x, const RingEdge& y) {
    return x.left() != y.left() ? x.left() < y.left() : x.index < y.index;
  });
  std::vector<RingEdge> active;  // edges that the vertical sweep line crosses
  for (const RingEdge& edge : edges) {
    std::erase_if(active, [&](const RingEdge& old) { return old.right() < edge.left(); });
    for (const RingEdge& old : active) {
      if (detail::edges_conflict(old, edge)) return false;
    }
    active.push_back(edge);
  }
  return true;
}

namespace detail {

/// Whether the exact midpoint of u and v lies in the solid part of the polygon and on none of its
/// edges.
inline bool contains_midpoint(const Polygon& polygon, const Point& u, const Point& v) {
  using Number = ExactNumber;
  const Number x = Number(u.x()) + v.x(), y = Number(u.y()) + v.y();  // twice the point
  bool on_edge = false;
  const auto winding = [&](const Ring& ring) {
    int result = 0;
    for_each_edge(ring, [&](const Point& a, const Point& b) {
      const Number ax = Number(2) * a.x() - x, ay = Number(2) * a.y() - y;
      const Number bx = Number(2) * b.x() - x, by = Number(2) * b.y() - y;
      const int side = (ax * by - ay * bx).sign();
      if (side == 0 && ax.sign() * bx.sign() <= 0 && ay.sign() * by.sign() <= 0) on_edge = true;
      const bool a_above = ay.sign() > 0, b_above = by.sign() > 0;
      if (a_above != b_above && side == (b_above ? 1 : -1)) result += side;
    });
    return result;
  };
  bool inside = winding(polygon.outer) != 0;
  for (const Ring& hole : polygon.holes) {
    if (winding(hole) % 2 != 0) inside = false;
  }
  return inside && !on_edge;
}

/// Whether the segment p-q meets the open interior of a simple polygon. Decided by exact
/// arithmetic.
inline bool interior_meets(const Polygon& polygon, const Point& p, const Point& q) {
  // Between two consecutive contacts, the segment lies inside, outside or on an edge.
  std::vector<Point> contacts{p, q};
  bool crosses = false;
  const auto test_edge = [&](const Point& a, const Point& b) {
    const int pa = orientation(p, q, a), pb = orientation(p, q, b);
    if (pa * pb < 0 && orientation(a, b, p) * orientation(a, b, q) < 0) crosses = true;
    if (pa == 0 && Box::around({p, q}).contains(a)) contacts.push_back(a);
  };
  for_each_edge(polygon.outer, test_edge);
  for (const Ring& hole : polygon.holes) for_each_edge(hole, test_edge);
  if (crosses) return true;
  std::sort(contacts.begin(), contacts.end(), [](const Point& a, const Point& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  for (std::size_t i = 1; i < contacts.size(); ++i) {
    if (contains_midpoint(polygon, contacts[i - 1], contacts[i])) return true;
  }
  return false;
}

}  // namespace detail

}  // namespace tutavia
