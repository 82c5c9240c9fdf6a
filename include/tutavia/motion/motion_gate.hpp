// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/assert.hpp"
#include "tutavia/motion/control_options.hpp"
#include "tutavia/motion/drive/obstacle_distance.hpp"
#include "tutavia/motion/drive_command.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// MotionGate: lets only commands through from which a robot can stop in time.

namespace tutavia {

/// The verdict on one motion of a robot.
struct MotionProof {
  bool proved = false;
  Blocker blocker{};  ///< if not proved
};

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
///   - no obstacle appears nearer than the robot needs to stop (`emergency` reports it).
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
  const Twist& last() const { return issued_.back(); }
  /// The robot stands, and no command that moves it is under way.
  bool stands() const {
    return std::all_of(issued_.begin(), issued_.end(), [](const Twist& t) { return t.is_zero(); });
  }

  /// Whether odometry and obstacles are finite numbers of a size that distances can be computed of.
  static bool accepts(const Pose& odometry, std::span<const MovingObstacle> observed) {
    return odometry.is_finite() && detail::is_valid_point(odometry.position) &&
           std::all_of(observed.begin(), observed.end(), detail::is_valid_obstacle);
  }

  /// The pose at which a command issued now takes effect.
  Pose start_of_command(const Pose& odometry) const { return committed(odometry).end; }

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

  /// Forgets the commands: the robot stands.
  void reset() {
    std::fill(issued_.begin(), issued_.end(), Twist{});
    braking_periods_ = 0;
  }

 private:
  /// The motion that commands under way have in store.
  struct Committed {
    Pose end;
    double length;  // of the path to it [m]
  };
  /// A motion that keeps a twist and brakes.
  struct Motion {
    Pose from;
    Twist twist;
    int hold;
    int periods;      // of braking
    double begin;     // from now [s]
    double reach;     // length of the path from the odometry's pose to standstill [m]
    double distance;  // to keep from obstacles [m]
  };

  MotionGate(const S& space, const ControlOptions& options)
      : space_(&space),
        options_(options),
        issued_(static_cast<std::size_t>(std::ceil(options.latency / options.period)) + 1) {}

  DriveCommand brake(const Pose& odometry, std::span<const MovingObstacle> observed,
                     bool input_is_valid);
  Committed committed(const Pose& odometry) const;
  int braking_periods(const Twist& twist) const;
  /// The twist in the k-th period of braking, k = 1 ... periods.
  static Twist braked(const Twist& twist, int k, int periods) {
    const double left = 1 - double(k) / periods;
    return k == periods ? Twist{} : Twist{left * twist.v, left * twist.omega};
  }
  MotionProof check(const Motion& motion, std::span<const MovingObstacle> observed) const;
  Motion motion(const Pose& odometry, const Twist& twist, int hold, int periods,
                std::span<const MovingObstacle> observed) const;
  MotionProof check_map(const Motion& motion, const Piece& path) const;
  MotionProof check_observed(const Motion& motion, const Piece& path,
                             const MovingObstacle& obstacle) const;
  /// Whether the robot keeps the distance from an obstacle that moves, for `time` seconds from
  /// `begin` on: by halving the time until the obstacle's own motion no longer matters.
  MotionProof check_moving(const Motion& motion, const Pose& from, const Twist& twist, double begin,
                           double time, const MovingObstacle& obstacle) const;
  double clearance_at(const Point& p, double time, std::span<const MovingObstacle> observed) const;
  /// When a motion has covered a part of its path [s].
  static double time_at(const Motion& motion, double fraction, double period);
  double whole_time(const Motion& m) const {  // at full speed, for the same path
    return options_.period * (m.hold + 0.5 * std::max(0, m.periods - 1));
  }

  DriveCommand issue(const Twist& twist, DriveStatus status, const Blocker& blocker) {
    std::rotate(issued_.begin(), issued_.begin() + 1, issued_.end());
    issued_.back() = twist;
    return {twist, status, blocker};
  }

  const S* space_;
  ControlOptions options_;
  std::vector<Twist> issued_;  // the last ones, the newest at the end
  int braking_periods_ = 0;    // in which the robot stops from the last command
};

template <ClearanceSpace S>
typename MotionGate<S>::Committed MotionGate<S>::committed(const Pose& odometry) const {
  Committed result{odometry, 0};
  for (std::size_t i = 0; i < issued_.size(); ++i) {
    const auto age = static_cast<double>(issued_.size() - i);  // in periods
    const double begin = std::max(0.0, options_.latency - age * options_.period);
    const double end = std::max(0.0, options_.latency - (age - 1) * options_.period);
    if (!(end > begin)) continue;
    result.end = moved(result.end, issued_[i], end - begin);
    result.length += std::abs(issued_[i].v) * (end - begin);
  }
  return result;
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
typename MotionGate<S>::Motion MotionGate<S>::motion(
    const Pose& odometry, const Twist& twist, int hold, int periods,
    std::span<const MovingObstacle> observed) const {
  const Committed before = committed(odometry);
  Motion result{before.end, twist, hold, periods, options_.latency, 0, 0};
  result.reach = before.length + std::abs(twist.v) * whole_time(result);
  const double error = options_.position_error + options_.heading_error * result.reach;
  const double radius = space_->safety_radius();
  const bool is_slow = std::abs(twist.v) <= 0.26 * options_.limits.max_speed;
  const double most = radius * (1 + 1e-3) + (is_slow ? 1 : 3) * error;
  result.distance = std::clamp(clearance_at(before.end.position, options_.latency, observed),
                               radius + error, most);
  return result;
}

template <ClearanceSpace S>
MotionProof MotionGate<S>::check(const Pose& odometry, const Twist& twist, int hold,
                                 std::span<const MovingObstacle> observed) const {
  if (!accepts(odometry, observed)) return {};
  if (twist.v == 0) return {.proved = true};
  const int periods = braking_periods(twist);
  const MotionProof proof = check(motion(odometry, twist, hold, periods, observed), observed);
  if (!proof.proved || hold == 1) return proof;
  // A robot that brakes at the next chance stops on the same arc, but where obstacles that move may
  // come to while they would have missed it farther on.
  const Motion soon = motion(odometry, twist, 1, periods, observed);
  const Piece path = path_of(soon.from, soon.twist, whole_time(soon));
  for (std::uint32_t i = 0; i < observed.size(); ++i) {
    if (observed[i].stands()) continue;
    MotionProof early = check_observed(soon, path, observed[i]);
    early.blocker.obstacle = i;
    if (!early.proved) return early;
  }
  return proof;
}

template <ClearanceSpace S>
MotionProof MotionGate<S>::check(const Motion& motion,
                                 std::span<const MovingObstacle> observed) const {
  const Piece path = path_of(motion.from, motion.twist, whole_time(motion));
  MotionProof proof = check_map(motion, path);
  for (std::uint32_t i = 0; proof.proved && i < observed.size(); ++i) {
    proof = check_observed(motion, path, observed[i]);
    if (!proof.proved) proof.blocker.obstacle = i;
  }
  return proof;
}

template <ClearanceSpace S>
double MotionGate<S>::time_at(const Motion& motion, double fraction, double period) {
  const double time = fraction * period * (motion.hold + 0.5 * std::max(0, motion.periods - 1));
  double left = time - motion.hold * period, elapsed = std::min(time, motion.hold * period);
  for (int k = 1; k < motion.periods && left > 0; ++k) {
    const double share = 1 - double(k) / motion.periods;
    elapsed += std::min(period, left / share);
    left -= share * period;
  }
  return motion.begin + elapsed;
}

template <ClearanceSpace S>
MotionProof MotionGate<S>::check_map(const Motion& motion, const Piece& path) const {
  return detail::on_drive_path(path, [&](const auto& piece) -> MotionProof {
    const PieceProof proof = prove_distance(*space_, piece, motion.distance);
    if (proof.status == ProofStatus::proved) return {.proved = true};
    const Point point = piece.point(proof.parameter);
    const NearestObstacle nearest =
        space_->nearest(Segment{point, point}, motion.distance * (1 + 1e-9));
    return {false,
            {Blocker::Kind::map, nearest.obstacle,
             time_at(motion, proof.parameter, options_.period), point}};
  });
}

template <ClearanceSpace S>
MotionProof MotionGate<S>::check_observed(const Motion& motion, const Piece& path,
                                          const MovingObstacle& obstacle) const {
  const Box box = detail::box_of(obstacle.shape);
  const double time = motion.begin + options_.period * (motion.hold + motion.periods);
  const double magnitude = box.largest_coordinate();
  return detail::on_drive_path(path, [&](const auto& piece) -> MotionProof {
    const Box swept = piece.box();
    const double reach = motion.distance + obstacle.velocity.norm() * time +
                         1e-6 * (magnitude + swept.largest_coordinate());
    if (!(swept.min.x() - reach <= box.max.x() && swept.min.y() - reach <= box.max.y() &&
          box.min.x() <= swept.max.x() + reach && box.min.y() <= swept.max.y() + reach)) {
      return {.proved = true};
    }
    if (obstacle.stands()) {
      const detail::ClosestApproach found = detail::distance_below(
          piece, obstacle.shape, std::max(magnitude, swept.largest_coordinate()));
      if (found.distance >= motion.distance) return {.proved = true};
      return {false,
              {Blocker::Kind::observed, 0, time_at(motion, found.parameter, options_.period),
               piece.point(found.parameter)}};
    }
    Pose pose = motion.from;
    double begin = motion.begin, length = motion.hold * options_.period;
    for (int k = 0; k == 0 || k < motion.periods; ++k) {
      const Twist twist = k == 0 ? motion.twist : braked(motion.twist, k, motion.periods);
      const MotionProof proof = check_moving(motion, pose, twist, begin, length, obstacle);
      if (!proof.proved) return proof;
      pose = moved(pose, twist, length);
      begin += length;
      length = options_.period;
    }
    return {.proved = true};
  });
}

template <ClearanceSpace S>
MotionProof MotionGate<S>::check_moving(const Motion& motion, const Pose& from, const Twist& twist,
                                        double begin, double time,
                                        const MovingObstacle& obstacle) const {
  // In the frame of the obstacle at the middle of the interval.
  const double middle = begin + 0.5 * time, drift = 0.5 * time * obstacle.velocity.norm();
  Pose shifted = from;
  shifted.position = detail::offset_along(from.position, -middle, obstacle.velocity);
  const double magnitude = detail::box_of(obstacle.shape).largest_coordinate() +
                           detail::max_magnitude(from.position) + std::abs(twist.v) * time;
  const detail::ClosestApproach found = detail::on_drive_path(
      path_of(shifted, twist, time),
      [&](const auto& piece) { return detail::distance_below(piece, obstacle.shape, magnitude); });
  if (found.distance - drift >= motion.distance) return {.proved = true};
  constexpr double finest = 1.0 / 256;  // of a period
  if (found.distance + drift < motion.distance || time < finest * options_.period) {
    const double at = found.parameter * time;
    return {false, {Blocker::Kind::observed, 0, begin + at, moved(from, twist, at).position}};
  }
  const double half = 0.5 * time;
  const MotionProof first = check_moving(motion, from, twist, begin, half, obstacle);
  if (!first.proved) return first;
  return check_moving(motion, moved(from, twist, half), twist, begin + half, half, obstacle);
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
    if (twist.v == before.v && twist.omega == before.omega) break;
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
  const Twist twist = braking_periods_ > 1 ? braked(last(), 1, braking_periods_) : Twist{};
  MotionProof proof{.proved = true};
  if (input_is_valid && twist.v != 0) {
    Motion braking = motion(odometry, twist, 1, std::max(1, braking_periods_ - 1), observed);
    // Odometry that jumps within its bounds is no emergency.
    const double error = options_.position_error + options_.heading_error * braking.reach;
    braking.distance = std::max(0.0, space_->safety_radius() - error);
    proof = check(braking, observed);
    const bool out_of_bounds =
        proof.blocker.kind == Blocker::Kind::map && proof.blocker.obstacle == NearestObstacle::none;
    proof.proved = proof.proved || out_of_bounds;
  }
  const DriveStatus status = !input_is_valid    ? DriveStatus::invalid_input
                             : last().is_zero() ? DriveStatus::blocked
                             : proof.proved     ? DriveStatus::stopping
                                                : DriveStatus::emergency;
  braking_periods_ = std::max(0, braking_periods_ - 1);
  return issue(twist, status, proof.blocker);
}

}  // namespace tutavia
