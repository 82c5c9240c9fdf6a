// SPDX-License-Identifier: MIT
// Plans every goal of a built-in map, prints a table and draws NAME.svg:
//
//   example_builtin_map [array|complex|maze|rrt_scene_1|rrt_scene_2]

#include <cstdio>
#include <iostream>
#include <numbers>
#include <optional>
#include <string>
#include <tutavia/tutavia.hpp>
#include <vector>

using namespace tutavia;

namespace {

std::vector<Scene> all_maps() {
  return {maps::array(), maps::complex(), maps::maze(), maps::rrt_scene_1(), maps::rrt_scene_2()};
}

/// The map with this name, or the maze if `name` is empty.
std::optional<Scene> find_map(const std::string& name) {
  if (name.empty()) return maps::maze();
  for (Scene& scene : all_maps()) {
    if (scene.name == name) return scene;
  }
  return std::nullopt;
}

void print_row(const Point& goal, const Plan& plan) {
  std::printf("(%4.1f, %4.1f) %9.3f %9.3f %9.1f %9.3f  %-8s %9.2f %9.2f %9.2f\n", goal.x(),
              goal.y(), plan.metrics.length, plan.route.curve.length(),
              plan.metrics.turning_angle * 180 / std::numbers::pi, plan.certificate.lower,
              std::string(to_string(plan.certificate.status)).c_str(), plan.stats.search_us / 1000,
              plan.stats.smooth_us / 1000, plan.stats.certify_us / 1000);
}

/// Plans all goals and draws the plans. Returns the exit code.
int plan_all_goals(const Scene& scene) {
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
  Planner planner{AStar{}, DeltaSmoother{}};
  std::vector<Plan> plans;
  std::printf("%-12s %9s %9s %9s %9s  %-8s %9s %9s %9s\n", "goal", "length", "A* length", "turning",
              "clearance", "proof", "search", "smooth", "certify");
  std::printf("%-12s %9s %9s %9s %9s  %-8s %9s %9s %9s\n", "[m]", "[m]", "[m]", "[deg]", "[m]", "",
              "[ms]", "[ms]", "[ms]");
  for (const Point& goal : scene.goals) {
    const auto plan = planner.plan(space, {.start = scene.start, .goal = goal});
    if (plan) {
      print_row(goal, *plan);
      plans.push_back(*plan);
    } else {
      std::cout << "no plan: " << plan.error() << '\n';
    }
  }
  const std::string file = scene.name + ".svg";
  const auto written = write_svg(file, scene.workspace, plans, {.title = scene.name});
  if (!written) {
    std::cerr << written.error() << '\n';
    return 1;
  }
  std::cout << plans.size() << " of " << scene.goals.size() << " goals planned, drawn in " << file
            << '\n';
  return plans.size() == scene.goals.size() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const auto scene = argc <= 2 ? find_map(argc == 2 ? argv[1] : "") : std::nullopt;
  if (scene) return plan_all_goals(*scene);
  if (argc == 2) std::cerr << "no built-in map is named \"" << argv[1] << "\"\n";
  std::cerr << "usage: example_builtin_map [NAME], where NAME is one of";
  for (const Scene& known : all_maps()) std::cerr << ' ' << known.name;
  std::cerr << '\n';
  return 2;
}
