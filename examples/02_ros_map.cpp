// SPDX-License-Identifier: MIT
// Plans on a map of ROS map_server with 0.3 m clearance, and prints a waypoint every 0.5 m.
// Needs the target tutavia::ros. Run it as: example_02_ros_map MAP.yaml

#include <iomanip>
#include <iostream>
#include <tutavia/io/ros_map_yaml.hpp>
#include <tutavia/tutavia.hpp>

int main(int argc, char** argv) {
  using namespace tutavia;
  if (argc != 2) {
    std::cerr << "usage: example_02_ros_map MAP.yaml\n";
    return 2;
  }
  const auto map = read_ros_map(argv[1]);
  if (!map) {
    std::cerr << map.error() << '\n';
    return 1;
  }
  for (const std::string& warning : map->warnings) std::cerr << warning << '\n';

  // The rows of a map may be turned by a yaw, so the plan is made in their frame.
  const auto grid = to_grid(*map, RosMap::UnknownCells::blocked);
  if (!grid) {
    std::cerr << grid.error() << '\n';
    return 1;
  }
  const auto space = CellSpace::build(*grid, {.resolution = map->resolution, .safety_radius = 0.3});
  if (!space) {
    std::cerr << space.error() << '\n';
    return 1;
  }
  Planner planner{Jps{}, ClothoidSmoother{}};
  const auto plan = planner.plan(*space, {.start = to_grid_frame(*map, {-1.6, -0.8}),
                                          .goal = to_grid_frame(*map, {1.7, -0.7})});
  if (!plan) {
    std::cerr << plan.error() << '\n';
    return 1;
  }

  std::cout << std::fixed << std::setprecision(2) << plan->metrics.length
            << " m, clearance at least " << plan->certificate.lower << " m\n";
  for (const CurvePoint& state : plan->curve.sample(0.5)) {
    const Point waypoint = to_map_frame(*map, state.position);
    std::cout << "x " << waypoint.x() << ", y " << waypoint.y() << ", yaw "
              << state.heading + map->yaw << '\n';
  }
}
