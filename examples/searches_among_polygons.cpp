// SPDX-License-Identifier: MIT
// Searches that need no grid: random trees, and the exact shortest path along tangents.
// And a search that finds a path wherever there is one.

#include <iostream>
#include <tutavia/tutavia.hpp>

using namespace tutavia;

template <class S, class Search>
void show(const S& space, const Query& query, Search search) {
  Planner planner{std::move(search)};
  const auto plan = planner.plan(space, query);
  std::cout << Search::name << ": ";
  if (plan) {
    std::cout << plan->metrics.length << " m, clearance " << plan->certificate.lower << " m\n";
  } else {
    std::cout << plan.error() << '\n';
  }
}

int main() {
  const Scene scene = maps::complex();
  const InflatedSpace space = InflatedSpace::build(scene.workspace).value();
  const Query query{.start = scene.start, .goal = scene.goals[0], .seed = 7};

  show(space, query, Rrt{});
  show(space, query, RrtConnect{.step = 1.0});
  show(space, query, RrtStar{.max_iterations = 2000});
  show(space, query, InformedRrtStar{.max_iterations = 2000});
  show(space, query, SafeRrtStar{.max_iterations = 2000});
  show(space, query, TangentGraph{});
  show(space, query, TangentGraph{.tangents = TangentGraph::prepare(space).value()});
  std::cout << "no path is shorter than " << find_optimum(space, query).value() << " m\n";

  // A slot that is 0.02 m wider than the robot: A* on a lattice of 0.25 m does not find it.
  const Workspace rooms{.bounds = {{0, 0}, {6, 4}},
                        .safety_radius = 0.3,
                        .obstacles = {Polygon{{{3, 0}, {3.2, 0}, {3.2, 1.7}, {3, 1.7}}},
                                      Polygon{{{3, 2.32}, {3.2, 2.32}, {3.2, 4}, {3, 4}}}}};
  const LatticeSpace lattice = LatticeSpace::build(rooms, {.resolution = 0.25}).value();
  const Query through{.start = {1, 1}, .goal = {5, 1}};
  show(lattice, through, AStar{});
  show(lattice, through, FirstOf{AStar{}, TangentGraph{}});
  show(lattice, through, AutoSearch{});  // the same on workspaces; on cells, jump points
}
