// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "tutavia/motion/band/shift_band.hpp"
#include "tutavia/motion/drive/candidates.hpp"
#include "tutavia/motion/drive_command.hpp"
#include "tutavia/motion/local_planner_options.hpp"
#include "tutavia/motion/motion_gate.hpp"
#include "tutavia/motion/timed_elastic_band.hpp"

/// \file
/// LocalPlanner: follows a path by elastic bands among obstacles that appear and move.

namespace tutavia {

/// What one step did, for logs and benchmarks.
struct LocalPlannerReport {
  std::size_t candidates = 0;  ///< paths around what is in the way
  std::size_t chosen = 0;
  BandReport band{};                                ///< of the candidate that was chosen
  bool searched = false;                            ///< whether detours were searched
  std::optional<Failure> failure{};                 ///< why there is no path, if there is none
  double detours_us = 0, band_us = 0, gate_us = 0;  ///< wall-clock times
};

/// Follows a path with a disc robot of differential drive, and drives around obstacles that appear
/// or move.
///
/// Each step lays a TimedElasticBand along the path ahead, optimises it, and passes the command of
/// its first interval through a MotionGate, so that what MotionGate guarantees holds for every
/// command. If the path is blocked, the tangent graph of a window around the robot gives the
/// shortest detour, and the one that passes the obstacle on its other side: each has a band of its
/// own. The robot changes to another path if that is shorter by `switch_gain`, or at once if it is
/// stopped on its own and not on the other. If no path is left, it stands (`blocked`) and searches
/// on: `report().failure` has the reason.
///
/// Steps that search no detour allocate only to grow: where more obstacles are near than before.
///
/// Example: examples/local_planning.cpp.
template <FeatureSpace S>
class LocalPlanner {
 public:
  /// A planner on the map `space`, which must outlive it. Errors: those of `validate` for the
  /// options of control and of the band; `invalid_option`.
  static Expected<LocalPlanner, Failure> build(const S& space, LocalPlannerOptions options = {});

  /// Follows a path from now on. The path should keep `margin` beyond the space's safety radius
  /// where it can. Errors: `invalid_input` for a path that is empty, not finite,
  /// or longer than 10^6 m; the robot then keeps its path.
  Expected<void, Failure> follow(Curve path);

  /// The command for the next period. Call it once in each. `observed` are all obstacles that the
  /// map does not have, where they are now.
  DriveCommand step(const Pose& odometry, std::span<const MovingObstacle> observed);

  const LocalPlannerOptions& options() const { return options_; }
  /// See tutavia::demanded_clearance.
  double demanded_clearance() const {
    return tutavia::demanded_clearance(gate_.space().safety_radius(), options_.control);
  }
  const LocalPlannerReport& report() const { return report_; }
  /// The path that is followed at present: the one given, or a detour and the rest of it.
  const Curve& path() const { return candidates_.current().path.curve(); }
  /// The band of that path.
  const Band& band() const { return candidates_.current().band; }

 private:
  using Clock = std::chrono::steady_clock;

  LocalPlanner(MotionGate<S> gate, LocalPlannerOptions options)
      : gate_(std::move(gate)), options_(options) {}

  static double lap(Clock::time_point& last) {
    const auto now = Clock::now();
    const std::chrono::duration<double, std::micro> elapsed = now - last;
    last = now;
    return elapsed.count();
  }

  void update_ways(const Pose& pose, std::span<const MovingObstacle> observed);
  /// The twist of the current path, or of another one that gets on where that does not; carefully
  /// if none does.
  Twist choose_twist(const Pose& pose, const Pose& odometry,
                     std::span<const MovingObstacle> observed);
  /// Whether there is no path, or the robot does not get on though it should.
  bool must_wait() const;
  /// Whether the robot has not got on for so long that it should stop trying.
  bool has_lost_patience() const;
  /// Brakes, and names what blocks the path.
  DriveCommand wait(const Pose& odometry, std::span<const MovingObstacle> observed);
  /// Brings the band of a candidate to the robot, and optimises it.
  void update_band(detail::Candidate& candidate, const Pose& pose,
                   std::span<const MovingObstacle> observed);
  /// By how much the robot has to turn to face along the path [rad].
  static double heading_error(const detail::Candidate& candidate, const Pose& pose);
  /// The twist along the band, or on the spot towards the path.
  Twist wanted(const detail::Candidate& candidate, const Pose& pose) const;
  /// Where the gate does not let the band's twist through: along the path itself, slowly, if that
  /// passes; or on the spot, to face along it; or, after some time, wherever the robot may drive.
  Twist carefully(const detail::Candidate& candidate, const Pose& pose, const Pose& odometry,
                  std::span<const MovingObstacle> observed, const Twist& refused) const;
  bool passes(const Pose& odometry, const Twist& twist,
              std::span<const MovingObstacle> observed) const {
    return gate_.check(odometry, gate_.reachable(twist), options_.control.hold, observed).proved;
  }

  MotionGate<S> gate_;
  LocalPlannerOptions options_;
  detail::Candidates candidates_;
  TimedElasticBand::Scratch scratch_;
  LocalPlannerReport report_;
  Blocker blocker_{};  // of the last command that was not waiting
  int standing_ = 0;   // periods without motion along a path
};

template <FeatureSpace S>
Expected<LocalPlanner<S>, Failure> LocalPlanner<S>::build(const S& space,
                                                          LocalPlannerOptions options) {
  auto gate = MotionGate<S>::build(space, options.control);
  if (!gate) return std::move(gate).unexpected();
  if (auto valid = validate(options); !valid) return std::move(valid).unexpected();
  options.band.limits = options.control.limits;
  LocalPlanner planner(std::move(*gate), options);
  TimedElasticBand& band = planner.options_.band;
  band.clearance = std::max(band.clearance, planner.demanded_clearance() + planner.options_.margin);
  if (auto valid = band.validate(); !valid) return std::move(valid).unexpected();
  return planner;
}

template <FeatureSpace S>
Expected<void, Failure> LocalPlanner<S>::follow(Curve path) {
  if (auto valid = detail::check_path(path); !valid) return valid;
  candidates_.reset(std::move(path), options_);
  report_ = {};
  blocker_ = {};
  standing_ = 0;
  return {};
}

template <FeatureSpace S>
DriveCommand LocalPlanner<S>::step(const Pose& odometry, std::span<const MovingObstacle> observed) {
  report_.searched = false;
  report_.detours_us = report_.band_us = report_.gate_us = 0;
  if (!gate_.accepts(odometry, observed) || candidates_.empty())
    return gate_.brake(odometry, observed);
  Clock::time_point last = Clock::now();
  const Pose pose = gate_.start_of_command(odometry);
  if (distance(pose.position, candidates_.path().end()) <= options_.goal_tolerance) {
    return gate_.arrive(odometry, observed);
  }
  update_ways(pose, observed);
  report_.detours_us = lap(last);
  if (must_wait()) return wait(odometry, observed);
  const Twist twist = choose_twist(pose, odometry, observed);
  report_.band_us = lap(last);
  DriveCommand command = gate_.command(odometry, twist, observed);
  report_.gate_us = lap(last);
  if (command.twist.is_zero() && command.status == DriveStatus::driving) {
    command.status = DriveStatus::blocked;
  }
  blocker_ = command.blocker;
  const bool gets_on = std::abs(command.twist.v) > 0.01 * options_.control.limits.max_speed;
  standing_ = gets_on ? 0 : standing_ + 1;
  if (gets_on) {
    candidates_.forget_failure();
    report_.failure.reset();
  }
  return command;
}

template <FeatureSpace S>
void LocalPlanner<S>::update_ways(const Pose& pose, std::span<const MovingObstacle> observed) {
  const bool changed = candidates_.have_changed(pose.position, observed, options_);
  if (changed && has_lost_patience()) standing_ = 0;
  const bool stands_for_long = standing_ > 0 && standing_ % 10 == 0;
  report_.searched = candidates_.update(gate_.space(), pose.position, observed, options_,
                                        (changed && candidates_.size() > 1) || stands_for_long);
  if (report_.searched) report_.failure = candidates_.failure();
  report_.candidates = candidates_.size();
  report_.chosen = candidates_.chosen();
}

template <FeatureSpace S>
Twist LocalPlanner<S>::choose_twist(const Pose& pose, const Pose& odometry,
                                    std::span<const MovingObstacle> observed) {
  update_band(candidates_.current(), pose, observed);
  const Twist twist = wanted(candidates_.current(), pose);
  const bool is_blocked = candidates_.current().is_blocked();
  if (!is_blocked && passes(odometry, twist, observed)) return twist;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (i == candidates_.chosen()) continue;
    update_band(candidates_[i], pose, observed);
    const Twist other = wanted(candidates_[i], pose);
    // Turning on the spot always passes, and is no reason to leave a path that is free.
    if ((other.v == 0 && !is_blocked) || !passes(odometry, other, observed)) continue;
    candidates_.choose(i);
    report_.chosen = i;
    return other;
  }
  return carefully(candidates_.current(), pose, odometry, observed, twist);
}

template <FeatureSpace S>
DriveCommand LocalPlanner<S>::wait(const Pose& odometry, std::span<const MovingObstacle> observed) {
  ++standing_;
  if (!report_.failure && has_lost_patience()) {
    report_.failure = Failure{.code = PlanError::not_proved,
                              .detail = "no motion along the path is proved from where it stands"};
  }
  DriveCommand command = gate_.brake(odometry, observed);
  if (command.blocker.kind != Blocker::Kind::none) return command;
  const detail::Candidate& candidate = candidates_.current();
  if (!candidate.block) {
    command.blocker = blocker_;
    if (blocker_.kind == Blocker::Kind::none) {
      const Twist slow{0.1 * options_.control.limits.max_speed, 0};
      command.blocker = gate_.check(odometry, slow, options_.control.hold, observed).blocker;
    }
    return command;
  }
  const double ahead = candidate.block->s - candidate.path.progress();
  command.blocker = {Blocker::Kind::observed, static_cast<std::uint32_t>(candidate.block->obstacle),
                     ahead / options_.control.limits.max_speed,
                     candidate.path.near(candidate.block->s).position};
  return command;
}

template <FeatureSpace S>
bool LocalPlanner<S>::must_wait() const {
  return (candidates_.failure() && candidates_.current().is_blocked()) || has_lost_patience();
}

template <FeatureSpace S>
bool LocalPlanner<S>::has_lost_patience() const {
  // Long enough to turn around twice.
  const DriveLimits& limits = options_.control.limits;
  const double patience = 5 + 4 * std::numbers::pi / limits.max_angular_speed;
  return standing_ * options_.control.period > patience;
}

template <FeatureSpace S>
double LocalPlanner<S>::heading_error(const detail::Candidate& candidate, const Pose& pose) {
  const double ahead = candidate.path.near(candidate.path.progress() + 0.2).heading;
  return std::remainder(ahead - pose.heading, 2 * std::numbers::pi);
}

template <FeatureSpace S>
void LocalPlanner<S>::update_band(detail::Candidate& candidate, const Pose& pose,
                                  std::span<const MovingObstacle> observed) {
  const double error = std::abs(heading_error(candidate, pose));
  candidate.turns_first = candidate.turns_first && error > 0.2 * options_.turn_first;
  if (candidate.turns_first) return;
  const double begin = candidate.path.progress(), end = begin + options_.horizon;
  const bool to_end = end >= candidate.path.length();
  // A robot that does not move though nothing blocks it begins anew.
  const bool is_old =
      standing_ % 10 != 9 && detail::shift_band(options_.band, pose, candidate.path.curve().at(end),
                                                to_end, candidate.band);
  if (!is_old && error > options_.turn_first) {
    candidate.turns_first = true;
    return candidate.band.clear();
  }
  if (!is_old) {
    options_.band.lay(candidate.path.curve(), begin, std::min(end, candidate.path.length()), pose,
                      candidate.band);
  }
  BandTask task{.start = gate_.last(), .free_end_heading = to_end};
  if (to_end) task.end = Twist{};
  auto report = options_.band.optimize(gate_.space(), observed, task, candidate.band, scratch_);
  if (!report) return candidate.band.clear();
  report_.band = *report;
}

template <FeatureSpace S>
Twist LocalPlanner<S>::carefully(const detail::Candidate& candidate, const Pose& pose,
                                 const Pose& odometry, std::span<const MovingObstacle> observed,
                                 const Twist& refused) const {
  const double full = 2 * std::numbers::pi, slow = 0.25 * options_.control.limits.max_speed;
  if (std::abs(gate_.last().v) > 2 * slow) return refused;
  const Point ahead = candidate.path.near(candidate.path.progress() + 0.15).position;
  const Point to{ahead.x() - pose.position.x(), ahead.y() - pose.position.y()};
  const double along = heading(to), error = std::remainder(along - pose.heading, full);
  if (std::abs(error) < 0.3 && passes(odometry, {slow, error}, observed)) return {slow, error};
  const bool is_stuck = standing_ * options_.control.period > 5 && gate_.last().v == 0;
  if (!is_stuck) return std::abs(error) > 0.05 ? Twist{0, 2 * error} : refused;
  // Out of a niche, in whatever direction is proved and nearest to the path.
  constexpr int directions = 16;
  for (int k = 0; k < directions; ++k) {
    const int step = k % 2 == 0 ? k / 2 : -(k + 1) / 2;
    const double off = full / directions * step;
    const double turn = std::remainder(along + off - pose.heading, full);
    if (!passes({odometry.position, odometry.heading + turn}, {slow, 0}, observed)) continue;
    if (std::abs(turn) < 0.1 && passes(odometry, {slow, 0}, observed)) return {slow, 0};
    return {0, 2 * turn};
  }
  return refused;
}

template <FeatureSpace S>
Twist LocalPlanner<S>::wanted(const detail::Candidate& candidate, const Pose& pose) const {
  if (candidate.turns_first || candidate.band.empty())
    return {0, 2 * heading_error(candidate, pose)};
  return first_twist(candidate.band);
}

}  // namespace tutavia
