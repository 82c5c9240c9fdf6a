// SPDX-License-Identifier: MIT
/// \file
/// Driving among obstacles that appear: simulated runs on several maps with contacts, limits and
/// goals counted; or the time of one control step.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "../examples/drive/simulate.hpp"
#include "program.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/motion/local_planner.hpp"
#include "tutavia/motion/path_follower.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;
using namespace drive_program;
using bench::Clock;
using bench::micros_since;
using bench::UsageError;
using bench::value_or_throw;

struct Arguments {
  std::size_t runs = 200, obstacles = 12, steps = 2000;
  double noise = 0, latency = 0, radius = 0.3;
  std::uint64_t seed = 0;
  unsigned jobs = 1;
  std::string controller = "band";
  std::vector<std::string> maps{"array", "complex", "maze"};
  std::vector<std::string> grids;
  std::optional<std::uint64_t> only;
  bool measures_steps = false;
};

ControlOptions control_options(const Arguments& args) {
  return {.latency = args.latency, .position_error = args.noise, .heading_error = args.noise};
}

/// One run: its result, and whether what stays leaves a way to the goal.
struct Run {
  std::uint64_t seed = 0;
  bool exists = false;  // there is a path at all
  DriveResult result{};
};

/// A random free point in a box.
template <class S>
Point free_point(const S& space, const Box& box, Random& random, double clearance) {
  const Box b{space.bounds().clamp(box.min), space.bounds().clamp(box.max)};
  while (true) {
    const Point p{random.uniform(b.min.x(), b.max.x()), random.uniform(b.min.y(), b.max.y())};
    if (space.clearance(p) >= space.safety_radius() + clearance) return p;
  }
}

template <class S, Controller C>
DriveResult drive(const S& space, C controller, const Curve& path, const Arguments& args,
                  std::uint64_t seed, GlobalPlanner<S>& planner) {
  Random random(seed + 77);
  const ControlOptions control = control_options(args);
  Encounters encounters({.count = args.obstacles, .seed = seed});
  const SimulationOptions options{.control = control,
                                  .time_limit = 600 + 4 * path.length() / control.limits.max_speed,
                                  .patience = 90,
                                  .seed = seed};
  // The robot needs the odometry's errors as room, see MotionGate.
  const double margin = demanded_clearance(space.safety_radius(), control) - space.safety_radius();
  return simulate(space, controller, planner, encounters, {path.start(), random.uniform(-3, 3)},
                  path, options, margin);
}

/// A run between random points of a map.
template <class S>
Run run_once(const S& space, const Arguments& args, std::uint64_t seed) {
  Random random(seed);
  GlobalPlanner<S> planner(space, 0.1 + 3 * args.noise);
  Run run{.seed = seed};
  const double room = 0.1 + 3 * args.noise;
  for (int attempt = 0; attempt < 200 && !run.exists; ++attempt) {
    const Point start = free_point(space, space.bounds(), random, room);
    const Point goal = free_point(space, Box::around({start}).inflated(20), random, room);
    if (distance(start, goal) < 5 || distance(start, goal) > 25) continue;
    const auto path = planner.plan(start, goal);
    if (!path) continue;
    run.exists = true;
    const ControlOptions control = control_options(args);
    if (args.controller == "band") {
      run.result = drive(space, value_or_throw(LocalPlanner<S>::build(space, {.control = control})),
                         path->curve, args, seed, planner);
    } else {
      run.result = drive(space, value_or_throw(PathFollower<S>::build(space, {.control = control})),
                         path->curve, args, seed, planner);
    }
  }
  return run;
}

template <class S>
std::vector<Run> run_all(const S& space, const Arguments& args) {
  if (args.only) return {run_once(space, args, *args.only)};
  std::vector<Run> runs(args.runs);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < runs.size(); i = next++) {
      runs[i] = run_once(space, args, args.seed + i);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned k = 1; k < args.jobs; ++k) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return runs;
}

/// One line per map; false if something is counted that must not be.
bool print_runs(const std::string& name, const std::vector<Run>& runs) {
  std::size_t driven = 0, reached = 0, connected = 0, own = 0, into = 0, limits = 0,
              emergencies = 0, replans = 0;
  double time = 0, length = 0;
  for (const Run& run : runs) {
    if (!run.exists) continue;
    const DriveResult& result = run.result;
    ++driven;
    const bool is_there = result.ending == Ending::reached;
    reached += is_there ? 1 : 0;
    connected += is_there || result.is_connected.value_or(true) ? 1 : 0;
    own += result.own_contacts;
    into += result.driven_into;
    limits += result.limit_violations;
    emergencies += result.emergencies;
    replans += result.replans;
    time += result.time;
    length += result.length;
    if (!is_there || result.own_contacts + result.limit_violations > 0) {
      std::fprintf(stderr, "%s seed %llu: %s after %.1f s; %zu contacts, connected: %s; %s\n",
                   name.c_str(), static_cast<unsigned long long>(run.seed),
                   std::string(to_string(result.ending)).c_str(), result.time, result.own_contacts,
                   !result.is_connected   ? "unknown"
                   : *result.is_connected ? "yes"
                                          : "no",
                   result.reason.c_str());
    }
  }
  std::printf("%-16s %5zu %9zu %8zu %8zu %8zu %7zu %11zu %8zu %9.0f %10.0f\n", name.c_str(), driven,
              connected, reached, own, into, limits, emergencies, replans, time, length);
  std::fflush(stdout);
  return own + limits == 0 && 100 * reached >= 99 * connected;
}

bool measure_runs(const Arguments& args) {
  std::printf("%-16s %5s %9s %8s %8s %8s %7s %11s %8s %9s %10s\n", "map", "runs", "connected",
              "reached", "contacts", "into it", "limits", "emergencies", "replans", "time [s]",
              "length [m]");
  bool good = true;
  for (const std::string& name : args.maps) {
    const Scene scene = name == "array"     ? maps::array()
                        : name == "complex" ? maps::complex()
                                            : maps::maze();
    const auto space =
        value_or_throw(LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}));
    good = print_runs(name, run_all(space, args)) && good;
  }
  for (const std::string& path : args.grids) {
    const auto space = value_or_throw(
        CellSpace::build(value_or_throw(read_moving_ai_map(path)), {.safety_radius = args.radius}));
    good = print_runs(path.substr(path.find_last_of('/') + 1), run_all(space, args)) && good;
  }
  return good;
}

/// The quantile of sorted values.
double quantile(const std::vector<double>& sorted, double share) {
  return sorted[std::min(sorted.size() - 1,
                         static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

/// The time of control steps through a hall with 50 obstacles, a third of which move.
bool measure_steps(const Arguments& args) {
  Random random(args.seed);
  const InflatedSpace hall = value_or_throw(
      InflatedSpace::build({.bounds = {{0, 0}, {60, 12}}, .safety_radius = args.radius}));
  std::vector<MovingObstacle> obstacles;
  while (obstacles.size() < 50) {
    const Point center{random.uniform(3, 57), random.uniform(1, 11)};
    const double size = random.uniform(0.15, 0.4);
    MovingObstacle obstacle{Disc{center, size}};
    if (obstacles.size() % 3 == 1) obstacle.velocity = {random.uniform(-0.1, 0.1), 0.05};
    if (obstacles.size() % 3 == 2) {
      obstacle.shape = Polygon{{center, center + Point(size, 0), center + Point(0, size)}};
    }
    obstacles.push_back(obstacle);
  }
  auto planner =
      value_or_throw(LocalPlanner<InflatedSpace>::build(hall, {.control = control_options(args)}));
  const Point ends[] = {{1, 6}, {59, 6}};
  if (!planner.follow(Curve::polyline(ends))) return false;
  Pose pose{ends[0], 0};
  std::vector<double> times, quiet;
  double detours = 0, band = 0, gate = 0, iterations = 0, poses = 0;
  std::map<std::string, std::size_t> statuses, band_ends;
  for (std::size_t i = 0; i < args.steps; ++i) {
    const auto begin = Clock::now();
    const DriveCommand command = planner.step(pose, obstacles);
    times.push_back(micros_since(begin));
    const LocalPlannerReport& report = planner.report();
    if (!report.searched) quiet.push_back(times.back());
    detours += report.detours_us;
    band += report.band_us;
    gate += report.gate_us;
    iterations += report.band.iterations;
    poses += static_cast<double>(planner.band().poses.size());
    ++statuses[std::string(to_string(command.status))];
    ++band_ends[std::string(to_string(report.band.end))];
    if (command.status == DriveStatus::arrived) {
      std::reverse(std::begin(obstacles), std::end(obstacles));
      pose.position = ends[0];
      if (!planner.follow(Curve::polyline(ends))) return false;
    }
    pose = moved(pose, command.twist, 0.1);
    for (MovingObstacle& obstacle : obstacles) {
      const Box box = tutavia::detail::box_of(obstacle.shape);
      if (box.min.y() < 0.5 || box.max.y() > 11.5) obstacle.velocity = -obstacle.velocity;
      obstacle.shape = at_time(obstacle, 0.1);
    }
  }
  const auto count = static_cast<double>(times.size());
  const double sum = detours + band + gate;
  std::sort(times.begin(), times.end());
  std::sort(quiet.begin(), quiet.end());
  std::printf("steps %zu, of them %zu with a search for detours\n", times.size(),
              times.size() - quiet.size());
  std::printf("poses %.1f, iterations %.1f a step\n", poses / count, iterations / count);
  std::printf("all steps: p50 %.0f us, p99 %.0f us, most %.0f us\n", quantile(times, 0.5),
              quantile(times, 0.99), times.back());
  std::printf("without a search: p50 %.0f us, p99 %.0f us\n", quantile(quiet, 0.5),
              quantile(quiet, 0.99));
  std::printf("share of candidates %.2f, band %.2f, gate %.2f\n", detours / sum, band / sum,
              gate / sum);
  for (const auto& [name, number] : statuses) std::printf("  %s: %zu\n", name.c_str(), number);
  for (const auto& [name, number] : band_ends)
    std::printf("  band %s: %zu\n", name.c_str(), number);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Drives robots among obstacles that appear, and counts contacts and goals reached.",
               "tutavia-bench-drive"};
  Arguments args;
  app.add_option("--runs", args.runs, "Runs on each map")->capture_default_str();
  app.add_option("--obstacles", args.obstacles, "Obstacles that appear in a run")
      ->capture_default_str();
  app.add_option("--noise", args.noise, "Bound on the odometry's errors [m and rad]")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--latency", args.latency, "Until a command takes effect [s]")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--radius", args.radius, "Safety radius on grids and of --steps [m]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seed", args.seed, "Of the first run");
  app.add_option("--only", args.only, "This run alone");
  app.add_option("--jobs", args.jobs, "Threads")->check(CLI::Range(1, 1024));
  app.add_option("--controller", args.controller, "band or pursuit")
      ->check(CLI::IsMember({"band", "pursuit"}));
  app.add_option("--map", args.maps, "Built-in maps")
      ->delimiter(',')
      ->check(CLI::IsMember({"array", "complex", "maze", "none"}));
  app.add_option("--grid", args.grids, "MovingAI maps, of cells of 1 m")->delimiter(',');
  app.add_option("--steps", args.steps, "Measure so many control steps instead");
  return bench::run_program(app, argc, argv, [&] {
    if (args.maps == std::vector<std::string>{"none"}) args.maps.clear();
    const bool good = app.count("--steps") > 0 ? measure_steps(args) : measure_runs(args);
    return good ? 0 : 1;
  });
}
