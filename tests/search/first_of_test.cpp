// SPDX-License-Identifier: MIT
#include "tutavia/search/first_of.hpp"

#include "support/catch.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/space/lattice_space.hpp"

namespace {

using namespace tutavia;
using test::search_once;

/// Two rooms; the slot between them is wider than the robot by 0.02 m.
LatticeSpace rooms_with_slot(double resolution) {
  return LatticeSpace::build({.bounds = {{0, 0}, {6, 4}},
                              .safety_radius = 0.3,
                              .obstacles = {Polygon{{{3, 0}, {3.2, 0}, {3.2, 1.7}, {3, 1.7}}},
                                            Polygon{{{3, 2.32}, {3.2, 2.32}, {3.2, 4}, {3, 4}}}}},
                             {.resolution = resolution})
      .value();
}
const Query through{.start = {1, 1}, .goal = {5, 1}};

TEST_CASE("the second search runs where the first has no path, and the route says which found it") {
  const FirstOf both{AStar{}, TangentGraph{}};
  const auto coarse = rooms_with_slot(0.25);
  const auto failed = search_once(AStar{}, coarse, through);
  REQUIRE(failed.error().code == PlanError::unreachable_at_resolution);
  const auto exact = search_once(both, coarse, through);
  REQUIRE(exact);
  CHECK(exact->found_by == "tangent_graph");
  const auto alone = search_once(TangentGraph{}, coarse, through);
  CHECK(exact->cost == alone->cost);
  CHECK(exact->stats.expanded == failed.error().stats.expanded + alone->stats.expanded);
  CHECK(exact->stats.generated == failed.error().stats.generated + alone->stats.generated);

  const auto fine = search_once(both, rooms_with_slot(0.01), through);
  REQUIRE(fine);
  CHECK(fine->found_by == "astar");
}

TEST_CASE("a search within a search names the one that found the path") {
  const FirstOf nested{FirstOf{AStar{}, AStar{}}, TangentGraph{}};
  CHECK(search_once(nested, rooms_with_slot(0.01), through)->found_by == "astar");
  CHECK(search_once(nested, rooms_with_slot(0.25), through)->found_by == "tangent_graph");
}

TEST_CASE("answers that need no second search are those of the first") {
  const FirstOf both{AStar{}, TangentGraph{}};
  const auto space = rooms_with_slot(0.25);
  Query query = through;
  query.start = {3.1, 1};
  CHECK(search_once(both, space, query).error().code == PlanError::start_blocked);
  query = through;
  query.budget.max_expansions = 3;
  const auto stopped = search_once(both, space, query);
  CHECK(stopped.error().code == PlanError::budget_exhausted);
  CHECK(stopped.error().stats.expanded == 3);
}

TEST_CASE("the searches share one budget") {
  const FirstOf both{AStar{}, TangentGraph{}};
  const auto space = rooms_with_slot(0.25);
  Query query = through;
  query.budget.max_expansions = search_once(AStar{}, space, through).error().stats.expanded + 1;
  const auto stopped = search_once(both, space, query);
  CHECK(stopped.error().code == PlanError::budget_exhausted);
  CHECK(stopped.error().stats.expanded == query.budget.max_expansions);
}

TEST_CASE("FirstOf keeps the searcher contract") {
  test::searcher_contract(FirstOf{AStar{}, TangentGraph{}}, {.ties = test::Ties::not_proved});
}

}  // namespace
