// SPDX-License-Identifier: MIT
/// \file
/// The shortest path of a disc among polygons: its time, without and with prepared tangents, beside
/// A* and AutoSearch on a lattice, and how much longer other paths are; and the time to prepare
/// tangents, and to update them when one polygon moves.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "polygon_worlds.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/auto_search.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/search/theta_star.hpp"
#include "tutavia/smooth/homotopy_refine.hpp"
#include "tutavia/smooth/shortcut.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/changed_boxes.hpp"

namespace {

using namespace tutavia;
using bench::Clock;
using bench::micros_since;
using bench::UsageError;
using bench::value_or_throw;

const std::vector<std::string> kinds{"astar",       "astar+shortcut",   "theta_star",
                                     "taut(astar)", "taut(theta_star)", "taut+homotopy_refine"};

/// Sums over the worlds with one number of polygons.
struct Row {
  std::size_t polygons = 0, worlds = 0, wrong = 0;
  double astar_us = 0, auto_us = 0, optimum_us = 0, prepared_us = 0, prepare_ms = 0, update_ms = 0,
         expanded = 0;
  double slowest_us = 0, slowest_prepared_us = 0;
  std::vector<double> ratios = std::vector<double>(kinds.size(), 0.0);

  double mean(double sum) const { return sum / static_cast<double>(worlds); }
};

/// The least time over the rounds, and the last answer.
template <class Run>
auto timed(std::size_t rounds, double& micros, const Run& run) {
  auto result = run();
  micros = std::numeric_limits<double>::infinity();
  for (std::size_t round = 0; round < rounds; ++round) {
    const auto begin = Clock::now();
    result = run();
    micros = std::min(micros, micros_since(begin));
  }
  return result;
}

/// Moves a polygon by a metre and back again. The least time of one update, in microseconds;
/// negative where the tangents are not the same as before.
double update_time(const Workspace& workspace, const TangentVisibilityGraph& tangents,
                   std::size_t rounds) {
  Workspace moved = workspace;
  auto& polygon = std::get<Polygon>(moved.obstacles[moved.obstacles.size() / 2]);
  for (Point& p : polygon.outer) p.x() += p.x() < 50 ? 1 : -1;
  const InflatedSpace here = value_or_throw(InflatedSpace::build(workspace));
  const InflatedSpace there = value_or_throw(InflatedSpace::build(moved));
  const auto changed = changed_boxes(workspace, moved);
  double forth = 0, back = 0;
  const auto after =
      value_or_throw(timed(rounds, forth, [&] { return tangents.updated(there, changed); }));
  const auto again =
      value_or_throw(timed(rounds, back, [&] { return after.updated(here, changed); }));
  return again == tangents ? 0.5 * (forth + back) : -1;
}

/// False where A* has no route.
bool run_world(const Scene& scene, std::size_t rounds, Row& row) {
  const LatticeSpace space =
      value_or_throw(LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}));
  const Query query{.start = scene.start, .goal = scene.goals[0]};
  NoObserver no_observer;
  AStar::Scratch astar;
  double astar_us = 0, optimum_us = 0, prepared_us = 0;
  const auto route =
      timed(rounds, astar_us, [&] { return AStar{}.search(space, query, astar, no_observer); });
  if (!route) return false;
  AutoSearch::Scratch auto_scratch;
  double auto_us = 0;
  const auto auto_route = timed(rounds, auto_us, [&] {
    return AutoSearch{}.search(space, query, auto_scratch, no_observer);
  });
  if (!auto_route || auto_route->cost != route->cost) ++row.wrong;
  detail::TangentScratch scratch;
  const auto optimum = timed(rounds, optimum_us, [&] {
    return TangentGraph{}.search(space, query, scratch, no_observer);
  });
  if (!optimum) throw UsageError{"the tangent graph found no path"};
  const auto begin = Clock::now();
  const TangentGraph prepared{.tangents = value_or_throw(TangentGraph::prepare(space))};
  row.prepare_ms += micros_since(begin) / 1000;
  const double update_us = update_time(scene.workspace, *prepared.tangents, rounds);
  row.update_ms += update_us / 1000;
  if (update_us < 0) ++row.wrong;
  const auto again = timed(rounds, prepared_us,
                           [&] { return prepared.search(space, query, scratch, no_observer); });

  const double length = optimum->curve.length();
  const bool is_proved = certify(space, optimum->curve).status == ProofStatus::proved;
  if (!is_proved || !again || std::abs(again->cost - length) > 1e-9 * length) ++row.wrong;
  ThetaStar::Scratch theta;
  const Curve at_angles =
      value_or_throw(ThetaStar{}.search(space, query, theta, no_observer)).curve;
  const Curve taut = value_or_throw(TautString{}.smooth(space, route->curve, {}));
  const Curve curves[] = {route->curve,
                          value_or_throw(Shortcut{}.smooth(space, route->curve, {})),
                          at_angles,
                          taut,
                          value_or_throw(TautString{}.smooth(space, at_angles, {})),
                          value_or_throw(HomotopyRefine{}.smooth(space, taut, {}))};
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    row.ratios[k] += curves[k].length() / length;
    if (curves[k].length() < length * (1 - 1e-9)) ++row.wrong;
  }
  ++row.worlds;
  row.astar_us += astar_us;
  row.auto_us += auto_us;
  row.optimum_us += optimum_us;
  row.prepared_us += prepared_us;
  row.slowest_us = std::max(row.slowest_us, optimum_us);
  row.slowest_prepared_us = std::max(row.slowest_prepared_us, prepared_us);
  row.expanded += static_cast<double>(optimum->stats.expanded);
  return true;
}

int run(const polygon_worlds::Arguments& args) {
  std::printf("100 x 100 m, lattice 0.25 m, worlds from seed %llu on\n",
              static_cast<unsigned long long>(args.seed));
  std::string csv =
      "polygons,worlds,astar_us,auto_us,optimum_us,slowest_us,prepared_us,slowest_prepared_us,"
      "prepare_ms,"
      "update_ms,expanded,wrong";
  for (const std::string& kind : kinds) csv += "," + kind;
  csv += '\n';
  bool good = true;
  for (const std::size_t polygons : args.polygons) {
    Row row;
    row.polygons = polygons;
    polygon_worlds::for_each_world(
        args, polygons, [&](const Scene& scene) { return run_world(scene, args.rounds, row); });
    std::printf(
        "%zu polygons: A* %.1f us, auto %.3f x A*, optimum %.1f us (%.2f x A*, slowest %.1f us), "
        "prepared %.1f us "
        "(%.2f x A*, slowest %.1f us; prepared in %.1f ms, updated in %.2f ms), %.0f expansions, "
        "%zu wrong\n",
        polygons, row.mean(row.astar_us), row.auto_us / row.astar_us, row.mean(row.optimum_us),
        row.optimum_us / row.astar_us, row.slowest_us, row.mean(row.prepared_us),
        row.prepared_us / row.astar_us, row.slowest_prepared_us, row.mean(row.prepare_ms),
        row.mean(row.update_ms), row.mean(row.expanded), row.wrong);
    std::printf("  length / optimum:");
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      std::printf(" %s %.5f", kinds[k].c_str(), row.mean(row.ratios[k]));
    }
    std::puts("");
    std::fflush(stdout);
    char line[256];
    std::snprintf(line, sizeof line, "%zu,%zu,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.1f,%zu",
                  polygons, row.worlds, row.mean(row.astar_us), row.mean(row.auto_us),
                  row.mean(row.optimum_us), row.slowest_us, row.mean(row.prepared_us),
                  row.slowest_prepared_us, row.mean(row.prepare_ms), row.mean(row.update_ms),
                  row.mean(row.expanded), row.wrong);
    csv += line;
    for (const double ratio : row.ratios) {
      std::snprintf(line, sizeof line, ",%.7f", row.mean(ratio));
      csv += line;
    }
    csv += '\n';
    good = good && row.wrong == 0;
  }
  bench::write_if_named(args.csv, csv);
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  polygon_worlds::Arguments args;
  CLI::App app("The shortest path of a disc among polygons, beside other paths",
               "tutavia-bench-optimum");
  return polygon_worlds::main(
      app, args, [&] { return run(args); }, argc, argv);
}
