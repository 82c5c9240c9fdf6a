// SPDX-License-Identifier: MIT
// Limits for a query: a deadline, a number of iterations, and cancelling from another thread. A
// search that improves its path while there is time returns the best one at the end of its budget.

#include <iomanip>
#include <iostream>
#include <stop_token>
#include <thread>
#include <tutavia/tutavia.hpp>

/// Prints the length of every better path.
struct Improvements {
  void expanded(const tutavia::Point&) {}
  void generated(const tutavia::Point&) {}
  void improved(const tutavia::Curve&, double length) { std::cout << "  " << length << " m\n"; }
};

int main() {
  using namespace tutavia;
  std::cout << std::fixed << std::setprecision(1);
  const Scene scene = maps::rrt_scene_1();
  const auto space = InflatedSpace::build(scene.workspace).value();
  const Query query{.start = scene.start, .goal = scene.goals[0], .seed = 7};
  Planner planner{RrtStar{.max_iterations = 1'000'000'000}};

  // A deadline is a point in time. This one passes before there is a path.
  Query late = query;
  late.budget = Budget::for_seconds(0);
  const auto none = planner.plan(space, late);
  std::cout << "no time: " << (none ? "a plan" : to_string(none.error().code)) << '\n';

  // The best path after 1000 of a thousand million iterations.
  Query limited = query;
  limited.budget.max_expansions = 1000;
  std::cout << "1000 iterations:\n";
  Improvements improvements;
  const auto best = planner.plan(space, limited, improvements);
  if (!best) {
    std::cerr << best.error() << '\n';
    return 1;
  }
  std::cout << "the plan has " << best->metrics.length << " m\n";

  // A std::jthread hands its function a stop token.
  std::jthread planning([&](std::stop_token stop) {
    Query cancellable = query;
    cancellable.budget.stop = stop;
    const auto plan = planner.plan(space, cancellable);
    std::cout << "stopped: " << (plan ? "a plan" : to_string(plan.error().code)) << '\n';
  });
  planning.request_stop();
}
