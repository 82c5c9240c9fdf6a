// SPDX-License-Identifier: MIT
#include "tutavia/search/jps.hpp"

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

TEST_CASE("Jps keeps the searcher contract") { test::searcher_contract(Jps{}); }

TEST_CASE("jump points are few among the nodes that A* expands") {
  const std::uint64_t seed = 442;
  Random random(seed);
  std::uint64_t of_astar = 0, own = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 60)).value();
    const Query query = test::random_query(random, space);
    const auto expected = test::search_once(AStar{}, space, query);
    const auto route = test::search_once(Jps{}, space, query);
    REQUIRE(route.has_value() == expected.has_value());
    if (!route) continue;
    CHECK(route->cost == Approx(expected->cost).epsilon(1e-9));
    of_astar += expected->stats.expanded;
    own += route->stats.expanded;
  }
  CHECK(own < of_astar / 2);
}

TEST_CASE("jump point search is defined for one movement rule") {
  for (const MovementRule rule : test::all_rules) {
    CAPTURE(static_cast<int>(rule));
    const auto space = CellSpace::build(test::free_grid(4, 4), {.movement = rule}).value();
    const auto route = test::search_once(Jps{}, space, {.start = {0.5, 0.5}, .goal = {3.5, 3.5}});
    REQUIRE(route.has_value() == (rule == MovementRule::no_cut));
    if (!route) CHECK(route.error().code == PlanError::invalid_option);
  }
}

}  // namespace
