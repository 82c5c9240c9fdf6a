// SPDX-License-Identifier: MIT
/// \file
/// tutavia-reproduce: the tables of the papers on searches, with the figures of this library beside
/// the published ones, on grids that stand for those of the papers (which print none).

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "program.hpp"
#include "support/paper_maps.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/registry.hpp"

namespace {

using namespace tutavia;

/// Figures of one search, means over the grids of a set.
struct Figures {
  double nodes = 0, length = 0;
  double turning_angle = 0, turns = 0;  ///< [degrees]
  double time = 0;                      ///< here [us], in the papers of their own unit
};

/// A search as a table names it, and what the paper printed for it.
struct Contender {
  std::string name;
  AnySearch<CellSpace> search;
  std::optional<Figures> published{};
};

struct Arguments {
  std::vector<std::string> tables{"rea", "ssa"};
  std::size_t rounds = 5;
  std::string csv;
};

/// Runs all searches on all grids in turn; of the times the least over the rounds.
std::vector<Figures> measure_all(const std::vector<Contender>& contenders,
                                 std::span<const test::PaperTask> tasks, std::size_t rounds) {
  std::vector<Figures> all(contenders.size());
  const auto count = static_cast<double>(tasks.size());
  std::vector<detail::AnyScratch> scratch(contenders.size());
  NoObserver no_observer;
  for (const test::PaperTask& task : tasks) {
    std::vector<double> least(contenders.size(), std::numeric_limits<double>::infinity());
    for (std::size_t round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < contenders.size(); ++i) {
        const auto begin = bench::Clock::now();
        const auto route =
            contenders[i].search.search(task.space, task.query, scratch[i], no_observer);
        least[i] = std::min(least[i], bench::micros_since(begin));
        if (!route) throw bench::UsageError{contenders[i].name + ": " + route.error().detail};
        if (round > 0) continue;
        const PathMetrics metrics = measure(route->curve);
        all[i].nodes += static_cast<double>(route->stats.expanded) / count;
        all[i].length += metrics.length / count;
        all[i].turning_angle += metrics.turning_angle * 180 / std::numbers::pi / count;
        all[i].turns += static_cast<double>(metrics.turning_points) / count;
      }
    }
    for (std::size_t i = 0; i < contenders.size(); ++i) all[i].time += least[i] / count;
  }
  return all;
}

/// Prints figures beside the published ones; relative smoothness and time against `base`, the A* of
/// the table. Adds the lines of the CSV file.
void print_set(const std::string& set, const std::vector<Contender>& contenders,
               const std::vector<Figures>& ours, std::size_t base, std::string& csv) {
  std::printf("\n%-34s %15s %17s %17s %13s %11s %15s\n", set.c_str(), "nodes", "length",
              "turning deg", "turns", "RS", "time / A*");
  const std::optional<Figures>& published_base = contenders[base].published;
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const auto pair = [](double value, const std::optional<double>& published, int width,
                         int digits) {
      std::printf(" %*.*f ", width, digits, value);
      if (published) {
        std::printf("(%*.*f)", width, digits, *published);
      } else {
        std::printf("%*s", width + 2, "");
      }
    };
    const Figures& own = ours[i];
    const std::optional<Figures>& paper = contenders[i].published;
    const auto figure = [&](double Figures::*member) -> std::optional<double> {
      if (!paper || (*paper).*member < 0) return std::nullopt;
      return (*paper).*member;
    };
    const auto ratio = [&](double Figures::*member, bool inverse) -> std::optional<double> {
      const auto value = figure(member);
      if (!value || !published_base) return std::nullopt;
      const double of_base = (*published_base).*member;
      return inverse ? of_base / *value : *value / of_base;
    };
    const double smoothness = ours[base].turning_angle / own.turning_angle;
    std::printf("%-34s", contenders[i].name.c_str());
    pair(own.nodes, figure(&Figures::nodes), 6, 0);
    pair(own.length, figure(&Figures::length), 7, 2);
    pair(own.turning_angle, figure(&Figures::turning_angle), 7, 1);
    pair(own.turns, figure(&Figures::turns), 5, 1);
    pair(smoothness, ratio(&Figures::turning_angle, true), 4, 2);
    pair(own.time / ours[base].time, ratio(&Figures::time, false), 6, 3);
    std::printf("\n");
    std::array<char, 512> line{};
    std::snprintf(line.data(), line.size(), "%s,%s,%.3f,%.6f,%.4f,%.3f,%.4f,%.5f\n", set.c_str(),
                  contenders[i].name.c_str(), own.nodes, own.length, own.turning_angle, own.turns,
                  smoothness, own.time / ours[base].time);
    csv += line.data();
  }
}

template <class A>
Contender contender(std::string name, const A& algorithm,
                    const std::optional<Figures>& published = std::nullopt) {
  return {std::move(name), erase_search<CellSpace>(algorithm), published};
}

/// Table 2 of the paper "Improved REA*": nodes, length, turning angle, turns, time in seconds.
void print_rea(const Arguments& args, std::string& csv) {
  const std::array<std::array<Figures, 5>, 3> published{{
      {{{559, 98.63, 900, 19, 2.74},
        {31, 93.11, 675, 15, 0.14},
        {32, 96.29, 510.26, 12, 0.06},
        {25, 94.48, 531.08, 12, 0.27},
        {19, 87.84, 338.4, 10, 0.11}}},
      {{{1075, 168.47, 2070, 43, 5.1},
        {31, 146.28, 945, 21, 0.14},
        {21, 150.25, 852.97, 11, 0.04},
        {18, 166.78, 908.08, 13, 0.21},
        {13, 148.98, 858.17, 11, 0.09}}},
      {{{236, 66.5, 1305, 26, 1.19},
        {47, 64.25, 675, 15, 0.19},
        {39, 71.97, 1014.6, 27, 0.08},
        {23, 64.17, 423.11, 20, 0.27},
        {25, 64.06, 670.19, 23, 0.12}}},
  }};
  std::printf(
      "Improved REA*, table 2; in brackets what was published, of other maps of the kind\n");
  const auto maps = test::rea_maps();
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const test::PaperTask task = maps[i].task();
    const auto& paper = published[i];
    const std::vector<Contender> contenders{
        contender("A*", AStar{}, paper[0]),
        contender("JPS", Jps{}, paper[1]),
        contender("REA*", ReaStar{}, paper[2]),
        contender("SBREA*", SbReaStar{}, paper[3]),
        contender("improved REA*", ImprovedReaStar{}, paper[4]),
        contender("improved REA*, markers", ImprovedReaStar{.funnel = false}),
        contender("improved REA*, markers, last leg",
                  ImprovedReaStar{.exit_cost = ExitCost::last_leg, .funnel = false})};
    print_set("map " + maps[i].name, contenders, measure_all(contenders, {&task, 1}, args.rounds),
              0, csv);
  }
}

/// Means of table 2 of the paper on SSA-A* (35 x 35), and what table 3 says of the other sizes.
void print_ssa(const Arguments& args, std::string& csv) {
  struct Set {
    const char *name, *title;
    std::array<Figures, 4> published;  // A*, Dijkstra, SSA-A*, ants; time in milliseconds
    double fewer_nodes, longer;        // SSA-A* against A*, percent
  };
  const std::array<Set, 6> sets{{
      {"cluster_20", "20 x 20, clustered", {}, 67.17, 1.62},
      {"random_20", "20 x 20, random", {}, 72.52, 1.46},
      {"cluster_35",
       "35 x 35, clustered",
       {{{224.93, 52.575, -1, -1, 3.647},
         {633.73, 52.575, -1, -1, 4.349},
         {46.87, 53.361, -1, -1, 1.531},
         {220.67, 54.596, -1, -1, 32.12}}},
       78.87,
       1.48},
      {"random_35",
       "35 x 35, random",
       {{{287.4, 51.436, -1, -1, 2.624},
         {977.8, 51.436, -1, -1, 4.177},
         {46.53, 52.512, -1, -1, 0.921},
         {213.13, 54.721, -1, -1, 25.52}}},
       83.08,
       2.18},
      {"cluster_50", "50 x 50, clustered", {}, 81.86, 0.58},
      {"random_50", "50 x 50, random", {}, 86.1, 1.82},
  }};
  std::printf(
      "\nSSA-A*, tables 2 and 3; means over 15 grids, in brackets what was published, of other "
      "grids "
      "of the kind\n");
  for (const Set& set : sets) {
    const auto tasks = test::ssa_tasks(set.name);
    const auto paper = [&](std::size_t i) -> std::optional<Figures> {
      if (set.published[i].nodes == 0) return std::nullopt;
      return set.published[i];
    };
    const std::vector<Contender> contenders{
        contender("A*, Euclidean", AStar{.heuristic = HeuristicKind::euclidean}, paper(0)),
        contender("A*, octile", AStar{}), contender("Dijkstra", Dijkstra{}, paper(1)),
        contender("SSA-A*", SsaAStar{}, paper(2)), contender("ant colony", AntColony{}, paper(3))};
    const auto figures = measure_all(contenders, tasks, args.rounds);
    print_set(set.title, contenders, figures, 0, csv);
    std::printf("SSA-A* against A*: %.2f %% fewer nodes (%.2f), %.2f %% longer (%.2f)\n",
                100 * (1 - figures[3].nodes / figures[0].nodes), set.fewer_nodes,
                100 * (figures[3].length / figures[0].length - 1), set.longer);
  }
}

int run(const Arguments& args) {
  std::string csv =
      "set,search,nodes,length,turning_angle_deg,turns,relative_smoothness,time_ratio\n";
  for (const std::string& table : args.tables) {
    if (table == "rea") print_rea(args, csv);
    if (table == "ssa") print_ssa(args, csv);
  }
  bench::write_if_named(args.csv, csv);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments args;
  CLI::App app("The papers' tables on searches, published figures beside ours",
               "tutavia-reproduce");
  app.add_option("--tables", args.tables, "rea, ssa")
      ->delimiter(',')
      ->check(CLI::IsMember({"rea", "ssa"}));
  app.add_option("--rounds", args.rounds, "Least time over so many rounds")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--csv", args.csv, "Write the figures to a file");
  return bench::run_program(app, argc, argv, [&] { return run(args); });
}
