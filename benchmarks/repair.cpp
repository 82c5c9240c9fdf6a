// SPDX-License-Identifier: MIT
/// \file
/// One polygon moves: the time to revalidate and repair a plan beside that of a new plan in the
/// same space, in turns, and how much longer repaired paths are.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "polygon_worlds.hpp"
#include "tutavia/repair.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/clothoid_smoother.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/changed_boxes.hpp"

namespace {

using namespace tutavia;
using bench::Clock;
using bench::micros_since;
using bench::value_or_throw;

struct Arguments : polygon_worlds::Arguments {
  std::size_t moves = 20;
};

/// The measured figures of one move.
struct Measurement {
  RepairKind kind;
  double repair_us, plan_us, boxes_us;
  double length_ratio, kept;  // of the repaired to the new curve; share of the earlier length
};

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Moves one polygon by up to 3 m: any of them, or the one nearest to a random point of the curve.
Workspace with_one_moved(Workspace workspace, const InflatedSpace& space, const Curve& curve,
                         bool near, Random& random) {
  std::size_t moved = random.below(workspace.obstacles.size());
  if (near) {
    const Point p = curve.point(random.uniform(0, curve.length()));
    moved = space.nearest(Segment{p, p}, std::numeric_limits<double>::infinity()).obstacle;
  }
  const double angle = random.uniform(0, 2 * std::numbers::pi), by = random.uniform(0.5, 3);
  for (Point& p : std::get<Polygon>(workspace.obstacles[moved]).outer) {
    p += by * Point(std::cos(angle), std::sin(angle));
  }
  return workspace;
}

InflatedSpace build(const Workspace& workspace, const InflatedSpace*) {
  return value_or_throw(InflatedSpace::build(workspace));
}
LatticeSpace build(const Workspace& workspace, const LatticeSpace*) {
  return value_or_throw(LatticeSpace::build(workspace, {.resolution = 0.25}));
}

/// A planner in worlds of polygons, and what was measured with it.
template <class Space, class Search, class Smooth>
class Row {
 public:
  Row(std::string name, Search search, Smooth smooth)
      : name_(std::move(name)), planner_(search, smooth), repairer_(search, smooth) {}

  void run(const Scene& scene, const Arguments& args, std::uint64_t seed) {
    Random random(seed);
    const Space space = build(scene.workspace, static_cast<const Space*>(nullptr));
    const InflatedSpace obstacles = value_or_throw(InflatedSpace::build(scene.workspace));
    const Query query{.start = scene.start, .goal = scene.goals[0]};
    const auto plan = planner_.plan(space, query);
    if (!plan || !repairer_.plan(space, query)) return;
    for (std::size_t i = 0; i < args.moves; ++i) {
      const Workspace moved =
          with_one_moved(scene.workspace, obstacles, plan->curve, i % 2 == 0, random);
      const Space after = build(moved, static_cast<const Space*>(nullptr));
      measure_move(scene.workspace, moved, after, *plan, query, args.rounds);
    }
  }

  void print() const {
    static constexpr std::array<const char*, 4> kinds{"kept", "part", "anew", "all"};
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
      std::vector<double> ratios, repair, plan, longer, boxes, kept;
      for (const Measurement& m : measured_) {
        if (kind < 3 && kind != static_cast<std::size_t>(m.kind)) continue;
        ratios.push_back(m.repair_us / m.plan_us);
        repair.push_back(m.repair_us);
        plan.push_back(m.plan_us);
        longer.push_back(m.length_ratio);
        boxes.push_back(m.boxes_us);
        kept.push_back(m.kept);
      }
      if (ratios.empty()) continue;
      const auto mean = [](const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
      };
      std::printf(
          "%-26s %-4s %5zu  ratio median %.4f, of sums %.4f  repair %8.1f us, plan %8.1f us, "
          "boxes %5.1f us  kept %.2f  length %.5f, largest %.4f\n",
          name_.c_str(), kinds[kind], ratios.size(), median(ratios), mean(repair) / mean(plan),
          mean(repair), mean(plan), mean(boxes), mean(kept), mean(longer),
          *std::max_element(longer.begin(), longer.end()));
    }
    if (wrong_ > 0) std::printf("%s: %zu wrong\n", name_.c_str(), wrong_);
    std::fflush(stdout);
  }

  bool is_good() const { return wrong_ == 0; }

 private:
  void measure_move(const Workspace& before, const Workspace& moved, const Space& after,
                    const Plan& plan, const Query& query, std::size_t rounds) {
    const auto begin = Clock::now();
    const auto changed = changed_boxes(before, moved);
    const double boxes_us = micros_since(begin);
    double repair_us = std::numeric_limits<double>::infinity(), plan_us = repair_us;
    std::optional<Expected<Repaired, Failure>> repaired;
    std::optional<Expected<Plan, Failure>> anew;
    for (std::size_t round = 0; round < rounds; ++round) {
      const auto first = Clock::now();
      repaired.emplace(repair(repairer_, after, plan, revalidate(after, plan, changed), query));
      repair_us = std::min(repair_us, micros_since(first));
      const auto second = Clock::now();
      anew.emplace(planner_.plan(after, query));
      plan_us = std::min(plan_us, micros_since(second));
    }
    if (!anew->has_value() && !repaired->has_value()) return;
    if (!repaired->has_value()) {
      ++wrong_;
      return;
    }
    if (!anew->has_value()) return;
    const Repaired& result = **repaired;
    if (certify(after, result.plan.curve).status != ProofStatus::proved) ++wrong_;
    const double kept = (result.at_start.length + result.at_end.length) / plan.curve.length();
    measured_.push_back({result.kind, repair_us, plan_us, boxes_us,
                         result.plan.metrics.length / (*anew)->metrics.length, kept});
  }

  std::string name_;
  Planner<Search, Smooth> planner_, repairer_;
  std::vector<Measurement> measured_;
  std::size_t wrong_ = 0;
};

/// Every row in every world; their order is that of the arguments.
template <class... Rows>
bool run_rows(const Arguments& args, Rows... rows) {
  for (const std::size_t polygons : args.polygons) {
    std::printf("%zu polygons, %zu worlds from seed %llu on, %zu moves each\n", polygons,
                args.worlds, static_cast<unsigned long long>(args.seed), args.moves);
    for (std::uint64_t world = 0; world < args.worlds; ++world) {
      const Scene scene = polygon_worlds::make(polygons, args.seed + world);
      (rows.run(scene, args, args.seed + world), ...);
    }
    (rows.print(), ...);
  }
  return (rows.is_good() && ...);
}

int run(const Arguments& args) {
  const bool good =
      run_rows(args, Row<InflatedSpace, TangentGraph, NoSmoothing>("tangent_graph", {}, {}),
               Row<InflatedSpace, TangentGraph, ClothoidSmoother>("tangent_graph+clothoid", {}, {}),
               Row<LatticeSpace, AStar, NoSmoothing>("astar", {}, {}),
               Row<LatticeSpace, AStar, TautString>("astar+taut_string", {}, {}),
               Row<LatticeSpace, AStar, ClothoidSmoother>("astar+clothoid", {}, {}),
               Row<LatticeSpace, AStar, BezierSmoother>("astar+bezier", {}, {}));
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments args;
  args.polygons = {300};
  CLI::App app("Repairs of plans after one polygon has moved, beside new plans",
               "tutavia-bench-repair");
  app.add_option("--moves", args.moves, "Moves per world")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  return polygon_worlds::main(
      app, args, [&] { return run(args); }, argc, argv);
}
