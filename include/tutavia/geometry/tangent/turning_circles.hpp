// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tutavia/geometry/pose.hpp"
#include "tutavia/geometry/vehicle_path.hpp"

/// \file
/// TurningCircles: where the turning circles at two poses lie to each other.

namespace tutavia::detail {

/// Turns below this are rounding [rad].
inline constexpr double steering_rounding = 0x1p-47;
/// Words whose lengths differ by less than this share of them are equally long.
inline constexpr double steering_tie = 1e-10;

/// The turning circles of a vehicle at two poses. Lengths are in units of the radius.
///
/// With the mean of both headings as the x axis, half the turn h, and the goal at (x, y), the
/// centres of both left circles differ by (x - 2 sin h, y), and those of the left circle at the
/// start and the right one at the goal by (x, y - 2 cos h). The square of the latter, less 4, is
/// x^2 + y^2 - 4 y cos h - 4 sin^2 h: so nothing cancels if the poses are close together.
struct TurningCircles {
  /// The vector from the centre of a circle at the start to one at the goal, with direction d.
  struct Between {
    double distance = 0;
    double excess = 0;  ///< distance^2 - 4, positive if the circles are apart; 0 if it is rounding
    double first = 0;   ///< h + d: its direction in the frame of the start [rad]
    double last = 0;    ///< h - d between circles of one side, d - h between circles of both [rad]
  };
  /// The circle on one side of the start. The right side is mirrored, so that it counts as left.
  struct Side {
    double mirror = 1;   ///< -1 for the right side
    double turn = 0;     ///< from the heading of the start to that of the goal [rad]
    Between same{};      ///< to the circle on the same side of the goal
    Between opposite{};  ///< to the circle on the other side of the goal
  };

  std::array<Side, 2> sides;  ///< left, right
  double rounding = 0;        ///< of distances, that of the poses included
  double turn_rounding = 0;   ///< of turns between circles that touch [rad]

  /// \pre finite poses, radius > 0
  static TurningCircles at(const Pose& from, const Pose& to, double radius) {
    const double turn = wrapped_angle(to.heading - from.heading), half = 0.5 * turn;
    const double axis = from.heading + half, cosine = std::cos(axis), sine = std::sin(axis);
    const double dx = (to.position.x() - from.position.x()) / radius;
    const double dy = (to.position.y() - from.position.y()) / radius;
    const Point goal{cosine * dx + sine * dy, cosine * dy - sine * dx};
    const Point normal{std::sin(half), std::cos(half)};
    const double reach =
        std::fmax(max_magnitude(from.position), max_magnitude(to.position)) / radius;
    const double rounding = 0x1p-50 * (1 + reach);
    return {
        {side(1, turn, goal, normal), side(-1, turn, goal, normal)}, rounding, std::sqrt(rounding)};
  }

 private:
  static Side side(double mirror, double turn, const Point& goal, const Point& normal) {
    const double half = 0.5 * mirror * turn, across = 2 * mirror * normal.x();
    const double along = 2 * normal.y(), x = goal.x(), y = mirror * goal.y();
    Side result{mirror, mirror * turn};
    const double near = x * x + y * y, beside = 2 * y * along, turned = across * across;
    const double excess = near - beside - turned;
    const bool rounded = std::abs(excess) <= 0x1p-50 * (near + std::abs(beside) + turned);
    result.same = between({x - across, y}, half, 1);
    result.same.excess = (result.same.distance - 2) * (result.same.distance + 2);
    result.opposite = between({x, y - along}, half, -1);
    result.opposite.excess = rounded ? 0 : excess;
    return result;
  }
  static Between between(const Point& v, double half, double sign) {
    const double direction = std::atan2(v.y(), v.x());
    const double distance = std::sqrt(v.x() * v.x() + v.y() * v.y());
    return {distance, 0, half + direction, sign * (half - direction)};
  }
};

/// The left turn that changes the heading by `angle`, in [-tolerance, 2 pi - tolerance) [rad]. A
/// tolerance above pi, where circles are smaller than the rounding of their centres, counts as pi.
/// \pre |angle| <= 4 pi
inline double left_turn(double angle, double tolerance) {
  constexpr double circle = 2 * std::numbers::pi;
  tolerance = std::min(tolerance, std::numbers::pi);
  while (angle < -tolerance) angle += circle;
  while (angle >= circle - tolerance) angle -= circle;
  return angle;
}

/// The same in [0, 2 pi); 0 if all but rounding of a full circle is left.
inline double left_turn(double angle) { return std::max(left_turn(angle, steering_rounding), 0.0); }

/// The lengths of a drive forwards: a turn, a straight move, a turn.
struct TurnStraightTurn {
  double first, straight, last;
};

/// LSL. The closer the centres of its circles are, the less does their direction say. A turn that
/// is negative within the rounding of the centres is 0, and the other one takes the difference.
/// Angles are of any number of circles; they add up to `turn`.
inline TurnStraightTurn around_one_side(double first, double straight, double last, double turn,
                                        const TurningCircles& circles) {
  if (straight <= 4 * circles.rounding) return {left_turn(turn), 0, 0};
  const double tolerance = steering_rounding + circles.rounding / straight;
  double t = left_turn(first, tolerance), v = left_turn(last, tolerance);
  if (t < 0) {
    v += t;
    t = 0;
  } else if (v < 0) {
    t += v;
    v = 0;
  }
  return {left_turn(t), straight, left_turn(v)};
}

/// LSR. The square of the straight move is rounded, so a short one is uncertain, and both turns
/// with it. If one is negative within that, both grow by the difference, and the straight move
/// shrinks by twice as much: the drive ends at the same pose. Angles are of any number of circles.
inline TurnStraightTurn around_both_sides(double first, double straight, double last,
                                          const TurningCircles& circles) {
  const double tolerance =
      steering_rounding + circles.rounding / std::max(straight, circles.turn_rounding);
  const double t = left_turn(first, tolerance), v = left_turn(last, tolerance);
  double missing = std::max(0.0, -std::min(t, v));
  if (2 * missing > straight) missing = 0;
  return {left_turn(t + missing), straight - 2 * missing, left_turn(v + missing)};
}

}  // namespace tutavia::detail
