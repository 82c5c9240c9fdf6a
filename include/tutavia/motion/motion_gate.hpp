// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "tutavia/motion/control_options.hpp"
#include "tutavia/motion/drive/braking_motion.hpp"
#include "tutavia/motion/drive/command_history.hpp"
#include "tutavia/motion/drive/obstacle_distance.hpp"
#include "tutavia/motion/drive_command.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// MotionGate: lets only commands through from which a robot can stop in time.

namespace tutavia {

/// Lets a command pass only if the robot can keep it for `hold` periods and then brake to a
/// standstill, and stays at the safety radius all the way: from the map, from obstacles that stand,
/// and from those that move, until the robot stands.
///
/// The robot brakes along the arc on which it drives: speed and angular speed shrink in proportion,
/// in as few periods as both limits allow. So a motion sweeps one arc, whose distance from an
/// obstacle has a closed form. Distances to obstacles that move are enclosed over intervals of
/// time. When no command passes, the robot brakes along the arc that was proved last. Hence a robot
/// that follows its commands exactly does not touch an obstacle while it moves, if
///   - its true pose is within the error bounds of the odometry,
///   - obstacles keep their velocity while the robot brakes, and
///   - no obstacle appears nearer than the robot needs to stop. `emergency` reports one that comes
///     nearer than the safety radius without the odometry's error before the robot stands.
/// An obstacle may still drive into a robot that stands. Turning on the spot moves no point of a
/// disc and always passes. The map's bounds limit the robot's centre, without the errors.
///
/// The odometry's errors are added to the safety radius: once up to a quarter of the greatest
/// speed, three times beyond, so that a robot stops where noise does not hold it; and once where it
/// is nearer already.
///
/// The gate remembers the commands it issued. Use one for each robot. Apart from `build`, nothing
/// allocates memory.
///
/// Source of the criterion: Fraichard and Asama 2004, "Inevitable collision states", restricted to
/// braking manoeuvres (passive safety: Macek, Vasquez, Fraichard and Siegwart 2009, "Towards safe
/// vehicle navigation in dynamic urban scenarios").
template <ClearanceSpace S>
class MotionGate {
 public:
  /// A gate for the map `space`, which must outlive it. Errors: those of `validate(options)`.
  static Expected<MotionGate, Failure> build(const S& space, const ControlOptions& options) {
    if (auto valid = validate(options); !valid) return std::move(valid).unexpected();
    return MotionGate(space, options);
  }

  const S& space() const { return *space_; }
  const ControlOptions& options() const { return options_; }
  /// The command issued last; zero at first.
  const Twist& last() const { return history_.last(); }
  /// The robot stands, and no command that moves it is under way.
  bool stands() const { return history_.stands(); }

  /// Whether odometry and obstacles are finite numbers of a size that distances can be computed of.
  static bool accepts(const Pose& odometry, std::span<const MovingObstacle> observed) {
    return odometry.is_finite() && detail::is_valid_point(odometry.position) &&
           std::all_of(observed.begin(), observed.end(), detail::is_valid_obstacle);
  }

  /// The pose at which a command issued now takes effect.
  Pose start_of_command(const Pose& odometry) const { return start(odometry).pose; }

  /// The command nearest to `wanted` that the limits allow after the last one, on the same arc
  /// where possible.
  Twist reachable(const Twist& wanted) const;

  /// Whether the robot can keep a twist from now for `hold` periods and then brake.
  MotionProof check(const Pose& odometry, const Twist& twist, int hold,
                    std::span<const MovingObstacle> observed) const;

  /// Issues the command for the next period: `wanted`, or if it is not proved something slower, or
  /// else the next step of braking.
  DriveCommand command(const Pose& odometry, const Twist& wanted,
                       std::span<const MovingObstacle> observed);

  /// Issues the next step of braking, whatever else could be done. \see command
  DriveCommand brake(const Pose& odometry, std::span<const MovingObstacle> observed) {
    return brake(odometry, observed, accepts(odometry, observed));
  }

  /// Brakes at the end of a path: `driving`, and `arrived` once the robot stands.
  DriveCommand arrive(const Pose& odometry, std::span<const MovingObstacle> observed) {
    DriveCommand command = brake(odometry, observed);
    if (command.status == DriveStatus::stopping || command.status == DriveStatus::blocked) {
      command.status = stands() ? DriveStatus::arrived : DriveStatus::driving;
      command.blocker = {};
    }
    return command;
  }

  /// Forgets the commands: the robot stands.
  void reset() {
    history_.clear();
    braking_periods_ = 0;
  }

 private:
  /// Where a command issued now takes effect.
  struct Start {
    Pose pose;
    double length;  // of the path until there [m]
  };

  MotionGate(const S& space, const ControlOptions& options)
      : space_(&space), options_(options), history_(options) {}

  DriveCommand brake(const Pose& odometry, std::span<const MovingObstacle> observed,
                     bool input_is_valid);
  Start start(const Pose& odometry) const;
  /// Whether the robot touches nothing, as far as the odometry can tell, until a command issued now
  /// takes effect, `length` metres from now. It cannot be kept from it any more.
  MotionProof check_under_way(const Pose& odometry, double length,
                              std::span<const MovingObstacle> observed) const;
  /// Whether a motion keeps its distance from the map and the observed obstacles. It may leave the
  /// bounds, which then are the blocker.
  MotionProof check_except_bounds(const detail::BrakingMotion& motion,
                                  std::span<const MovingObstacle> observed) const;
  static MotionProof check_observed(const detail::BrakingMotion& motion,
                                    std::span<const MovingObstacle> observed);
  int braking_periods(const Twist& twist) const;
  /// A bound on the odometry's error of a point on a path of some length [m].
  double error_within(double length) const {
    return options_.position_error + options_.heading_error * length;
  }
  /// The distance that a motion has to keep, if the robot has some clearance where it begins.
  double distance_to_keep(const Start& start, double clearance,
                          const detail::BrakingMotion& motion) const;
  double clearance_at(const Point& p, double time, std::span<const MovingObstacle> observed) const;

  DriveCommand issue(const Twist& twist, DriveStatus status, const Blocker& blocker) {
    history_.add(twist);
    return {twist, status, blocker};
  }

  const S* space_;
  ControlOptions options_;
  detail::CommandHistory history_;
  int braking_periods_ = 0;  // in which the robot stops from the last command
};

template <ClearanceSpace S>
typename MotionGate<S>::Start MotionGate<S>::start(const Pose& odometry) const {
  double length = 0;
  const Pose pose = history_.for_each_under_way(
      odometry, [&](const Pose&, const Twist& twist, double, double time) {
        length += std::abs(twist.v) * time;
      });
  return {pose, length};
}

template <ClearanceSpace S>
MotionProof MotionGate<S>::check_under_way(const Pose& odometry, double length,
                                           std::span<const MovingObstacle> observed) const {
  MotionProof proof{.proved = true};
  const double distance = std::max(0.0, space_->safety_radius() - error_within(length));
  history_.for_each_under_way(
      odometry, [&](const Pose& from, const Twist& twist, double begin, double time) {
        if (!proof.proved || twist.v == 0) return;
        proof = check_except_bounds({from, twist, 1, 0, time, begin, distance}, observed);
      });
  return proof;
}

template <ClearanceSpace S>
MotionProof MotionGate<S>::check_except_bounds(const detail::BrakingMotion& motion,
                                               std::span<const MovingObstacle> observed) const {
  MotionProof proof = motion.keeps_off_map(*space_);
  proof.proved = proof.proved || proof.blocker.kind == Blocker::Kind::bounds;
  if (!proof.proved) return proof;
  const MotionProof beside = check_observed(motion, observed);
  return beside.proved ? proof : beside;
}

template <ClearanceSpace S>
MotionProof MotionGate<S>::check_observed(const detail::BrakingMotion& motion,
                                          std::span<const MovingObstacle> observed) {
  MotionProof proof{.proved = true};
  for (std::uint32_t i = 0; proof.proved && i < observed.size(); ++i) {
    proof = motion.keeps_off(observed[i], i);
  }
  return proof;
}

template <ClearanceSpace S>
int MotionGate<S>::braking_periods(const Twist& twist) const {
  const DriveLimits& limits = options_.limits;
  const double periods =
      std::max(std::abs(twist.v) / (limits.max_acceleration * options_.period),
               std::abs(twist.omega) / (limits.max_angular_acceleration * options_.period));
  return static_cast<int>(std::ceil(periods * (1 - 1e-12)));
}

template <ClearanceSpace S>
Twist MotionGate<S>::reachable(const Twist& wanted) const {
  const DriveLimits& limits = options_.limits;
  // A ten-thousandth is left for the last step, which makes tiny turns straight.
  const double step = limits.max_acceleration * options_.period * (1 - 1e-4);
  const double turn = limits.max_angular_acceleration * options_.period * (1 - 1e-4);
  const double least_turn = 1e-4 * limits.max_angular_acceleration * options_.period;
  const double slowest = std::max(0.0 - limits.max_backward_speed, last().v - step);
  const double fastest = std::min(limits.max_speed, last().v + step);
  const double right = std::max(-limits.max_angular_speed, last().omega - turn);
  const double left = std::min(limits.max_angular_speed, last().omega + turn);
  Twist result{std::clamp(wanted.v, slowest, fastest), std::clamp(wanted.omega, right, left)};
  if (wanted.v != 0 && result.v != 0 && wanted.v * result.v > 0) {
    const double curvature = wanted.omega / wanted.v;
    result.omega = std::clamp(curvature * result.v, right, left);
    // Where the robot cannot turn so fast, it drives slower.
    if (std::abs(curvature * result.v) > std::abs(result.omega) && curvature * result.omega > 0) {
      result.v = std::clamp(result.omega / curvature, std::min(slowest, result.v),
                            std::max(fastest, result.v));
    }
  }
  if (std::abs(result.omega) < least_turn) result.omega = 0;
  return result;
}

template <ClearanceSpace S>
double MotionGate<S>::clearance_at(const Point& p, double time,
                                   std::span<const MovingObstacle> observed) const {
  double least = space_->clearance(p) - space_->distance_error_bound();
  for (const MovingObstacle& obstacle : observed) {
    const Point q = detail::offset_along(p, -time, obstacle.velocity);
    const double magnitude = detail::box_of(obstacle.shape).largest_coordinate();
    least = std::min(least, detail::distance_below(Segment{q, q}, obstacle.shape,
                                                   std::max(magnitude, detail::max_magnitude(q)))
                                .distance);
  }
  return least;
}

template <ClearanceSpace S>
double MotionGate<S>::distance_to_keep(const Start& start, double clearance,
                                       const detail::BrakingMotion& motion) const {
  const double error = error_within(start.length + motion.length());
  const double radius = space_->safety_radius();
  const bool is_slow = std::abs(motion.twist.v) <= 0.26 * options_.limits.fastest();
  const double most = radius * (1 + 1e-3) + (is_slow ? 1 : 3) * error;
  return std::clamp(clearance, radius + error, most);
}

template <ClearanceSpace S>
MotionProof MotionGate<S>::check(const Pose& odometry, const Twist& twist, int hold,
                                 std::span<const MovingObstacle> observed) const {
  if (!accepts(odometry, observed)) return {};
  const bool is_possible = hold >= 1 && std::abs(twist.v) <= options_.limits.fastest() &&
                           std::abs(twist.omega) <= options_.limits.max_angular_speed;
  if (!is_possible) return {};  // for NaN, too
  const Start from = start(odometry);
  MotionProof proof = check_under_way(odometry, from.length, observed);
  if (!proof.proved || twist.v == 0) return proof;
  const double clearance = clearance_at(from.pose.position, options_.latency, observed);
  detail::BrakingMotion motion{from.pose,       twist,           hold, braking_periods(twist),
                               options_.period, options_.latency};
  motion.distance = distance_to_keep(from, clearance, motion);
  proof = motion.keeps_off_map(*space_);
  if (proof.proved) proof = check_observed(motion, observed);
  if (!proof.proved || hold == 1) return proof;
  // A robot that brakes at the next chance stops on the same arc, but where obstacles that move may
  // come to while they would have missed it farther on.
  motion.hold = 1;
  motion.distance = distance_to_keep(from, clearance, motion);
  for (std::uint32_t i = 0; proof.proved && i < observed.size(); ++i) {
    if (!observed[i].stands()) proof = motion.keeps_off(observed[i], i);
  }
  return proof;
}

template <ClearanceSpace S>
DriveCommand MotionGate<S>::command(const Pose& odometry, const Twist& wanted,
                                    std::span<const MovingObstacle> observed) {
  if (!accepts(odometry, observed) || !std::isfinite(wanted.v) || !std::isfinite(wanted.omega)) {
    return brake(odometry, observed, false);
  }
  Blocker blocker;
  Twist before{std::numeric_limits<double>::quiet_NaN(), 0};
  for (const double share : {1.0, 0.75, 0.5, 0.25, 0.1}) {
    const Twist twist = reachable({share * wanted.v, share * wanted.omega});
    if (twist.v == before.v && twist.omega == before.omega) continue;
    before = twist;
    const MotionProof proof = check(odometry, twist, options_.hold, observed);
    if (proof.proved) {
      braking_periods_ = braking_periods(twist);
      return issue(twist, share == 1 ? DriveStatus::driving : DriveStatus::slowed, blocker);
    }
    if (share == 1) blocker = proof.blocker;
  }
  DriveCommand braking = brake(odometry, observed);
  if (braking.status != DriveStatus::emergency) braking.blocker = blocker;
  return braking;
}

template <ClearanceSpace S>
DriveCommand MotionGate<S>::brake(const Pose& odometry, std::span<const MovingObstacle> observed,
                                  bool input_is_valid) {
  const Twist twist = detail::braked(last(), 1, std::max(1, braking_periods_));
  MotionProof proof{.proved = true};
  if (input_is_valid) {
    const Start from = start(odometry);
    proof = check_under_way(odometry, from.length, observed);
    if (proof.proved && twist.v != 0) {
      detail::BrakingMotion braking{
          from.pose,       twist,           1, std::max(1, braking_periods_ - 1),
          options_.period, options_.latency};
      // Odometry that jumps within its bounds is no emergency.
      const double error = error_within(from.length + braking.length());
      braking.distance = std::max(0.0, space_->safety_radius() - error);
      proof = check_except_bounds(braking, observed);
    }
  }
  const DriveStatus status = !input_is_valid    ? DriveStatus::invalid_input
                             : !proof.proved    ? DriveStatus::emergency
                             : last().is_zero() ? DriveStatus::blocked
                                                : DriveStatus::stopping;
  braking_periods_ = std::max(0, braking_periods_ - 1);
  return issue(twist, status, proof.blocker);
}

}  // namespace tutavia
