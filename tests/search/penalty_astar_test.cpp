// SPDX-License-Identifier: MIT
#include "tutavia/search/penalty_astar.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/check_route.hpp"
#include "support/explicit_graph.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("PenaltyAStar keeps the searcher contract") { test::searcher_contract(PenaltyAStar{}); }

TEST_CASE("penalty A* minimises length plus penalty times turning") {
  const std::uint64_t seed = 430;
  Random random(seed);
  PenaltyAStar::Scratch scratch;
  NoObserver no_observer;
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto rule = static_cast<MovementRule>(random.below(4));
    const auto space =
        CellSpace::build(test::random_grid(random, 25), {.resolution = 0.5, .movement = rule})
            .value();
    const Query query = test::random_query(random, space);
    if (!space.is_free(query.start) || !space.is_free(query.goal)) continue;
    const double penalty = random.uniform(0.01, 2);
    const auto expected = test::explicit_cost(space, query, nullptr, penalty);
    found += expected.has_value();
    // The price of a turn is rounded to whole units of 0.5 m / 13860.
    test::check_route(space, query,
                      PenaltyAStar{penalty}.search(space, query, scratch, no_observer), expected,
                      0.01);
  }
  CHECK(found > test::scaled(100) / 4);
}

TEST_CASE("a penalty below 0 is refused") {
  const auto space = CellSpace::build(OccupancyGrid::blocked(3, 3).value()).value();
  const Query query{.start = {0.5, 0.5}, .goal = {2.5, 0.5}};
  for (const auto& search : {PenaltyAStar{-1.0}, PenaltyAStar{std::nan("")}}) {
    const auto route = test::search_once(search, space, query);
    REQUIRE_FALSE(route);
    CHECK(route.error().code == PlanError::invalid_option);
  }
}

}  // namespace
