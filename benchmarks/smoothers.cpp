// SPDX-License-Identifier: MIT
/// \file
/// All smoothers on routes of A* through worlds of polygons: time, the proof included, against the
/// time of a textbook A* for the same query, length against the taut string, and the time that a
/// robot takes along the result.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "baselines.hpp"
#include "polygon_worlds.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/motion/speed_profile.hpp"
#include "tutavia/registry.hpp"
#include "tutavia/space/lattice_space.hpp"

namespace {

using namespace tutavia;
using bench::Clock;
using bench::micros_since;
using bench::UsageError;
using bench::value_or_throw;

struct Arguments : polygon_worlds::Arguments {
  std::vector<std::string> smoothers;
};

/// What one smoother did in all worlds with one number of polygons.
struct Row {
  std::size_t polygons;
  std::string smoother;
  std::vector<double> micros{};  ///< least over the rounds, per world
  double of_textbook = 0;        ///< sums of shares over the worlds
  double over_taut = 0;
  double of_search = 0;
  double travel_s = 0;  ///< with default SpeedLimits; NaN where a curve cannot be driven
  double eased_s = 0;   ///< the same with a jerk of 1 m/s^3
  std::size_t evaluations = 0, failed = 0;

  double mean() const {
    double sum = 0;
    for (const double t : micros) sum += t;
    return sum / static_cast<double>(micros.size());
  }
  double per_world(double sum) const { return sum / static_cast<double>(micros.size()); }
};

double travel_time(const Curve& curve, const SpeedLimits& limits) {
  const auto profile = SpeedProfile::build(curve, limits);
  return profile ? profile->duration() : std::numeric_limits<double>::quiet_NaN();
}

/// One world and its route; times in turn within every round.
void run_world(const Scene& scene, const Route& route, const LatticeSpace& space,
               const std::vector<AnySmoother<LatticeSpace>>& smoothers, const Arguments& args,
               double search_us, std::vector<Row>& rows) {
  baseline::TextbookAStar textbook(space.grid());
  const Cell start = space.frame().nearest_cell(scene.start);
  const Cell goal = space.frame().nearest_cell(scene.goals[0]);
  const double taut = value_or_throw(TautString{}.smooth(space, route.curve, {})).length();
  double textbook_us = std::numeric_limits<double>::infinity();
  std::vector<double> best(smoothers.size(), textbook_us);
  for (std::size_t round = 0; round < args.rounds; ++round) {
    auto begin = Clock::now();
    const bool found = textbook(start, goal).cost < std::numeric_limits<double>::infinity();
    textbook_us = std::min(textbook_us, micros_since(begin));
    if (!found) throw UsageError{"the textbook A* found no path"};
    for (std::size_t s = 0; s < smoothers.size(); ++s) {
      begin = Clock::now();
      const auto curve = smoothers[s].smooth(space, route.curve, {});
      const Certificate proof = curve ? certify(space, *curve) : Certificate{};
      best[s] = std::min(best[s], micros_since(begin));
      if (round > 0) continue;
      Row& row = rows[s];
      if (proof.status != ProofStatus::proved) ++row.failed;
      row.evaluations += proof.evaluations;
      if (!curve) continue;
      row.over_taut += curve->length() / taut;
      row.travel_s += travel_time(*curve, {});
      row.eased_s += travel_time(*curve, {.max_jerk = 1});
    }
  }
  for (std::size_t s = 0; s < smoothers.size(); ++s) {
    rows[s].micros.push_back(best[s]);
    rows[s].of_textbook += best[s] / textbook_us;
    rows[s].of_search += best[s] / search_us;
  }
}

/// The worlds with one number of polygons that have a route.
std::vector<Row> run_worlds(std::size_t polygons,
                            const std::vector<AnySmoother<LatticeSpace>>& smoothers,
                            const Arguments& args) {
  std::vector<Row> rows;
  for (const auto& smoother : smoothers) rows.push_back({polygons, smoother.name});
  AStar::Scratch scratch;
  polygon_worlds::for_each_world(args, polygons, [&](const Scene& scene) {
    const LatticeSpace space =
        value_or_throw(LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}));
    NoObserver no_observer;
    const Query query{.start = scene.start, .goal = scene.goals[0]};
    double search_us = std::numeric_limits<double>::infinity();
    auto route = AStar{}.search(space, query, scratch, no_observer);
    if (!route) return false;
    for (std::size_t round = 0; round < args.rounds; ++round) {
      const auto begin = Clock::now();
      route = AStar{}.search(space, query, scratch, no_observer);
      search_us = std::min(search_us, micros_since(begin));
    }
    run_world(scene, *route, space, smoothers, args, search_us, rows);
    return true;
  });
  return rows;
}

void print(const Row& r) {
  std::printf("%8zu %-24s %10.1f %13.2f %12.2f %13.6f %9.1f %9.1f %12.0f %7zu\n", r.polygons,
              r.smoother.c_str(), r.mean(), 100 * r.per_world(r.of_textbook),
              100 * r.per_world(r.of_search), r.per_world(r.over_taut), r.per_world(r.travel_s),
              r.per_world(r.eased_s), r.per_world(static_cast<double>(r.evaluations)), r.failed);
  std::fflush(stdout);
}

std::string csv_text(const std::vector<Row>& rows) {
  std::string text =
      "polygons,smoother,worlds,mean_us,of_textbook_astar,of_astar,length_over_taut,travel_s,"
      "travel_with_jerk_s,evaluations,failed\n";
  char line[256];
  for (const Row& r : rows) {
    std::snprintf(line, sizeof line, "%zu,%s,%zu,%.3f,%.6f,%.6f,%.9f,%.3f,%.3f,%.1f,%zu\n",
                  r.polygons, r.smoother.c_str(), r.micros.size(), r.mean(),
                  r.per_world(r.of_textbook), r.per_world(r.of_search), r.per_world(r.over_taut),
                  r.per_world(r.travel_s), r.per_world(r.eased_s),
                  r.per_world(static_cast<double>(r.evaluations)), r.failed);
    text += line;
  }
  return text;
}

int run(const Arguments& args) {
  std::vector<AnySmoother<LatticeSpace>> chosen;
  for (const auto& smoother : all_smoothers<LatticeSpace>()) {
    const auto& names = args.smoothers;
    if (names.empty() || std::find(names.begin(), names.end(), smoother.name) != names.end()) {
      chosen.push_back(smoother);
    }
  }
  if (!args.smoothers.empty() && chosen.size() != args.smoothers.size()) {
    std::string known;
    for (const auto& smoother : all_smoothers<LatticeSpace>()) known += " " + smoother.name;
    throw UsageError{"--smoother: unknown or repeated name; known:" + known};
  }
  std::printf("100 x 100 m, lattice 0.25 m, worlds from seed %llu on; times with the proof\n",
              static_cast<unsigned long long>(args.seed));
  std::printf("%8s %-24s %10s %13s %12s %13s %9s %9s %12s %7s\n", "polygons", "smoother", "mean us",
              "% textbook A*", "% own A*", "length / taut", "travel s", "with jerk", "evaluations",
              "failed");
  std::vector<Row> rows;
  for (const std::size_t polygons : args.polygons) {
    for (const Row& row : run_worlds(polygons, chosen, args)) {
      print(row);
      rows.push_back(row);
    }
  }
  bench::write_if_named(args.csv, csv_text(rows));
  const bool good =
      std::all_of(rows.begin(), rows.end(), [](const Row& r) { return r.failed == 0; });
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments args;
  args.rounds = 5;
  CLI::App app("Smoothers on routes through worlds of polygons, their results proved",
               "tutavia-bench-smoothers");
  app.add_option("--smoother", args.smoothers, "Smoothers; all where none are named")
      ->delimiter(',');
  return polygon_worlds::main(
      app, args, [&] { return run(args); }, argc, argv);
}
