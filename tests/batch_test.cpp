// SPDX-License-Identifier: MIT
#include "tutavia/batch.hpp"

#include <chrono>
#include <stop_token>
#include <thread>
#include <vector>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/registry.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/weighted_astar.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/shortcut.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

TEST_CASE("a batch gives the same plans on any number of threads") {
  const std::uint64_t seed = 500;
  Random random(seed);
  INFO("seed " << seed);
  const auto space = CellSpace::build(test::random_grid(random, 60)).value();
  std::vector<Query> queries;
  for (std::size_t i = 0; i < test::scaled(100); ++i) {
    queries.push_back(test::random_query(random, space));
  }
  const Planner planner(Jps{}, Shortcut{});
  const auto expected = plan_batch(planner, space, queries, 1);
  REQUIRE(expected.size() == queries.size());
  const auto planned = std::count_if(expected.begin(), expected.end(),
                                     [](const auto& plan) { return plan.has_value(); });
  CHECK(static_cast<std::size_t>(planned) * 3 > queries.size());
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

TEST_CASE("searches by name give the same plans on any number of threads") {
  const std::uint64_t seed = 1;
  Random random(seed);
  INFO("seed " << seed);
  auto grid = OccupancyGrid::blocked(300, 300).value();
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 300; ++x) grid.set({x, y}, random.uniform() < 0.75);
  }
  const auto space = CellSpace::build(std::move(grid)).value();
  std::vector<Query> queries;
  for (std::size_t i = 0; i < test::scaled(200); ++i) {
    queries.push_back(test::random_query(random, space));
  }
  const auto jps_plus =
      detail::erase_jps_plus<CellSpace>();  // its table is prepared by the first to ask
  for (const auto& search : {erase_search<CellSpace>(AStar{}), jps_plus}) {
    INFO(search.name);
    const Planner planner(search);
    const auto two = plan_batch(planner, space, queries, 2);
    const auto one = plan_batch(planner, space, queries, 1);
    std::size_t planned = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      REQUIRE(one[i].has_value() == two[i].has_value());
      if (!one[i]) continue;
      ++planned;
      CHECK(test::same_curve(one[i]->curve, two[i]->curve));
    }
    CHECK(planned * 3 > queries.size());
  }
}

TEST_CASE("a batch keeps every option of its planner") {
  const Scene scene = maps::array();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  Planner planner(WeightedAStar{.weight = 3}, DeltaSmoother{.join = DeltaSmoother::Join::paper});
  std::vector<Query> queries;
  for (const Point& goal : scene.goals) queries.push_back({.start = scene.start, .goal = goal});
  const auto plans = plan_batch(planner, space, queries, 2);
  bool differs = false;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto alone = planner.plan(space, queries[i]);
    CHECK(test::same_curve(plans[i].value().curve, alone->curve));
    const auto other = Planner{WeightedAStar{}, DeltaSmoother{}}.plan(space, queries[i]);
    differs = differs || !test::same_curve(alone->curve, other->curve);
  }
  CHECK(differs);  // the options matter
}

TEST_CASE("a search on a large map stops soon after it is cancelled or out of time") {
  OccupancyGrid field = OccupancyGrid::blocked(1024, 1024).value();
  for (int y = 0; y < 1023; ++y) field.set_run(y, 0, 1023, true);  // the goal's row is walled off
  field.set_run(1022, 0, 1023, false);
  field.set_run(1023, 0, 1023, true);
  const auto space = CellSpace::build(std::move(field)).value();
  Query query{.start = space.frame().point({0, 0}), .goal = space.frame().point({0, 1023})};
  Dijkstra::Scratch scratch;
  NoObserver no_observer;
  query.budget = Budget::for_seconds(0.002);
  const auto late = Dijkstra{}.search(space, query, scratch, no_observer);
  REQUIRE_FALSE(late);
  CHECK(late.error().code == PlanError::budget_exhausted);
  CHECK(late.error().stats.expanded < 1'000'000);  // the whole map would be more

  std::stop_source source;
  query.budget = Budget{.stop = source.get_token()};
  source.request_stop();
  const auto cancelled = Dijkstra{}.search(space, query, scratch, no_observer);
  REQUIRE_FALSE(cancelled);
  CHECK(cancelled.error().code == PlanError::cancelled);
  CHECK(cancelled.error().stats.expanded < 256);
}

}  // namespace
