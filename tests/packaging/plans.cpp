// SPDX-License-Identifier: MIT
// Prints a plan to every goal of the built-in maps to the last bit. It is compiled twice, with the
// headers of the library and with the single header that is generated from them.

#ifdef TUTAVIA_SINGLE_HEADER
#include "tutavia_single.hpp"
#else
#include <tutavia/tutavia.hpp>
#endif

#include <cstddef>
#include <cstdio>
#include <iostream>

using namespace tutavia;

#ifdef TUTAVIA_SINGLE_HEADER
std::size_t goals_in_second_unit();
#else
static std::size_t goals_in_second_unit() { return maps::maze().goals.size(); }
#endif

int main() {
  for (const Scene& scene :
       {maps::array(), maps::complex(), maps::maze(), maps::rrt_scene_1(), maps::rrt_scene_2()}) {
    const auto space =
        LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
    Planner planner{AStar{}, DeltaSmoother{}};
    for (const Point& goal : scene.goals) {
      const auto plan = planner.plan(space, {.start = scene.start, .goal = goal});
      if (!plan) {
        std::cerr << scene.name << ": " << plan.error() << '\n';
        return 1;
      }
      std::printf("%s: %.17g m, %zu waypoints, %zu pieces, clearance in [%.17g, %.17g] m\n",
                  scene.name.c_str(), plan->metrics.length, plan->route.curve.pieces().size() + 1,
                  plan->curve.pieces().size(), plan->certificate.lower, plan->certificate.upper);
    }
  }
  return goals_in_second_unit() == maps::maze().goals.size() ? 0 : 1;
}
