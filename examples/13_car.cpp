// SPDX-License-Identifier: MIT
// A car parks in a bay: headings, a turning radius and a footprint, all of it proved. Then the same
// with continuous curvature, so that its wheels turn while it rolls.

#include <iomanip>
#include <iostream>
#include <numbers>
#include <tutavia/tutavia.hpp>

int main() {
  using namespace tutavia;
  std::cout << std::fixed << std::setprecision(2);
  const auto block = [](double x0, double y0, double x1, double y1) {
    return Polygon{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
  };
  const Workspace lot{.bounds = {{-15, -8}, {15, 8}},
                      .obstacles = {block(-15, -6, -1.3, -0.8), block(1.3, -6, 15, -0.8)}};
  const auto space = InflatedSpace::build(lot).value();

  // 4.5 x 1.8 m, axles 2.7 m apart, turning radius 5 m; the middle of the rear axle is planned.
  const Vehicle car = Vehicle::car(4.5, 1.8, 2.7, 5);
  const Query query{.start = {-8, 1.5},
                    .goal = {0, -4.6},
                    .start_heading = 0,
                    .goal_heading = std::numbers::pi / 2};
  Planner planner{HybridAStar{.vehicle = car}, VehicleShortcut{}};
  const auto plan = planner.plan(space, query);
  if (!plan) {
    std::cerr << plan.error() << '\n';
    return 1;
  }
  const VehiclePath path{plan->curve, plan->gears};
  std::cout << "length " << path.length() << " m, " << path.cusps().size()
            << " change of gear, the whole car at least " << plan->certificate.lower
            << " m from every obstacle\n";
  for (double s = 0; s < path.length(); s += 4) {
    const Pose pose = path.at(s);
    std::cout << "  x " << pose.position.x() << ", y " << pose.position.y() << ", heading "
              << pose.heading << '\n';
  }

  // With full lock after 2 m of way the wheels turn while the car rolls, never while it stands.
  Planner steady{HybridAStar{.vehicle = car}, ContinuousCurvature{.max_sharpness = 0.1}};
  const auto smooth = steady.plan(space, query);
  if (!smooth || smooth->fell_back) {
    std::cerr << "no path of continuous curvature\n";
    return 1;
  }
  // A wheel that turns by 0.5 rad/s, axles 2.7 m apart.
  const SpeedLimits limits{.max_speed = 2, .max_curvature_rate = 0.5 / 2.7};
  std::cout << "with continuous curvature " << smooth->metrics.length << " m, driven in "
            << SpeedProfile::build(smooth->curve, limits).value().duration() << " s; with jumps in "
            << SpeedProfile::build(plan->curve, limits).value().duration() << " s\n";
}
