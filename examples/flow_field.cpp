// SPDX-License-Identifier: MIT
// A flow field: paths to the nearest of several goals from everywhere on a map.

#include <iostream>
#include <tutavia/tutavia.hpp>
#include <vector>

using namespace tutavia;

int main() {
  auto grid = OccupancyGrid::blocked(40, 30).value();
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) grid.set({x, y}, x != 20 || y > 24);
  }
  const CellSpace space = CellSpace::build(grid).value();
  const std::vector<Point> docks{{2.5, 2.5}, {37.5, 27.5}};
  const FlowField field = FlowField::build(space, docks).value();
  for (const Point& start : {Point(10.5, 5.5), Point(25.5, 5.5), Point(18.5, 28.5)}) {
    const Route route = field.path(space, start).value();
    std::cout << route.cost << " m to (" << route.curve.end().x() << ", " << route.curve.end().y()
              << ")\n";
  }
}
