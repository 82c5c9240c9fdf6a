// SPDX-License-Identifier: MIT
// Searches and smoothers chosen by name at run time, and a table of their lengths over that of the
// shortest path. The registry compiles all of them, so it is not part of tutavia.hpp.

#include <array>
#include <iomanip>
#include <iostream>
#include <string_view>
#include <tutavia/registry.hpp>
#include <tutavia/tutavia.hpp>

int main() {
  using namespace tutavia;
  using Space = LatticeSpace;
  const Scene scene = maps::maze();
  const auto space = Space::build(scene.workspace, {.resolution = scene.resolution}).value();
  const Query query{.start = scene.start, .goal = scene.goals[0], .seed = 1};
  const auto optimum = find_optimum(space, query);
  if (!optimum) {
    std::cerr << optimum.error() << '\n';
    return 1;
  }
  std::cout << std::fixed << std::setprecision(3) << "the shortest path has " << *optimum
            << " m\n\n";

  constexpr std::array smoothers{"none", "shortcut", "taut_string", "delta", "b_spline"};
  std::cout << std::setw(16) << "length / optimum";
  for (const std::string_view name : smoothers) std::cout << std::setw(12) << name;
  std::cout << '\n';
  for (const std::string_view name :
       {"astar", "jps", "theta_star", "rea_star", "rrt_star", "tangent_graph"}) {
    const auto search = make_search<Space>(name);
    if (!search) {
      std::cerr << search.error() << '\n';
      return 1;
    }
    std::cout << std::setw(16) << name;
    for (const std::string_view smoother_name : smoothers) {
      const auto smoother = make_smoother<Space>(smoother_name);
      if (!smoother) {
        std::cerr << smoother.error() << '\n';
        return 1;
      }
      Planner planner{*search, *smoother};
      const auto plan = planner.plan(space, query);
      if (plan) {
        std::cout << std::setw(12) << plan->metrics.length / *optimum;
      } else {
        std::cout << std::setw(12) << "no plan";
      }
    }
    std::cout << '\n';
  }
  std::cout << '\n' << make_search<Space>("theta-star").error() << '\n';
}
