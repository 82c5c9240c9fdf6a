// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../plan/usage_error.hpp"
#include "drive.hpp"
#include "simulator.hpp"
#include "tutavia/motion/local_planner.hpp"
#include "tutavia/motion/path_follower.hpp"
#include "tutavia/search/query_checks.hpp"

/// \file
/// drive_on: the drive on a kind of space.

namespace drive_program {

namespace detail {

inline ControlOptions control_options(const Arguments& args) {
  return {.latency = args.latency, .position_error = args.noise, .heading_error = args.noise};
}

inline SimulationOptions simulation_options(const Arguments& args, double path_length) {
  const ControlOptions control = control_options(args);
  const double time = 300 + 4 * path_length / control.limits.max_speed;
  return {.limits = control.limits,
          .period = control.period,
          .latency = control.latency,
          .position_error = control.position_error,
          .heading_error = control.heading_error,
          .time_limit = args.time_limit.value_or(time),
          .seed = args.seed,
          .keeps_trace = true};
}

/// Whether what stays for good leaves a way to the goal.
template <class S>
std::optional<bool> is_connected_at_end(const S& space, const Drive& drive, const Point& goal) {
  std::vector<MovingObstacle> standing;
  for (const Encounter& e : drive.encounters) {
    if (e.stays()) standing.push_back(e.obstacle);
  }
  return is_connected(space, drive.result.end.position, goal, standing);
}

template <class S, Controller C>
void simulate(const S& space, C controller, const Pose& start, const Arguments& args,
              GlobalPlanner<S>& planner, const Progress& progress, Drive& drive) {
  const Point goal = drive.path.curve.end();
  Encounters encounters({.count = args.obstacles, .seed = args.seed});
  const auto replan = [&](const Pose& odometry, std::span<const MovingObstacle> observed) {
    auto path = planner.plan(odometry.position, goal, observed);
    if (!path) return Expected<Curve, Failure>(std::move(path).unexpected());
    return Expected<Curve, Failure>(std::move(path->curve));
  };
  Simulator simulator(space, controller, encounters,
                      simulation_options(args, drive.path.curve.length()), replan);
  drive.result = simulator.run(start, drive.path.curve, progress);
  drive.encounters = encounters.all();
  if (drive.result.ending != Ending::reached) {
    drive.result.is_connected = is_connected_at_end(space, drive, goal);
  }
}

}  // namespace detail

template <class S>
Expected<Drive, Failure> drive_on(const S& space, const plan_program::Task& task,
                                  const Arguments& args, const Progress& progress) {
  plan_program::MapFrame frame = task.frame;
  const Point start = frame.to_grid(task.scene.start), goal = frame.to_grid(task.scene.goals[0]);
  // The planner takes starts that noise led out of the bounds or into a zone; users' it must not.
  if (auto valid = check_query(space, {.start = start, .goal = goal}); !valid) {
    return std::move(valid).unexpected();
  }
  const ControlOptions control = detail::control_options(args);
  GlobalPlanner<S> planner(space, 0.1 + 3 * args.noise);
  auto path = planner.plan(start, goal);
  if (!path) return std::move(path).unexpected();
  Drive drive{.path = std::move(*path)};
  const double heading = args.heading ? *args.heading - frame.yaw() : drive.path.curve.heading(0);
  const auto run = [&](auto controller) {
    detail::simulate(space, plan_program::value_or_throw(std::move(controller)), {start, heading},
                     args, planner, progress, drive);
  };
  if (args.controller == ControllerKind::band) {
    run(LocalPlanner<S>::build(space, {.control = control}));
  } else {
    run(PathFollower<S>::build(space, {.control = control}));
  }
  return drive;
}

}  // namespace drive_program
