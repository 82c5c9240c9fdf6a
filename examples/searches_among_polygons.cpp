// SPDX-License-Identifier: MIT
// Searches that need no grid: random trees, and the exact shortest path along tangents.

#include <iostream>
#include <tutavia/tutavia.hpp>

using namespace tutavia;

template <class Search>
void show(const InflatedSpace& space, const Query& query, Search search) {
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
}
