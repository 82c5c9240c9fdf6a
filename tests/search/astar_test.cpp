// SPDX-License-Identifier: MIT
#include "tutavia/search/astar.hpp"

#include <cstdint>
#include <memory>

#include "support/against_astar.hpp"
#include "support/check_route.hpp"
#include "support/explicit_graph.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

TEST_CASE("A* keeps the searcher contract") { test::searcher_contract(AStar{}); }

TEST_CASE(
    "A* finds paths as short as Dijkstra's with fewer expansions, under every movement rule") {
  const std::uint64_t seed = 40;
  test::WorldGenerator worlds(seed);
  std::uint64_t astar_expanded = 0, dijkstra_expanded = 0;
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto rule = static_cast<MovementRule>(round % 4);
    const auto space =
        LatticeSpace::build(world, {.resolution = world.bounds.width() / 30, .movement = rule})
            .value();
    const Query query{.start = worlds.point(world), .goal = worlds.point(world)};
    const auto a = test::search_once(AStar{}, space, query);
    const auto d = test::search_once(Dijkstra{}, space, query);
    REQUIRE(a.has_value() == d.has_value());
    if (!a) {
      CHECK(a.error().code == d.error().code);
      continue;
    }
    ++found;
    // EndpointLink costs are rounded up to 1 / 13860 of a step.
    CHECK(a->cost == Approx(d->cost).epsilon(0).margin(2 * space.frame().resolution / 13860));
    astar_expanded += a->stats.expanded;
    dijkstra_expanded += d->stats.expanded;
  }
  CHECK(found > test::scaled(100) / 5);
  CHECK(astar_expanded < dijkstra_expanded);
}

TEST_CASE("A* with all successors keeps the searcher contract") {
  test::searcher_contract(AStar{.successors = AStar::Successors::all});
}

TEST_CASE("canonical successors give the same lengths with fewer nodes generated") {
  const test::Effort effort =
      test::against_astar(AStar{.successors = AStar::Successors::all}, 441, &Statistics::generated);
  CHECK(effort.of_astar < effort.own);
}

TEST_CASE("A* tells its observer of every expansion and every label") {
  struct Counter {
    std::uint64_t expansions = 0, labels = 0;
    void expanded(const Point&) { ++expansions; }
    void generated(const Point&) { ++labels; }
  } counter;
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  AStar::Scratch scratch;
  const auto route =
      AStar{}.search(space, {.start = scene.start, .goal = scene.goals[0]}, scratch, counter);
  REQUIRE(route);
  CHECK(counter.expansions == route->stats.expanded);
  CHECK(counter.labels == route->stats.generated);
  CHECK(counter.expansions > 100);
}

TEST_CASE("A* on the built-in maps finds the lengths known for a tolerant lattice") {
  // Array to (6, 8.3) and maze to (14.5, 14.5): an independent prototype gave 9.9349 and 20.7865.
  const auto length = [](const Scene& scene, std::size_t goal) {
    const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
    return test::search_once(AStar{}, space, {.start = scene.start, .goal = scene.goals[goal]})
        .value()
        .cost;
  };
  CHECK(length(maps::array(), 0) == Approx(9.9349).margin(1e-4));
  CHECK(length(maps::array(), 1) == Approx(17.4083).margin(1e-4));
  CHECK(length(maps::maze(), 0) == Approx(20.7865).margin(1e-4));
  CHECK(length(maps::maze(), 2) == Approx(18.8794).margin(1e-4));
}

TEST_CASE("searches with cell costs find the explicit graph's price") {
  const std::uint64_t seed = 420;
  Random random(seed);
  AStar::Scratch astar;
  Dijkstra::Scratch dijkstra;
  NoObserver no_observer;
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 30), {.resolution = 0.5}).value();
    auto costs = std::make_shared<CellCosts>(space.grid());
    for (int y = 0; y < costs->height(); ++y) {
      for (int x = 0; x < costs->width(); ++x) {
        costs->set({x, y}, static_cast<std::uint8_t>(random.below(256)));
      }
    }
    const Query query = test::random_query(random, space);
    if (!space.is_free(query.start) || !space.is_free(query.goal)) continue;
    const auto expected = test::explicit_cost(space, query, costs.get());
    found += expected.has_value();
    test::check_route(space, query, AStar{.costs = costs}.search(space, query, astar, no_observer),
                      expected, 1e-7);
    test::check_route(space, query, Dijkstra{costs}.search(space, query, dijkstra, no_observer),
                      expected, 1e-7);
  }
  CHECK(found > test::scaled(100) / 4);
}

TEST_CASE("with cell costs the straight segment between points off the grid is no shortcut") {
  OccupancyGrid hall = OccupancyGrid::blocked(21, 11).value();
  for (int y = 0; y < 11; ++y) hall.set_run(y, 0, 20, true);
  const auto space = CellSpace::build(std::move(hall)).value();
  auto costs = std::make_shared<CellCosts>(space.grid());
  for (int y = 0; y < 5; ++y) costs->set({10, y}, 255);
  const Query query{.start = {0.75, 0.5}, .goal = {20.25, 0.5}};
  AStar::Scratch scratch;
  NoObserver no_observer;
  const auto plain = AStar{}.search(space, query, scratch, no_observer).value();
  CHECK(plain.curve.length() == 19.5);
  const auto dear = AStar{.costs = costs}.search(space, query, scratch, no_observer);
  test::check_route(space, query, dear, test::explicit_cost(space, query, costs.get()), 1e-3);
  CHECK(dear->curve.length() > 19.5);
}

TEST_CASE("A* refuses cell costs of another grid") {
  const auto space = CellSpace::build(test::free_grid(3, 3)).value();
  const auto costs = std::make_shared<CellCosts>(test::free_grid(4, 3));
  const auto route =
      test::search_once(AStar{.costs = costs}, space, {.start = {0.5, 0.5}, .goal = {2.5, 0.5}});
  REQUIRE_FALSE(route);
  CHECK(route.error().code == PlanError::invalid_option);
}

}  // namespace
