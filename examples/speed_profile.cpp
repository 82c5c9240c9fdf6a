// SPDX-License-Identifier: MIT
// From a plan to a motion: smooth curvature, a proof, and the speed along the curve.

#include <iostream>
#include <tutavia/tutavia.hpp>

using namespace tutavia;

int main() {
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
  Planner planner{AStar{}, ClothoidSmoother{}};
  const auto plan = planner.plan(space, {.start = scene.start, .goal = scene.goals[0]}).value();

  // The planner has proved the curve; this is how to prove one of your own.
  const Certificate certificate = certify(space, plan.curve);
  std::cout << to_string(certificate.status) << ", clearance at least " << certificate.lower
            << " m\n";

  const SpeedLimits limits{.max_speed = 1.5, .max_lateral_acceleration = 0.8, .max_jerk = 2};
  const auto profile = SpeedProfile::build(plan.curve, limits).value();
  std::cout << profile.duration() << " s for " << plan.metrics.length << " m\n";
  for (const SpeedProfile::State& state : profile.sample(5)) {
    std::cout << state.time << " s: " << state.speed << " m/s at (" << state.position.x() << ", "
              << state.position.y() << ")\n";
  }
}
