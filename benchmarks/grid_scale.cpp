// SPDX-License-Identifier: MIT
/// \file
/// tutavia-bench-grid-scale: a huge grid, memory, and batches.
///
/// Without arguments: a grid of 16,384 x 16,384 cells, a tenth of it covered by random rectangles,
/// is crossed from corner to corner by A* and by JPS; what the process holds is printed after each
/// step. Then a batch of queries on a 1024 x 1024 part of the same kind, on one thread and on all.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tutavia/batch.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t seed = 1;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Resident memory now, in MiB (Linux; 0 elsewhere).
double resident_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmRSS:", 0) == 0) return std::atof(line.c_str() + 6) / 1024;
  }
  return 0;
}

/// A tenth of the cells covered by rectangles of 4 to 64 cells a side; the corners stay free.
OccupancyGrid rectangles(int side) {
  Random random(seed);
  OccupancyGrid grid = OccupancyGrid::blocked(side, side).value();
  for (int y = 0; y < side; ++y) grid.set_run(y, 0, side - 1, true);
  const auto upto = [&](int n) { return static_cast<int>(random.below(static_cast<unsigned>(n))); };
  const double wanted = 0.1 * side * static_cast<double>(side);
  for (double covered = 0; covered < wanted;) {
    const int w = 4 + upto(61), h = 4 + upto(61), x = upto(side - w), y = upto(side - h);
    for (int k = 0; k < h; ++k) grid.set_run(y + k, x, x + w - 1, false);
    covered += static_cast<double>(w) * h;
  }
  grid.set_run(0, 0, 0, true);
  grid.set_run(side - 1, side - 1, side - 1, true);
  return grid;
}

template <class A>
void cross(const CellSpace& space, const A& algorithm) {
  const int last = space.grid().width() - 1;
  const Query query{.start = space.frame().point({0, 0}),
                    .goal = space.frame().point({last, last})};
  const double before = resident_mib();
  typename A::Scratch scratch;
  NoObserver no_observer;
  const auto start = Clock::now();
  const auto route = algorithm.search(space, query, scratch, no_observer);
  const double time = seconds_since(start);
  if (!route) {
    std::printf("%-16s %s\n", std::string(A::name).c_str(), route.error().detail.c_str());
    return;
  }
  const double held = resident_mib() - before;
  std::printf(
      "%-16s length %.3f, %llu expanded, %llu labelled, %.3f s, %.0f MiB held (%.1f bytes "
      "per cell labelled)\n",
      std::string(A::name).c_str(), route->cost,
      static_cast<unsigned long long>(route->stats.expanded),
      static_cast<unsigned long long>(route->stats.generated), time, held,
      held * 1048576 / static_cast<double>(route->stats.generated));
}

void batch() {
  const auto space = CellSpace::build(rectangles(1024)).value();
  Random random(seed + 1);
  std::vector<Query> queries;
  while (queries.size() < 2000) {
    const Cell a{static_cast<int>(random.below(1024)), static_cast<int>(random.below(1024))};
    const Cell b{static_cast<int>(random.below(1024)), static_cast<int>(random.below(1024))};
    if (!space.grid().is_free(a) || !space.grid().is_free(b)) continue;
    queries.push_back({.start = space.frame().point(a), .goal = space.frame().point(b)});
  }
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  const Planner planner{AStar{}};
  double one = 1e300, all = 1e300;
  for (int round = 0; round < 5; ++round) {
    auto start = Clock::now();
    plan_batch(planner, space, queries, 1);
    one = std::min(one, seconds_since(start));
    start = Clock::now();
    plan_batch(planner, space, queries, cores);
    all = std::min(all, seconds_since(start));
  }
  std::printf("batch of %zu plans: %.3f s on 1 thread, %.3f s on %u, efficiency %.2f\n",
              queries.size(), one, all, cores, one / all / cores);
}

}  // namespace

int main() {
  constexpr int side = 16384;
  const double empty = resident_mib();
  const auto space = CellSpace::build(rectangles(side)).value();
  std::printf("%d x %d cells: %.0f MiB\n", side, side, resident_mib() - empty);
  cross(space, AStar{});
  cross(space, AStar{.successors = AStar::Successors::all});
  const double before = resident_mib();
  auto start = Clock::now();
  space.turn_planes();
  std::printf("planes of jumps: %.0f MiB, %.2f s\n", resident_mib() - before, seconds_since(start));
  cross(space, Jps{});
  batch();
  return 0;
}
