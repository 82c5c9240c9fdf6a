// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/search/astar.hpp"
#include "tutavia/search/grid_graph.hpp"
#include "tutavia/search/heuristic.hpp"
#include "tutavia/search/salp_swarm.hpp"

/// \file
/// SSA-A*: A* with a heuristic that a swarm has tuned.

namespace tutavia {

/// The heuristic w1 Chebyshev distance + w2 Euclidean distance + w3 times the share of blocked
/// cells among the eight neighbours (those outside the map are blocked), in cells. The defaults are
/// near to what `tune_ssa` finds on grids of 20 x 20 cells, be they random or with clustered
/// obstacles.
struct SsaWeights {
  double chebyshev = 1.55;  ///< w1
  double euclidean = 0.85;  ///< w2
  double density = 0.7;     ///< w3
};

/// A* with the heuristic of `SsaWeights`, which overestimates: fewer expansions for a bounded loss
/// of length. Cells are re-opened when a cheaper way to them is found, so the path costs at most
/// max(1, w1 + w2) times the cheapest one and w3 cells more. `tune_ssa` finds weights for maps of a
/// kind. Errors: `invalid_option` for a weight that is negative or more than 1000; else as for
/// AStar.
/// Source: the SSA-A* paper, equation (1) and algorithm 1; see docs/algorithms.md.
struct SsaAStar {
  static constexpr std::string_view name = "ssa_astar";
  using Scratch = GridGraphScratch;

  SsaWeights weights{};

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (const auto failure = check(weights)) return Unexpected{*failure};
    return graph_search(
        space, query, scratch, observer, PlainPrices{}, [&](const LinkedQuery& linked) {
          return [w = weights, grid = space.grid().view(),
                  chebyshev = GoalEstimate(Heuristic::chebyshev, linked),
                  euclidean = GoalEstimate(Heuristic::euclidean, linked)](Cell cell) {
            const int free = std::popcount(unsigned{grid.neighbourhood(grid.index(cell))});
            return static_cast<Cost>(w.chebyshev * static_cast<double>(chebyshev(cell)) +
                                     w.euclidean * static_cast<double>(euclidean(cell)) +
                                     w.density * (8 - free) * (straight_cost / 8.0));
          };
        });
  }

  /// `invalid_option` for weights that no search takes.
  static std::optional<Failure> check(const SsaWeights& weights) {
    for (const auto& [weight, option] :
         {std::pair{weights.chebyshev, "chebyshev"}, std::pair{weights.euclidean, "euclidean"},
          std::pair{weights.density, "density"}}) {
      if (weight >= 0 && weight <= 1000) continue;
      return Failure{
          .code = PlanError::invalid_option,
          .detail = std::string("the weight ") + option + " must lie between 0 and 1000"};
    }
    return std::nullopt;
  }
};

/// Where and how weights are tuned.
struct SsaTraining {
  SsaWeights lower{0.5, 0.5, 0.1}, upper{2, 2, 1};  ///< what the paper searches
  SalpSwarm swarm{};
  /// Expansions, as a share of those of A*, that a path which is longer than the shortest by its
  /// whole length counts like; 0: the paper's fitness, expansions alone.
  double length_penalty = 0;
};

/// Weights, and how they were found.
struct TunedWeights {
  SsaWeights weights{};
  double fitness = 0;
  std::vector<double> training;  ///< the least fitness after each iteration
};

/// The weights with which SSA-A* does its queries with the fewest expansions: the mean over all of
/// its expansions over those of A* with the Euclidean heuristic, so that large maps count like
/// small ones, plus `length_penalty` times the excess of length. Query i is on space i.
///
/// Errors: `invalid_input` for no spaces, for another number of queries, and for a query that A*
/// has no path for (named by its index); `invalid_option` for a penalty that is negative; those of
/// SalpSwarm::minimise; weights as for SsaAStar.
template <GridSpace S>
Expected<TunedWeights, Failure> tune_ssa(std::span<const S> spaces, std::span<const Query> queries,
                                         const SsaTraining& training = {}) {
  if (spaces.empty() || spaces.size() != queries.size()) {
    return fail(PlanError::invalid_input, "as many queries as spaces are needed, one at least");
  }
  if (!(training.length_penalty >= 0 && std::isfinite(training.length_penalty))) {
    return fail(PlanError::invalid_option, "length_penalty must be finite and not negative");
  }
  for (const SsaWeights& bound : {training.lower, training.upper}) {
    if (const auto failure = SsaAStar::check(bound)) return Unexpected{*failure};
  }
  struct Reference {
    double expanded, shortest;
  };
  std::vector<Reference> references;
  AStar::Scratch scratch;
  NoObserver nobody;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    const auto guided =
        AStar{.heuristic = Heuristic::euclidean}.search(spaces[i], queries[i], scratch, nobody);
    if (!guided) {
      return fail(PlanError::invalid_input, "query " + std::to_string(i) + " has no path: " +
                                                std::string(to_string(guided.error().code)));
    }
    references.push_back({static_cast<double>(guided->stats.expanded), guided->cost});
  }
  const auto fitness = [&](std::span<const double> w) {
    SsaAStar::Scratch own;
    const SsaAStar search{{w[0], w[1], w[2]}};
    double sum = 0;
    for (std::size_t i = 0; i < spaces.size(); ++i) {
      const auto route = search.search(spaces[i], queries[i], own, nobody);
      if (!route) return std::numeric_limits<double>::infinity();
      const Reference& reference = references[i];
      if (reference.expanded > 0) {
        sum += static_cast<double>(route->stats.expanded) / reference.expanded;
      }
      if (reference.shortest > 0) {
        sum += training.length_penalty * (route->cost / reference.shortest - 1);
      }
    }
    return sum / static_cast<double>(spaces.size());
  };
  const std::array lower{training.lower.chebyshev, training.lower.euclidean,
                         training.lower.density};
  const std::array upper{training.upper.chebyshev, training.upper.euclidean,
                         training.upper.density};
  auto found = training.swarm.minimise(fitness, lower, upper);
  if (!found) return Unexpected{std::move(found.error())};
  const auto& best = found->best;
  return TunedWeights{{best[0], best[1], best[2]}, found->value, std::move(found->training)};
}

}  // namespace tutavia
