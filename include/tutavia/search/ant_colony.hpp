// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/core/parts/zeroed_array.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/grid/search_grid.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// AntColony: paths on a grid from repeated random walks guided by pheromone.

namespace tutavia {

namespace detail {

/// Memory of an ant colony, reused by later queries.
struct AntScratch {
  std::vector<std::uint32_t> visited;  ///< the last ant on each cell
  std::vector<std::size_t> tour, best;
  std::vector<Cell> cells;
};

}  // namespace detail

/// Each ant performs a self-avoiding random walk from the start, biased towards steps with more
/// pheromone and towards cells closer to the goal. An ant that has no step left backtracks. An ant
/// that reaches the goal deposits pheromone on its tour, more on a shorter tour. Pheromone
/// evaporates in every round, and the best tour so far gets an extra deposit at the end of each.
///
/// A returned path is valid, without any bound on its length: on maps of more than some thousand
/// cells it is usually not short. The same seed gives the same path. Memory: 64 bytes per cell
/// visited.
///
/// Errors: `invalid_option`; those of `search_grid`; `budget_exhausted` if no ant arrived in any
/// round, or if the budget ended before an ant arrived; `cancelled`.
///
/// Source: Dorigo, Maniezzo and Colorni 1996, "Ant system: optimization by a colony of cooperating
/// agents" (with one elitist ant). This is the baseline of the SSA-A* paper, which does not print
/// its parameters; see docs/algorithms.md.
///
/// Example: examples/searches_on_cells.cpp.
struct AntColony {
  static constexpr std::string_view name = "ant_colony";
  using Scratch = detail::AntScratch;

  enum class DeadEnds {
    step_back,  ///< the ant backtracks until another step is legal
    discard     ///< the ant gives up, as in the paper; among walls every ant may
  };

  std::uint32_t ants = 30;        ///< per round
  std::uint32_t iterations = 50;  ///< rounds
  double pheromone_exponent = 1;  ///< alpha
  double distance_exponent = 5;   ///< beta, the exponent of 1 / distance to the goal
  double evaporation = 0.3;       ///< rho: share lost per round, in [0, 1)
  DeadEnds dead_ends = DeadEnds::step_back;
  double deposit = 100;  ///< Q: an ant deposits Q / length [cells]; every step starts with 1

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const;

 private:
  Expected<void, Failure> check() const {
    const auto is_weight = [](double x) { return x >= 0 && x <= 100; };
    const auto invalid = [](const char* detail) { return fail(PlanError::invalid_option, detail); };
    if (ants == 0) return invalid("ants must not be 0");
    if (iterations == 0) return invalid("iterations must not be 0");
    if (!is_weight(pheromone_exponent)) return invalid("pheromone_exponent must lie in [0, 100]");
    if (!is_weight(distance_exponent)) return invalid("distance_exponent must lie in [0, 100]");
    if (!(evaporation >= 0 && evaporation < 1)) return invalid("evaporation must lie in [0, 1)");
    if (!(deposit >= 0 && std::isfinite(deposit))) {
      return invalid("deposit must be finite, not negative");
    }
    return {};
  }
};

namespace detail {

template <GridSpace S, Observer O>
class Colony {
 public:
  Colony(const AntColony& options, SearchContext<S, O>& context, const GridQuery& linked,
         AntScratch& scratch)
      : options_(options),
        context_(context),
        linked_(linked),
        grid_(context.space.grid().view()),
        table_(all_successors(context.space.movement())),
        pheromones_(8 * context.space.grid().index_count()),
        scratch_(scratch),
        random_(context.query.seed) {}

  Expected<void, Failure> run() {
    scratch_.visited.assign(context_.space.grid().index_count(), 0);
    scratch_.best.clear();
    for (std::uint32_t round = 0; round < options_.iterations && within_; ++round) {
      for (std::uint32_t ant = 0; ant < options_.ants && within_; ++ant) {
        ++context_.statistics.generated;
        const auto cost = walk(ant + 1 + round * options_.ants);
        if (!cost) continue;
        if (*cost < best_) {
          best_ = *cost;
          scratch_.best = scratch_.tour;
        }
        deposit(scratch_.tour, *cost);
      }
      if (!scratch_.best.empty()) deposit(scratch_.best, best_);
      evaporate();
    }
    const bool is_cancelled = !within_ && within_.error().code == PlanError::cancelled;
    if (!scratch_.best.empty() && !is_cancelled) return {};
    if (!within_) return std::move(within_);
    return fail(PlanError::budget_exhausted);
  }

  void path(std::vector<Cell>& cells) const {
    cells.clear();
    for (auto i = scratch_.best.rbegin(); i != scratch_.best.rend(); ++i) {
      append_cell(cells, grid_.cell(*i));
    }
  }

 private:
  /// Runs one ant and stores its path in `tour`. Returns the path's cost if the ant arrives.
  std::optional<Cost> walk(std::uint32_t ant) {
    auto& tour = scratch_.tour;
    const CellLink& first = linked_.starts.data()[random_.below(linked_.starts.size())];
    tour.assign(1, grid_.index(first.cell));
    scratch_.visited[tour.back()] = ant;
    while (!tour.empty()) {
      const Cell cell = grid_.cell(tour.back());
      if (const auto exit = linked_.exit_cost(cell)) return first.cost + length() + *exit;
      if (auto within = context_.check_budget(); !within) {
        within_ = std::move(within);
        return std::nullopt;
      }
      context_.count_expanded(cell);
      if (const auto step = choose(tour.back(), cell, ant)) {
        tour.push_back(grid_.index(cell + steps[*step]));
        scratch_.visited[tour.back()] = ant;
      } else if (options_.dead_ends == AntColony::DeadEnds::step_back) {
        tour.pop_back();
      } else {
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  std::size_t step_between(std::size_t from, std::size_t to) const {
    const Cell by = grid_.cell(to) - grid_.cell(from);
    return static_cast<std::size_t>(std::find(steps.begin(), steps.end(), by) - steps.begin());
  }
  Cost length() const {
    Cost sum = 0;
    for (std::size_t i = 1; i < scratch_.tour.size(); ++i) {
      sum += step_cost(step_between(scratch_.tour[i - 1], scratch_.tour[i]));
    }
    return sum;
  }

  /// The next step of an ant; empty if every neighbour is blocked or already visited.
  std::optional<std::size_t> choose(std::size_t at, Cell cell, std::uint32_t ant) {
    // Logarithms minus the largest: the powers themselves overflow, or vanish for all steps.
    std::array<double, 8> weights{};
    weights.fill(-std::numeric_limits<double>::infinity());
    double largest = -std::numeric_limits<double>::infinity(), sum = 0;
    for (unsigned left = table_[grid_.neighbourhood(at)]; left != 0; left &= left - 1) {
      const auto step = static_cast<std::size_t>(std::countr_zero(left));
      const Cell next = cell + steps[step];
      if (scratch_.visited[grid_.index(next)] == ant) continue;
      const double dx = next.x - linked_.goal_cell.x, dy = next.y - linked_.goal_cell.y;
      const double nearness = 1 / (std::sqrt(dx * dx + dy * dy) + 1e-3);
      weights[step] = options_.pheromone_exponent * std::log(first_ + pheromones_[8 * at + step]) +
                      options_.distance_exponent * std::log(nearness);
      largest = std::max(largest, weights[step]);
    }
    if (!std::isfinite(largest)) return std::nullopt;
    for (double& weight : weights) sum += weight = std::exp(weight - largest);
    double pick = random_.uniform() * sum;
    std::optional<std::size_t> chosen;
    for (std::size_t step = 0; step < weights.size(); ++step) {
      if (!(weights[step] > 0)) continue;
      chosen = step;
      pick -= weights[step];
      if (pick < 0) break;
    }
    return chosen;
  }

  /// Pheromone is stored in a unit that shrinks at every evaporation, so evaporation writes no
  /// cell.
  void deposit(const std::vector<std::size_t>& tour, Cost cost) {
    const double length = static_cast<double>(cost) / static_cast<double>(straight_cost);
    if (!(length > 0)) return;
    for (std::size_t i = 1; i < tour.size(); ++i) {
      const std::size_t step = step_between(tour[i - 1], tour[i]);
      pheromones_[8 * tour[i - 1] + step] += options_.deposit / length * unit_;
    }
  }
  void evaporate() {
    unit_ /= 1 - options_.evaporation;
    if (unit_ < 1e100) return;
    for (std::size_t i = 0; i < pheromones_.size(); ++i) {
      if (pheromones_[i] != 0) pheromones_[i] /= unit_;  // pages never written stay unallocated
    }
    first_ = std::max(first_ / unit_, std::numeric_limits<double>::min());
    unit_ = 1;
  }

  const AntColony& options_;
  SearchContext<S, O>& context_;
  const GridQuery& linked_;
  OccupancyGrid::View grid_;
  const SuccessorTable& table_;
  ZeroedArray<double> pheromones_;  // of each step from each cell
  AntScratch& scratch_;
  Random random_;
  Expected<void, Failure> within_;  // an error once the budget has ended
  double first_ = 1;                // initial pheromone of every step
  double unit_ = 1;                 // stored value of one unit of pheromone
  Cost best_ = std::numeric_limits<Cost>::max();
};

/// Runs a Colony within `search_grid`.
struct ColonySearch {
  const AntColony& options;
  AntScratch& scratch;

  template <GridSpace S, Observer O>
  Expected<GridPath, Failure> run(const GridQuery& linked, SearchContext<S, O>& context) const {
    Colony<S, O> colony(options, context, linked, scratch);
    if (auto found = colony.run(); !found) return std::move(found).unexpected();
    colony.path(scratch.cells);
    return GridPath{scratch.cells};
  }
};

}  // namespace detail

template <GridSpace S, Observer O>
Expected<Route, Failure> AntColony::search(const S& space, const Query& query, Scratch& scratch,
                                           O& observer) const {
  if (auto valid = check(); !valid) return std::move(valid).unexpected();
  return detail::search_grid(space, query, observer, detail::ColonySearch{*this, scratch});
}

}  // namespace tutavia
