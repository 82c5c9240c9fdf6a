// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "tutavia/core/random.hpp"
#include "tutavia/geometry/pose.hpp"
#include "tutavia/geometry/steering_word.hpp"
#include "tutavia/geometry/vehicle_path.hpp"

/// \file
/// Words driven move by move in long doubles, random poses, and what every path of a word keeps.

namespace tutavia::test {

/// The pose to which a word leads. Its heading is not wrapped.
inline Pose driven(const SteeringWord& word, const Pose& from, double radius) {
  long double x = from.position.x(), y = from.position.y(), heading = from.heading;
  for (std::size_t i = 0; i < word.size; ++i) {
    const long double length = word.moves[i].length, r = radius;
    if (word.moves[i].steering == Steering::straight) {
      x += r * length * std::cos(heading);
      y += r * length * std::sin(heading);
      continue;
    }
    const long double side = word.moves[i].steering == Steering::left ? 1 : -1;
    const long double next = heading + side * length;
    x += side * r * (std::sin(next) - std::sin(heading));
    y -= side * r * (std::cos(next) - std::cos(heading));
    heading = next;
  }
  return {{static_cast<double>(x), static_cast<double>(y)}, static_cast<double>(heading)};
}

inline double heading_difference(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

/// How far from `to` the word ends, as a share of the lengths and coordinates it was computed from.
inline double relative_miss(const SteeringWord& word, const Pose& from, const Pose& to,
                            double radius) {
  const double scale = radius * (1 + word.length()) + from.position.norm() + to.position.norm();
  return (driven(word, from, radius).position - to.position).norm() / scale;
}

/// "L+R-S-": the steering and gears of a word without rounding.
inline std::string shape_of(const SteeringWord& word) {
  const SteeringWord moves = word.without_rounding();
  std::string shape;
  for (std::size_t i = 0; i < moves.size; ++i) {
    shape += "RSL"[static_cast<int>(moves.moves[i].steering) + 1];
    shape += moves.moves[i].length < 0 ? '-' : '+';
  }
  return shape;
}

inline Pose any_pose(Random& random, double reach) {
  const double pi = std::numbers::pi;
  return {{random.uniform(-reach, reach), random.uniform(-reach, reach)}, random.uniform(-pi, pi)};
}

/// `pose`, given in the frame of `frame`.
inline Pose placed(const Pose& pose, const Pose& frame) {
  const double c = std::cos(frame.heading), s = std::sin(frame.heading);
  const Point& p = pose.position;
  return {frame.position + Point(c * p.x() - s * p.y(), s * p.x() + c * p.y()),
          frame.heading + pose.heading};
}

/// The first promise that a path from one pose to another breaks: its ends, headings, curvature,
/// joined pieces and length. Empty if it keeps all.
inline std::string broken_promise(const VehiclePath& path, const SteeringWord& word,
                                  const Pose& from, const Pose& to, double radius) {
  if (path.empty()) return "no piece";
  if (path.curve.start() != from.position || path.curve.end() != to.position) return "ends";
  if (heading_difference(path.start().heading, from.heading) > 1e-12) return "first heading";
  if (heading_difference(path.end().heading, to.heading) > 1e-12) return "last heading";
  const double scale = radius + detail::max_magnitude(from.position) +
                       detail::max_magnitude(to.position) + radius * word.length();
  if (std::abs(path.length() - radius * word.length()) > 1e-13 * scale) return "length";
  for (std::size_t i = 0; i < path.gears.size(); ++i) {
    const Piece& piece = path.curve.pieces()[i];
    if (const Arc* arc = piece.get_if<Arc>()) {
      if (arc->radius != radius) return "radius";
      if (arc->evaluation_error() > 1e-14 * scale) return "gap";
    } else if (max_curvature(piece) > 0) {
      return "curvature";
    }
    if (i == 0) continue;
    if (heading_difference(path.pose(i - 1, 1).heading, path.pose(i, 0).heading) > 1e-12) {
      return "heading between pieces";
    }
  }
  return {};
}

}  // namespace tutavia::test
