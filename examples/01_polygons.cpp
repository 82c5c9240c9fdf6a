// SPDX-License-Identifier: MIT
// Plans among polygons and discs: a smooth path, its proved clearance, and points along it.
// The robot is a disc; safety_radius is its radius and what it keeps beyond that.

#include <iomanip>
#include <iostream>
#include <tutavia/tutavia.hpp>

int main() {
  using namespace tutavia;
  Workspace room{.bounds = {{0, 0}, {10, 6}}, .safety_radius = 0.4};
  room.obstacles.emplace_back(Disc{.center = {3, 3.4}, .radius = 1});
  room.obstacles.emplace_back(Polygon{{{5, 0}, {6, 0}, {6, 4}, {5, 3}}});

  const auto space = LatticeSpace::build(room, {.resolution = 0.1});
  if (!space) {
    std::cerr << space.error() << '\n';
    return 1;
  }
  Planner planner{AStar{}, ClothoidSmoother{}};
  const auto plan = planner.plan(*space, {.start = {1, 3}, .goal = {9, 1}});
  if (!plan) {
    std::cerr << plan.error() << '\n';
    return 1;
  }

  std::cout << std::fixed << std::setprecision(2) << plan->metrics.length
            << " m, clearance at least " << plan->certificate.lower << " m\n";
  for (const CurvePoint& state : plan->curve.sample(1.0)) {
    std::cout << "after " << state.s << " m: (" << state.position.x() << ", " << state.position.y()
              << "), heading " << state.heading << " rad\n";
  }
}
