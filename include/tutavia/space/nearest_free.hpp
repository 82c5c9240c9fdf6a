// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// nearest_free_point: the free point nearest to a blocked one.

namespace tutavia {

namespace detail {

/// Part of the boundary of free space: a circle around a vertex or disc, an obstacle edge offset by
/// the safety radius, or a side of the bounds.
struct Boundary {
  Segment line;
  double radius = 0;  // of a circle around line.a

  static Boundary circle(const Point& center, double radius) { return {{center, center}, radius}; }
  bool is_circle() const { return radius > 0; }
};

/// Calls `visit(q)` for the points of a boundary nearest to p.
template <class Visit>
void for_each_projection(const Boundary& boundary, const Point& p, Visit visit) {
  if (!boundary.is_circle()) return visit(boundary.line.point(boundary.line.nearest_parameter(p)));
  const Point center = boundary.line.a, v = p - center;
  if (v.norm() > 0) return visit(offset_along(center, boundary.radius / v.norm(), v));
  for (const Point& axis : {Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1)}) {
    visit(offset_along(center, boundary.radius, axis));
  }
}

/// Calls `visit(q)` for the points where two boundaries meet.
template <class Visit>
void for_each_crossing(const Boundary& first, const Boundary& second, Visit visit) {
  if (!first.is_circle() && !second.is_circle()) {
    const Segment &s = first.line, &t = second.line;
    const Point d = s.b - s.a, e = t.b - t.a;
    const double determinant = cross(d, e);
    if (determinant != 0) visit(offset_along(s.a, cross(Point(t.a - s.a), e) / determinant, d));
    return;
  }
  if (!second.is_circle()) return for_each_crossing(second, first, visit);
  // The line that meets the circle: that of the segment, or the common chord of two circles.
  const Point center = second.line.a;
  const double squared_radius = second.radius * second.radius;
  Point foot, direction;
  if (!first.is_circle()) {
    direction = first.line.b - first.line.a;
    const double squared_length = direction.squaredNorm();
    if (!(squared_length > 0)) return;
    const Point v = center - first.line.a;
    foot = offset_along(first.line.a, v.dot(direction) / squared_length, direction);
  } else {
    const Point between = first.line.a - center;
    const double squared_length = between.squaredNorm();
    if (!(squared_length > 0)) return;
    const double along = (squared_length + squared_radius - first.radius * first.radius) / 2;
    foot = offset_along(center, along / squared_length, between);
    direction = perpendicular(between);
  }
  const double height = distance(foot, center);
  const double half = squared_radius - height * height;
  if (!(half >= 0)) return;
  const double reach = std::sqrt(half) / direction.norm();
  visit(offset_along(foot, reach, direction));
  visit(offset_along(foot, -reach, direction));
}

/// The sides of the bounds within `reach` of a point.
inline std::vector<Boundary> sides_near(const Box& bounds, const Point& origin, double reach) {
  std::vector<Boundary> sides;
  const Point c0 = bounds.min, c2 = bounds.max, c1{c2.x(), c0.y()}, c3{c0.x(), c2.y()};
  for (const Segment& side : {Segment{c0, c1}, Segment{c1, c2}, Segment{c2, c3}, Segment{c3, c0}}) {
    if (distance(origin, side) <= reach) sides.push_back({side});
  }
  return sides;
}

/// Adds the boundary of the points within `offset` of an edge or a point.
inline void add_zone(const Segment& core, double offset, std::vector<Boundary>& boundaries) {
  boundaries.push_back(Boundary::circle(core.a, offset));
  if (core.a == core.b) return;
  boundaries.push_back(Boundary::circle(core.b, offset));
  const Point normal = perpendicular(core.b - core.a);
  const double scale = offset / normal.norm();
  for (const double side : {scale, -scale}) {
    boundaries.push_back(
        {{offset_along(core.a, side, normal), offset_along(core.b, side, normal)}});
  }
}

/// The points on each boundary nearest to `origin` and the crossings of boundaries, clamped to the
/// bounds and within `reach`, nearest first. Each crossing is also tried shifted by `shift` along
/// both axes.
inline std::vector<Point> free_candidates(const std::vector<Boundary>& boundaries,
                                          const Box& bounds, const Point& origin, double reach,
                                          double shift) {
  struct Candidate {
    double distance;
    std::size_t number;  // in order of creation
    Point point;
  };
  std::vector<Candidate> candidates;
  const auto add = [&](const Point& q) {
    const Point inside = bounds.clamp(q);
    const double d = distance(inside, origin);
    if (d <= reach) candidates.push_back({d, candidates.size(), inside});
  };
  const auto add_crossing = [&](const Point& q) {
    add(q);
    for (const Point& axis : {Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1)}) {
      add(offset_along(q, shift, axis));
    }
  };
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    for_each_projection(boundaries[i], origin, add);
    for (std::size_t j = 0; j < i; ++j) {
      for_each_crossing(boundaries[i], boundaries[j], add_crossing);
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.number < b.number;
  });
  std::vector<Point> points;
  points.reserve(candidates.size());
  for (const Candidate& candidate : candidates) points.push_back(candidate.point);
  return points;
}

}  // namespace detail

/// The point of free space nearest to `p`. Empty if there is no free space within the bounds, or if
/// the search radius covers more than 512 boundaries before one is found.
///
/// The nearest point is `p` itself, or lies on one boundary of free space, or at the crossing of
/// two. All candidates within a growing radius are tested, nearest first; the returned point is
/// proved free. Boundaries are offset by 32 u M from the zones, and crossings are also tried
/// slightly shifted, so that rounding does not hide free points.
template <FeatureSpace S>
std::optional<Point> nearest_free_point(const S& space, const Point& p) {
  const Box& bounds = space.bounds();
  const Point origin = bounds.clamp(p);
  if (!detail::is_finite(p)) return std::nullopt;
  if (space.is_free(origin)) return origin;
  const double margin = 2 * space.distance_error_bound(), r = space.safety_radius();
  const double farthest = std::hypot(bounds.width(), bounds.height());
  double reach = std::min(farthest, 2 * r + 4 * margin + farthest / 256);
  while (true) {
    std::vector<detail::Boundary> boundaries = detail::sides_near(bounds, origin, reach);
    space.for_each_feature(Box{origin, origin}.inflated(reach + r),
                           [&](const Segment& core, double radius) {
                             detail::add_zone(core, radius + r + margin, boundaries);
                           });
    constexpr std::size_t most_boundaries = 512;  // their pairs take some milliseconds
    if (boundaries.size() > most_boundaries) return std::nullopt;
    for (const Point& candidate :
         detail::free_candidates(boundaries, bounds, origin, reach, 4 * margin)) {
      if (space.is_free(candidate)) return candidate;
    }
    if (reach >= farthest) return std::nullopt;
    reach = std::min(farthest, 2 * reach);
  }
}

}  // namespace tutavia
