// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/smooth/route/input_checks.hpp"

/// \file
/// CurveSide: where a curve can be cut so that another one may be joined to what stays.

namespace tutavia::detail {

/// Where a new part leaves the earlier curve, seen from one of its ends.
struct RepairAnchor {
  std::size_t kept = 0;  ///< number of whole pieces between that end and `stub`
  /// The straight end of what stays, which leads to `point`; not there at the end of the curve.
  std::optional<Segment> stub{};
  Point point = Point::Zero();
};

/// A curve seen from one of its ends: piece 0 is the nearest to it.
class CurveSide {
 public:
  CurveSide(const Curve& curve, bool from_goal) : curve_(curve), from_goal_(from_goal) {}

  Point start() const { return from_goal_ ? curve_.end() : curve_.start(); }
  /// The piece as a segment that leads away from that end, if it is one and not a point.
  std::optional<Segment> segment(std::size_t k) const {
    const auto& pieces = curve_.pieces();
    const Segment* found = pieces[from_goal_ ? pieces.size() - 1 - k : k].get_if<Segment>();
    if (found == nullptr || found->a == found->b) return std::nullopt;
    return from_goal_ ? found->reversed() : *found;
  }

  /// A point before piece `failed`, with `spare` or more bends between it and the first straight
  /// piece that has to change. On a polyline it is a waypoint, else the middle of a straight piece.
  /// If there is none, it is the end of the curve.
  RepairAnchor anchor(std::size_t failed, std::size_t spare, bool is_polyline) const {
    std::size_t straight = 0;
    for (std::size_t k = is_polyline ? failed : failed + 1; k-- > 0;) {
      const auto line = segment(k);
      if (!line || straight++ < spare) continue;
      const Point point = is_polyline ? line->b : line->point(0.5);
      return {k, Segment{line->a, point}, point};
    }
    return {0, std::nullopt, start()};
  }

  /// Waypoints along the curve from one anchor to another that is farther from this end: the
  /// corners in which its straight pieces would meet without the bends between them.
  std::vector<Point> corners(const RepairAnchor& outer, const RepairAnchor& inner) const {
    std::vector<Point> points{outer.point};
    if (!inner.stub || inner.point == outer.point) return points;
    bool has_before = outer.stub.has_value();
    Segment before = outer.stub.value_or(Segment{});
    for (std::size_t k = has_before ? outer.kept + 1 : 0; k <= inner.kept; ++k) {
      const auto line = segment(k);
      if (!line) continue;
      const Point direction = before.b - before.a, next = line->b - line->a;
      const double s = cross(line->a - before.b, next) / cross(direction, next);
      const bool meet = has_before && s > 0 && std::isfinite(s);
      points.push_back(meet ? Point(before.b + s * direction) : line->a);
      before = *line;
      has_before = true;
    }
    points.push_back(inner.point);
    return points;
  }

 private:
  const Curve& curve_;
  bool from_goal_;
};

/// The turn between two consecutive pieces [rad].
inline double turn_between(const Piece& before, const Piece& after) {
  const auto end = [](const auto& piece) -> Point { return piece.end_direction(); };
  const auto start = [](const auto& piece) -> Point { return piece.start_direction(); };
  return std::abs(turn_angle(before.visit(end), after.visit(start)));
}

/// Makes one segment of pieces i and i + 1 if they are segments in the same direction.
inline bool merge_straight(std::vector<Piece>& pieces, std::size_t i) {
  const Segment *first = pieces[i].get_if<Segment>(), *second = pieces[i + 1].get_if<Segment>();
  if (first == nullptr || second == nullptr) return false;
  if (!(turn_between(pieces[i], pieces[i + 1]) <= 1e-12)) return false;
  pieces[i + 1] = Segment{first->a, second->b};
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
  return true;
}

inline bool equal_segments(const Piece& a, const Piece& b) {
  const Segment *first = a.get_if<Segment>(), *second = b.get_if<Segment>();
  return first != nullptr && second != nullptr && first->a == second->a && first->b == second->b;
}

}  // namespace tutavia::detail
