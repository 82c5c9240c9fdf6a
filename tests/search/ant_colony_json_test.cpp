// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>

#include "support/free_route.hpp"
#include "support/paper_maps.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/search/ant_colony.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;
using test::search_once;

TEST_CASE("AntColony keeps the searcher contract") {
  test::searcher_contract(AntColony{.iterations = 5},
                          {.completeness = test::Completeness::gives_up});
}

TEST_CASE("what ants find is a path, the same from the same seed") {
  const std::uint64_t seed = 920;
  Random random(seed);
  AntColony::Scratch scratch, other;
  NoObserver no_observer;
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space =
        CellSpace::build(test::random_grid(random, 24), {.movement = test::all_rules[round % 4]})
            .value();
    Query query = test::random_query(random, space);
    query.seed = round;
    const auto route = AntColony{}.search(space, query, scratch, no_observer);
    const auto again = AntColony{}.search(space, query, other, no_observer);
    REQUIRE(route.has_value() == again.has_value());
    if (!route) {
      CHECK(route.error().code == again.error().code);
      continue;
    }
    ++found;
    CHECK(test::same_curve(route->curve, again->curve));
    CHECK(route->curve.start() == query.start);
    CHECK(route->curve.end() == query.goal);
    REQUIRE(test::is_free(space, *route));
  }
  CHECK(found > test::scaled(10));
}

TEST_CASE("ants find the way with any weights that are allowed") {
  AntColony::Scratch scratch;
  NoObserver no_observer;
  const auto length = [&](int width, int height, const AntColony& ants) {
    OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
    for (int y = 0; y < height; ++y) grid.set_run(y, 0, width - 1, true);
    const auto space = CellSpace::build(std::move(grid)).value();
    const Query query{.start = {0.5, 0.5}, .goal = {width - 0.5, 0.5}};
    const auto route = ants.search(space, query, scratch, no_observer);
    REQUIRE(route);
    return route->curve.length();
  };
  // The hundredth power of 1 / 2500 is 0 in doubles.
  CHECK(length(2500, 1, {.ants = 2, .iterations = 2, .distance_exponent = 100}) == 2499);
  // The hundredth power of a pheromone, in units that grow from round to round, is infinite.
  for (const double evaporation : {0.0, 0.3, 0.9, 0.99999}) {
    INFO(evaporation);
    CHECK(length(40, 10, {.pheromone_exponent = 100, .evaporation = evaporation}) < 400);
  }
}

TEST_CASE("ants learn: more rounds give shorter paths on the grids of the SSA-A* paper") {
  for (const std::string kind : {"cluster_20", "random_20"}) {
    double few = 0, many = 0, shortest = 0;
    std::size_t found = 0, grids = 0;
    AntColony::Scratch scratch;
    AStar::Scratch reference;
    NoObserver no_observer;
    for (const auto& [space, query] : test::ssa_tasks(kind)) {
      const auto optimum = AStar{}.search(space, query, reference, no_observer);
      const AntColony hasty{.iterations = 2, .dead_ends = AntColony::DeadEnds::discard};
      const auto early = hasty.search(space, query, scratch, no_observer);
      const AntColony colony{.dead_ends = AntColony::DeadEnds::discard};
      const auto late = colony.search(space, query, scratch, no_observer);
      REQUIRE(optimum);
      ++grids;
      if (!early || !late) continue;
      ++found;
      CHECK(late->cost >= optimum->cost * (1 - 1e-9));
      CHECK(late->cost <= early->cost * (1 + 1e-9));
      few += early->cost;
      many += late->cost;
      shortest += optimum->cost;
    }
    INFO(kind << ": paths on " << found << " of " << grids << " grids, " << few / shortest
              << " times the shortest after 2 rounds, " << many / shortest << " after 50");
    CHECK(found > grids / 2);
    CHECK(many < few);
  }
}

TEST_CASE("an ant colony refuses what it cannot use, and says when no ant arrives") {
  const auto tasks = test::ssa_tasks("random_20");
  const CellSpace& space = tasks[0].space;
  const Query& query = tasks[0].query;
  AntColony::Scratch scratch;
  NoObserver no_observer;
  const auto code = [&](const AntColony& colony, const Query& q) {
    const auto route = colony.search(space, q, scratch, no_observer);
    REQUIRE_FALSE(route);
    return route.error().code;
  };
  CHECK(code({.ants = 0}, query) == PlanError::invalid_option);
  CHECK(code({.iterations = 0}, query) == PlanError::invalid_option);
  CHECK(code({.pheromone_exponent = -1}, query) == PlanError::invalid_option);
  CHECK(code({.distance_exponent = std::nan("")}, query) == PlanError::invalid_option);
  CHECK(code({.evaporation = 1}, query) == PlanError::invalid_option);
  CHECK(code({.deposit = HUGE_VAL}, query) == PlanError::invalid_option);
  Query hasty = query;
  hasty.budget.max_expansions = 3;
  CHECK(code({}, hasty) == PlanError::budget_exhausted);
  // A pheromone that fades fast, many rounds: the units are made anew on the way.
  CHECK(
      AntColony{.iterations = 300, .evaporation = 0.9}.search(space, query, scratch, no_observer));
}

}  // namespace
