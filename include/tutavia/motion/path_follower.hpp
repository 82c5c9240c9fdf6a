// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/motion/control_options.hpp"
#include "tutavia/motion/drive/obstacle_distance.hpp"
#include "tutavia/motion/drive/tracked_path.hpp"
#include "tutavia/motion/drive_command.hpp"
#include "tutavia/motion/motion_gate.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// PathFollower: regulated pure pursuit behind a gate.

namespace tutavia {

/// Options of PathFollower.
struct PathFollowerOptions {
  ControlOptions control{};
  double lookahead_time = 1.5;  ///< the lookahead distance at a speed, divided by the speed [s]
  double min_lookahead = 0.3;   ///< [m]
  double max_lookahead = 0.9;   ///< [m]
  double max_lateral_acceleration = 0.3;  ///< speed squared times curvature [m/s^2]
  double slow_gap = 0.3;     ///< slower where the gap to an obstacle is less than this [m]
  double slowest = 0.4;      ///< share of the maximum speed at no gap, in (0, 1]
  double turn_from = 0.8;    ///< turns on the spot if the path is this far off its heading [rad]
  double turn_until = 0.15;  ///< until it is less than this [rad]
  double tolerance = 0.02;   ///< has arrived at this distance from the end, or nearer [m]
};

/// Errors: `invalid_option`, which names the option.
inline Expected<void, Failure> validate(const PathFollowerOptions& options) {
  if (auto valid = validate(options.control); !valid) return valid;
  const auto is_positive = [](double x) { return x > 0 && std::isfinite(x); };
  const auto invalid = [](const char* rule) { return fail(PlanError::invalid_option, rule); };
  if (!is_positive(options.lookahead_time))
    return invalid("lookahead_time must be positive and finite");
  if (!is_positive(options.min_lookahead))
    return invalid("min_lookahead must be positive and finite");
  if (!(options.max_lookahead >= options.min_lookahead && std::isfinite(options.max_lookahead)))
    return invalid("max_lookahead must be finite and not below min_lookahead");
  if (!is_positive(options.max_lateral_acceleration))
    return invalid("max_lateral_acceleration must be positive and finite");
  if (!(options.slow_gap >= 0 && std::isfinite(options.slow_gap)))
    return invalid("slow_gap must be finite and not negative");
  if (!(options.slowest > 0 && options.slowest <= 1))
    return invalid("slowest must be positive and at most 1");
  if (!(options.turn_until > 0 && options.turn_from >= options.turn_until &&
        std::isfinite(options.turn_from)))
    return invalid("turn_from must be finite and not below turn_until, which must be positive");
  if (!is_positive(options.tolerance)) return invalid("tolerance must be positive and finite");
  return {};
}

/// Follows a curve by regulated pure pursuit: the robot drives along the arc to a point of the path
/// some distance ahead. The distance grows with the speed. The speed is limited by the curvature of
/// the arc and of the path ahead, by the gap to obstacles, and by the way to the end. Where the
/// path is far off its heading, the robot turns on the spot.
///
/// Every command passes a MotionGate, with its guarantee: the robot slows down or stops before an
/// obstacle. It does not drive around obstacles; where it stands `blocked`, give it a new path. The
/// path should keep some room beyond the safety radius, because the robot cuts corners a little.
///
/// The follower keeps a pointer to the space. One follower per robot. `step` allocates nothing.
///
/// Source: Macenski, Singh, Martin and Gines 2023, "Regulated pure pursuit for robot path
/// tracking"; Coulter 1992, "Implementation of the pure pursuit path tracking algorithm".
///
/// Example: examples/10_speed_profile.cpp.
template <ClearanceSpace S>
class PathFollower {
 public:
  using Options = PathFollowerOptions;

  /// A follower on the map `space`, which must outlive it. Errors: those of `validate(options)`.
  static Expected<PathFollower, Failure> build(const S& space, const Options& options = {}) {
    if (auto valid = validate(options); !valid) return std::move(valid).unexpected();
    auto gate = MotionGate<S>::build(space, options.control);
    if (!gate) return std::move(gate).unexpected();
    return PathFollower(std::move(*gate), options);
  }

  /// Sets the path. The robot may be moving. Errors: `invalid_input` for a curve that is empty or
  /// not finite; the robot then keeps its path.
  Expected<void, Failure> follow(Curve path);

  /// The path; empty at first.
  const Curve& path() const { return path_; }
  /// How far the robot has come along the path [m].
  double progress() const { return progress_; }

  /// The command for the next period. Call it once per period, with obstacles where they are now.
  DriveCommand step(const Pose& odometry, std::span<const MovingObstacle> observed);

 private:
  PathFollower(MotionGate<S> gate, const Options& options)
      : gate_(std::move(gate)), options_(options) {}

  const ControlOptions& control() const { return options_.control; }
  void advance(const Point& robot);
  /// Along the arc to the point at this distance ahead on the path.
  Twist pursue(const Pose& from, double lookahead, double speed) const;
  /// The direction of the point ahead, seen from the robot, in [-pi, pi].
  double bearing(const Pose& from, double lookahead) const;
  double turn_towards(double angle) const;
  double speed_limit(const Pose& from, std::span<const MovingObstacle> observed) const;
  double speed_in_bends() const;
  /// The highest speed from which the robot stops within a distance, or an angle.
  double stopping_speed(double way, double deceleration) const {
    const double period = control().period;
    return deceleration * (std::sqrt(period * period + 2 * way / deceleration) - period);
  }
  double speed_on(double curvature) const {
    const double most = control().limits.max_speed, bend = std::abs(curvature);
    if (!(bend > 0)) return most;
    return std::min({most, std::sqrt(options_.max_lateral_acceleration / bend),
                     control().limits.max_angular_speed / bend});
  }

  MotionGate<S> gate_;
  Options options_;
  Curve path_{};
  double progress_ = 0;
  bool is_turning_ = false;
  bool has_arrived_ = false;
};

template <ClearanceSpace S>
Expected<void, Failure> PathFollower<S>::follow(Curve path) {
  if (auto valid = detail::check_path(path); !valid) return valid;
  path_ = std::move(path);
  progress_ = 0;
  is_turning_ = has_arrived_ = false;
  return {};
}

template <ClearanceSpace S>
DriveCommand PathFollower<S>::step(const Pose& odometry, std::span<const MovingObstacle> observed) {
  if (!odometry.is_finite() || path_.empty()) return gate_.brake(odometry, observed);
  const Pose from = gate_.start_of_command(odometry);
  advance(from.position);
  if (distance(from.position, path_.end()) <= options_.tolerance + control().position_error) {
    has_arrived_ = true;
  }
  if (has_arrived_) return gate_.arrive(odometry, observed);

  const double lookahead = std::clamp(std::abs(gate_.last().v) * options_.lookahead_time,
                                      options_.min_lookahead, options_.max_lookahead);
  const double angle = bearing(from, lookahead);
  is_turning_ = std::abs(angle) > (is_turning_ ? options_.turn_until : options_.turn_from);
  if (is_turning_) return gate_.command(odometry, {0, turn_towards(angle)}, observed);

  const double speed = speed_limit(from, observed);
  const Twist wanted = pursue(from, lookahead, speed);
  const auto is_proved = [&](const Twist& twist) {
    return gate_.check(odometry, gate_.reachable(twist), control().hold, observed).proved;
  };
  if (is_proved(wanted)) return gate_.command(odometry, wanted, observed);
  // Nearer to the path there may be more room.
  const Twist nearer = pursue(from, options_.min_lookahead, speed);
  if (is_proved(nearer)) return gate_.command(odometry, nearer, observed);
  return gate_.command(odometry, wanted, observed);
}

/// The nearest point of the path not far behind and not far ahead: where a path comes near to
/// itself, the robot stays on its part.
template <ClearanceSpace S>
void PathFollower<S>::advance(const Point& robot) {
  const double back = std::max(0.0, progress_ - 0.5 * options_.max_lookahead);
  const double front = progress_ + 2 * options_.max_lookahead;
  double best = std::numeric_limits<double>::infinity(), s = progress_;
  for (std::size_t i = path_.locate(back).first; i < path_.pieces().size(); ++i) {
    const double before = path_.length_before(i), after = path_.length_before(i + 1);
    if (before > front) break;
    path_.pieces()[i].visit([&](const auto& piece) {
      const double length = after - before;
      if (!(length > 0)) return;
      const double foot = before + piece.length_to(piece.nearest_parameter(robot));
      const double at = std::clamp(foot, std::max(back, before), std::min(front, after));
      const double off = distance(robot, path_.point(at));
      if (off < best) {
        best = off;
        s = at;
      }
    });
  }
  progress_ = s;
}

template <ClearanceSpace S>
double PathFollower<S>::bearing(const Pose& from, double lookahead) const {
  const Point to = path_.point(progress_ + lookahead) - from.position;
  const double angle = std::atan2(to.y(), to.x()) - from.heading;
  return std::remainder(angle, 2 * std::numbers::pi);
}

template <ClearanceSpace S>
Twist PathFollower<S>::pursue(const Pose& from, double lookahead, double speed) const {
  const double away = distance(path_.point(progress_ + lookahead), from.position);
  const double curvature = away > 0 ? 2 * std::sin(bearing(from, lookahead)) / away : 0;
  const double v = std::min(speed, speed_on(curvature));
  return {v, curvature * v};
}

template <ClearanceSpace S>
double PathFollower<S>::turn_towards(double angle) const {
  const DriveLimits& limits = control().limits;
  return std::copysign(std::min(limits.max_angular_speed,
                                stopping_speed(std::abs(angle), limits.max_angular_acceleration)),
                       angle);
}

template <ClearanceSpace S>
double PathFollower<S>::speed_limit(const Pose& from,
                                    std::span<const MovingObstacle> observed) const {
  const DriveLimits& limits = control().limits;
  const double way = std::max(path_.length() - progress_, distance(from.position, path_.end()));
  double speed =
      std::min({limits.max_speed, speed_in_bends(), stopping_speed(way, limits.max_acceleration)});
  const double room = detail::clearance_among(gate_.space(), observed, from.position) -
                      gate_.space().safety_radius();
  if (room < options_.slow_gap) {
    const double share = std::max(0.0, room) / options_.slow_gap;
    speed = std::min(speed, limits.max_speed * (options_.slowest + (1 - options_.slowest) * share));
  }
  return speed;
}

/// Slow enough for the bends that the robot reaches before it could stop.
template <ClearanceSpace S>
double PathFollower<S>::speed_in_bends() const {
  const DriveLimits& limits = control().limits;
  const double most = limits.max_speed, brakes = limits.max_acceleration;
  const double way = most * most / (2 * brakes) + most * control().period;
  constexpr int samples = 8;
  double speed = most;
  for (int i = 0; i <= samples; ++i) {
    const double ahead = way * i / samples;
    const double there = speed_on(path_.curvature(progress_ + ahead));
    speed = std::min(speed, std::sqrt(there * there + 2 * brakes * ahead));
  }
  return speed;
}

}  // namespace tutavia
