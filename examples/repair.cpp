// SPDX-License-Identifier: MIT
// An obstacle comes into the way of a plan: only the pieces next to it are proved again, and only
// the part that failed is planned again.

#include <iostream>
#include <tutavia/tutavia.hpp>

using namespace tutavia;

int main() {
  Scene scene = maps::maze();
  const Query query{.start = scene.start, .goal = scene.goals[0]};
  Planner planner{TangentGraph{}, ClothoidSmoother{}};
  const auto space = InflatedSpace::build(scene.workspace).value();
  const Plan plan = planner.plan(space, query).value();

  Workspace changed = scene.workspace;
  changed.obstacles.push_back(Disc{plan.curve.point(0.4 * plan.curve.length()), 0.1});
  const auto after = InflatedSpace::build(changed).value();

  const Revalidation found =
      revalidate(after, plan, changed_boxes(scene.workspace, changed), query.budget);
  std::cout << found.proved_again << " of " << plan.curve.pieces().size()
            << " pieces proved again, " << found.failed.size() << " failed\n";

  const auto repaired = repair(planner, after, plan, found, query);
  if (!repaired) {
    std::cerr << "no plan: " << repaired.error() << '\n';
    return 1;
  }
  std::cout << "kept " << repaired->at_start.length << " m at the start and "
            << repaired->at_end.length << " m at the end of " << plan.metrics.length << " m; now "
            << repaired->plan.metrics.length << " m, clearance at least "
            << repaired->plan.certificate.lower << " m\n";
}
