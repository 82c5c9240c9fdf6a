// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/polygon.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// Workspace: bounds, obstacles and safety radius.

namespace tutavia {

/// A solid disc.
struct Disc {
  Point center = Point::Zero();
  double radius = 0;  ///< [m]; 0 is a single point
};

/// A solid obstacle that the robot must avoid.
using Obstacle = std::variant<Polygon, Disc>;

namespace detail {

/// The bounding box of an obstacle.
Box box_of(const Obstacle& obstacle);

}  // namespace detail

/// The bounds, the obstacles and the distance to keep from them.
///
/// Free space is closed: the points of `bounds` at a distance of `safety_radius` or more from every
/// obstacle. The bounds limit the robot's centre and are not inflated. Obstacles may overlap,
/// touch, nest or extend beyond the bounds.
struct Workspace {
  Box bounds;
  double safety_radius = 0;  ///< [m]: the robot's radius plus any extra margin
  std::vector<Obstacle> obstacles{};

  /// The bounding box of all obstacles; empty without any.
  Box extent() const;

  /// The largest magnitude among all coordinates [m]; rounding errors are proportional to it.
  double largest_coordinate() const;
};

namespace detail {

/// Whether predicates handle a coordinate without overflow or underflow.
inline bool is_valid_coordinate(double x) {
  return x == 0 || (std::abs(x) >= 0x1p-400 && std::abs(x) <= 0x1p400);
}
inline bool is_valid_point(const Point& p) {
  return is_valid_coordinate(p.x()) && is_valid_coordinate(p.y());
}

inline constexpr const char* coordinate_rule =
    "must be finite, and 0 or between 2^-400 and 2^400 in magnitude";

/// A message about the first invalid point of a ring; empty if there is none.
inline std::string error_message(const Ring& ring, const std::string& name) {
  if (ring.empty()) return name + " has no points";
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!is_valid_point(ring[i])) {
      return name + "[" + std::to_string(i) + "] " + coordinate_rule;
    }
  }
  return {};
}

inline std::string error_message(const Obstacle& obstacle, const std::string& name) {
  if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
    if (!is_valid_point(disc->center)) return name + ".center " + coordinate_rule;
    if (!is_valid_coordinate(disc->radius) || disc->radius < 0) {
      return name + ".radius must not be negative, and " + coordinate_rule;
    }
    return {};
  }
  const Polygon& polygon = std::get<Polygon>(obstacle);
  std::string result = error_message(polygon.outer, name + ".polygon");
  for (std::size_t i = 0; result.empty() && i < polygon.holes.size(); ++i) {
    result = error_message(polygon.holes[i], name + ".holes[" + std::to_string(i) + "]");
  }
  return result;
}

/// The rounding error of one distance computed from coordinates up to `magnitude`, with a reserve
/// [m]: 16 u M. Constructed paths keep twice this much as an extra margin.
inline double distance_rounding_error(double magnitude) { return 16 * 0x1p-53 * magnitude; }

inline Box box_of(const Obstacle& obstacle) {
  if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
    return Box::around({disc->center}).inflated(disc->radius);
  }
  Box box;
  const Polygon& polygon = std::get<Polygon>(obstacle);
  for (const Point& p : polygon.outer) box.include(p);
  for (const Ring& hole : polygon.holes) {
    for (const Point& p : hole) box.include(p);
  }
  return box;
}

}  // namespace detail

inline Box Workspace::extent() const {
  Box extent;
  for (const Obstacle& obstacle : obstacles) {
    const Box box = detail::box_of(obstacle);
    extent.include(box.min);
    extent.include(box.max);
  }
  return extent;
}

inline double Workspace::largest_coordinate() const {
  return obstacles.empty() ? bounds.largest_coordinate()
                           : std::fmax(bounds.largest_coordinate(), extent().largest_coordinate());
}

/// Checks a workspace before planning. Errors: `invalid_input` with the object and its index for a
/// coordinate that is not finite or has a magnitude outside 2^-400 to 2^400 (0 is valid), an empty
/// ring, a negative radius, empty bounds, or coordinates so large that their rounding (32 u M)
/// exceeds a thousandth of the safety radius.
inline Expected<void, Failure> validate(const Workspace& workspace) {
  const auto invalid = [](std::string detail) {
    return fail(PlanError::invalid_input, std::move(detail));
  };
  const Box& bounds = workspace.bounds;
  if (!detail::is_valid_point(bounds.min) || !detail::is_valid_point(bounds.max)) {
    return invalid(std::string("bounds ").append(detail::coordinate_rule));
  }
  if (!(bounds.min.x() <= bounds.max.x() && bounds.min.y() <= bounds.max.y())) {
    return invalid("bounds are empty: the minimum lies above the maximum");
  }
  if (!detail::is_valid_coordinate(workspace.safety_radius) || workspace.safety_radius < 0) {
    return invalid(
        std::string("safety_radius must not be negative, and ").append(detail::coordinate_rule));
  }
  for (std::size_t i = 0; i < workspace.obstacles.size(); ++i) {
    std::string error_message =
        detail::error_message(workspace.obstacles[i], "obstacles[" + std::to_string(i) + "]");
    if (!error_message.empty()) return invalid(std::move(error_message));
  }
  const double r = workspace.safety_radius, magnitude = workspace.largest_coordinate();
  if (r > 0 && 2 * detail::distance_rounding_error(magnitude) > 1e-3 * r) {
    return invalid("coordinates are too large for the safety radius: " + std::to_string(magnitude) +
                   " m against " + std::to_string(r) + " m leaves no room for rounding");
  }
  return {};
}

}  // namespace tutavia
