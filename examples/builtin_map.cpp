// SPDX-License-Identifier: MIT
// Plans the first goal of a built-in map and draws it.

#include <iostream>
#include <tutavia/tutavia.hpp>

int main() {
  using namespace tutavia;
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
  Planner planner{AStar{}, DeltaSmoother{}};
  const auto plan = planner.plan(space, {.start = scene.start, .goal = scene.goals[0]});
  if (!plan) {
    std::cerr << plan.error() << '\n';
    return 1;
  }
  std::cout << plan->metrics.length << " m, clearance at least " << plan->certificate.lower
            << " m\n";
  const auto written = write_svg("builtin_map.svg", scene.workspace, *plan);
  return written ? 0 : 1;
}
