// SPDX-License-Identifier: MIT
// A nav2 costmap, a robot with a radius, and a proved path to follow.

#include <cstdint>
#include <iostream>
#include <tutavia/tutavia.hpp>
#include <vector>

using namespace tutavia;

int main() {
  // As nav2_costmap_2d::Costmap2D::getCharMap() gives it: row 0 is the bottom row.
  const std::size_t width = 120, height = 80;
  std::vector<std::uint8_t> costs(width * height, 0);
  for (std::size_t y = 0; y < 50; ++y) costs[y * width + 60] = 254;

  const auto grid = grid_from_costmap(costs, width, height, 254, RosMap::UnknownCells::blocked);
  if (!grid) {
    std::cerr << grid.error() << '\n';
    return 1;
  }
  const auto space =
      CellSpace::build(*grid, {.resolution = 0.05, .origin = {-3, -2}, .safety_radius = 0.25});
  if (!space) {
    std::cerr << space.error() << '\n';
    return 1;
  }
  Planner planner{AStar{}, TautString{}};
  const auto plan = planner.plan(*space, {.start = {-2.5, -1.5}, .goal = {2.5, -1.5}});
  if (!plan) {
    std::cerr << plan.error() << '\n';
    return 1;
  }
  std::cout << plan->metrics.length << " m, clearance at least " << plan->certificate.lower
            << " m\n";
  for (const CurvePoint& pose : plan->curve.sample(1.0)) {
    std::cout << pose.position.x() << ", " << pose.position.y() << ", yaw " << pose.heading << '\n';
  }
}
