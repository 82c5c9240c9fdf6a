// SPDX-License-Identifier: MIT
// A robot follows a plan. An obstacle that the map does not have appears on its way: the local
// planner finds a way around it, and every command is proved to leave the robot time to stop.

#include <iostream>
#include <tutavia/tutavia.hpp>

using namespace tutavia;

int main() {
  Scene scene = maps::complex();
  const auto space = InflatedSpace::build(scene.workspace).value();
  // The path leaves 0.1 m more than the robot needs, so that there is room to follow it.
  scene.workspace.safety_radius += 0.1;
  const auto roomy = InflatedSpace::build(scene.workspace).value();
  Planner planner{TangentGraph{}, DeltaSmoother{}};
  const auto plan = planner.plan(roomy, {.start = scene.start, .goal = scene.goals[0]}).value();

  // Its bands keep half a metre from obstacles where they can.
  const LocalPlannerOptions options{.band = TimedElasticBand{.clearance = 0.5}};
  auto local = LocalPlanner<InflatedSpace>::build(space, options).value();
  if (!local.follow(plan.curve)) return 1;
  const MovingObstacle box{Disc{plan.curve.point(0.3 * plan.curve.length()), 0.2}};
  std::vector<MovingObstacle> observed;
  Pose pose{scene.start, plan.curve.heading(0)};  // from odometry, on a robot
  DriveCommand command;
  std::string_view status;
  const double period = options.control.period;
  for (int k = 0; command.status != DriveStatus::arrived && k < 5000; ++k) {
    // It comes into view a quarter of a metre before the robot's edge.
    if (observed.empty() && distance(pose.position, std::get<Disc>(box.shape).center) < 0.75) {
      observed.push_back(box);
      std::cout << k * period << " s: an obstacle\n";
    }
    command = local.step(pose, observed);
    if (to_string(command.status) != status) {
      status = to_string(command.status);
      std::cout << k * period << " s: " << status << " at (" << pose.position.x() << ", "
                << pose.position.y() << ")\n";
    }
    pose = moved(pose, command.twist, period);
  }
  std::cout << distance(pose.position, scene.goals[0]) << " m from the goal\n";
}
