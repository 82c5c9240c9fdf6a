// SPDX-License-Identifier: MIT
// From a plan to a motion: the fastest speeds along the curve within limits, and a controller that
// follows it. Every command of the controller is proved to leave the robot time to stop.

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <tutavia/tutavia.hpp>

int main() {
  using namespace tutavia;
  std::cout << std::fixed << std::setprecision(2);
  Scene scene = maps::maze();
  const auto space = InflatedSpace::build(scene.workspace).value();
  // The path keeps 0.1 m more than the robot needs, so that there is room to follow it.
  scene.workspace.safety_radius += 0.1;
  const auto roomy = InflatedSpace::build(scene.workspace).value();
  Planner planner{TangentGraph{}, ClothoidSmoother{}};
  const auto plan = planner.plan(roomy, {.start = scene.start, .goal = scene.goals[0]});
  if (!plan) {
    std::cerr << plan.error() << '\n';
    return 1;
  }

  const SpeedLimits limits{.max_speed = 1.5, .max_lateral_acceleration = 0.8, .max_jerk = 2};
  const auto profile = SpeedProfile::build(plan->curve, limits);
  if (!profile) {
    std::cerr << profile.error() << '\n';
    return 1;
  }
  std::cout << plan->metrics.length << " m in " << profile->duration() << " s\n";
  for (const SpeedProfile::State& state : profile->sample(5)) {
    std::cout << state.time << " s: " << state.speed << " m/s at (" << state.position.x() << ", "
              << state.position.y() << ")\n";
  }

  auto follower = PathFollower<InflatedSpace>::build(
      space, {.control = {.limits = {.max_speed = 0.8, .max_angular_speed = 1}}});
  if (!follower || !follower->follow(plan->curve)) return 1;
  const double period = ControlOptions{}.period;
  Pose pose{scene.start, plan->curve.heading(0)};  // on a robot, from odometry
  double off = 0, clearance = space.clearance(pose.position);
  DriveCommand command;
  for (int k = 0; command.status != DriveStatus::arrived && k < 2000; ++k) {
    command = follower->step(pose, {});  // {}: no obstacles beside those of the map
    pose = moved(pose, command.twist, period);
    off = std::max(off, plan->curve.nearest(pose.position).distance);
    clearance = std::min(clearance, space.clearance(pose.position));
  }
  std::cout << to_string(command.status) << ", never more than " << off
            << " m off the path, never nearer to an obstacle than " << clearance << " m\n";
}
