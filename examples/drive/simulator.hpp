// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "contact.hpp"
#include "drive_result.hpp"
#include "encounters.hpp"
#include "odometry_noise.hpp"
#include "tutavia/core/expected.hpp"
#include "tutavia/motion/control_options.hpp"
#include "tutavia/motion/differential_drive.hpp"
#include "tutavia/motion/drive_command.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// Simulator: a robot with differential drive, and a judge of what it does.

namespace drive_program {

using namespace tutavia;

/// What drives a robot: it is given a path, and asked for a command once in each period.
template <class C>
concept Controller = requires(C& controller, Curve path, const Pose& odometry,
                              std::span<const MovingObstacle> observed) {
  { controller.follow(std::move(path)) } -> std::same_as<Expected<void, Failure>>;
  { controller.step(odometry, observed) } -> std::same_as<DriveCommand>;
};

/// Options of a simulation.
struct SimulationOptions {
  ControlOptions control{};      ///< of the robot; the controller must be given the same
  double goal_tolerance = 0.15;  ///< from the goal, the odometry's error aside [m]
  double time_limit = 600;       ///< [s]
  double patience = 30;          ///< standing for longer than this ends the drive [s]
  double replan_after = 1;       ///< standing still for this long asks for a new path [s]
  double replan_interval = 2;    ///< between two requests for a path [s]
  std::uint64_t seed = 0;        ///< of the noise
  bool keeps_trace = false;
};

/// A new global path from where the robot is, around obstacles that are observed.
using Replan = std::function<Expected<Curve, Failure>(const Pose& odometry,
                                                      std::span<const MovingObstacle> observed)>;

/// Drives a robot along a path while obstacles appear, and judges every contact and every command
/// independently of the controller.
///
/// The robot follows twists exactly. The controller sees poses with bounded errors, and obstacles
/// where they are. The disc of the safety radius touches an obstacle where they overlap by more
/// than a nanometre, anywhere in continuous time. Leaving the map's bounds by more than the
/// odometry's error is a contact with the map. Obstacles appear and vanish between two periods.
template <FeatureSpace S, Controller C>
class Simulator {
 public:
  /// All three must outlive the simulator. Where the controller is `blocked`, `replan` is asked for
  /// another path, if there is one.
  Simulator(const S& map, C& controller, Encounters& encounters, const SimulationOptions& options,
            Replan replan = {})
      : map_(map),
        controller_(controller),
        encounters_(encounters),
        options_(options),
        replan_(std::move(replan)),
        noise_(options.control.position_error, options.control.heading_error, options.seed) {}

  /// Drives from a pose at standstill, until the robot arrives or gives up, or the time is over.
  DriveResult run(const Pose& start, Curve path, const Progress& progress = {}) {
    path_ = std::move(path);
    goal_ = path_.end();
    pose_ = start;
    if (const auto accepted = controller_.follow(path_); !accepted) {
      return stopped("the controller refuses the path: " + accepted.error().detail);
    }
    if (options_.keeps_trace) result_.paths.push_back({0, path_});
    while (!is_over()) {
      period();
      if (progress) progress(now(), result_.length);
    }
    result_.time = now();
    result_.end = pose_;
    return std::move(result_);
  }

  /// The time of the simulation [s].
  double now() const { return static_cast<double>(periods_) * options_.control.period; }

 private:
  /// A command, and when it takes effect [s].
  struct Pending {
    double begins;
    Twist twist;
  };

  static constexpr double rounding = 1e-9;     // [m] and [m/s]
  static constexpr double most_clearance = 1;  // to look for [m]

  bool is_over() {
    if (is_over_) return true;
    if (now() >= options_.time_limit) {
      result_.ending = Ending::timed_out;
      result_.reason = "not there after " + std::to_string(options_.time_limit) + " s";
      return true;
    }
    return false;
  }

  DriveResult stopped(std::string reason) {
    end(Ending::stopped, std::move(reason));
    return std::move(result_);
  }
  void end(Ending ending, std::string reason) {
    result_.ending = ending;
    result_.reason = std::move(reason);
    is_over_ = true;
  }

  void period() {
    encounters_.advance(now(), map_, pose_, path_);
    encounters_.observe(now(), observed_);
    in_contact_.resize(encounters_.all().size() + 1, Contact::none);
    const Pose odometry = noise_.disturbed(pose_);
    const DriveCommand command = controller_.step(odometry, observed_);
    check_limits(command.twist);
    if (command.status == DriveStatus::emergency) ++result_.emergencies;
    pending_.push_back({now() + options_.control.latency, command.twist});
    const TraceRow row{now(), pose_, twist_, 0, command.status};
    const double clearance = drive_until(now() + options_.control.period);
    if (options_.keeps_trace) {
      result_.trace.push_back(row);
      result_.trace.back().twist = twist_;
      result_.trace.back().clearance = clearance;
    }
    ++periods_;
    watch(command, odometry);
  }

  /// Counts a command that the robot's limits do not allow after the one before it.
  void check_limits(const Twist& twist) {
    const DriveLimits& limits = options_.control.limits;
    const double step = limits.max_acceleration * options_.control.period + rounding;
    const double turn = limits.max_angular_acceleration * options_.control.period + rounding;
    const bool is_allowed = twist.v <= limits.max_speed + rounding &&
                            twist.v >= -limits.max_backward_speed - rounding &&
                            std::abs(twist.omega) <= limits.max_angular_speed + rounding &&
                            std::abs(twist.v - commanded_.v) <= step &&
                            std::abs(twist.omega - commanded_.omega) <= turn;
    if (!is_allowed) ++result_.limit_violations;  // for NaN, too
    commanded_ = twist;
  }

  /// Moves the robot through a period, with the twists that take effect in it. Returns the least
  /// clearance.
  double drive_until(double end) {
    double time = now(), clearance = most_clearance;
    while (time < end) {
      // Not a nanosecond earlier: sums of periods are rounded.
      while (!pending_.empty() && pending_.front().begins <= time + 1e-9) {
        twist_ = pending_.front().twist;
        pending_.erase(pending_.begin());
      }
      const double next = pending_.empty() ? end : std::min(end, pending_.front().begins);
      const Motion motion{pose_, twist_, next - time};
      clearance = std::min(clearance, judge(motion, time));
      pose_ = motion.at(motion.duration);
      result_.length += std::abs(twist_.v) * motion.duration;
      time = next;
    }
    return clearance;
  }

  /// Counts the contacts in a motion that begins at `time`. Returns the least clearance.
  double judge(const Motion& motion, double time) {
    const double radius = map_.safety_radius(), cap = radius + most_clearance;
    double least = approach(map_, motion, cap).distance - radius;
    count(0, least < -rounding || leaves_bounds(motion), true);
    double own_least = least;
    for (std::size_t i = 0; i < encounters_.all().size(); ++i) {
      const Encounter& encounter = encounters_.all()[i];
      if (!encounter.is_present(now())) {
        in_contact_[i + 1] = Contact::none;
        continue;
      }
      const MovingObstacle obstacle = encounter.at(time);
      const double clearance = approach(motion, obstacle, cap).distance - radius;
      const bool is_own = obstacle.stands() || motion.twist.v != 0;
      count(i + 1, clearance < -rounding, is_own);
      least = std::min(least, clearance);
      if (is_own) own_least = std::min(own_least, clearance);
    }
    result_.min_clearance = std::min(result_.min_clearance, own_least);
    return least;
  }
  bool leaves_bounds(const Motion& motion) const {
    // The odometry's pose keeps to the bounds. Its heading is off for less than a metre until the
    // robot stands.
    const Box allowed = map_.bounds().inflated(rounding + options_.control.position_error +
                                               options_.control.heading_error);
    return !path_of(motion.from, motion.twist, motion.duration).visit([&](const auto& piece) {
      return allowed.contains(piece.box());
    });
  }

  enum class Contact : std::uint8_t { none, driven_into, own };

  /// Counts a contact once, however long it lasts; twice if it becomes the robot's own.
  void count(std::size_t obstacle, bool touches, bool is_own) {
    Contact& state = in_contact_[obstacle];
    if (!touches) {
      state = Contact::none;
    } else if (is_own && state != Contact::own) {
      ++result_.own_contacts;
      state = Contact::own;
    } else if (!is_own && state == Contact::none) {
      ++result_.driven_into;
      state = Contact::driven_into;
    }
  }

  bool stands() const {
    return twist_.is_zero() && std::all_of(pending_.begin(), pending_.end(),
                                           [](const Pending& p) { return p.twist.is_zero(); });
  }

  /// Ends the drive, or asks for a new path.
  void watch(const DriveCommand& command, const Pose& odometry) {
    if (!stands()) {
      stands_since_ = now();
      return;
    }
    if (command.status == DriveStatus::arrived) {
      const double off = distance(pose_.position, goal_);
      if (off <= options_.goal_tolerance + options_.control.position_error)
        return end(Ending::reached, {});
      return end(Ending::stopped, "arrived " + std::to_string(off) + " m from the goal");
    }
    const double standing = now() - stands_since_;
    if (standing >= options_.patience) {
      return end(Ending::stopped, std::string(to_string(command.status)) +
                                      (refusal_.empty() ? "" : "; " + refusal_));
    }
    if (replan_ && standing >= options_.replan_after &&
        now() - replanned_ >= options_.replan_interval) {
      follow_new_path(odometry);
    }
  }

  void follow_new_path(const Pose& odometry) {
    replanned_ = now();
    encounters_.observe(now(), observed_);
    auto path = replan_(odometry, observed_);
    if (!path) {
      refusal_ = "no new path: " + std::string(to_string(path.error().code));
      return;
    }
    if (!controller_.follow(*path)) return;
    ++result_.replans;
    refusal_.clear();
    path_ = std::move(*path);
    if (options_.keeps_trace) result_.paths.push_back({now(), path_});
  }

  const S& map_;
  C& controller_;
  Encounters& encounters_;
  SimulationOptions options_;
  Replan replan_;
  OdometryNoise noise_;

  Curve path_{};
  Point goal_ = Point::Zero();
  Pose pose_{};
  Twist twist_{};      // in effect
  Twist commanded_{};  // last
  std::vector<Pending> pending_{};
  std::vector<MovingObstacle> observed_{};
  std::vector<Contact> in_contact_{};  // with the map, then with each obstacle
  std::uint64_t periods_ = 0;
  double stands_since_ = 0;
  double replanned_ = -1e9;
  std::string refusal_{};
  bool is_over_ = false;
  DriveResult result_{};
};

}  // namespace drive_program
