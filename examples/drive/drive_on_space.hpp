// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../plan/usage_error.hpp"
#include "drive.hpp"
#include "simulate.hpp"
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
  return {.control = control,
          .time_limit = args.time_limit.value_or(time),
          .seed = args.seed,
          .keeps_trace = true};
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
  Encounters encounters({.count = args.obstacles, .seed = args.seed});
  const auto run = [&](auto built) {
    auto controller = plan_program::value_or_throw(std::move(built));
    const SimulationOptions options = detail::simulation_options(args, drive.path.curve.length());
    drive.result = simulate(space, controller, planner, encounters, {start, heading},
                            drive.path.curve, options, 0, progress);
  };
  if (args.controller == ControllerKind::band) {
    run(LocalPlanner<S>::build(space, {.control = control}));
  } else {
    run(PathFollower<S>::build(space, {.control = control}));
  }
  drive.encounters = encounters.all();
  return drive;
}

}  // namespace drive_program
