// SPDX-License-Identifier: MIT
/// \file
/// tutavia-bench-grid: grid searches on MovingAI maps, beside what one would use without this
/// library. Every length is checked against the scenario's, or against the bound of a search that
/// is not optimal.

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "map_benchmark.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/bidirectional_astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/flow_field.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/jps_plus.hpp"
#include "tutavia/search/penalty_astar.hpp"
#include "tutavia/search/rea_star.hpp"
#include "tutavia/search/ssa_astar.hpp"
#include "tutavia/search/weighted_astar.hpp"
#include "tutavia/smooth/no_smoothing.hpp"
#include "tutavia/smooth/taut_string.hpp"

namespace {

using namespace map_benchmark;

/// The whole map from every query's start, and the path to its goal: compare with whole-map
/// searches.
Engine flow_field_engine(const CellSpace& space) {
  const auto run = [&space](Cell start, Cell goal) -> Engine::Answer {
    const std::vector<Point> roots{space.frame().point(start)};
    const auto field = FlowField::build(space, roots);
    if (!field) return {};
    const auto route = field->path(space, space.frame().point(goal));
    if (!route) return {};
    return {route->cost, field->stats().expanded, field->stats().generated, route->curve};
  };
  return {run, 0, grid_bytes(space)};
}

/// A whole plan: search, smoothing, proof and metrics.
template <class Search, class Smooth>
Engine plan_engine(const CellSpace& space, const Search& search, const Smooth& smoother,
                   std::size_t bytes) {
  auto planner = std::make_shared<Planner<Search, Smooth>>(search, smoother);
  const auto run = [&space, planner](Cell start, Cell goal) -> Engine::Answer {
    const auto plan = planner->plan(
        space, {.start = space.frame().point(start), .goal = space.frame().point(goal)});
    if (!plan) return {};
    return {plan->route.cost, plan->route.stats.expanded, plan->route.stats.generated, plan->curve};
  };
  return {run, 0, bytes};
}

/// SSA-A* in both settings; without its term for the density of obstacles; with one of its
/// distances alone and the same sum of weights; and with weights whose sum is 1, which is
/// consistent.
const std::map<std::string, SsaAStar>& ssa_searches() {
  static const SsaAStar::Weights distances{.density = 0};
  static const std::map<std::string, SsaAStar> searches{
      {"ssa_astar", {}},
      {"ssa_astar_closed", {.reopen = false}},
      {"ssa_astar_distances", {.weights = distances}},
      {"ssa_astar_chebyshev", {.weights = {2.4, 0, 0}}},
      {"ssa_astar_euclidean", {.weights = {0, 2.4, 0}}},
      {"ssa_astar_consistent", {.weights = {1.55 / 2.4, 0.85 / 2.4, 0}}},
  };
  return searches;
}

/// The proved bound of SSA-A* for a shortest path of `optimal` cells.
double ssa_bound(const SsaAStar& search, double optimal) {
  const SsaAStar::Weights& w = search.weights;
  const double factor = std::max(1.0, w.chebyshev + w.euclidean);
  return search.reopen ? factor * optimal + w.density
                       : (factor + w.density / 2) * optimal + w.density;
}

Engines engines() {
  Engines all{
      {"astar", [](const CellSpace& s) { return engine(s, AStar{}, grid_bytes(s)); }},
      {"astar_all_successors",
       [](const CellSpace& s) {
         return engine(s, AStar{.successors = AStar::Successors::all}, grid_bytes(s));
       }},
      {"astar_euclidean",
       [](const CellSpace& s) {
         return engine(s, AStar{.heuristic = HeuristicKind::euclidean}, grid_bytes(s));
       }},
      {"bidirectional_astar",
       [](const CellSpace& s) { return engine(s, BidirectionalAStar{}, grid_bytes(s)); }},
      {"weighted_astar",
       [](const CellSpace& s) { return engine(s, WeightedAStar{.weight = 1}, grid_bytes(s)); }},
      {"penalty_astar",
       [](const CellSpace& s) { return engine(s, PenaltyAStar{0}, grid_bytes(s)); }},
      {"flow_field", flow_field_engine},
      {"dijkstra", [](const CellSpace& s) { return engine(s, Dijkstra{}, grid_bytes(s)); }},
      {"jps", [](const CellSpace& s) { return engine(s, Jps{}, grid_bytes(s) + plane_bytes(s)); }},
      {"jps_plus",
       [](const CellSpace& s) {
         return prepared_engine<JpsPlus>(s, grid_bytes(s),
                                         [](const auto& table) { return JpsPlus{table}; });
       }},
      {"jps_plan",
       [](const CellSpace& s) {
         return plan_engine(s, Jps{}, NoSmoothing{}, grid_bytes(s) + plane_bytes(s));
       }},
      {"jps_plan_taut_string",
       [](const CellSpace& s) {
         return plan_engine(s, Jps{}, TautString{}, grid_bytes(s) + plane_bytes(s));
       }},
      {"rea_star",
       [](const CellSpace& s) { return engine(s, ReaStar{}, grid_bytes(s) + grid_bytes(s)); }},
      {"textbook_astar",
       [](const CellSpace& s) { return baseline_engine<baseline::TextbookAStar>(s); }},
      {"boost_astar",
       [](const CellSpace& s) { return baseline_engine<baseline::BoostSearch>(s, true); }},
      {"boost_dijkstra",
       [](const CellSpace& s) { return baseline_engine<baseline::BoostSearch>(s, false); }},
      {"boost_whole_map",
       [](const CellSpace& s) { return baseline_engine<baseline::BoostSearch>(s, false, false); }},
  };
  for (const auto& [name, search] : ssa_searches()) {
    all[name] = [algorithm = search](const CellSpace& s) {
      return engine(s, algorithm, grid_bytes(s));
    };
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  Benchmark benchmark;
  benchmark.name = "tutavia-bench-grid";
  benchmark.description = "Grid searches on MovingAI maps, lengths checked";
  benchmark.engines = engines();
  benchmark.searches = {"astar"};
  benchmark.compares_lengths = true;
  benchmark.optimum = [](const CellSpace&) {
    return [](const ScenarioRow& row) { return row.optimal_length; };
  };
  benchmark.is_right = [](const CellSpace&, const std::string& search, const Engine::Answer& answer,
                          double optimal) {
    const double tolerance = 0.02 + 1e-5 * optimal;  // of the scenarios' lengths
    const auto ssa = ssa_searches().find(search);
    const double most = ssa == ssa_searches().end() ? optimal : ssa_bound(ssa->second, optimal);
    return optimal - tolerance <= answer.cost && answer.cost <= most + tolerance;
  };
  return map_benchmark::main(benchmark, argc, argv);
}
