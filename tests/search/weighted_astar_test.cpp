// SPDX-License-Identifier: MIT
#include "tutavia/search/weighted_astar.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("WeightedAStar keeps the searcher contract") { test::searcher_contract(WeightedAStar{}); }

TEST_CASE("weighted A* keeps its bound, and A* by Manhattan distance that of sqrt 2") {
  const std::uint64_t seed = 440;
  Random random(seed);
  AStar::Scratch astar;
  WeightedAStar::Scratch weighted;
  NoObserver no_observer;
  bool longer = false;
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 60)).value();
    const Query query = test::random_query(random, space);
    if (!space.is_free(query.start) || !space.is_free(query.goal)) continue;
    const double weight = random.uniform(1, 4);
    const auto best = AStar{}.search(space, query, astar, no_observer);
    const auto fast = WeightedAStar{weight}.search(space, query, weighted, no_observer);
    const auto greedy =
        AStar{.heuristic = HeuristicKind::manhattan}.search(space, query, astar, no_observer);
    REQUIRE(best.has_value() == fast.has_value());
    REQUIRE(best.has_value() == greedy.has_value());
    if (!best) continue;
    ++found;
    CHECK(fast->cost <= weight * best->cost * (1 + 1e-9));
    CHECK(greedy->cost <= 1.4142136 * best->cost * (1 + 1e-9));
    longer = longer || fast->cost > best->cost + 1e-9;
  }
  CHECK(longer);
  CHECK(found > test::scaled(100) / 3);
}

TEST_CASE("weights below 1 are refused") {
  const auto space = CellSpace::build(OccupancyGrid::blocked(3, 3).value()).value();
  const Query query{.start = {0.5, 0.5}, .goal = {2.5, 0.5}};
  for (const auto& search : {WeightedAStar{0.5}, WeightedAStar{std::nan("")}}) {
    const auto route = test::search_once(search, space, query);
    REQUIRE_FALSE(route);
    CHECK(route.error().code == PlanError::invalid_option);
  }
}

}  // namespace
