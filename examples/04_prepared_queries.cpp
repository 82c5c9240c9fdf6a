// SPDX-License-Identifier: MIT
// Tables that are prepared once for a map make every later query faster: jumps on cells, a
// navigation mesh for a point among cells, tangents for a disc among polygons.

#include <iomanip>
#include <iostream>
#include <tutavia/tutavia.hpp>

/// Plans to every goal and prints the lengths.
template <class Search, class Space>
void plan_all(const Search& search, const Space& space, const tutavia::Scene& scene) {
  tutavia::Planner planner{search};
  std::cout << std::setw(13) << Search::name << ':';
  for (const tutavia::Point& goal : scene.goals) {
    const auto plan = planner.plan(space, {.start = scene.start, .goal = goal});
    if (plan) {
      std::cout << ' ' << plan->metrics.length << " m";
    } else {
      std::cout << ' ' << plan.error();
    }
  }
  std::cout << '\n';
}

int main() {
  using namespace tutavia;
  std::cout << std::fixed << std::setprecision(2);

  // A wall with a door, as cells of 1 m, for a point.
  auto grid = OccupancyGrid::blocked(40, 30).value();
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) grid.set({x, y}, x != 20 || y == 24);
  }
  const auto cells = CellSpace::build(grid).value();
  const Scene tasks{.start = {2.5, 3.5}, .goals = {{37.5, 3.5}, {30.5, 20.5}, {12.5, 28.5}}};
  const auto jumps = JpsPlus::prepare(cells);
  const auto mesh = AnyAngle::prepare(cells);
  if (!jumps || !mesh) return 1;
  plan_all(JpsPlus{*jumps}, cells, tasks);
  plan_all(AnyAngle{*mesh}, cells, tasks);

  // The maze, for a disc.
  const Scene maze = maps::maze();
  const auto space = InflatedSpace::build(maze.workspace).value();
  const auto tangents = TangentGraph::prepare(space);
  if (!tangents) return 1;
  plan_all(TangentGraph{.tangents = *tangents}, space, maze);

  // A table belongs to one space, and says whether it is this one.
  grid.set({20, 24}, false);
  std::cout << "for the same cells: " << (*jumps)->matches(cells.grid())
            << ", with the door closed: " << (*jumps)->matches(grid) << '\n';
}
