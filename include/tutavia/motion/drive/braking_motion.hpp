// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/motion/differential_drive.hpp"
#include "tutavia/motion/drive/obstacle_distance.hpp"
#include "tutavia/motion/drive_command.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// BrakingMotion: a robot keeps a twist, brakes along its arc, and keeps its distance.

namespace tutavia::detail {

/// The twist in the k-th of `periods` periods of braking; zero in the last one.
inline Twist braked(const Twist& twist, int k, int periods) {
  const double left = 1 - double(k) / periods;
  return k == periods ? Twist{} : Twist{left * twist.v, left * twist.omega};
}

/// Calls `f` with the segment or arc that `path_of` returned.
template <class F>
auto on_drive_path(const Piece& path, F&& f) {
  const Arc* arc = path.get_if<Arc>();
  return arc != nullptr ? f(*arc) : f(*path.get_if<Segment>());
}

/// A robot keeps a twist for `hold` periods, and brakes in proportion for `periods` more: along one
/// arc.
struct BrakingMotion {
  Pose from;
  Twist twist;
  int hold;
  int periods;          // of braking
  double period;        // [s]
  double begin;         // from now [s]
  double distance = 0;  // to keep from obstacles [m]

  /// How long the robot would drive at the twist to come as far [s].
  double full_time() const { return period * (hold + 0.5 * std::max(0, periods - 1)); }
  /// Of the path [m].
  double length() const { return std::abs(twist.v) * full_time(); }
  Piece path() const { return path_of(from, twist, full_time()); }
  /// When the robot has covered a part of the path, from now [s].
  double time_at(double fraction) const;

  /// Whether the motion keeps its distance from the map, and within its bounds.
  template <ClearanceSpace S>
  MotionProof keeps_off_map(const S& space) const;
  /// Whether it keeps its distance from an obstacle, until the robot stands. `index`: its number.
  MotionProof keeps_off(const MovingObstacle& obstacle, std::uint32_t index) const;

 private:
  /// A part of the motion at one twist.
  struct Interval {
    Pose from;
    Twist twist;
    double begin;  // [s]
    double time;   // how long it lasts [s]
  };

  /// Whether an interval keeps the distance from an obstacle that moves: by halving the time until
  /// the obstacle's own motion no longer matters.
  MotionProof keeps_off(const MovingObstacle& obstacle, std::uint32_t index,
                        const Interval& interval) const;
};

inline double BrakingMotion::time_at(double fraction) const {
  const double time = fraction * full_time(), held = hold * period;
  double left = time - held, elapsed = std::min(time, held);
  for (int k = 1; k < periods && left > 0; ++k) {
    const double share = 1 - double(k) / periods;
    elapsed += std::min(period, left / share);
    left -= share * period;
  }
  return begin + elapsed;
}

template <ClearanceSpace S>
MotionProof BrakingMotion::keeps_off_map(const S& space) const {
  return on_drive_path(path(), [&](const auto& piece) -> MotionProof {
    const PieceProof proof = prove_distance(space, piece, distance);
    if (proof.status == ProofStatus::proved) return {.proved = true};
    const Point point = piece.point(proof.parameter);
    const double time = time_at(proof.parameter);
    if (!space.bounds().contains(point)) {
      return {false, {Blocker::Kind::bounds, NearestObstacle::none, time, point}};
    }
    const double reach = distance + space.safety_radius() + space.distance_error_bound();
    const NearestObstacle nearest = space.nearest(Segment{point, point}, reach);
    return {false, {Blocker::Kind::map, nearest.obstacle, time, point}};
  });
}

inline MotionProof BrakingMotion::keeps_off(const MovingObstacle& obstacle,
                                            std::uint32_t index) const {
  const Box box = box_of(obstacle.shape);
  return on_drive_path(path(), [&](const auto& piece) -> MotionProof {
    const Box swept = piece.box();
    const double magnitude = std::max(box.largest_coordinate(), swept.largest_coordinate());
    const double drift = obstacle.velocity.norm() * (begin + period * (double(hold) + periods));
    const Box near = swept.inflated(distance + drift + 1e-6 * magnitude);
    if (!near.meets(box)) return {.proved = true};
    if (obstacle.stands()) {
      const ClosestApproach found = distance_below(piece, obstacle.shape, magnitude);
      if (found.distance >= distance) return {.proved = true};
      return {
          false,
          {Blocker::Kind::observed, index, time_at(found.parameter), piece.point(found.parameter)}};
    }
    Interval interval{from, twist, begin, hold * period};
    for (int k = 1;; ++k) {
      MotionProof proof = keeps_off(obstacle, index, interval);
      if (!proof.proved || k >= periods) return proof;
      interval = {moved(interval.from, interval.twist, interval.time), braked(twist, k, periods),
                  interval.begin + interval.time, period};
    }
  });
}

inline MotionProof BrakingMotion::keeps_off(const MovingObstacle& obstacle, std::uint32_t index,
                                            const Interval& interval) const {
  // In the frame of the obstacle at the middle of the interval.
  const double half = 0.5 * interval.time, drift = half * obstacle.velocity.norm();
  Pose shifted = interval.from;
  shifted.position =
      offset_along(interval.from.position, -(interval.begin + half), obstacle.velocity);
  const double magnitude = box_of(obstacle.shape).largest_coordinate() +
                           max_magnitude(interval.from.position) + max_magnitude(shifted.position) +
                           length();
  const ClosestApproach found = on_drive_path(
      path_of(shifted, interval.twist, interval.time),
      [&](const auto& piece) { return distance_below(piece, obstacle.shape, magnitude); });
  if (found.distance - drift >= distance) return {.proved = true};
  constexpr double finest = 1.0 / 256;  // of a period
  if (found.distance + drift < distance || interval.time < finest * period) {
    const double at = found.parameter * interval.time;
    return {false,
            {Blocker::Kind::observed, index, interval.begin + at,
             moved(interval.from, interval.twist, at).position}};
  }
  const Interval first{interval.from, interval.twist, interval.begin, half};
  MotionProof proof = keeps_off(obstacle, index, first);
  if (!proof.proved) return proof;
  return keeps_off(obstacle, index,
                   {moved(first.from, first.twist, half), first.twist, first.begin + half, half});
}

}  // namespace tutavia::detail
