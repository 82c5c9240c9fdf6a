// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/pose.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/plan/vehicle.hpp"

/// \file
/// The outline of a vehicle's footprint, and the poses at which a picture shows it.

namespace tutavia::detail {

/// Whether disc i lies in another disc; of equal discs the first one lies in none of them.
inline bool is_covered(const std::vector<FootprintDisc>& discs, std::size_t i) {
  for (std::size_t j = 0; j < discs.size(); ++j) {
    if (j == i) continue;
    const double gap = discs[j].radius - discs[i].radius;
    const double apart = (discs[j].offset - discs[i].offset).norm();
    const bool are_equal = apart == 0 && gap == 0;
    if (are_equal ? j < i : apart <= gap) return true;
  }
  return false;
}

/// The parts of circle i that lie in other discs, as intervals of angles within [0, 2 pi].
inline std::vector<std::pair<double, double>> covered_angles(
    const std::vector<FootprintDisc>& discs, std::size_t i) {
  constexpr double turn = 2 * std::numbers::pi;
  const FootprintDisc& disc = discs[i];
  std::vector<std::pair<double, double>> covered;
  for (const FootprintDisc& other : discs) {
    const Point to_other = other.offset - disc.offset;
    const double apart = to_other.norm();
    if (apart >= disc.radius + other.radius || apart <= std::abs(disc.radius - other.radius)) {
      continue;
    }
    const double cosine =
        (apart * apart + disc.radius * disc.radius - other.radius * other.radius) /
        (2 * apart * disc.radius);
    const double half = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double middle = std::atan2(to_other.y(), to_other.x());
    const double from = middle - half < 0 ? middle - half + turn : middle - half;
    covered.emplace_back(from, std::min(from + 2 * half, turn));
    if (from + 2 * half > turn) covered.emplace_back(0, from + 2 * half - turn);
  }
  std::sort(covered.begin(), covered.end());
  return covered;
}

/// The outline of a union of discs as arcs around their centres, relative to the reference point.
/// Discs without a radius have none.
inline std::vector<Arc> outline_of(const std::vector<FootprintDisc>& discs) {
  constexpr double turn = 2 * std::numbers::pi;
  std::vector<Arc> arcs;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (!(discs[i].radius > 0) || is_covered(discs, i)) continue;
    double free_from = 0;
    const auto add = [&](double to) {
      if (to > free_from) {
        arcs.push_back(Arc::around(discs[i].offset, discs[i].radius, free_from, to - free_from));
      }
    };
    for (const auto& [from, to] : covered_angles(discs, i)) {
      add(from);
      free_from = std::max(free_from, to);
    }
    add(turn);
  }
  return arcs;
}

/// A point that is fixed to a vehicle, in the plane.
inline Point placed(const Point& p, const Pose& pose) {
  const double c = std::cos(pose.heading), s = std::sin(pose.heading);
  return pose.position + Point(c * p.x() - s * p.y(), s * p.x() + c * p.y());
}
/// An arc that is fixed to a vehicle, in the plane.
inline Arc placed(const Arc& arc, const Pose& pose) {
  return Arc::around(placed(arc.center, pose), arc.radius, arc.start_angle + pose.heading,
                     arc.sweep);
}

/// Poses at equal distances along a path, both ends among them: 10 to 25, about `spacing` apart.
/// \pre the path is not empty
inline std::vector<Pose> poses_along(const VehiclePath& path, double spacing) {
  const double length = path.length();
  const double gaps = std::clamp(std::ceil(length / spacing), 9.0, 24.0);
  std::vector<Pose> poses{path.start()};
  for (double i = 1; i < gaps; ++i) poses.push_back(path.at(length * i / gaps));
  poses.push_back(path.end());
  return poses;
}

}  // namespace tutavia::detail
