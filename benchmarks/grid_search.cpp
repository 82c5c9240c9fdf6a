// SPDX-License-Identifier: MIT
/// \file
/// tutavia-bench-grid: grid searches on MovingAI maps, beside what one would use without this
/// library. Every length is checked against the scenario's.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "baselines.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/io/write_file.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/bidirectional_astar.hpp"
#include "tutavia/search/canonical_astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/flow_field.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/jps_plus.hpp"
#include "tutavia/search/penalty_astar.hpp"
#include "tutavia/search/weighted_astar.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;
using Clock = std::chrono::steady_clock;

struct UsageError {
  std::string message;
};

double micros_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

template <class T>
T value_or_throw(Expected<T, Failure> result) {
  if (!result) throw UsageError{result.error().detail};
  return std::move(*result);
}

/// One search, ready for queries on one map.
struct Engine {
  struct Answer {
    double cost = std::numeric_limits<double>::infinity();
    std::uint64_t expanded = 0;
    std::uint64_t generated = 0;
  };
  std::function<Answer(Cell, Cell)> run;
  double preprocess_ms = 0;
  std::size_t bytes = 0;  ///< of the map with everything prepared for it
};

using MakeEngine = std::function<Engine(const CellSpace&)>;

template <class A>
Engine engine(const CellSpace& space, const A& algorithm, std::size_t bytes) {
  auto scratch = std::make_shared<typename A::Scratch>();
  const auto run = [&space, algorithm, scratch](Cell start, Cell goal) -> Engine::Answer {
    NoObserver nobody;
    const Query query{.start = space.frame().point(start), .goal = space.frame().point(goal)};
    const auto route = algorithm.search(space, query, *scratch, nobody);
    if (!route) return {};
    return {route->cost, route->stats.expanded, route->stats.generated};
  };
  return {run, 0, bytes};
}

template <class Baseline, class... Options>
Engine baseline_engine(const CellSpace& space, Options... options) {
  const auto start = Clock::now();
  auto search = std::make_shared<Baseline>(space.grid(), options...);
  Engine result;
  result.preprocess_ms = micros_since(start) / 1000;
  result.run = [search](Cell from, Cell to) -> Engine::Answer {
    const baseline::Answer answer = (*search)(from, to);
    return {answer.cost, answer.expanded, answer.generated};
  };
  return result;
}

std::size_t grid_bytes(const CellSpace& space) { return space.grid().words().size() * 8; }

/// The whole map from every query's start, and the path to its goal: compare with whole-map
/// searches.
Engine flow_field_engine(const CellSpace& space) {
  const auto run = [&space](Cell start, Cell goal) -> Engine::Answer {
    const std::vector<Point> roots{space.frame().point(start)};
    const auto field = FlowField::build(space, roots);
    if (!field) return {};
    const auto route = field->path(space, space.frame().point(goal));
    if (!route) return {};
    return {route->cost, field->stats().expanded, field->stats().generated};
  };
  return {run, 0, grid_bytes(space)};
}

const std::map<std::string, MakeEngine>& engines() {
  static const std::map<std::string, MakeEngine> all{
      {"astar", [](const CellSpace& s) { return engine(s, AStar{}, grid_bytes(s)); }},
      {"canonical_astar",
       [](const CellSpace& s) { return engine(s, CanonicalAStar{}, grid_bytes(s)); }},
      {"bidirectional_astar",
       [](const CellSpace& s) { return engine(s, BidirectionalAStar{}, grid_bytes(s)); }},
      {"weighted_astar",
       [](const CellSpace& s) { return engine(s, WeightedAStar{.weight = 1}, grid_bytes(s)); }},
      {"penalty_astar",
       [](const CellSpace& s) { return engine(s, PenaltyAStar{0}, grid_bytes(s)); }},
      {"flow_field", flow_field_engine},
      {"dijkstra", [](const CellSpace& s) { return engine(s, Dijkstra{}, grid_bytes(s)); }},
      {"jps",
       [](const CellSpace& s) {
         return engine(s, Jps{}, grid_bytes(s) + s.stop_planes().memory());
       }},
      {"jps_plus",
       [](const CellSpace& s) {
         s.stop_planes();
         const auto start = Clock::now();
         const auto table = value_or_throw(JpsPlus::prepare(s));
         const double prepare_ms = micros_since(start) / 1000;
         Engine result = engine(s, JpsPlus{table}, grid_bytes(s) + table->memory());
         result.preprocess_ms = prepare_ms;
         return result;
       }},
      {"textbook_astar",
       [](const CellSpace& s) { return baseline_engine<baseline::TextbookAStar>(s); }},
      {"boost_astar",
       [](const CellSpace& s) { return baseline_engine<baseline::BoostSearch>(s, true); }},
      {"boost_dijkstra",
       [](const CellSpace& s) { return baseline_engine<baseline::BoostSearch>(s, false); }},
      {"boost_whole_map",
       [](const CellSpace& s) { return baseline_engine<baseline::BoostSearch>(s, false, false); }},
  };
  return all;
}

/// What one search did on one map.
struct Row {
  std::string map, search;
  std::vector<double> micros;  ///< least over the rounds, per query
  std::uint64_t expanded = 0, generated = 0;
  std::size_t wrong = 0, failed = 0;
  double preprocess_ms = 0, bytes_per_cell = 0;

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

struct Arguments {
  std::string map, scen, all, csv;
  std::vector<std::string> searches{"astar"};
  std::size_t queries = 50, rounds = 3;
};

/// Runs all searches on one map, in turn within every round.
std::vector<Row> run_map(const std::string& map, const std::string& scen, const Arguments& args) {
  auto scenario = value_or_throw(read_moving_ai_scenario(scen));
  auto grid = value_or_throw(read_moving_ai_map(map));
  if (const auto fits = check_scenario(scenario, grid); !fits) {
    throw UsageError{scen + ": " + fits.error().detail};
  }
  const auto cells = static_cast<double>(grid.width()) * static_cast<double>(grid.height());
  const CellSpace space = value_or_throw(CellSpace::build(std::move(grid)));
  std::vector<ScenarioRow> queries;
  const std::size_t count = std::min(args.queries, scenario.size());
  for (std::size_t i = 0; i < count; ++i) queries.push_back(scenario[i * scenario.size() / count]);

  std::vector<Row> rows;
  std::vector<Engine> searches;
  for (const std::string& name : args.searches) {
    searches.push_back(engines().at(name)(space));
    Row row;
    row.map = std::filesystem::path(map).filename().string();
    row.search = name;
    row.micros.assign(queries.size(), std::numeric_limits<double>::infinity());
    row.preprocess_ms = searches.back().preprocess_ms;
    row.bytes_per_cell = static_cast<double>(searches.back().bytes) / cells;
    rows.push_back(row);
  }
  for (std::size_t round = 0; round < args.rounds; ++round) {
    for (std::size_t s = 0; s < searches.size(); ++s) {
      for (std::size_t q = 0; q < queries.size(); ++q) {
        const auto begin = Clock::now();
        const Engine::Answer answer = searches[s].run(queries[q].start, queries[q].goal);
        rows[s].micros[q] = std::min(rows[s].micros[q], micros_since(begin));
        if (round > 0) continue;
        rows[s].expanded += answer.expanded;
        rows[s].generated += answer.generated;
        const double length = queries[q].optimal_length;
        if (!std::isfinite(answer.cost)) {
          ++rows[s].failed;
        } else if (std::abs(answer.cost - length) > 0.02 + 1e-5 * length) {
          ++rows[s].wrong;
        }
      }
    }
  }
  return rows;
}

std::string csv_text(const std::vector<Row>& rows) {
  std::string text =
      "map,search,queries,mean_us,p50_us,p99_us,expanded,generated,wrong_length,failed,"
      "preprocess_ms,bytes_per_cell\n";
  char line[512];
  for (const Row& r : rows) {
    std::snprintf(line, sizeof line, "%s,%s,%zu,%.3f,%.3f,%.3f,%llu,%llu,%zu,%zu,%.3f,%.4f\n",
                  r.map.c_str(), r.search.c_str(), r.micros.size(), r.mean(), r.percentile(0.5),
                  r.percentile(0.99), static_cast<unsigned long long>(r.expanded),
                  static_cast<unsigned long long>(r.generated), r.wrong, r.failed, r.preprocess_ms,
                  r.bytes_per_cell);
    text += line;
  }
  return text;
}

/// A table for people, with the speed of each search relative to the first one.
void print_table(const std::vector<Row>& rows, const std::vector<std::string>& searches) {
  std::printf("%-18s %-16s %8s %11s %11s %9s %9s %6s %8s\n", "map", "search", "mean us", "expanded",
              "generated", "ns/exp", "ns/gen", "wrong", "speed-up");
  std::vector<double> logs(searches.size(), 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& r = rows[i];
    const Row& first = rows[i - i % searches.size()];
    const double total = 1000 * r.mean() * static_cast<double>(r.micros.size());
    const double ratio = first.mean() / r.mean();
    logs[i % searches.size()] += std::log(ratio);
    std::printf("%-18s %-16s %8.1f %11llu %11llu %9.1f %9.1f %6zu %8.2f\n", r.map.c_str(),
                r.search.c_str(), r.mean(), static_cast<unsigned long long>(r.expanded),
                static_cast<unsigned long long>(r.generated),
                total / static_cast<double>(std::max<std::uint64_t>(1, r.expanded)),
                total / static_cast<double>(std::max<std::uint64_t>(1, r.generated)),
                r.wrong + r.failed, ratio);
  }
  const double maps = static_cast<double>(rows.size() / searches.size());
  for (std::size_t s = 0; s < searches.size(); ++s) {
    std::printf("%-18s %-16s %69.2f\n", "geometric mean", searches[s].c_str(),
                std::exp(logs[s] / maps));
  }
}

int run(const Arguments& args) {
  for (const std::string& name : args.searches) {
    if (engines().count(name) != 0) continue;
    std::string known;
    for (const auto& [other, make] : engines()) known += " " + other;
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
    for (Row& row : run_map(map, scen, args)) rows.push_back(std::move(row));
  }
  print_table(rows, args.searches);
  if (!args.csv.empty()) {
    if (auto written = write_file(args.csv, csv_text(rows)); !written) {
      throw UsageError{written.error().detail};
    }
  }
  const bool good = std::all_of(rows.begin(), rows.end(),
                                [](const Row& r) { return r.wrong == 0 && r.failed == 0; });
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments args;
  CLI::App app("Grid searches on MovingAI maps, lengths checked");
  auto* map = app.add_option("--map", args.map, "Map (.map)");
  app.add_option("--scen", args.scen, "Its scenarios (.scen)");
  app.add_option("--all", args.all, "Folder: every .map with the .map.scen beside it")
      ->excludes(map);
  app.add_option("--search", args.searches, "Searches; speed-ups are relative to the first")
      ->delimiter(',');
  app.add_option("--queries", args.queries, "Rows of the scenario, evenly strided")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--rounds", args.rounds, "Least time over so many rounds")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--csv", args.csv, "Write the figures to a file");
  try {
    app.parse(argc, argv);
    return run(args);
  } catch (const CLI::Success& request) {
    return app.exit(request);
  } catch (const CLI::ParseError& error) {
    std::cerr << "tutavia-bench-grid: " << error.what() << '\n';
  } catch (const UsageError& error) {
    std::cerr << "tutavia-bench-grid: " << error.message << '\n';
  }
  return 2;
}
