// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "encounters.hpp"
#include "global_planner.hpp"
#include "simulator.hpp"

/// \file
/// simulate: a drive that plans anew where the robot is blocked.

namespace drive_program {

/// Drives along a path by a controller. Where that is blocked, `planner` plans another path. If the
/// robot does not reach the end, the result says whether what stays for good leaves a path there
/// that keeps `margin` beyond the safety radius.
template <class S, Controller C>
DriveResult simulate(const S& space, C& controller, GlobalPlanner<S>& planner,
                     Encounters& encounters, const Pose& start, const Curve& path,
                     const SimulationOptions& options, double margin = 0,
                     const Progress& progress = {}) {
  const auto replan = [&](const Pose& odometry,
                          std::span<const MovingObstacle> observed) -> Expected<Curve, Failure> {
    auto found = planner.plan(odometry.position, path.end(), observed);
    if (!found) return std::move(found).unexpected();
    return std::move(found->curve);
  };
  Simulator simulator(space, controller, encounters, options, replan);
  DriveResult result = simulator.run(start, path, progress);
  if (result.ending == Ending::reached) return result;
  std::vector<MovingObstacle> standing;
  for (const Encounter& e : encounters.all()) {
    if (e.stays()) standing.push_back(e.obstacle);
  }
  result.is_connected = is_connected(space, result.end.position, path.end(), standing, margin);
  return result;
}

}  // namespace drive_program
