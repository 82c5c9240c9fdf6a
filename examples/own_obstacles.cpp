// SPDX-License-Identifier: MIT
// Your own obstacles: plans among polygons and discs, and samples the curve by arc length.

#include <iostream>
#include <tutavia/tutavia.hpp>

int main() {
  using namespace tutavia;
  Workspace workspace{.bounds = {{0, 0}, {10, 6}}, .safety_radius = 0.4};
  workspace.obstacles.emplace_back(Disc{.center = {3, 3.4}, .radius = 1});
  workspace.obstacles.emplace_back(Polygon{{{5, 0}, {6, 0}, {6, 4}, {5, 3}}});
  const auto space = LatticeSpace::build(workspace, {.resolution = 0.1});
  if (!space) {
    std::cerr << space.error() << '\n';
    return 1;
  }
  Planner planner{AStar{}, Shortcut{}};
  const auto plan = planner.plan(*space, {.start = {1, 3}, .goal = {9, 1}});
  if (!plan) {
    std::cerr << plan.error() << '\n';
    return 1;
  }
  for (const CurvePoint& state : plan->curve.sample(1.0)) {
    std::cout << state.s << " m: (" << state.position.x() << ", " << state.position.y()
              << "), heading " << state.heading << " rad\n";
  }
}
