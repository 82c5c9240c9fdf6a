// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/search/astar.hpp"
#include "tutavia/search/ssa_astar.hpp"
#include "tutavia/tuning/salp_swarm.hpp"

/// \file
/// tune_ssa: tunes the weights of SSA-A* for a class of maps.

namespace tutavia {

/// The ranges of the weights and the options of the tuning.
struct SsaTraining {
  /// The effort of a search.
  enum class Effort {
    expansions,      ///< what determines its time
    distinct_nodes,  ///< nodes expanded at least once: the length of the paper's visited list
  };

  SsaAStar::Weights lower{0.5, 0.5, 0.1}, upper{2, 2, 1};  ///< the paper's ranges
  SalpSwarm swarm{};
  /// Penalty for excess length: a path twice as long as the shortest costs as much as this fraction
  /// of A*'s effort. 0: the paper's fitness, effort alone.
  double length_penalty = 0;
  Effort effort = Effort::expansions;
  bool reopen = true;  ///< see SsaAStar; without re-opening both efforts are the same
};

/// Weights, and the course of their tuning.
struct TunedWeights {
  SsaAStar::Weights weights{};
  double fitness = 0;
  std::vector<double> training;  ///< the least fitness after each iteration
};

namespace detail {

/// Effort and shortest length of A* with the Euclidean heuristic on a training query.
struct SsaReference {
  double effort, shortest;
};

inline double ssa_effort(const Statistics& stats, SsaTraining::Effort effort) {
  return static_cast<double>(effort == SsaTraining::Effort::expansions
                                 ? stats.expanded
                                 : stats.distinct.value_or(stats.expanded));
}

/// One reference per query. Errors: `invalid_input` for a query without a path, named by its index.
template <GridSpace S>
Expected<std::vector<SsaReference>, Failure> ssa_references(std::span<const S> spaces,
                                                            std::span<const Query> queries,
                                                            SsaTraining::Effort effort) {
  std::vector<SsaReference> references;
  AStar::Scratch scratch;
  NoObserver no_observer;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    const auto guided = AStar{.heuristic = HeuristicKind::euclidean}.search(spaces[i], queries[i],
                                                                            scratch, no_observer);
    if (!guided) {
      return fail(PlanError::invalid_input, "query " + std::to_string(i) + " has no path: " +
                                                std::string(to_string(guided.error().code)));
    }
    references.push_back({ssa_effort(guided->stats, effort), guided->cost});
  }
  return references;
}

/// The mean cost of `search` over all queries, relative to the references.
template <GridSpace S>
double ssa_fitness(const SsaAStar& search, std::span<const S> spaces,
                   std::span<const Query> queries, std::span<const SsaReference> references,
                   const SsaTraining& training) {
  SsaAStar::Scratch scratch;
  NoObserver no_observer;
  double sum = 0;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    const auto route = search.search(spaces[i], queries[i], scratch, no_observer);
    if (!route) return std::numeric_limits<double>::infinity();
    const SsaReference& reference = references[i];
    if (reference.effort > 0) sum += ssa_effort(route->stats, training.effort) / reference.effort;
    if (reference.shortest > 0) {
      sum += training.length_penalty * (route->cost / reference.shortest - 1);
    }
  }
  return sum / static_cast<double>(spaces.size());
}

}  // namespace detail

/// The weights with which SSA-A* solves its queries with the least effort. Minimises the mean, over
/// all queries, of its effort over that of A* with the Euclidean heuristic, so that large maps
/// count like small ones, plus `length_penalty` times the relative excess of length. Query i is on
/// space i.
///
/// Errors: `invalid_input` for no spaces, for another number of queries, and for a query for which
/// A* finds no path (named by its index); `invalid_option` for a negative penalty and for weights
/// as in SsaAStar; those of SalpSwarm::minimise.
///
/// Example: examples/tuning.cpp.
template <GridSpace S>
Expected<TunedWeights, Failure> tune_ssa(std::span<const S> spaces, std::span<const Query> queries,
                                         const SsaTraining& training = {}) {
  if (spaces.empty() || spaces.size() != queries.size()) {
    return fail(PlanError::invalid_input, "as many queries as spaces are needed, one at least");
  }
  if (!(training.length_penalty >= 0 && std::isfinite(training.length_penalty))) {
    return fail(PlanError::invalid_option, "length_penalty must be finite and not negative");
  }
  for (const SsaAStar::Weights& bound : {training.lower, training.upper}) {
    if (auto valid = SsaAStar::check(bound); !valid) return std::move(valid).unexpected();
  }
  auto references = detail::ssa_references(spaces, queries, training.effort);
  if (!references) return std::move(references).unexpected();
  const auto fitness = [&](std::span<const double> w) {
    return detail::ssa_fitness(SsaAStar{{w[0], w[1], w[2]}, training.reopen}, spaces, queries,
                               std::span<const detail::SsaReference>(*references), training);
  };
  const std::array lower{training.lower.chebyshev, training.lower.euclidean,
                         training.lower.density};
  const std::array upper{training.upper.chebyshev, training.upper.euclidean,
                         training.upper.density};
  auto found = training.swarm.minimise(fitness, lower, upper);
  if (!found) return std::move(found).unexpected();
  const auto& best = found->best;
  return TunedWeights{{best[0], best[1], best[2]}, found->value, std::move(found->training)};
}

}  // namespace tutavia
