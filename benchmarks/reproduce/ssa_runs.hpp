// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <span>
#include <utility>
#include <vector>

#include "runs.hpp"
#include "support/paper_maps.hpp"
#include "tutavia/search/ant_colony.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/ssa_astar.hpp"
#include "tutavia/tuning/ssa_tuning.hpp"

/// \file
/// The searches of the SSA-A* paper on one grid.

namespace reproduce {

/// The searches on one grid. Nodes are counted once each, as on the paper's visited list.
struct SsaRuns {
  Run astar, dijkstra, jps, tuned, library, ants;
  double ant_cells = 0;  ///< visited by at least one ant
};

/// The distinct positions that a search expands.
class DistinctPositions {
 public:
  void expanded(const Point& p) { seen_.insert({p.x(), p.y()}); }
  void generated(const Point& p) { seen_.insert({p.x(), p.y()}); }
  double count() const { return static_cast<double>(seen_.size()); }

 private:
  std::set<std::pair<double, double>> seen_;
};

/// Tunes the weights as the paper does: as few distinct nodes as possible, whatever the length.
inline SsaAStar tuned_on(const std::vector<test::PaperTask>& tasks, const Options& options) {
  std::vector<CellSpace> spaces;
  std::vector<Query> queries;
  for (const test::PaperTask& task : tasks) {
    spaces.push_back(task.space);
    queries.push_back(task.query);
  }
  const SsaTraining training{.swarm = {.seed = options.seed},
                             .effort = SsaTraining::Effort::distinct_nodes};
  return {tune_ssa(std::span<const CellSpace>(spaces), std::span<const Query>(queries), training)
              .value()
              .weights};
}

/// Runs all searches. `ants` of the colony; none: it is left out.
inline SsaRuns run_all(const test::PaperTask& task, const SsaAStar& tuned, const AntColony* colony,
                       const Options& options) {
  SsaRuns runs;
  const auto run = [&](const auto& algorithm) {
    return search(algorithm, task.space, task.query, options);
  };
  runs.astar = run(AStar{.heuristic = HeuristicKind::euclidean});
  runs.dijkstra = run(Dijkstra{});
  runs.jps = run(Jps{});
  runs.tuned = run(tuned);
  runs.library = run(SsaAStar{.reopen = false});
  if (colony == nullptr) return runs;
  Options once = options;
  once.rounds = options.rounds > 0 ? 1 : 0;
  runs.ants = search(*colony, task.space, task.query, once);
  DistinctPositions cells;
  AntColony::Scratch scratch;
  if (colony->search(task.space, task.query, scratch, cells)) runs.ant_cells = cells.count();
  return runs;
}

}  // namespace reproduce
