// SPDX-License-Identifier: MIT
#include "tutavia/batch.hpp"

#include <chrono>
#include <stop_token>
#include <thread>
#include <vector>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/pull/shortcut.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("a batch gives the same plans on any number of threads") {
  const std::uint64_t seed = 500;
  Random random(seed);
  INFO("seed " << seed);
  const auto space = CellSpace::build(test::random_grid(random, 60)).value();
  std::vector<Query> queries;
  for (std::size_t i = 0; i < test::scaled(100); ++i) {
    queries.push_back({.start = space.frame().point(test::random_cell(random, space.grid())),
                       .goal = space.frame().point(test::random_cell(random, space.grid()))});
  }
  const Planner planner(Jps{}, Shortcut{});
  const auto expected = plan_batch(planner, space, queries, 1);
  REQUIRE(expected.size() == queries.size());
  for (const unsigned threads : {0u, 2u, 3u, 16u}) {
    INFO(threads << " threads");
    const auto plans = plan_batch(planner, space, queries, threads);
    REQUIRE(plans.size() == expected.size());
    for (std::size_t i = 0; i < plans.size(); ++i) {
      REQUIRE(plans[i].has_value() == expected[i].has_value());
      if (!plans[i]) {
        CHECK(plans[i].error().code == expected[i].error().code);
        continue;
      }
      CHECK(test::same_curve(plans[i]->curve, expected[i]->curve));
      CHECK(plans[i]->certificate.lower == expected[i]->certificate.lower);
      CHECK(plans[i]->stats.expanded == expected[i]->stats.expanded);
    }
  }
  CHECK(plan_batch(planner, space, std::vector<Query>{}, 4).empty());
}

TEST_CASE("a search on a large map stops soon after it is cancelled or out of time") {
  OccupancyGrid field = OccupancyGrid::blocked(1024, 1024).value();
  for (int y = 0; y < 1023; ++y) field.set_run(y, 0, 1023, true);  // the goal's row is walled off
  field.set_run(1022, 0, 1023, false);
  field.set_run(1023, 0, 1023, true);
  const auto space = CellSpace::build(std::move(field)).value();
  Query query{.start = space.frame().point({0, 0}), .goal = space.frame().point({0, 1023})};
  Dijkstra::Scratch scratch;
  NoObserver nobody;
  query.budget = Budget::for_seconds(0.002);
  const auto late = Dijkstra{}.search(space, query, scratch, nobody);
  REQUIRE_FALSE(late);
  CHECK(late.error().code == PlanError::budget_exhausted);
  CHECK(late.error().stats.expanded < 1'000'000);  // the whole map would be more

  std::stop_source source;
  query.budget = Budget{.stop = source.get_token()};
  source.request_stop();
  const auto cancelled = Dijkstra{}.search(space, query, scratch, nobody);
  REQUIRE_FALSE(cancelled);
  CHECK(cancelled.error().code == PlanError::cancelled);
  CHECK(cancelled.error().stats.expanded < 256);
}

}  // namespace
