// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/motion/control_options.hpp"
#include "tutavia/motion/drive/detours.hpp"
#include "tutavia/motion/drive/tracked_path.hpp"
#include "tutavia/motion/drive_command.hpp"
#include "tutavia/motion/motion_gate.hpp"
#include "tutavia/motion/timed_elastic_band.hpp"

/// \file
/// LocalPlanner: follows a path by elastic bands among obstacles that appear and move.

namespace tutavia {

/// Options of a LocalPlanner.
struct LocalPlannerOptions {
  ControlOptions control{};
  /// Its limits are those of `control`. A clearance below what the gate demands is raised to that
  /// plus `margin`.
  TimedElasticBand band{.clearance = 0};
  double horizon = 3;           ///< length of a band [m]
  double margin = 0.1;          ///< room that detours leave beyond what the gate demands [m]
  double window = 6;            ///< half the side of the square in which detours are searched [m]
  double goal_tolerance = 0.1;  ///< distance from the end of the path at which to stop [m]
  double switch_gain = 0.5;     ///< how much shorter another way must be to change to it [m]
  double turn_first = 0.9;      ///< heading error beyond which the robot turns on the spot [rad]
  int search_interval = 5;      ///< least number of periods between two searches for detours
};

/// What one step did, for logs and benchmarks.
struct LocalPlannerReport {
  std::size_t candidates = 0;  ///< ways around what is in the way
  std::size_t chosen = 0;
  BandReport band{};                                ///< of the candidate that was chosen
  bool searched = false;                            ///< whether detours were searched
  std::optional<Failure> failure{};                 ///< why there is no way, if there is none
  double detours_us = 0, band_us = 0, gate_us = 0;  ///< wall-clock times
};

/// Follows a path with a disc robot of differential drive, and drives around obstacles that appear
/// or move.
///
/// Each step lays a TimedElasticBand along the way ahead, optimises it, and passes the command of
/// its first interval through a MotionGate, so that what MotionGate guarantees holds for every
/// command. If the way is blocked, the tangent graph of a window around the robot gives the
/// shortest detour, and the one that passes the obstacle on its other side: each has a band of its
/// own. The robot changes to another way if that is shorter by `switch_gain`, or at once if it is
/// stopped on its own and not on the other. If no way is left, it stands (`blocked`) and searches
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
  /// where it can. Errors: `invalid_input` for an empty path.
  Expected<void, Failure> follow(Curve path);

  /// The command for the next period. Call it once in each. `observed` are all obstacles that the
  /// map does not have, where they are now.
  DriveCommand step(const Pose& odometry, std::span<const MovingObstacle> observed);

  const LocalPlannerOptions& options() const { return options_; }
  /// The distance from obstacles that the gate demands at full speed [m]: what a path has to keep
  /// for the robot to follow it.
  double demanded_clearance() const;
  const LocalPlannerReport& report() const { return report_; }
  /// The way that is followed at present: the path, or a detour and the rest of it.
  const Curve& way() const { return candidates_[report_.chosen].way.curve(); }
  /// The band of that way.
  const Band& band() const { return candidates_[report_.chosen].band; }

 private:
  using Clock = std::chrono::steady_clock;

  /// A way to the end, and the band along its next part.
  struct Candidate {
    detail::TrackedPath way{};
    Band band{};
    std::optional<detail::TrackedPath::Block> block{};  // the first one ahead
    double astray = 0;                                  // the robot's distance from the way [m]
    bool turns_first = false;                           // on the spot, before its band is optimised

    bool is_blocked() const { return block.has_value(); }
    /// The robot is too far off to get back; near the end there is little way left for it.
    bool is_lost() const { return astray > std::min(1.0, 0.2 + way.remaining()); }
  };

  LocalPlanner(MotionGate<S> gate, LocalPlannerOptions options)
      : gate_(std::move(gate)), options_(std::move(options)) {}

  static double lap(Clock::time_point& last) {
    const auto now = Clock::now();
    const std::chrono::duration<double, std::micro> elapsed = now - last;
    last = now;
    return elapsed.count();
  }

  void update_ways(const Pose& pose, std::span<const MovingObstacle> observed);
  bool obstacles_changed(std::span<const MovingObstacle> observed);
  void search_ways(const Pose& pose, std::span<const MovingObstacle> observed);
  void choose();
  /// Whether there is no way on, or the robot does not get on though it should.
  bool must_wait() const;
  /// Brakes at the end of the path.
  DriveCommand arrive(const Pose& odometry, std::span<const MovingObstacle> observed);
  /// Brakes, and names what blocks the way.
  DriveCommand wait(const Pose& odometry, std::span<const MovingObstacle> observed);
  /// Brings the band of a candidate to the robot, and optimises it.
  void update_band(Candidate& candidate, const Pose& pose,
                   std::span<const MovingObstacle> observed);
  /// True if the band was laid anew.
  bool lay_or_shift(Candidate& candidate, const Pose& pose) const;
  /// By how much the robot has to turn to face along the way [rad].
  static double heading_error(const Candidate& candidate, const Pose& pose);
  /// The twist along the band, or on the spot towards the way.
  Twist wanted(const Candidate& candidate, const Pose& pose) const;
  /// Where the gate does not let the band's twist through: along the way itself, slowly, if that
  /// passes; or on the spot, to face along it; or, after some time, wherever the robot may drive.
  Twist carefully(const Candidate& candidate, const Pose& pose, const Pose& odometry,
                  std::span<const MovingObstacle> observed, const Twist& refused) const;
  bool passes(const Pose& odometry, const Twist& twist,
              std::span<const MovingObstacle> observed) const {
    return gate_.check(odometry, gate_.reachable(twist), options_.control.hold, observed).proved;
  }

  MotionGate<S> gate_;
  LocalPlannerOptions options_;
  detail::TrackedPath path_;  // as given
  std::vector<Candidate> candidates_{1};
  TimedElasticBand::Scratch scratch_;
  std::vector<MovingObstacle> seen_;
  LocalPlannerReport report_;
  Blocker blocker_{};  // of the last command that was not waiting
  int since_search_ = 0;
  int standing_ = 0;  // periods without motion along a way
};

template <FeatureSpace S>
Expected<LocalPlanner<S>, Failure> LocalPlanner<S>::build(const S& space,
                                                          LocalPlannerOptions options) {
  auto gate = MotionGate<S>::build(space, options.control);
  if (!gate) return std::move(gate).unexpected();
  const auto invalid = [](const char* rule) { return fail(PlanError::invalid_option, rule); };
  if (!(options.horizon > 0 && std::isfinite(options.horizon)))
    return invalid("horizon must be positive and finite");
  if (!(options.margin >= 0 && std::isfinite(options.margin)))
    return invalid("margin must be finite and not negative");
  if (!(options.window > 0 && std::isfinite(options.window)))
    return invalid("window must be positive and finite");
  if (!(options.goal_tolerance > 0)) return invalid("goal_tolerance must be positive");
  if (!(options.switch_gain >= 0)) return invalid("switch_gain must not be negative");
  if (!(options.turn_first > 0)) return invalid("turn_first must be positive");
  if (options.search_interval < 1) return invalid("search_interval must be at least 1");
  options.band.limits = options.control.limits;
  LocalPlanner planner(std::move(*gate), std::move(options));
  TimedElasticBand& band = planner.options_.band;
  band.clearance = std::max(band.clearance, planner.demanded_clearance() + planner.options_.margin);
  if (auto valid = band.validate(); !valid) return std::move(valid).unexpected();
  return planner;
}

template <FeatureSpace S>
double LocalPlanner<S>::demanded_clearance() const {
  const ControlOptions& control = options_.control;
  const DriveLimits& limits = control.limits;
  const double braking = std::max(limits.max_speed / limits.max_acceleration,
                                  limits.max_angular_speed / limits.max_angular_acceleration);
  const double reach =
      limits.max_speed * (control.latency + control.period * control.hold + 0.5 * braking);
  const double error = control.position_error + control.heading_error * reach;
  return gate_.space().safety_radius() * (1 + 1e-3) + 3 * error;
}

template <FeatureSpace S>
Expected<void, Failure> LocalPlanner<S>::follow(Curve path) {
  if (path.empty()) return fail(PlanError::invalid_input, "the path is empty");
  path_ = detail::TrackedPath(std::move(path));
  candidates_.assign(1, Candidate{.way = path_});
  report_ = {};
  blocker_ = {};
  seen_.clear();
  since_search_ = options_.search_interval;
  standing_ = 0;
  return {};
}

template <FeatureSpace S>
DriveCommand LocalPlanner<S>::step(const Pose& odometry, std::span<const MovingObstacle> observed) {
  report_.searched = false;
  report_.detours_us = report_.band_us = report_.gate_us = 0;
  if (!gate_.accepts(odometry, observed) || path_.empty()) return gate_.brake(odometry, observed);
  Clock::time_point last = Clock::now();
  const Pose pose = gate_.start_of_command(odometry);
  if (distance(pose.position, path_.curve().end()) <= options_.goal_tolerance) {
    return arrive(odometry, observed);
  }
  update_ways(pose, observed);
  report_.detours_us = lap(last);
  if (must_wait()) return wait(odometry, observed);
  update_band(candidates_[report_.chosen], pose, observed);
  Twist twist = wanted(candidates_[report_.chosen], pose);
  report_.band_us = lap(last);
  bool passed = !candidates_[report_.chosen].is_blocked() && passes(odometry, twist, observed);
  for (std::size_t i = 0; !passed && i < candidates_.size(); ++i) {
    if (i == report_.chosen) continue;
    // Another way is not waited for if it is free.
    const std::size_t before = std::exchange(report_.chosen, i);
    update_band(candidates_[i], pose, observed);
    const Twist other = wanted(candidates_[i], pose);
    // Turning on the spot always passes, and is no reason to leave a way that is free.
    const bool gets_on = other.v != 0 || candidates_[before].is_blocked();
    passed = gets_on && passes(odometry, other, observed);
    if (passed) {
      twist = other;
    } else {
      report_.chosen = before;
    }
  }
  if (!passed) twist = carefully(candidates_[report_.chosen], pose, odometry, observed, twist);
  report_.band_us += lap(last);
  DriveCommand command = gate_.command(odometry, twist, observed);
  report_.gate_us = lap(last);
  const bool moves = !command.twist.is_zero();
  standing_ =
      std::abs(command.twist.v) > 0.01 * options_.control.limits.max_speed ? 0 : standing_ + 1;
  if (!moves && command.status == DriveStatus::driving) command.status = DriveStatus::blocked;
  blocker_ = command.blocker;
  if (standing_ == 0) report_.failure.reset();
  return command;
}

template <FeatureSpace S>
DriveCommand LocalPlanner<S>::arrive(const Pose& odometry,
                                     std::span<const MovingObstacle> observed) {
  DriveCommand command = gate_.brake(odometry, observed);
  if (command.status == DriveStatus::stopping || command.status == DriveStatus::blocked) {
    command.status = gate_.stands() ? DriveStatus::arrived : DriveStatus::driving;
    command.blocker = {};
  }
  return command;
}

template <FeatureSpace S>
DriveCommand LocalPlanner<S>::wait(const Pose& odometry, std::span<const MovingObstacle> observed) {
  DriveCommand command = gate_.brake(odometry, observed);
  if (command.blocker.kind != Blocker::Kind::none) return command;
  const Candidate& chosen = candidates_[report_.chosen];
  if (!chosen.block) {
    command.blocker = blocker_;
    return command;
  }
  const double time = (chosen.block->s - chosen.way.progress()) / options_.control.limits.max_speed;
  command.blocker = {Blocker::Kind::observed, static_cast<std::uint32_t>(chosen.block->obstacle),
                     time, chosen.way.near(chosen.block->s).position};
  return command;
}

template <FeatureSpace S>
bool LocalPlanner<S>::obstacles_changed(std::span<const MovingObstacle> observed) {
  const double period = options_.control.period;
  bool changed = observed.size() != seen_.size();
  for (std::size_t i = 0; !changed && i < observed.size(); ++i) {
    const Point expected =
        detail::offset_along(detail::center_of(seen_[i].shape), period, seen_[i].velocity);
    changed = seen_[i].velocity != observed[i].velocity ||
              distance(expected, detail::center_of(observed[i].shape)) > 0.01;
  }
  seen_.assign(observed.begin(), observed.end());
  return changed;
}

template <FeatureSpace S>
void LocalPlanner<S>::update_ways(const Pose& pose, std::span<const MovingObstacle> observed) {
  path_.advance(pose.position);
  const double ahead = options_.horizon + 1;
  for (Candidate& candidate : candidates_) {
    candidate.astray = candidate.way.advance(pose.position);
    candidate.block = candidate.way.first_block(observed, demanded_clearance(),
                                                options_.control.limits.max_speed, ahead);
  }
  report_.candidates = candidates_.size();
  ++since_search_;
  const bool changed = obstacles_changed(observed);
  if (changed) standing_ = 0;
  const Candidate& chosen = candidates_[report_.chosen];
  const bool needed = chosen.is_blocked() || chosen.is_lost() ||
                      (changed && candidates_.size() > 1) || (standing_ > 0 && standing_ % 10 == 0);
  if (needed && since_search_ >= options_.search_interval) search_ways(pose, observed);
  choose();
}

template <FeatureSpace S>
void LocalPlanner<S>::search_ways(const Pose& pose, std::span<const MovingObstacle> observed) {
  since_search_ = 0;
  report_.searched = true;
  report_.failure.reset();
  const double speed = options_.control.limits.max_speed;
  const double ahead = options_.horizon + 1;
  const auto block = path_.first_block(observed, demanded_clearance(), speed, ahead);
  const double after = std::min(path_.length(), (block ? block->s : path_.progress()) + 0.5);
  double clearance = demanded_clearance() + options_.margin;
  double least = demanded_clearance() + 0.2 * options_.margin;
  double here = gate_.space().clearance(pose.position);
  for (const MovingObstacle& obstacle : observed) {
    const Segment point{pose.position, pose.position};
    here = std::min(here, detail::distance_to(point, obstacle.shape).distance);
  }
  // A robot that stands nearer may leave along paths as near.
  least = std::max(gate_.space().safety_radius() * (1 + 1e-4), std::min(least, here * (1 - 1e-3)));
  clearance = std::max(least, std::min(clearance, here * (1 - 1e-3)));
  detail::Detours<S> detours(gate_.space(), path_, observed);
  const detail::DetourQuery query{pose.position, clearance, least, options_.window, after};
  auto first = detours.shortest(query);
  if (!first) {
    report_.failure = std::move(first.error());
    return;
  }
  std::vector<Candidate> ways;
  if (!candidates_[report_.chosen].is_blocked() && !candidates_[report_.chosen].is_lost()) {
    ways.push_back(std::move(candidates_[report_.chosen]));
  }
  const std::optional<Curve> second =
      block ? detours.other_side(query, *first, block->obstacle) : std::nullopt;
  ways.push_back(Candidate{.way = detail::TrackedPath(std::move(*first))});
  if (second) ways.push_back(Candidate{.way = detail::TrackedPath(*second)});
  candidates_ = std::move(ways);
  report_.chosen = 0;
  report_.candidates = candidates_.size();
}

template <FeatureSpace S>
void LocalPlanner<S>::choose() {
  const auto cost = [&](std::size_t i) {
    const Candidate& candidate = candidates_[i];
    return candidate.astray + candidate.way.remaining() + (candidate.is_blocked() ? 1e6 : 0.0);
  };
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (cost(i) + options_.switch_gain < cost(report_.chosen)) report_.chosen = i;
  }
}

template <FeatureSpace S>
bool LocalPlanner<S>::must_wait() const {
  if (report_.failure && candidates_[report_.chosen].is_blocked()) return true;
  // Long enough to turn around twice.
  const DriveLimits& limits = options_.control.limits;
  const double patience = 5 + 4 * std::numbers::pi / limits.max_angular_speed;
  return standing_ * options_.control.period > patience;
}

template <FeatureSpace S>
bool LocalPlanner<S>::lay_or_shift(Candidate& candidate, const Pose& pose) const {
  const detail::TrackedPath& way = candidate.way;
  Band& band = candidate.band;
  const double end = std::min(way.length(), way.progress() + options_.horizon);
  std::size_t nearest = 0;
  const std::size_t few = std::min<std::size_t>(band.poses.size(), 10);
  for (std::size_t i = 1; i < few; ++i) {
    if (distance(pose.position, band.poses[i].position) <
        distance(pose.position, band.poses[nearest].position)) {
      nearest = i;
    }
  }
  const CurvePoint target = way.curve().at(end);
  // A robot that does not move though nothing blocks it begins anew.
  const bool keep = standing_ % 10 != 9 && band.poses.size() >= nearest + 4 &&
                    distance(pose.position, band.poses[nearest].position) < 0.3 &&
                    distance(target.position, band.poses.back().position) < 0.5;
  if (!keep) {
    options_.band.lay(way.curve(), way.progress(), end, pose, band);
    return true;
  }
  using Difference = std::ptrdiff_t;
  band.poses.erase(band.poses.begin(), band.poses.begin() + Difference(nearest));
  band.intervals.erase(band.intervals.begin(), band.intervals.begin() + Difference(nearest));
  band.intervals[0] = std::clamp(
      distance(pose.position, band.poses[1].position) / options_.control.limits.max_speed,
      0.1 * options_.band.reference_interval,
      options_.band.reference_interval + options_.band.hysteresis);
  const double full = 2 * std::numbers::pi;
  band.poses[0] = {pose.position, band.poses[1].heading +
                                      std::remainder(pose.heading - band.poses[1].heading, full)};
  Pose& back = band.poses.back();
  const double before = band.poses[band.poses.size() - 2].heading;
  if (end < way.length()) {
    back = {target.position, before + std::remainder(target.heading - before, full)};
  } else {
    back.position = target.position;
  }
  return false;
}

template <FeatureSpace S>
double LocalPlanner<S>::heading_error(const Candidate& candidate, const Pose& pose) {
  const double ahead = candidate.way.near(candidate.way.progress() + 0.2).heading;
  return std::remainder(ahead - pose.heading, 2 * std::numbers::pi);
}

template <FeatureSpace S>
void LocalPlanner<S>::update_band(Candidate& candidate, const Pose& pose,
                                  std::span<const MovingObstacle> observed) {
  const double error = std::abs(heading_error(candidate, pose));
  candidate.turns_first = candidate.turns_first && error > 0.2 * options_.turn_first;
  if (candidate.turns_first) return;
  const bool is_new = lay_or_shift(candidate, pose);
  candidate.turns_first = is_new && error > options_.turn_first;
  if (candidate.turns_first) return candidate.band.clear();
  const bool to_end = candidate.way.progress() + options_.horizon >= candidate.way.length();
  BandTask task{.start = gate_.last(), .free_end_heading = to_end};
  if (to_end) task.end = Twist{};
  auto report = options_.band.optimize(gate_.space(), observed, task, candidate.band, scratch_);
  if (!report) return candidate.band.clear();
  report_.band = *report;
}

template <FeatureSpace S>
Twist LocalPlanner<S>::carefully(const Candidate& candidate, const Pose& pose, const Pose& odometry,
                                 std::span<const MovingObstacle> observed,
                                 const Twist& refused) const {
  const double full = 2 * std::numbers::pi, slow = 0.25 * options_.control.limits.max_speed;
  if (std::abs(gate_.last().v) > 2 * slow) return refused;
  const detail::TrackedPath& way = candidate.way;
  const Point ahead = way.near(way.progress() + 0.15).position;
  const Point to{ahead.x() - pose.position.x(), ahead.y() - pose.position.y()};
  const double along = heading(to), error = std::remainder(along - pose.heading, full);
  if (std::abs(error) < 0.3 && passes(odometry, {slow, error}, observed)) return {slow, error};
  const bool is_stuck = standing_ * options_.control.period > 5 && gate_.last().v == 0;
  if (!is_stuck) return std::abs(error) > 0.05 ? Twist{0, 2 * error} : refused;
  // Out of a niche, in whatever direction is proved and nearest to the way.
  constexpr int directions = 16;
  for (int k = 0; k < directions; ++k) {
    const double off = full / directions * ((k + 1) / 2) * (k % 2 == 0 ? 1 : -1);
    const double turn = std::remainder(along + off - pose.heading, full);
    if (!passes({odometry.position, odometry.heading + turn}, {slow, 0}, observed)) continue;
    if (std::abs(turn) < 0.1 && passes(odometry, {slow, 0}, observed)) return {slow, 0};
    return {0, 2 * turn};
  }
  return refused;
}

template <FeatureSpace S>
Twist LocalPlanner<S>::wanted(const Candidate& candidate, const Pose& pose) const {
  if (candidate.turns_first || candidate.band.empty()) {
    return {0, 2 * heading_error(candidate, pose)};
  }
  return first_twist(candidate.band);
}

}  // namespace tutavia
