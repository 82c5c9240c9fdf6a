// SPDX-License-Identifier: MIT
#include <cstdint>
#include <iterator>
#include <limits>

#include "support/free_route.hpp"
#include "support/paper_maps.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/ssa_astar.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/tuning/ssa_tuning.hpp"

namespace {

using namespace tutavia;

TEST_CASE("SSA-A* keeps the searcher contract") {
  test::searcher_contract(SsaAStar{});
  test::searcher_contract(SsaAStar{{.chebyshev = 0.5, .euclidean = 0.5, .density = 0.1}});
  test::searcher_contract(SsaAStar{.reopen = false});
}

TEST_CASE("SSA-A* keeps its bound on random grids and finds a path where there is one", "[soak]") {
  const std::uint64_t seed = 900;
  Random random(seed);
  SsaAStar::Scratch scratch;
  AStar::Scratch reference;
  NoObserver no_observer;
  std::size_t found = 0;
  double worst = 0;
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space =
        CellSpace::build(test::random_grid(random, 40), {.movement = test::all_rules[round % 4]})
            .value();
    const Query query = test::random_query(random, space);
    const SsaAStar::Weights w{random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 1)};
    const auto shortest = AStar{}.search(space, query, reference, no_observer);
    const auto route = SsaAStar{w}.search(space, query, scratch, no_observer);
    REQUIRE(route.has_value() == shortest.has_value());
    if (!shortest) continue;
    ++found;
    REQUIRE(test::is_free(space, *route));
    const double bound = std::max(1.0, w.chebyshev + w.euclidean) * shortest->cost + w.density;
    CHECK(route->cost <= bound * (1 + 1e-8));
    CHECK(route->cost >= shortest->cost * (1 - 1e-8));
    CHECK(route->stats.distinct.value_or(0) <= route->stats.expanded);
    if (shortest->cost > 0) worst = std::max(worst, route->cost / shortest->cost);
  }
  INFO(found << " paths, the longest " << worst << " times the shortest");
  CHECK(found > test::scaled(100));
}

TEST_CASE("SSA-A* without re-opening keeps its bound, between any points", "[soak]") {
  const std::uint64_t seed = 901;
  Random random(seed);
  SsaAStar::Scratch scratch, other;
  AStar::Scratch reference;
  NoObserver no_observer;
  std::size_t found = 0, longer_than_reopened = 0;
  double largest_share = 0;  // of the bound
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space =
        CellSpace::build(test::random_grid(random, 40), {.movement = test::all_rules[round % 4]})
            .value();
    Query query = test::random_query(random, space);
    if (round % 3 == 0) {
      query.start += Point(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
      query.goal += Point(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
    }
    // Some weights make the density of obstacles count for more than the distances.
    const bool is_dense = round % 5 == 0;
    const SsaAStar::Weights w{random.uniform(0, is_dense ? 0.6 : 2),
                              random.uniform(0, is_dense ? 0.6 : 2),
                              random.uniform(0, is_dense ? 20 : 1)};
    const auto shortest = AStar{}.search(space, query, reference, no_observer);
    const auto route = SsaAStar{w, false}.search(space, query, scratch, no_observer);
    REQUIRE(route.has_value() == shortest.has_value());
    if (!shortest) continue;
    ++found;
    REQUIRE(test::is_free(space, *route));
    const double factor = std::max(1.0, w.chebyshev + w.euclidean) + w.density / 2;
    const double bound = factor * shortest->cost + w.density;
    CHECK(route->cost <= bound * (1 + 1e-4));  // h is rounded down to 1 / 13860 of a cell
    if (shortest->cost > 0) largest_share = std::max(largest_share, route->cost / bound);
    CHECK(route->stats.distinct.value_or(0) == route->stats.expanded);
    const auto reopened = SsaAStar{w}.search(space, query, other, no_observer);
    REQUIRE(reopened);
    longer_than_reopened += route->cost > reopened->cost * (1 + 1e-9);
  }
  INFO(found << " paths, " << longer_than_reopened << " longer than with re-opening, the longest "
             << largest_share << " of the bound");
  CHECK(found > test::scaled(100));
  CHECK(longer_than_reopened > 0);
}

/// The spaces and queries of one of the paper's sets.
struct PaperSet {
  std::vector<CellSpace> spaces;
  std::vector<Query> queries;

  explicit PaperSet(const std::string& name) {
    for (auto& [space, query] : test::ssa_tasks(name)) {
      spaces.push_back(std::move(space));
      queries.push_back(query);
    }
  }
};

TEST_CASE("weights tuned on some grids save expansions on others of their kind") {
  for (const std::string kind : {"cluster", "random"}) {
    const PaperSet small(kind + "_20"), large(kind + "_35");
    SsaTraining training{.length_penalty = 8};
    training.swarm.iterations = 30;
    const auto tuned = tune_ssa(std::span<const CellSpace>(small.spaces),
                                std::span<const Query>(small.queries), training);
    INFO((tuned ? "" : tuned.error().detail));
    REQUIRE(tuned);
    const SsaAStar::Weights& w = tuned->weights;
    double expanded = 0, of_euclidean = 0, of_octile = 0, length = 0, shortest = 0;
    SsaAStar::Scratch scratch;
    AStar::Scratch other;
    NoObserver no_observer;
    for (std::size_t i = 0; i < large.spaces.size(); ++i) {
      const auto& space = large.spaces[i];
      const auto& query = large.queries[i];
      const auto route = SsaAStar{w}.search(space, query, scratch, no_observer);
      const auto euclidean =
          AStar{.heuristic = HeuristicKind::euclidean}.search(space, query, other, no_observer);
      const auto octile = AStar{}.search(space, query, other, no_observer);
      REQUIRE((route && euclidean && octile));
      expanded += double(route->stats.expanded);
      of_euclidean += double(euclidean->stats.expanded);
      of_octile += double(octile->stats.expanded);
      length += route->cost;
      shortest += octile->cost;
    }
    INFO(kind << " grids: weights (" << w.chebyshev << ", " << w.euclidean << ", " << w.density
              << "), expansions " << expanded / of_euclidean
              << " times those of A* with the Euclidean heuristic, " << expanded / of_octile
              << " times those of octile A*; length " << length / shortest);
    CHECK(expanded < 0.36 * of_euclidean);
    CHECK(length < 1.025 * shortest);
    CHECK(std::is_sorted(tuned->training.rbegin(), tuned->training.rend()));
    CHECK(tuned->training.back() == tuned->fitness);
    training.swarm.threads = 1;
    const auto again = tune_ssa(std::span<const CellSpace>(small.spaces),
                                std::span<const Query>(small.queries), training);
    CHECK(again->training == tuned->training);
  }
}

TEST_CASE("weights can be tuned for few distinct nodes") {
  const PaperSet set("cluster_35");
  const std::span<const CellSpace> spaces(set.spaces);
  const std::span<const Query> queries(set.queries);
  const auto tuned = [&](SsaTraining::Effort effort, bool reopen) {
    SsaTraining training{.effort = effort, .reopen = reopen};
    training.swarm.iterations = 20;
    return tune_ssa(spaces, queries, training).value();
  };
  const auto nodes = tuned(SsaTraining::Effort::distinct_nodes, true);
  CHECK(nodes.fitness < tuned(SsaTraining::Effort::expansions, true).fitness);
  // Without re-opening, every expansion is of another node.
  const auto closed = tuned(SsaTraining::Effort::expansions, false);
  CHECK(closed.training == tuned(SsaTraining::Effort::distinct_nodes, false).training);
  // The fitness is what it says.
  double share = 0;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    const auto route = test::search_once(SsaAStar{nodes.weights}, spaces[i], queries[i]);
    const auto euclidean =
        test::search_once(AStar{.heuristic = HeuristicKind::euclidean}, spaces[i], queries[i]);
    REQUIRE((route && euclidean));
    share += static_cast<double>(route->stats.distinct.value()) /
             static_cast<double>(euclidean->stats.expanded);
  }
  CHECK(share / static_cast<double>(spaces.size()) == Approx(nodes.fitness));
}

TEST_CASE("SSA-A* and its training refuse what they cannot use") {
  const PaperSet set("random_20");
  const auto refused = [&](const SsaAStar::Weights& w) {
    SsaAStar::Scratch scratch;
    NoObserver no_observer;
    const auto route = SsaAStar{w}.search(set.spaces[0], set.queries[0], scratch, no_observer);
    REQUIRE_FALSE(route);
    return route.error().code;
  };
  CHECK(refused({.chebyshev = -0.1}) == PlanError::invalid_option);
  CHECK(refused({.euclidean = std::nan("")}) == PlanError::invalid_option);
  CHECK(refused({.density = 1001}) == PlanError::invalid_option);
  const std::span<const CellSpace> spaces(set.spaces);
  std::vector<Query> queries = set.queries;
  const auto code = [&](std::span<const CellSpace> s, const SsaTraining& training) {
    const auto tuned = tune_ssa(s, std::span<const Query>(queries), training);
    REQUIRE_FALSE(tuned);
    return tuned.error();
  };
  CHECK(code(spaces.first(3), {}).code == PlanError::invalid_input);
  CHECK(code(spaces, {.length_penalty = -1}).code == PlanError::invalid_option);
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(code(spaces, {.length_penalty = infinity}).code == PlanError::invalid_option);
  CHECK(code(spaces, {.swarm = {.population = 0}}).code == PlanError::invalid_option);
  CHECK(code(spaces, {.lower = {-1, 0, 0}, .swarm = {.iterations = 1}}).code ==
        PlanError::invalid_option);
  queries[4].goal = {-5, 0};
  const Failure failure = code(spaces, {});
  CHECK(failure.code == PlanError::invalid_input);
  CHECK(failure.detail.find("query 4") != std::string::npos);
}

}  // namespace
