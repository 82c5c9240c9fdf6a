// SPDX-License-Identifier: MIT
#include "tutavia/tuning/salp_swarm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using Place = std::span<const double>;

constexpr std::array<double, 3> lower{-1, 0.5, -3}, upper{2, 2, 4};

/// Least, and 0, at (0.3, 1.2, -0.7).
double bowl(Place x) {
  return std::pow(x[0] - 0.3, 2) + 3 * std::pow(x[1] - 1.2, 2) + 0.5 * std::pow(x[2] + 0.7, 2);
}

TEST_CASE("a swarm finds the least value of a bowl, its best never gets worse") {
  for (const auto variant : {SalpSwarm::Variant::equations, SalpSwarm::Variant::pseudo_code}) {
    for (const std::size_t leaders : {1u, 15u}) {
      const SalpSwarm swarm{
          .variant = variant, .population = 30, .iterations = 300, .leaders = leaders, .seed = 7};
      const auto found = swarm.minimise(bowl, lower, upper);
      REQUIRE(found);
      CHECK(found->value == bowl(found->best));
      CHECK(found->value < 0.1);
      CHECK(found->training.size() == 301);
      CHECK(found->training.back() == found->value);
      CHECK(std::is_sorted(found->training.rbegin(), found->training.rend()));
      for (std::size_t j = 0; j < 3; ++j) {
        CHECK(found->best[j] >= lower[j]);
        CHECK(found->best[j] <= upper[j]);
      }
    }
  }
}

TEST_CASE("a swarm's result depends on the seed, not on the number of threads") {
  const auto best = [&](std::uint64_t seed, unsigned threads) {
    const SalpSwarm swarm{.iterations = 20, .seed = seed, .threads = threads};
    return swarm.minimise(bowl, lower, upper).value().best;
  };
  CHECK(best(1, 1) == best(1, 4));
  CHECK(best(1, 1) == best(1, 0));
  CHECK(best(1, 1) != best(2, 1));
}

TEST_CASE("a ranked swarm follows its fittest salp, and equal ones keep their order") {
  constexpr std::size_t population = 4;
  // All positions that are evaluated, in order, for a function of one variable.
  const auto evaluated = [&](SalpSwarm::Order order, const auto& value) {
    std::vector<double> positions;
    const auto record = [&](Place x) {
      positions.push_back(x[0]);
      return value(x[0]);
    };
    const std::array<double, 1> zero{0}, one{1};
    const SalpSwarm swarm{
        .order = order, .population = population, .iterations = 2, .seed = 5, .threads = 1};
    REQUIRE(swarm.minimise(record, zero, one));
    REQUIRE(positions.size() == 3 * population);
    return positions;
  };
  const auto flat = [](double) { return 1.0; };
  CHECK(evaluated(SalpSwarm::Order::ranked, flat) == evaluated(SalpSwarm::Order::drawn, flat));

  const auto falling = [](double x) { return -x; };
  std::vector<double> x = evaluated(SalpSwarm::Order::ranked, falling);
  CHECK_FALSE(std::is_sorted(x.begin(), x.begin() + population, std::greater<>()));
  std::sort(x.begin(), x.begin() + population, std::greater<>());
  for (std::size_t i = 1; i < population; ++i) {
    CHECK(x[population + i] == 0.5 * (x[i] + x[population + i - 1]));
  }
}

TEST_CASE("ranking does not make the swarm worse") {
  double ranked = 0, drawn = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto value = [&](SalpSwarm::Order order) {
      const SalpSwarm swarm{.order = order, .seed = seed, .threads = 1};
      return swarm.minimise(bowl, lower, upper).value().value;
    };
    ranked += value(SalpSwarm::Order::ranked) / 100;
    drawn += value(SalpSwarm::Order::drawn) / 100;
  }
  INFO("mean of the least values: ranked " << ranked << ", as drawn " << drawn);
  CHECK(ranked <= drawn);
}

TEST_CASE("values that are no numbers are the worst, and a point is a bound") {
  const auto nan_left = [](Place x) { return x[0] < 0.5 ? std::nan("") : x[0]; };
  const std::array<double, 1> zero{0}, one{1};
  const auto found = SalpSwarm{.seed = 3}.minimise(nan_left, zero, one).value();
  CHECK(found.value >= 0.5);
  CHECK(found.value < 0.6);
  CHECK(SalpSwarm{.iterations = 2}.minimise(nan_left, one, one).value().value == 1);
}

TEST_CASE("a swarm refuses what it cannot search") {
  const auto code = [&](const SalpSwarm& swarm, Place low, Place high, const Budget& budget = {}) {
    const auto found = swarm.minimise(bowl, low, high, budget);
    REQUIRE_FALSE(found);
    return found.error().code;
  };
  CHECK(code({.population = 0}, lower, upper) == PlanError::invalid_option);
  CHECK(code({.iterations = 0}, lower, upper) == PlanError::invalid_option);
  CHECK(code({.leaders = 0}, lower, upper) == PlanError::invalid_option);
  CHECK(code({.leaders = 11}, lower, upper) == PlanError::invalid_option);
  CHECK(code({}, upper, lower) == PlanError::invalid_input);
  const std::array<double, 3> far_apart{-1e308, -1e308, -1e308}, away{1e308, 1e308, 1e308};
  CHECK(code({}, far_apart, away) == PlanError::invalid_input);
  CHECK(code({}, {}, {}) == PlanError::invalid_input);
  CHECK(code({}, lower, Place(upper).first(2)) == PlanError::invalid_input);
  std::array<double, 3> endless = upper;
  endless[1] = std::numeric_limits<double>::infinity();
  CHECK(code({}, lower, endless) == PlanError::invalid_input);
  std::stop_source source;
  source.request_stop();
  CHECK(code({}, lower, upper, Budget{.stop = source.get_token()}) == PlanError::cancelled);
}

}  // namespace
