// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "program.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// Worlds of convex polygons for benchmarks on workspaces.

namespace polygon_worlds {

using namespace tutavia;

/// How large the polygons are, and the robot, so that about as much of the world is free with any
/// number of them.
struct Sizes {
  double smallest, largest, safety_radius;  // [m]
};

inline Sizes sizes_of(std::size_t polygons) {
  if (polygons <= 16) return {4, 9, 0.5};
  if (polygons <= 100) return {1.5, 4, 0.4};
  if (polygons <= 300) return {1, 2.4, 0.3};
  return {0.5, 1.4, 0.2};
}

/// 100 x 100 m with convex polygons of 4 to 8 vertices on circles, the angles between neighbouring
/// vertices between 0.35 and 2.8 rad; they may overlap, but keep half a metre more than the safety
/// radius from start and goal, which lie in opposite corners.
inline Scene make(std::size_t polygons, std::uint64_t seed) {
  Random random(seed);
  const Sizes sizes = sizes_of(polygons);
  Scene scene;
  scene.workspace = {
      .bounds = {{0, 0}, {100, 100}}, .safety_radius = sizes.safety_radius, .obstacles = {}};
  scene.start = {2.125, 2.125};
  scene.goals = {{97.875, 97.875}};
  scene.resolution = 0.25;
  while (scene.workspace.obstacles.size() < polygons) {
    const double radius = random.uniform(sizes.smallest, sizes.largest);
    const Point centre{random.uniform(0, 100), random.uniform(0, 100)};
    const double gap = radius + sizes.safety_radius + 0.5;
    if (distance(centre, scene.start) < gap || distance(centre, scene.goals[0]) < gap) continue;
    std::vector<double> angles(4 + random.below(5));
    for (double& angle : angles) angle = random.uniform(0, 2 * std::numbers::pi);
    std::sort(angles.begin(), angles.end());
    bool spread = true;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * std::numbers::pi;
      spread = spread && next - angles[i] >= 0.35 && next - angles[i] <= 2.8;
    }
    if (!spread) continue;
    Ring ring;
    for (const double a : angles) {
      ring.push_back({centre.x() + radius * std::cos(a), centre.y() + radius * std::sin(a)});
    }
    scene.workspace.obstacles.emplace_back(Polygon{std::move(ring)});
  }
  return scene;
}

/// What benchmarks on these worlds are asked.
struct Arguments {
  std::vector<std::size_t> polygons{16, 100, 300, 1000};
  std::size_t worlds = 20, rounds = 3;
  std::uint64_t seed = 1;
  std::string csv;
};

/// Calls `run_world(scene)` for worlds with so many polygons until it has returned true, for a
/// world that has a route, as often as is asked.
template <class RunWorld>
void for_each_world(const Arguments& args, std::size_t polygons, const RunWorld& run_world) {
  std::uint64_t seed = args.seed;
  for (std::size_t world = 0; world < args.worlds; ++seed) {
    if (seed > args.seed + 100 * args.worlds) {
      throw bench::UsageError{"too few worlds have a route"};
    }
    if (run_world(make(polygons, seed))) ++world;
  }
}

/// The program: its options (those of its own are in `app` already), its errors on one line, exit
/// code 2 for bad usage.
template <class Run>
int main(CLI::App& app, Arguments& args, const Run& run, int argc, char** argv) {
  app.add_option("--polygons", args.polygons, "Numbers of polygons")
      ->delimiter(',')
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}));
  app.add_option("--worlds", args.worlds, "Worlds per number of polygons")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--rounds", args.rounds, "Least time over so many rounds")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", args.seed, "Of the first world")->capture_default_str();
  app.add_option("--csv", args.csv, "Write the figures to a file");
  return bench::run_program(app, argc, argv, run);
}

}  // namespace polygon_worlds
