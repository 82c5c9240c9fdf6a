// SPDX-License-Identifier: MIT
#include <tutavia/tutavia.hpp>

int main() {
  const auto scene = tutavia::maps::array();
  const auto space = tutavia::LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  tutavia::Planner planner{tutavia::AStar{}, tutavia::DeltaSmoother{}};
  return planner.plan(space, {.start = scene.start, .goal = scene.goals[0]}) ? 0 : 1;
}
