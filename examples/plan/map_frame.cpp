// SPDX-License-Identifier: MIT
#include "map_frame.hpp"

#include <cstddef>
#include <string>
#include <type_traits>

namespace plan_program {

namespace {

/// Puts the coordinates of one point in the place of another's, wherever a text has them.
void name_anew(const Point& before, const Point& after, std::string& text) {
  const std::string old = detail::to_text(before), now = detail::to_text(after);
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at)) {
    text.replace(at, old.size(), now);
    at += now.size();
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
  for (const auto& [known, in_map] : given_) name_anew(known, in_map, failure.detail);
  if (auto& safe = failure.nearest_safe_point) {
    name_anew(*safe, to_map(*safe), failure.detail);
    safe = to_map(*safe);
  }
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
