// SPDX-License-Identifier: MIT
#include "map_frame.hpp"

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace plan_program {

namespace {

/// Puts the coordinates of the second point of a pair in the place of the first's, wherever a text
/// has them.
void name_anew(const std::vector<std::pair<Point, Point>>& points, std::string& text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    for (const auto& [before, after] : points) {
      const std::string old = detail::to_text(before), now = detail::to_text(after);
      if (text.compare(at, old.size(), old) != 0) continue;
      text.replace(at, old.size(), now);
      at += now.size() - 1;
      break;
    }
  }
}

}  // namespace

Point MapFrame::to_grid(const Point& in_map) {
  if (!is_turned_) return in_map;
  given_.emplace_back(to_grid_frame(map_, in_map), in_map);
  return given_.back().first;
}

Point MapFrame::to_map(const Point& in_grid) const {
  if (!is_turned_) return in_grid;
  for (const auto& [known, in_map] : given_) {
    if (known == in_grid) return in_map;
  }
  return to_map_frame(map_, in_grid);
}

Piece MapFrame::to_map(const Piece& in_grid) const {
  return in_grid.visit([&]<class P>(P piece) -> Piece {
    if constexpr (std::is_same_v<P, QuadraticBezier> || std::is_same_v<P, CubicBezier>) {
      for (Point& p : piece.points) p = to_map(p);
    } else {
      piece.a = to_map(piece.a);
      piece.b = to_map(piece.b);
    }
    if constexpr (std::is_same_v<P, Arc>) {
      piece.center = to_map(piece.center);
      piece.start_angle += map_.yaw;
    }
    if constexpr (std::is_same_v<P, Clothoid>) piece.start_heading += map_.yaw;
    return piece;
  });
}

Curve MapFrame::to_map(const Curve& in_grid) const {
  if (!is_turned_) return in_grid;
  Curve curve;
  curve.reserve(in_grid.pieces().size());
  for (const Piece& piece : in_grid.pieces()) curve.push_back(to_map(piece));
  return curve;
}

Expected<Plan, Failure> MapFrame::to_map(Expected<Plan, Failure> plan) const {
  if (!is_turned_) return plan;
  if (plan) {
    plan->curve = to_map(plan->curve);
    plan->route.curve = to_map(plan->route.curve);
    plan->certificate.point = to_map(plan->certificate.point);
    return plan;
  }
  Failure& failure = plan.error();
  std::vector<std::pair<Point, Point>> points = given_;
  if (auto& safe = failure.nearest_safe_point) {
    points.emplace_back(*safe, to_map(*safe));
    safe = points.back().second;
  }
  name_anew(points, failure.detail);
  return plan;
}

SearchRecord MapFrame::to_map(SearchRecord record) const {
  if (!is_turned_) return record;
  for (SearchRecord::Event& event : record.events) {
    event.a = to_map(event.a);
    event.b = to_map(event.b);
  }
  record.tree_path = to_map(record.tree_path);
  return record;
}

}  // namespace plan_program
