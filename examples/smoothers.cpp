// SPDX-License-Identifier: MIT
// Every smoother on one route of A*: length, largest curvature and proved clearance.

#include <iostream>
#include <tutavia/tutavia.hpp>

using namespace tutavia;

template <class Smooth>
void show(const LatticeSpace& space, const Query& query, Smooth smoother) {
  Planner planner{AStar{}, std::move(smoother)};
  const auto plan = planner.plan(space, query).value();
  std::cout << Smooth::name << ": " << plan.metrics.length << " m, curvature up to "
            << plan.metrics.max_curvature << " 1/m, clearance " << plan.certificate.lower << " m"
            << (plan.fell_back ? ", fell back to the route\n" : "\n");
}

int main() {
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
  const Query query{.start = scene.start, .goal = scene.goals[0]};

  show(space, query, NoSmoothing{});
  show(space, query, Shortcut{});
  show(space, query, RedundantNodeRemoval{});
  show(space, query, TautString{});
  show(space, query, DeltaSmoother{.join = DeltaSmoother::Join::paper});
  show(space, query, BezierSmoother{});
  show(space, query, BSplineSmoother{});
  show(space, query, SmoothingSpline{});
  show(space, query, TwoStageBSpline{});
  show(space, query, ClothoidSmoother{});
  show(space, query, HomotopyRefine{});
  show(space, query, Pipeline{Shortcut{}, BezierSmoother{}});

  // On the cells of a map, for a point robot: a path pulled taut.
  auto grid = OccupancyGrid::blocked(20, 20).value();
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) grid.set({x, y}, x != 10 || y >= 15);
  }
  const CellSpace cells = CellSpace::build(grid).value();
  Planner planner{Jps{}, StringPull{}};
  const auto plan = planner.plan(cells, {.start = {2.5, 2.5}, .goal = {17.5, 3.5}}).value();
  std::cout << StringPull::name << ": " << plan.metrics.length << " m on cells\n";
}
