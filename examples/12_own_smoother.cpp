// SPDX-License-Identifier: MIT
// A smoother of your own: drops every second waypoint where that is safe. The planner proves the
// result, and falls back to the route of the search if it cannot.

#include <iomanip>
#include <iostream>
#include <string_view>
#include <tutavia/tutavia.hpp>
#include <vector>

struct EverySecond {
  static constexpr std::string_view name = "every_second";

  template <tutavia::FreeSpace S>
  tutavia::Expected<tutavia::Curve, tutavia::Failure> smooth(const S& space,
                                                             const tutavia::Curve& input,
                                                             const tutavia::Budget& budget) const {
    const std::vector<tutavia::Point> points = tutavia::waypoints(input);
    std::vector<tutavia::Point> kept{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (const auto exceeded = budget.exceeded()) return tutavia::fail(*exceeded);
      const bool can_skip = i + 1 < points.size() && space.segment_free(kept.back(), points[i + 1]);
      kept.push_back(points[can_skip ? ++i : i]);
    }
    return tutavia::Curve::polyline(kept);
  }
};

static_assert(tutavia::Smoother<EverySecond, tutavia::LatticeSpace>);

int main() {
  const tutavia::Scene scene = tutavia::maps::complex();
  const auto space =
      tutavia::LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
  tutavia::Planner planner{tutavia::AStar{}, EverySecond{}};
  const auto plan = planner.plan(space, {.start = scene.start, .goal = scene.goals[0]});
  if (!plan) {
    std::cerr << plan.error() << '\n';
    return 1;
  }
  std::cout << std::fixed << std::setprecision(2) << "route " << plan->route.cost << " m, smoothed "
            << plan->metrics.length << " m, "
            << (plan->fell_back ? "fell back to the route\n" : "proved\n");
}
