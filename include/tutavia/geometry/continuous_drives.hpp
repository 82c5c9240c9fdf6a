// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>

#include "tutavia/core/assert.hpp"
#include "tutavia/geometry/pose.hpp"
#include "tutavia/geometry/steering_word.hpp"
#include "tutavia/geometry/tangent/continuous_turn.hpp"
#include "tutavia/geometry/tangent/turning_circles.hpp"
#include "tutavia/geometry/vehicle_path.hpp"

/// \file
/// ContinuousDrives: short drives between two poses, with a curvature that never jumps.

namespace tutavia {

/// Up to three moves with a curvature that is 0 at the ends of each.
struct ContinuousWord {
  /// Turns have the change of the heading as length [rad], straight moves their length [m]; both
  /// are negative in reverse.
  std::array<SteeringMove, 3> moves{};
  std::size_t size = 0;
  double length = std::numeric_limits<double>::infinity();  ///< of the path [m]

  /// Appends a move. A straight one is joined to a straight one before it, and left out if no more
  /// than `rounding` remains [m]. \pre size < 3
  void push_back(const SteeringMove& move, double rounding) {
    TUTAVIA_ASSERT(size < moves.size());
    moves[size++] = move;
    if (move.steering != Steering::straight) return;
    if (size > 1 && moves[size - 2].steering == Steering::straight) {
      --size;
      moves[size - 1].length += move.length;
    }
    if (std::abs(moves[size - 1].length) <= rounding) --size;
  }
};

/// Drives whose curvature is continuous: turns between clothoids (see detail::ContinuousTurn) and
/// straight moves. The curvature is 0 at both ends and at cusps, so the wheels never turn while the
/// vehicle stands.
///
/// Words are a turn, a straight move and a turn; a turn between two straight moves; and three
/// turns, each move in either gear. Among them are the counterparts of all words of Dubins; those
/// of Reeds and Shepp with four and five moves are not.
///
/// Source: Fraichard and Scheuer 2004, "From Reeds and Shepp's to continuous-curvature paths".
class ContinuousDrives {
 public:
  using Word = ContinuousWord;

  /// \pre both limits are positive and finite
  explicit ContinuousDrives(const SteeringLimits& limits, bool reverse = false)
      : turn_(limits), radius_(limits.min_turning_radius), reverse_(reverse) {}

  /// The length of a move [m].
  double length(const SteeringMove& move) const {
    const double size = std::abs(move.length);
    return move.steering == Steering::straight ? size : turn_.length(size);
  }

  /// The shortest of these words from one pose to another; among those whose lengths differ by less
  /// than 1e-10 of themselves, the first. Empty only if the poses are equal up to rounding.
  /// \pre the poses are finite, and their coordinates below 1e150
  ContinuousWord word(const Pose& from, const Pose& to) const;

  /// The shortest word for each pair of gears in which a drive starts and ends; of infinite length
  /// where there is none. \pre that of `word`
  std::array<ContinuousWord, 4> words(const Pose& from, const Pose& to) const;

  /// The path of a word from `word(from, to)`: it starts and ends exactly at these positions, with
  /// headings within 1e-12 rad of those of the poses if coordinates are not large beside the
  /// turning radius. It is built from both ends; one piece takes the rounding. A word without moves
  /// is an arc of sweep 0.
  VehiclePath path(const ContinuousWord& word, const Pose& from, const Pose& to) const;

  /// The shortest path between two poses. \pre the poses are finite
  VehiclePath path(const Pose& from, const Pose& to) const {
    return path(word(from, to), from, to);
  }

 private:
  struct Search;

  /// Appends a move from a pose, and returns the pose at its end.
  Pose append(const Pose& from, const SteeringMove& move, VehiclePath& path) const;

  detail::ContinuousTurn turn_;
  double radius_;  // the least that may be turned [m]
  bool reverse_;
};

/// Tries the words between two poses.
struct ContinuousDrives::Search {
  const ContinuousDrives& drives;
  const detail::ContinuousTurn& turn;
  std::span<const double> gears;         // 1: forward, -1: reverse
  double start, goal;                    // headings [rad]
  Point ends;                            // from one position to the other
  double rounding;                       // of positions [m]
  std::array<ContinuousWord, 4> best{};  // by the gears of the first and the last move

  /// The vector between the centres of the first and the last turn, on these sides, in these gears.
  Point centres(double first, double first_gear, double last, double last_gear) const {
    const auto centre = [&](double heading, double gear, double side) {
      const double c = std::cos(heading), s = std::sin(heading);
      const double x = gear * turn.ahead(), y = side * turn.beside();
      return Point{c * x - s * y, s * x + c * y};
    };
    return ends + centre(goal, -last_gear, last) - centre(start, first_gear, first);
  }

  /// The move that turns from one heading to another; straight if they are the same up to rounding.
  SteeringMove turn_between(double from, double to, double side, double gear,
                            double distance) const {
    const double tolerance = detail::steering_rounding + rounding / (distance + turn.radius());
    const double angle = detail::wrapped_angle(gear * side * (to - from));
    if (std::abs(angle) <= tolerance) return {Steering::straight, gear * 2 * turn.ahead()};
    return {side > 0 ? Steering::left : Steering::right,
            gear * (angle < 0 ? angle + 2 * std::numbers::pi : angle)};
  }

  /// Keeps the word of these moves if it is the shortest so far in its gears.
  void offer(std::span<const SteeringMove> moves) { offer(moves, 16 * rounding); }
  /// The same, where straight moves of less than `least` are rounding [m].
  void offer(std::span<const SteeringMove> moves, double least) {
    ContinuousWord word;
    for (const SteeringMove& move : moves) word.push_back(move, least);
    word.length = 0;
    for (std::size_t i = 0; i < word.size; ++i) {
      if (gears.size() == 1 && word.moves[i].length < 0) return;
      word.length += drives.length(word.moves[i]);
    }
    if (word.size == 0) return;
    const auto in_reverse = [](const SteeringMove& move) { return move.length < 0 ? 1u : 0u; };
    ContinuousWord& kept =
        best[2 * in_reverse(word.moves[0]) + in_reverse(word.moves[word.size - 1])];
    if (word.length < (1 - detail::steering_tie) * kept.length) kept = word;
  }

  /// A straight move alone, if the goal lies ahead or behind in the same heading.
  void with_one_move() {
    const double c = std::cos(start), s = std::sin(start);
    if (std::abs(detail::wrapped_angle(goal - start)) > detail::steering_rounding ||
        std::abs(c * ends.y() - s * ends.x()) > 4 * rounding) {
      return;
    }
    offer(std::array{SteeringMove{Steering::straight, c * ends.x() + s * ends.y()}});
  }

  /// A turn between straight moves, which lie on the lines of both poses.
  void with_one_turn(double side) {
    const Point ahead{std::cos(start), std::sin(start)}, behind{std::cos(goal), std::sin(goal)};
    for (const double gear : gears) {
      const SteeringMove move = turn_between(start, goal, side, gear, 0);
      if (move.steering == Steering::straight) continue;
      const Point rest = centres(side, gear, side, gear);  // the sum of both straight moves
      const double across = cross(ahead, behind);
      const SteeringMove first{Steering::straight, cross(rest, behind) / across};
      const SteeringMove last{Steering::straight, cross(ahead, rest) / across};
      if (std::abs(across) > 1e-3) {
        offer(std::array{first, move, last}, 16 * rounding / std::abs(across));
      }
      // Where one of them is 0 up to rounding, it would need a gear of its own.
      if (std::abs(cross(behind, rest)) <= 4 * rounding) {
        offer(std::array{move, SteeringMove{Steering::straight, behind.dot(rest)}});
      }
      if (std::abs(cross(ahead, rest)) <= 4 * rounding) {
        offer(std::array{SteeringMove{Steering::straight, ahead.dot(rest)}, move});
      }
    }
  }

  /// A turn, a straight move, a turn. Seen along the straight move, the centres lie beside each
  /// other by the difference of their sides.
  void with_straight(double first, double last) {
    const double across = (last - first) * turn.beside();
    for (const double first_gear : gears) {
      for (const double last_gear : gears) {
        const Point between = centres(first, first_gear, last, last_gear);
        const double square = between.squaredNorm() - across * across;
        if (square < -4 * rounding * std::abs(across)) continue;
        for (const double sign : gears) {
          const double along = sign * std::sqrt(std::fmax(square, 0));
          const double straight = along - (first_gear + last_gear) * turn.ahead();
          const double heading = std::atan2(between.y(), between.x()) - std::atan2(across, along);
          const double distance = std::abs(along);
          offer(std::array{turn_between(start, heading, first, first_gear, distance),
                           SteeringMove{Steering::straight, straight},
                           turn_between(heading, goal, last, last_gear, distance)});
        }
      }
    }
  }

  /// Three turns, to alternating sides. The centres form a triangle.
  void with_turns(double side) {
    for (const double first_gear : gears) {
      for (const double middle_gear : gears) {
        for (const double last_gear : gears) {
          const Point between = centres(side, first_gear, side, last_gear);
          const Point in{(first_gear + middle_gear) * turn.ahead(), -2 * side * turn.beside()};
          const Point out{(middle_gear + last_gear) * turn.ahead(), 2 * side * turn.beside()};
          const double a = in.norm(), b = out.norm(), c = between.norm();
          const double cosine = (a * a + c * c - b * b) / (2 * a * c);
          if (!(std::abs(cosine) <= 1)) continue;
          const double direction = std::atan2(between.y(), between.x());
          for (const double bend : {1.0, -1.0}) {
            const double to_middle = direction + bend * std::acos(cosine);
            const Point rest{between.x() - a * std::cos(to_middle),
                             between.y() - a * std::sin(to_middle)};
            const double entry = to_middle - std::atan2(in.y(), in.x());
            const double exit = std::atan2(rest.y(), rest.x()) - std::atan2(out.y(), out.x());
            offer(std::array{turn_between(start, entry, side, first_gear, 0),
                             turn_between(entry, exit, -side, middle_gear, 0),
                             turn_between(exit, goal, side, last_gear, 0)});
          }
        }
      }
    }
  }
};

inline ContinuousWord ContinuousDrives::word(const Pose& from, const Pose& to) const {
  ContinuousWord shortest;
  for (const ContinuousWord& word : words(from, to)) {
    if (word.length < (1 - detail::steering_tie) * shortest.length) shortest = word;
  }
  return shortest;
}

inline std::array<ContinuousWord, 4> ContinuousDrives::words(const Pose& from,
                                                             const Pose& to) const {
  static constexpr std::array gears{1.0, -1.0};
  const double magnitude =
      std::fmax(detail::max_magnitude(from.position), detail::max_magnitude(to.position));
  Search search{*this,
                turn_,
                std::span(gears).first(reverse_ ? 2 : 1),
                detail::wrapped_angle(from.heading),
                detail::wrapped_angle(to.heading),
                to.position - from.position,
                0x1p-50 * (magnitude + turn_.radius())};
  if (search.ends.norm() <= 16 * search.rounding &&
      std::abs(detail::wrapped_angle(search.goal - search.start)) <= detail::steering_rounding) {
    return {ContinuousWord{.length = 0}};
  }
  search.with_one_move();
  for (const double side : {1.0, -1.0}) {
    for (const double other : {side, -side}) search.with_straight(side, other);
    search.with_one_turn(side);
    search.with_turns(side);
  }
  return search.best;
}

inline Pose ContinuousDrives::append(const Pose& from, const SteeringMove& move,
                                     VehiclePath& path) const {
  if (move.steering != Steering::straight) return turn_.append(from, move, path);
  const Point end = detail::offset_along(from.position, move.length,
                                         Point{std::cos(from.heading), std::sin(from.heading)});
  path.push_back(detail::straight_drive(from, end, move.length / radius_),
                 detail::gear_of(move.length));
  return {end, from.heading};
}

inline VehiclePath ContinuousDrives::path(const ContinuousWord& word, const Pose& from,
                                          const Pose& to) const {
  VehiclePath path, back;
  Pose near = from, far = to;  // where the parts from the start and from the end meet the joint
  near.heading = detail::wrapped_angle(from.heading);
  far.heading = detail::wrapped_angle(to.heading);
  if (word.size == 0) {
    Arc point = detail::turn_from(near, {Steering::left, 0}, radius_);
    point.b = to.position;
    path.push_back(point, Gear::forward);
    return path;
  }
  std::size_t joint = word.size / 2;
  for (std::size_t i = 0; i < word.size; ++i) {
    if (word.moves[i].steering == Steering::straight) joint = i;
  }
  for (std::size_t i = 0; i < joint; ++i) near = append(near, word.moves[i], path);
  for (std::size_t i = word.size; i-- > joint + 1;) {
    const SteeringMove& move = word.moves[i];
    far = turn_.append(far, {move.steering, -move.length}, back);
  }
  const SteeringMove& middle = word.moves[joint];
  if (middle.steering == Steering::straight) {
    path.push_back(detail::straight_drive(near, far.position, middle.length / radius_),
                   detail::gear_of(middle.length));
  } else {
    turn_.append(near, middle, path, far.position);
  }
  path.append(back.reversed());
  return path;
}

}  // namespace tutavia
