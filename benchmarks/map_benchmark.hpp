// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "baselines.hpp"
#include "program.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// What the benchmarks on MovingAI maps have in common: searches in turn on the same queries, every
/// answer checked, least times over rounds, a table and a CSV file.

namespace map_benchmark {

using namespace tutavia;
using bench::Clock;
using bench::micros_since;
using bench::UsageError;
using bench::value_or_throw;

/// One search, ready for queries on one map.
struct Engine {
  struct Answer {
    double cost = std::numeric_limits<double>::infinity();
    std::uint64_t expanded = 0;
    std::uint64_t generated = 0;
    Curve curve{};
    std::uint64_t distinct = 0;  ///< nodes expanded at least once; 0: not counted
  };
  std::function<Answer(Cell, Cell)> run;
  double preprocess_ms = 0;
  std::size_t bytes = 0;  ///< of the map with everything prepared for it
};

using MakeEngine = std::function<Engine(const CellSpace&)>;
using Engines = std::map<std::string, MakeEngine>;

inline std::size_t grid_bytes(const CellSpace& space) { return space.grid().words().size() * 8; }

inline std::size_t plane_bytes(const CellSpace& space) {  // of jump point search
  return space.stop_planes().memory() + space.turn_planes().memory();
}

/// A search of the library between the centres of cells.
template <class A>
Engine engine(const CellSpace& space, const A& algorithm, std::size_t bytes) {
  auto scratch = std::make_shared<typename A::Scratch>();
  const auto run = [&space, algorithm, scratch](Cell start, Cell goal) -> Engine::Answer {
    NoObserver no_observer;
    const Query query{.start = space.frame().point(start), .goal = space.frame().point(goal)};
    auto route = algorithm.search(space, query, *scratch, no_observer);
    if (!route) return {};
    return {route->cost, route->stats.expanded, route->stats.generated, std::move(route->curve),
            route->stats.distinct.value_or(0)};
  };
  return {run, 0, bytes};
}

/// The same with what it prepares for the map, timed; `with(prepared)` makes the algorithm.
template <class A, class With>
Engine prepared_engine(const CellSpace& space, std::size_t bytes, const With& with) {
  const auto start = Clock::now();
  const auto prepared = value_or_throw(A::prepare(space));
  const double prepare_ms = micros_since(start) / 1000;
  Engine result = engine(space, with(prepared), bytes + prepared->memory());
  result.preprocess_ms = prepare_ms;
  return result;
}

template <class Baseline, class... Options>
Engine baseline_engine(const CellSpace& space, Options... options) {
  const auto start = Clock::now();
  auto search = std::make_shared<Baseline>(space.grid(), options...);
  Engine result;
  result.preprocess_ms = micros_since(start) / 1000;
  result.run = [search](Cell from, Cell to) -> Engine::Answer {
    const baseline::Answer answer = (*search)(from, to);
    Curve curve;
    for (std::size_t i = answer.path.size(); i > 1; --i) {
      curve.push_back(Segment{answer.path[i - 1], answer.path[i - 2]});
    }
    return {answer.cost, answer.expanded, answer.generated, std::move(curve)};
  };
  return result;
}

/// What a benchmark compares, and how it tells right from wrong.
struct Benchmark {
  std::string name, description;
  Engines engines;
  std::vector<std::string> searches;  ///< run where none are named
  bool compares_lengths = false;      ///< with columns for lengths and vertices
  /// For one map: the optimal length of a row.
  std::function<std::function<double(const ScenarioRow&)>(const CellSpace&)> optimum;
  /// Whether an answer is right, given the optimal length.
  std::function<bool(const CellSpace&, const std::string& search, const Engine::Answer&,
                     double optimal)>
      is_right;
};

/// What one search did on one map.
struct Row {
  std::string map, search;
  std::vector<double> micros;  ///< least over the rounds, per query
  std::uint64_t expanded = 0, generated = 0, distinct = 0;
  std::size_t wrong = 0, failed = 0;
  double preprocess_ms = 0, bytes_per_cell = 0;
  double sum_of_ratios = 0, max_ratio = 0;  ///< length / optimal
  std::size_t vertices = 0;                 ///< of all paths, ends included

  /// Counts one answer.
  void count(const Engine::Answer& answer, double optimal, bool is_right) {
    expanded += answer.expanded;
    generated += answer.generated;
    distinct += answer.distinct;
    if (!std::isfinite(answer.cost)) {
      ++failed;
      return;
    }
    if (!is_right) ++wrong;
    const double ratio = optimal > 0 ? answer.cost / optimal : 1;
    sum_of_ratios += ratio;
    max_ratio = std::max(max_ratio, ratio);
    vertices += answer.curve.pieces().size() + 1;
  }

  double answers() const {
    return static_cast<double>(std::max<std::size_t>(1, micros.size() - failed));
  }
  double mean_ratio() const { return sum_of_ratios / answers(); }
  double mean_vertices() const { return static_cast<double>(vertices) / answers(); }
  double mean() const {
    double sum = 0;
    for (const double t : micros) sum += t;
    return micros.empty() ? 0 : sum / static_cast<double>(micros.size());
  }
  double percentile(double p) const {
    std::vector<double> sorted = micros;
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty()
               ? 0
               : sorted[static_cast<std::size_t>(p * static_cast<double>(sorted.size() - 1) + 0.5)];
  }
};

/// The order in which searches and queries take turns within a round, and with it what the caches
/// hold when a query starts.
enum class Caches {
  shared,  ///< a search answers all queries once: its own data, as far as they are not too many
  warm,    ///< a search answers all queries three times, the last two are timed
  cold,    ///< all searches answer one query before the next, and each starts after 8 MB of others'
};

struct Arguments {
  std::string map, scen, all, csv;
  std::vector<std::string> searches;
  std::size_t queries = 50, rounds = 3;
  Caches caches = Caches::shared;
};

/// Replaces what the first two levels of cache hold.
inline void sweep_caches() {
  static std::vector<unsigned char> memory(std::size_t{8} << 20);
  for (std::size_t i = 0; i < memory.size(); i += 64) ++memory[i];
}

/// Calls `run(search, query, is_timed)` in the order of the caches.
template <class Run>
void take_turns(Caches caches, std::size_t searches, std::size_t queries, const Run& run) {
  if (caches == Caches::cold) {
    for (std::size_t q = 0; q < queries; ++q) {
      for (std::size_t s = 0; s < searches; ++s) {
        sweep_caches();
        run(s, q, true);
      }
    }
    return;
  }
  const int times = caches == Caches::warm ? 3 : 1;
  for (std::size_t s = 0; s < searches; ++s) {
    for (int time = 0; time < times; ++time) {
      for (std::size_t q = 0; q < queries; ++q) run(s, q, times == 1 || time > 0);
    }
  }
}

/// At most `count` rows of a map's scenarios, evenly strided.
inline std::vector<ScenarioRow> strided_rows(const std::string& scen, const OccupancyGrid& map,
                                             std::size_t count) {
  const auto scenario = value_or_throw(read_moving_ai_scenario(scen));
  if (const auto fits = check_scenario(scenario, map); !fits) {
    throw UsageError{scen + ": " + fits.error().detail};
  }
  std::vector<ScenarioRow> rows;
  count = std::min(count, scenario.size());
  for (std::size_t i = 0; i < count; ++i) rows.push_back(scenario[i * scenario.size() / count]);
  return rows;
}

/// Adds the options for the numbers of queries and rounds.
inline void add_counts(CLI::App& app, std::size_t& queries, std::size_t& rounds) {
  app.add_option("--queries", queries, "Rows of the scenario, evenly strided")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--rounds", rounds, "Least time over so many rounds")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
}

/// Runs all searches on one map, in turn within every round.
inline std::vector<Row> run_map(const Benchmark& benchmark, const std::string& map,
                                const std::string& scen, const Arguments& args) {
  auto grid = value_or_throw(read_moving_ai_map(map));
  const std::vector<ScenarioRow> queries = strided_rows(scen, grid, args.queries);
  const auto cells = static_cast<double>(grid.width()) * static_cast<double>(grid.height());
  const CellSpace space = value_or_throw(CellSpace::build(std::move(grid)));

  std::vector<double> optimal;
  const auto optimum = benchmark.optimum(space);
  for (const ScenarioRow& row : queries) {
    try {
      optimal.push_back(optimum(row));
    } catch (const UsageError& error) {
      throw UsageError{scen + " line " + std::to_string(row.line) + ": " + error.message};
    }
  }

  std::vector<Row> rows;
  std::vector<Engine> searches;
  for (const std::string& name : args.searches) {
    searches.push_back(benchmark.engines.at(name)(space));
    Row row;
    row.map = std::filesystem::path(map).filename().string();
    row.search = name;
    row.micros.assign(queries.size(), std::numeric_limits<double>::infinity());
    row.preprocess_ms = searches.back().preprocess_ms;
    row.bytes_per_cell = static_cast<double>(searches.back().bytes) / cells;
    rows.push_back(row);
  }
  for (std::size_t round = 0; round < args.rounds; ++round) {
    std::vector<std::vector<bool>> counted(searches.size(), std::vector<bool>(queries.size()));
    take_turns(args.caches, searches.size(), queries.size(),
               [&](std::size_t s, std::size_t q, bool is_timed) {
                 const auto begin = Clock::now();
                 const Engine::Answer answer = searches[s].run(queries[q].start, queries[q].goal);
                 const double micros = micros_since(begin);
                 if (is_timed) rows[s].micros[q] = std::min(rows[s].micros[q], micros);
                 if (round > 0 || counted[s][q]) return;
                 counted[s][q] = true;
                 rows[s].count(answer, optimal[q],
                               benchmark.is_right(space, rows[s].search, answer, optimal[q]));
               });
  }
  return rows;
}

inline std::string csv_text(const std::vector<Row>& rows, bool compares_lengths) {
  std::string text =
      "map,search,queries,mean_us,p50_us,p99_us,expanded,distinct,generated,wrong_length,failed,"
      "preprocess_ms,bytes_per_cell";
  text += compares_lengths ? ",mean_ratio,max_ratio,vertices\n" : "\n";
  char line[512];
  for (const Row& r : rows) {
    std::snprintf(line, sizeof line, "%s,%s,%zu,%.3f,%.3f,%.3f,%llu,%llu,%llu,%zu,%zu,%.3f,%.4f",
                  r.map.c_str(), r.search.c_str(), r.micros.size(), r.mean(), r.percentile(0.5),
                  r.percentile(0.99), static_cast<unsigned long long>(r.expanded),
                  static_cast<unsigned long long>(r.distinct),
                  static_cast<unsigned long long>(r.generated), r.wrong, r.failed, r.preprocess_ms,
                  r.bytes_per_cell);
    text += line;
    if (compares_lengths) {
      std::snprintf(line, sizeof line, ",%.7f,%.7f,%.2f", r.mean_ratio(), r.max_ratio,
                    r.mean_vertices());
      text += line;
    }
    text += '\n';
  }
  return text;
}

/// A table for people, with the speed of each search relative to the first one.
inline void print_table(const std::vector<Row>& rows, const std::vector<std::string>& searches,
                        bool compares_lengths) {
  std::printf("%-18s %-20s %9s %11s %11s %11s %9s %9s %6s %8s", "map", "search", "mean us",
              "expanded", "distinct", "generated", "ns/exp", "ns/gen", "wrong", "speed-up");
  std::puts(compares_lengths ? " mean length/optimal max vertices" : "");
  struct Mean {
    std::vector<double> logs;
    std::size_t maps = 0;
  };
  Mean random{std::vector<double>(searches.size(), 0)}, structured = random;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& r = rows[i];
    const Row& first = rows[i - i % searches.size()];
    const double total = 1000 * r.mean() * static_cast<double>(r.micros.size());
    const double ratio = first.mean() / r.mean();
    Mean& mean = r.map.starts_with("random") ? random : structured;
    mean.logs[i % searches.size()] += std::log(ratio);
    if (i % searches.size() == 0) ++mean.maps;
    std::printf("%-18s %-20s %9.1f %11llu %11s %11llu %9.1f %9.1f %6zu %8.2f", r.map.c_str(),
                r.search.c_str(), r.mean(), static_cast<unsigned long long>(r.expanded),
                r.distinct > 0 ? std::to_string(r.distinct).c_str() : "-",
                static_cast<unsigned long long>(r.generated),
                total / static_cast<double>(std::max<std::uint64_t>(1, r.expanded)),
                total / static_cast<double>(std::max<std::uint64_t>(1, r.generated)),
                r.wrong + r.failed, ratio);
    if (compares_lengths) {
      std::printf(" %19.6f %.6f %5.1f", r.mean_ratio(), r.max_ratio, r.mean_vertices());
    }
    std::puts("");
  }
  const auto print_mean = [&](const char* maps, const Mean& mean, std::size_t s) {
    if (mean.maps == 0) return;
    std::printf("geometric mean, %-24s %-20s %8.2f\n", maps, searches[s].c_str(),
                std::exp(mean.logs[s] / static_cast<double>(mean.maps)));
  };
  for (std::size_t s = 0; s < searches.size(); ++s) {
    print_mean("maps but random ones:", structured, s);
    print_mean("random maps:", random, s);
  }
}

inline int run(const Benchmark& benchmark, const Arguments& args) {
  for (const std::string& name : args.searches) {
    if (benchmark.engines.count(name) != 0) continue;
    std::string known;
    for (const auto& [other, make] : benchmark.engines) known += " " + other;
    throw UsageError{"unknown search \"" + name + "\"; known:" + known};
  }
  std::vector<std::pair<std::string, std::string>> files;
  if (!args.all.empty()) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(args.all, error)) {
      const std::string path = entry.path().string();
      if (entry.path().extension() == ".map") files.emplace_back(path, path + ".scen");
    }
    if (files.empty()) throw UsageError{args.all + ": no .map files there"};
    std::sort(files.begin(), files.end());
  } else if (args.map.empty() || args.scen.empty()) {
    throw UsageError{"--map and --scen are needed, or --all"};
  } else {
    files.emplace_back(args.map, args.scen);
  }
  std::vector<Row> rows;
  for (const auto& [map, scen] : files) {
    for (Row& row : run_map(benchmark, map, scen, args)) rows.push_back(std::move(row));
  }
  print_table(rows, args.searches, benchmark.compares_lengths);
  bench::write_if_named(args.csv, csv_text(rows, benchmark.compares_lengths));
  const bool good = std::all_of(rows.begin(), rows.end(),
                                [](const Row& r) { return r.wrong == 0 && r.failed == 0; });
  return good ? 0 : 1;
}

/// The program: its options, its errors on one line, exit code 1 for wrong answers and 2 for bad
/// usage.
inline int main(const Benchmark& benchmark, int argc, char** argv) {
  Arguments args;
  args.searches = benchmark.searches;
  CLI::App app(benchmark.description, benchmark.name);
  auto* map = app.add_option("--map", args.map, "Map (.map)");
  app.add_option("--scen", args.scen, "Its scenarios (.scen)");
  app.add_option("--all", args.all, "Folder: every .map with the .map.scen beside it")
      ->excludes(map);
  app.add_option("--search", args.searches, "Searches; speed-ups are relative to the first")
      ->delimiter(',');
  add_counts(app, args.queries, args.rounds);
  app.add_option("--caches", args.caches,
                 "warm: a search repeats its queries; cold: after 8 MB of other data; shared: "
                 "searches take turns")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Caches>{
          {"shared", Caches::shared}, {"warm", Caches::warm}, {"cold", Caches::cold}}));
  app.add_option("--csv", args.csv, "Write the figures to a file");
  return bench::run_program(app, argc, argv, [&] { return run(benchmark, args); });
}

}  // namespace map_benchmark
