// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// tangent_polyline: a polyline around the arcs of a curve.

namespace tutavia::detail {

/// Appends tangents of an arc, from its start to its end, where they are free. Each spans
/// `most_turn` of it at most. Returns false if one is not free.
template <FreeSpace S>
bool append_tangents(const S& space, const Arc& arc, double most_turn, std::vector<Point>& points) {
  const double count = std::max(1.0, std::ceil(std::abs(arc.sweep) / most_turn));
  const double half = arc.sweep / count / 2;
  const auto add = [&](const Point& p) {
    const bool is_free = space.segment_free(points.back(), p);
    points.push_back(p);
    return is_free;
  };
  for (double i = 0; i < count; ++i) {
    const double angle = arc.start_angle + (2 * i + 1) * half, reach = arc.radius / std::cos(half);
    if (!add(
            {arc.center.x() + reach * std::cos(angle), arc.center.y() + reach * std::sin(angle)})) {
      return false;
    }
  }
  return add(arc.b);
}

/// The waypoints of a curve of segments and arcs, each arc replaced by tangents that lie on its
/// outer side, and are free: as few as that allows, at least one for every 45 degrees. Empty if a
/// curve has other pieces, or if 64 times as many are not free.
template <FreeSpace S>
std::optional<std::vector<Point>> tangent_polyline(const S& space, const Curve& curve) {
  if (curve.empty()) return std::vector<Point>{};
  std::vector<Point> points{curve.start()};
  for (const Piece& piece : curve.pieces()) {
    if (piece.holds<Segment>()) {
      points.push_back(end_of(piece));
      continue;
    }
    const Arc* arc = piece.get_if<Arc>();
    if (arc == nullptr) return std::nullopt;
    const std::size_t before = points.size();
    bool is_free = false;
    for (int k = 0; k <= 6 && !is_free; ++k) {
      points.resize(before);
      is_free = append_tangents(space, *arc, std::numbers::pi / 4 / (1 << k), points);
    }
    if (!is_free) return std::nullopt;
  }
  return points;
}

}  // namespace tutavia::detail
