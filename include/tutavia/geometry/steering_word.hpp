// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "tutavia/core/assert.hpp"
#include "tutavia/geometry/tangent/turning_circles.hpp"
#include "tutavia/geometry/vehicle_path.hpp"

/// \file
/// SteeringWord: a drive with full lock or straight ahead, and its path. SteeringLimits.

namespace tutavia {

/// The position of the steering wheel: full lock to one side, or straight ahead.
enum class Steering : std::int8_t { right = -1, straight = 0, left = 1 };

/// How far, and how fast along its path, a vehicle steers.
struct SteeringLimits {
  double min_turning_radius = 1;  ///< [m], positive
  double max_sharpness = 1;       ///< change of the curvature with arc length [1/m^2], positive
};

/// A drive without steering meanwhile.
struct SteeringMove {
  Steering steering = Steering::straight;
  /// In turning radii, so in radians for turns; negative in reverse. (A ContinuousWord has straight
  /// moves in metres.)
  double length = 0;

  /// Change of the heading [rad], left positive.
  double turn() const { return static_cast<double>(steering) * length; }
};

/// Up to five moves, one after the other: what Dubins and Reeds and Shepp call a word.
struct SteeringWord {
  std::array<SteeringMove, 5> moves{};
  std::size_t size = 0;

  /// \pre size < 5
  void push_back(const SteeringMove& move) {
    TUTAVIA_ASSERT(size < moves.size());
    moves[size++] = move;
  }

  /// Sum of the lengths of all moves, in turning radii.
  double length() const {
    double sum = 0;
    for (std::size_t i = 0; i < size; ++i) sum += std::abs(moves[i].length);
    return sum;
  }

  /// The word without moves that are rounding only: turns below 2^-47 rad, and straight moves below
  /// 2^-47 of the length of the word.
  SteeringWord without_rounding() const {
    const double least = detail::steering_rounding * length();
    SteeringWord result;
    for (std::size_t i = 0; i < size; ++i) {
      const bool straight = moves[i].steering == Steering::straight;
      const double limit = straight ? least : detail::steering_rounding;
      if (std::abs(moves[i].length) > limit) result.push_back(moves[i]);
    }
    return result;
  }

  /// How often the vehicle stops and changes gear; moves that are rounding do not count.
  std::size_t cusps() const {
    const SteeringWord word = without_rounding();
    std::size_t count = 0;
    for (std::size_t i = 1; i < word.size; ++i) {
      if ((word.moves[i].length < 0) != (word.moves[i - 1].length < 0)) ++count;
    }
    return count;
  }
};

namespace detail {

inline Gear gear_of(double length) { return length < 0 ? Gear::reverse : Gear::forward; }

/// The arc of a turn from `from`, with its end computed.
inline Arc turn_from(const Pose& from, const SteeringMove& move, double radius) {
  const double side = static_cast<double>(move.steering);
  const double angle = from.heading - side * (std::numbers::pi / 2);
  const Point center{from.position.x() - radius * std::cos(angle),
                     from.position.y() - radius * std::sin(angle)};
  Arc arc = Arc::around(center, radius, angle, move.turn());
  arc.a = from.position;
  return arc;
}

/// A straight drive of `length` turning radii from `from` to `to`. A short one keeps its heading in
/// a number, because its ends, which are ends of arcs, are rounded.
inline Piece straight_drive(const Pose& from, const Point& to, double length) {
  const double direction = from.heading + (length < 0 ? std::numbers::pi : 0.0);
  if (std::abs(length) >= 0.01) return straight_piece(from.position, to, direction);
  return Clothoid{from.position, to, direction, 0, 0, distance(from.position, to)};
}

/// The path of a word of which only rounding is left: a single point, or straight ahead or back.
inline VehiclePath path_without_moves(const Pose& from, const Pose& to, double radius) {
  VehiclePath path;
  const Point step = to.position - from.position;
  if (is_zero(step)) {
    Arc point = turn_from(from, {Steering::left, 0}, radius);
    point.b = to.position;
    path.push_back(point, Gear::forward);
  } else {
    const double ahead = step.x() * std::cos(from.heading) + step.y() * std::sin(from.heading);
    const double length = std::copysign(step.norm() / radius, ahead);
    path.push_back(straight_drive(from, to.position, length), gear_of(length));
  }
  return path;
}

}  // namespace detail

/// The path of a word that leads from one pose to another: arcs of exactly this radius and straight
/// pieces (segments, or clothoids without curvature), one per move. Moves that are rounding are
/// left out; a single point is an arc of sweep 0. The path starts exactly at the position `from`
/// and ends exactly at the position `to`; its headings there are those of the poses within 1e-12
/// rad.
///
/// It is built from both ends. The straight move, or the middle turn if there is none, joins the
/// two parts and takes their rounding: a few 1e-16 of coordinates and lengths. \pre the word leads
/// from `from` to `to` up to rounding and has at most one straight move; the poses are finite;
/// radius > 0 [m]
inline VehiclePath vehicle_path(const SteeringWord& word, const Pose& from, const Pose& to,
                                double radius) {
  const SteeringWord driven = word.without_rounding();
  if (driven.size == 0) return detail::path_without_moves(from, to, radius);
  std::size_t joint = driven.size / 2;
  for (std::size_t i = 0; i < driven.size; ++i) {
    if (driven.moves[i].steering == Steering::straight) joint = i;
  }
  VehiclePath path;
  Pose near = from, far = to;  // where the parts from the start and from the end meet the joint
  for (std::size_t i = 0; i < joint; ++i) {
    const SteeringMove& move = driven.moves[i];
    const Arc arc = detail::turn_from(near, move, radius);
    path.push_back(arc, detail::gear_of(move.length));
    near = {arc.b, near.heading + move.turn()};
  }
  std::array<Arc, 5> last;
  for (std::size_t i = driven.size; i-- > joint + 1;) {
    const SteeringMove& move = driven.moves[i];
    last[i] = detail::turn_from(far, {move.steering, -move.length}, radius).reversed();
    far = {last[i].a, far.heading - move.turn()};
  }
  const SteeringMove& middle = driven.moves[joint];
  if (middle.steering == Steering::straight) {
    path.push_back(detail::straight_drive(near, far.position, middle.length),
                   detail::gear_of(middle.length));
  } else {
    Arc arc = detail::turn_from(near, middle, radius);
    arc.b = far.position;
    path.push_back(arc, detail::gear_of(middle.length));
  }
  for (std::size_t i = joint + 1; i < driven.size; ++i) {
    path.push_back(last[i], detail::gear_of(driven.moves[i].length));
  }
  return path;
}

}  // namespace tutavia
