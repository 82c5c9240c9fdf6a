// SPDX-License-Identifier: MIT
// Plans many queries on one space in several threads. Results stand in the order of the queries,
// and do not depend on the number of threads.

#include <iomanip>
#include <iostream>
#include <tutavia/tutavia.hpp>
#include <vector>

int main() {
  using namespace tutavia;
  const Scene scene = maps::array();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
  std::vector<Query> queries;
  for (const Point& goal : scene.goals) queries.push_back({.start = scene.start, .goal = goal});
  queries.push_back({.start = scene.start, .goal = {2, 3}});  // inside a pillar

  // The planner gives its options; each thread works with a planner and memory of its own.
  const Planner planner{AStar{}, TautString{}};
  const auto plans = plan_batch(planner, space, queries);
  std::cout << std::fixed << std::setprecision(2);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const Point& goal = queries[i].goal;
    std::cout << '(' << goal.x() << ", " << goal.y() << "): ";
    if (plans[i]) {
      std::cout << plans[i]->metrics.length << " m\n";
    } else {
      std::cout << to_string(plans[i].error().code) << '\n';
    }
  }

  const auto alone = plan_batch(planner, space, queries, 1);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (plans[i] && plans[i]->metrics.length != alone[i]->metrics.length) return 1;
  }
  std::cout << "the same in one thread\n";
}
