// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// nearest_free_point: the way out of a safety zone.

namespace tutavia {

namespace detail {

/// Part of the boundary of free space: a circle around an obstacle's vertex or disc, or an edge of
/// the obstacle or of the bounds moved out by the safety radius.
struct Circle {
  Point center;
  double radius;
};
using Boundary = std::variant<Segment, Circle>;

/// Calls `visit(q)` for the points of a boundary nearest to p.
template <class Visit>
void for_each_projection(const Boundary& boundary, const Point& p, Visit visit) {
  if (const Segment* s = std::get_if<Segment>(&boundary))
    return visit(s->point(s->nearest_parameter(p)));
  const Circle& circle = std::get<Circle>(boundary);
  const Point v = p - circle.center;
  if (v.norm() > 0) return visit(advance(circle.center, circle.radius / v.norm(), v));
  for (const Point& axis : {Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1)}) {
    visit(advance(circle.center, circle.radius, axis));
  }
}

/// Calls `visit(q)` where two boundaries meet.
template <class Visit>
void for_each_crossing(const Boundary& first, const Boundary& second, Visit visit) {
  const Segment* s = std::get_if<Segment>(&first);
  const Segment* t = std::get_if<Segment>(&second);
  if (s != nullptr && t != nullptr) {
    const Point d = s->b - s->a, e = t->b - t->a;
    const double determinant = cross(d, e);
    if (determinant != 0) visit(advance(s->a, cross(Point(t->a - s->a), e) / determinant, d));
    return;
  }
  if (s == nullptr && t != nullptr) return for_each_crossing(second, first, visit);
  // A line across a circle: the segment's own, or the common chord of two circles.
  const Circle& circle = std::get<Circle>(second);
  Point foot, direction;
  if (s != nullptr) {
    direction = s->b - s->a;
    const double square = direction.squaredNorm();
    if (!(square > 0)) return;
    const Point v = circle.center - s->a;
    foot = advance(s->a, v.dot(direction) / square, direction);
  } else {
    const Circle& other = std::get<Circle>(first);
    const Point between = other.center - circle.center;
    const double square = between.squaredNorm();
    if (!(square > 0)) return;
    const double along = (square + circle.radius * circle.radius - other.radius * other.radius) / 2;
    foot = advance(circle.center, along / square, between);
    direction = perpendicular(between);
  }
  const double height = distance(foot, circle.center);
  const double half = circle.radius * circle.radius - height * height;
  if (!(half >= 0)) return;
  const double reach = std::sqrt(half) / direction.norm();
  visit(advance(foot, reach, direction));
  visit(advance(foot, -reach, direction));
}

}  // namespace detail

/// The point of free space nearest to `p`, or nothing where there is no free space within the
/// bounds, or none before some hundred edges are within reach.
///
/// It is `p` itself, or on one boundary of free space next to p, or where two boundaries cross: all
/// of them within a growing reach are tried, nearest first, and what is returned was tested to be
/// free. The boundaries are kept 32 u M outside the zones, and crossings are tried a little further
/// out as well, so that rounding does not hide them.
template <FeatureSpace S>
std::optional<Point> nearest_free_point(const S& space, const Point& p) {
  const Box& bounds = space.bounds();
  const Point origin = bounds.clamp(p);
  if (!is_finite(p)) return std::nullopt;
  if (space.is_free(origin)) return origin;
  const double margin = 2 * space.slack(), r = space.safety_radius();
  const double farthest = std::hypot(bounds.width(), bounds.height());
  double reach = std::min(farthest, 2 * r + 4 * margin + farthest / 256);
  while (true) {
    std::vector<detail::Boundary> boundaries;
    const Point c0 = bounds.min, c2 = bounds.max, c1{c2.x(), c0.y()}, c3{c0.x(), c2.y()};
    for (const Segment& side :
         {Segment{c0, c1}, Segment{c1, c2}, Segment{c2, c3}, Segment{c3, c0}}) {
      if (distance(origin, side) <= reach) boundaries.emplace_back(side);
    }
    space.for_each_feature(
        Box{origin, origin}.inflated(reach + r), [&](const Segment& core, double radius) {
          const double offset = radius + r + margin;
          boundaries.emplace_back(detail::Circle{core.a, offset});
          if (core.a == core.b) return;
          boundaries.emplace_back(detail::Circle{core.b, offset});
          const Point aside = perpendicular(core.b - core.a);
          const double scale = offset / aside.norm();
          for (const double side : {scale, -scale}) {
            boundaries.emplace_back(
                Segment{advance(core.a, side, aside), advance(core.b, side, aside)});
          }
        });
    constexpr std::size_t most_boundaries = 512;  // their pairs take some milliseconds
    if (boundaries.size() > most_boundaries) return std::nullopt;
    std::vector<Point> candidates;
    const auto add = [&](const Point& q) {
      const Point inside = bounds.clamp(q);
      if (distance(inside, origin) <= reach) candidates.push_back(inside);
    };
    const auto add_crossing = [&](const Point& q) {
      add(q);
      for (const Point& axis : {Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1)}) {
        add(advance(q, 4 * margin, axis));
      }
    };
    for (std::size_t i = 0; i < boundaries.size(); ++i) {
      detail::for_each_projection(boundaries[i], origin, add);
      for (std::size_t j = 0; j < i; ++j) {
        detail::for_each_crossing(boundaries[i], boundaries[j], add_crossing);
      }
    }
    std::stable_sort(candidates.begin(), candidates.end(), [&](const Point& a, const Point& b) {
      return distance(a, origin) < distance(b, origin);
    });
    for (const Point& candidate : candidates) {
      if (space.is_free(candidate)) return candidate;
    }
    if (reach >= farthest) return std::nullopt;
    reach = std::min(farthest, 2 * reach);
  }
}

}  // namespace tutavia
