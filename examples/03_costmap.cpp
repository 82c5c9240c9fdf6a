// SPDX-License-Identifier: MIT
// Plans on the bytes of a nav2 costmap, for a robot of 0.25 m: walls (254) and unknown cells (255)
// are obstacles, and the planner keeps the radius itself, exactly.

#include <cstdint>
#include <iomanip>
#include <iostream>
#include <tutavia/tutavia.hpp>
#include <vector>

int main() {
  using namespace tutavia;
  // As nav2_costmap_2d::Costmap2D::getCharMap() gives it: row 0 is the bottom row.
  constexpr int width = 120, height = 80;
  std::vector<std::uint8_t> costs(width * height, 0);
  for (std::size_t y = 0; y < height; ++y) {
    if (y < 50) costs[y * width + 60] = 254;
    if (y >= 70) costs[y * width + 30] = 255;
  }

  const auto grid = grid_from_costmap(costs, width, height, 254, RosMap::UnknownCells::blocked);
  if (!grid) {
    std::cerr << grid.error() << '\n';
    return 1;
  }
  // Resolution and origin are those of the costmap.
  const auto space =
      CellSpace::build(*grid, {.resolution = 0.05, .origin = {-3, -2}, .safety_radius = 0.25});
  if (!space) {
    std::cerr << space.error() << '\n';
    return 1;
  }
  Planner planner{Jps{}, TautString{}};
  const auto plan = planner.plan(*space, {.start = {-2.5, -1.5}, .goal = {2.5, -1.4}});
  if (!plan) {
    std::cerr << plan.error() << '\n';
    return 1;
  }
  std::cout << std::fixed << std::setprecision(2) << plan->metrics.length
            << " m, clearance at least " << plan->certificate.lower << " m\n";
  for (const CurvePoint& pose : plan->curve.sample(1.0)) {
    std::cout << "x " << pose.position.x() << ", y " << pose.position.y() << ", yaw "
              << pose.heading << '\n';
  }
}
