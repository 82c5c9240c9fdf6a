// SPDX-License-Identifier: MIT
#include "tutavia/search/jps.hpp"

#include "support/against_astar.hpp"
#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("Jps keeps the searcher contract") { test::searcher_contract(Jps{}); }

TEST_CASE("jump points are few among the nodes that A* expands") {
  const test::Effort effort = test::against_astar(Jps{}, 442, &Statistics::expanded);
  CHECK(effort.own < effort.of_astar / 2);
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
