// SPDX-License-Identifier: MIT
#include "tutavia/search/rea_star.hpp"

#include <cstdint>

#include "support/free_route.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("REA* keeps the searcher contract") { test::searcher_contract(ReaStar{}); }

TEST_CASE("REA* finds a path where there is one, no longer than the shortest on the grid",
          "[soak]") {
  const std::uint64_t seed = 910;
  Random random(seed);
  ReaStar::Scratch scratch;
  Dijkstra::Scratch reference;
  NoObserver no_observer;
  std::size_t found = 0, expanded = 0, of_dijkstra = 0;
  double shorter = 0;
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space =
        CellSpace::build(test::random_grid(random, round % 2 == 0 ? 12 : 60)).value();
    const Query query = test::random_query(random, space);
    const auto shortest = Dijkstra{}.search(space, query, reference, no_observer);
    const auto route = ReaStar{}.search(space, query, scratch, no_observer);
    REQUIRE(route.has_value() == shortest.has_value());
    if (!shortest) {
      CHECK(route.error().code == shortest.error().code);
      continue;
    }
    ++found;
    CHECK(route->curve.start() == query.start);
    CHECK(route->curve.end() == query.goal);
    REQUIRE(test::is_free(space, *route));
    CHECK(route->cost == Approx(shortest->cost).epsilon(1e-8));
    CHECK(route->curve.length() <= shortest->cost * (1 + 1e-8));
    expanded += route->stats.expanded;
    of_dijkstra += shortest->stats.expanded;
    if (shortest->cost > 0) shorter += 1 - route->curve.length() / shortest->cost;
  }
  INFO(found << " paths, " << expanded << " rectangles for " << of_dijkstra
             << " expansions of Dijkstra's, " << 100 * shorter / double(found) << " % shorter");
  CHECK(found > test::scaled(100));
}

TEST_CASE("REA* is defined for one movement rule") {
  const auto space =
      CellSpace::build(OccupancyGrid::blocked(3, 3).value(), {.movement = MovementRule::allow})
          .value();
  ReaStar::Scratch scratch;
  NoObserver no_observer;
  const auto refused =
      ReaStar{}.search(space, {.start = {0.5, 0.5}, .goal = {1, 1}}, scratch, no_observer);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_option);
}

}  // namespace
