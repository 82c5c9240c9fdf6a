// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/core/parts/parallel.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/search/query_checks.hpp"

/// \file
/// SalpSwarm: minimises a function within bounds.

namespace tutavia {

namespace detail {

/// A function to minimise, which several threads may call at once.
template <class F>
concept SwarmObjective = requires(const F& value, std::span<const double> position) {
  { value(position) } -> std::convertible_to<double>;
};

}  // namespace detail

/// The salp swarm algorithm. Leading salps explore around the best position known, within a radius
/// that shrinks; the others follow one another in a chain. A heuristic whose only guarantee is that
/// the best position never gets worse.
///
/// Positions are drawn in sequence and evaluated in parallel, so the result depends on the seed
/// alone.
///
/// Source: Mirjalili et al. 2017, "Salp swarm algorithm", equations (3.1) to (3.4), with the
/// ranking of the SSA-A* paper (see `Order`). `variant` selects that paper's pseudo-code, which is
/// a different algorithm.
///
/// Example: examples/tuning.cpp.
struct SalpSwarm {
  /// The best position that a swarm found.
  struct Result {
    std::vector<double> best{};
    double value = std::numeric_limits<double>::infinity();
    /// The least value after the initial positions and after each iteration.
    std::vector<double> training{};
  };

  enum class Variant {
    equations,   ///< leaders and a chain of followers
    pseudo_code  ///< each salp moves near the best position (within 0.3) or half-way to it
  };

  /// The order of the salps in the chain; the first ones lead.
  enum class Order {
    ranked,  ///< by their values, the fittest first, anew in each iteration (the SSA-A* paper)
    drawn,   ///< as drawn at the start (Mirjalili et al.)
  };

  Variant variant = Variant::equations;
  Order order = Order::ranked;  ///< has no meaning for the pseudo-code
  std::size_t population = 10;
  std::size_t iterations = 100;
  std::size_t leaders = 1;
  std::uint64_t seed = 0;
  unsigned threads = 0;  ///< 0: one per core

  /// Minimises `value`, a function of as many numbers as there are bounds. Several threads call it
  /// at once. NaN counts as infinite.
  ///
  /// Errors: `invalid_option` for no population, iterations or leaders and for more leaders than
  /// salps; `invalid_input` for bounds that are not finite, reversed or of different number; those
  /// of the budget.
  template <detail::SwarmObjective F>
  Expected<Result, Failure> minimise(const F& value, std::span<const double> lower,
                                     std::span<const double> upper,
                                     const Budget& budget = {}) const;

 private:
  using Position = std::vector<double>;

  Expected<void, Failure> check() const {
    if (population == 0) return fail(PlanError::invalid_option, "population must not be 0");
    if (iterations == 0) return fail(PlanError::invalid_option, "iterations must not be 0");
    if (leaders == 0 || leaders > population) {
      return fail(PlanError::invalid_option, "leaders must lie in [1, population]");
    }
    return {};
  }

  /// Sorts the salps by their values, NaN last; equal ones keep their order.
  static void rank(std::vector<Position>& salps, std::span<const double> values) {
    std::vector<std::size_t> order(salps.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t i) {
      return std::isnan(values[i]) ? std::numeric_limits<double>::infinity() : values[i];
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return key(a) != key(b) ? key(a) < key(b) : a < b;
    });
    std::vector<Position> ranked;
    ranked.reserve(salps.size());
    for (const std::size_t i : order) ranked.push_back(std::move(salps[i]));
    salps = std::move(ranked);
  }

  /// Moves all salps for iteration t of 1 ... iterations.
  void move(std::vector<Position>& salps, const Position& best, std::size_t t,
            std::span<const double> lower, std::span<const double> upper, Random& random) const {
    const double progress = 4 * static_cast<double>(t) / static_cast<double>(iterations);
    const double reach = 2 * std::exp(-progress * progress);  // c1
    for (std::size_t i = 0; i < salps.size(); ++i) {
      const bool near_best = variant == Variant::pseudo_code && random.uniform() < 0.5;
      for (std::size_t j = 0; j < best.size(); ++j) {
        double& x = salps[i][j];
        if (variant == Variant::pseudo_code) {
          x = near_best ? best[j] + random.uniform(-0.3, 0.3) : 0.5 * (x + best[j]);
        } else if (i < leaders) {
          const double step = reach * ((upper[j] - lower[j]) * random.uniform() + lower[j]);
          x = random.uniform() < 0.5 ? best[j] + step : best[j] - step;
        } else {
          x = 0.5 * (x + salps[i - 1][j]);
        }
        x = std::clamp(x, lower[j], upper[j]);
      }
    }
  }

  template <detail::SwarmObjective F>
  std::vector<double> values(const F& value, const std::vector<Position>& salps) const {
    std::vector<double> results(salps.size());
    detail::for_each_in_parallel(salps.size(), threads, [&] {
      return [&](std::size_t i) {
        const double v = value(std::span<const double>(salps[i]));
        results[i] = std::isnan(v) ? std::numeric_limits<double>::infinity() : v;
      };
    });
    return results;
  }
};

template <detail::SwarmObjective F>
Expected<SalpSwarm::Result, Failure> SalpSwarm::minimise(const F& value,
                                                         std::span<const double> lower,
                                                         std::span<const double> upper,
                                                         const Budget& budget) const {
  if (auto valid = check(); !valid) return std::move(valid).unexpected();
  if (lower.empty() || lower.size() != upper.size()) {
    return fail(PlanError::invalid_input, "as many lower as upper bounds are needed");
  }
  for (std::size_t j = 0; j < lower.size(); ++j) {
    // Sums with a leader's step must stay finite, too.
    constexpr double most = std::numeric_limits<double>::max() / 8;
    if (!(-most <= lower[j] && lower[j] <= upper[j] && upper[j] <= most)) {
      return fail(PlanError::invalid_input, "bounds " + std::to_string(j) + " make no interval");
    }
  }
  Random random(seed);
  std::vector<Position> salps(population, Position(lower.size()));
  for (Position& salp : salps) {
    for (std::size_t j = 0; j < lower.size(); ++j) salp[j] = random.uniform(lower[j], upper[j]);
  }
  Result result{.best = salps[0]};
  for (std::size_t t = 0; t <= iterations; ++t) {
    if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while a swarm searches");
    if (t > 0) move(salps, result.best, t, lower, upper, random);
    const std::vector<double> found = values(value, salps);
    for (std::size_t i = 0; i < salps.size(); ++i) {
      if (found[i] < result.value) {
        result.value = found[i];
        result.best = salps[i];
      }
    }
    result.training.push_back(result.value);
    if (variant == Variant::equations && order == Order::ranked) rank(salps, found);
  }
  return result;
}

}  // namespace tutavia
