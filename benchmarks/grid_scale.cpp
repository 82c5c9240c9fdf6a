// SPDX-License-Identifier: MIT
/// \file
/// tutavia-bench-grid-scale: how memory and time grow with the size of a grid.
///
/// With --map: the map with every cell doubled, doubled again and so on; for each size and search
/// the time per query and per expansion, what is prepared, and what it takes.
///
/// Without: a grid of 16,384 x 16,384 cells, a tenth of it covered by random rectangles, is crossed
/// from corner to corner by A* and by JPS; what the process holds is printed after each step. Then
/// a batch of queries on the same grid, on one thread and on all.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "log_log_chart.hpp"
#include "map_benchmark.hpp"
#include "tutavia/batch.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/search/any_angle.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/jps_plus.hpp"
#include "tutavia/search/theta_star.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace map_benchmark;

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

void batch(const CellSpace& space) {
  Random random(seed + 1);
  const auto side = static_cast<unsigned>(space.grid().width());
  const auto draw = [&] { return static_cast<int>(random.below(side)); };
  std::vector<Query> queries;
  while (queries.size() < 200) {
    const Cell a{draw(), draw()}, b{draw(), draw()};
    if (!space.grid().is_free(a) || !space.grid().is_free(b)) continue;
    queries.push_back({.start = space.frame().point(a), .goal = space.frame().point(b)});
  }
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  const Planner planner{Jps{}};
  double one = 1e300, all = 1e300;
  for (int round = 0; round < 3; ++round) {
    auto start = Clock::now();
    plan_batch(planner, space, queries, 1);
    one = std::min(one, seconds_since(start));
    start = Clock::now();
    plan_batch(planner, space, queries, cores);
    all = std::min(all, seconds_since(start));
  }
  std::printf("batch of %zu plans by JPS: %.3f s on 1 thread, %.3f s on %u, efficiency %.2f\n",
              queries.size(), one, all, cores, one / all / cores);
}

void cross_large_grid() {
  constexpr int side = 16384;
  const double empty = resident_mib();
  const auto space = CellSpace::build(rectangles(side)).value();
  std::printf("%d x %d cells: %.0f MiB\n", side, side, resident_mib() - empty);
  cross(space, AStar{});
  cross(space, AStar{.successors = AStar::Successors::all});
  const double before = resident_mib();
  const auto start = Clock::now();
  space.turn_planes();
  std::printf("planes of jumps: %.0f MiB, %.2f s\n", resident_mib() - before, seconds_since(start));
  cross(space, Jps{});
  batch(space);
}

/// A map with every cell replaced by `scale` x `scale` cells.
OccupancyGrid enlarged(const OccupancyGrid& map, int scale) {
  OccupancyGrid grid = value_or_throw(OccupancyGrid::blocked(std::int64_t{map.width()} * scale,
                                                             std::int64_t{map.height()} * scale));
  for (int y = 0; y < map.height(); ++y) {
    map.for_each_run(y, true, [&](int first, int last) {
      for (int k = 0; k < scale; ++k) {
        grid.set_run(scale * y + k, scale * first, scale * last + scale - 1, true);
      }
    });
  }
  return grid;
}

struct GrowthArguments {
  std::string map, scen, svg;
  int largest = 8;
  std::size_t queries = 10, rounds = 3;
};

/// The searches whose growth is measured, with what they prepare.
std::vector<std::pair<std::string, MakeEngine>> growing_searches() {
  const auto mesh = [](const CellSpace& s) {
    return prepared_engine<AnyAngle>(s, grid_bytes(s), [](const auto& m) { return AnyAngle{m}; });
  };
  const auto jps = [](const CellSpace& s) {
    const auto start = Clock::now();
    s.turn_planes();
    const double prepare_ms = micros_since(start) / 1000;
    Engine result = engine(s, Jps{}, grid_bytes(s) + plane_bytes(s));
    result.preprocess_ms = prepare_ms;
    return result;
  };
  const auto jps_plus = [](const CellSpace& s) {
    return prepared_engine<JpsPlus>(s, grid_bytes(s), [](const auto& t) { return JpsPlus{t}; });
  };
  return {{"astar", [](const CellSpace& s) { return engine(s, AStar{}, grid_bytes(s)); }},
          {"jps", jps},
          {"jps_plus", jps_plus},
          {"theta_star", [](const CellSpace& s) { return engine(s, ThetaStar{}, grid_bytes(s)); }},
          {"any_angle", [](const CellSpace& s) { return engine(s, AnyAngle{}, grid_bytes(s)); }},
          {"any_angle_mesh", mesh}};
}

/// Means of one search on one map.
struct Growth {
  double micros = 0, expanded = 0;
};

Growth measure_growth(const Engine& engine, const std::vector<ScenarioRow>& queries, int scale,
                      std::size_t rounds) {
  Growth sum;
  for (const ScenarioRow& row : queries) {
    const Cell start{scale * row.start.x, scale * row.start.y};
    const Cell goal{scale * row.goal.x, scale * row.goal.y};
    double least = 1e300;
    Engine::Answer answer;
    for (std::size_t round = 0; round < rounds; ++round) {
      const auto begin = Clock::now();
      answer = engine.run(start, goal);
      least = std::min(least, micros_since(begin));
    }
    if (!std::isfinite(answer.cost)) throw UsageError{"a query of the scenario has no path"};
    sum.micros += least;
    sum.expanded += static_cast<double>(answer.expanded);
  }
  const auto count = static_cast<double>(queries.size());
  return {sum.micros / count, sum.expanded / count};
}

int show_growth(const GrowthArguments& args) {
  const OccupancyGrid map = value_or_throw(read_moving_ai_map(args.map));
  const std::vector<ScenarioRow> queries = strided_rows(args.scen, map, args.queries);
  std::printf(
      "| cells | search | prepared in | bytes per cell | us per query | expanded | ns per "
      "expansion |\n"
      "|---|---|---|---|---|---|---|\n");
  std::vector<bench::ChartLine> lines;
  for (int scale = 1; scale <= args.largest; scale *= 2) {
    const auto space = value_or_throw(CellSpace::build(enlarged(map, scale)));
    const double cells = double(space.grid().width()) * space.grid().height();
    std::size_t i = 0;
    for (const auto& [name, make] : growing_searches()) {
      const Engine engine = make(space);
      const Growth growth = measure_growth(engine, queries, scale, args.rounds);
      std::printf("| %.3g M | %s | %.2f ms | %.2f | %.1f | %.0f | %.0f |\n", cells / 1e6,
                  name.c_str(), engine.preprocess_ms, static_cast<double>(engine.bytes) / cells,
                  growth.micros, growth.expanded, 1000 * growth.micros / growth.expanded);
      std::fflush(stdout);
      if (lines.size() <= i) lines.push_back({name, {}});
      lines[i++].points.emplace_back(cells / 1e6, growth.micros);
    }
  }
  bench::write_if_named(args.svg, bench::log_log_chart("million cells", "us per query", lines));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  GrowthArguments args;
  CLI::App app("Memory and time of searches as grids grow", "tutavia-bench-grid-scale");
  auto* map = app.add_option("--map", args.map, "Map (.map) to enlarge");
  auto* scen = app.add_option("--scen", args.scen, "Its scenarios (.scen)");
  map->needs(scen);
  scen->needs(map);
  app.add_option("--largest", args.largest, "Largest factor of its sides, a power of two")
      ->capture_default_str()
      ->check(CLI::Range(1, 64));
  add_counts(app, args.queries, args.rounds);
  app.add_option("--svg", args.svg, "Draw the times per query to a file");
  return bench::run_program(app, argc, argv, [&] {
    if (!args.map.empty()) return show_growth(args);
    cross_large_grid();
    return 0;
  });
}
