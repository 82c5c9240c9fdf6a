// SPDX-License-Identifier: MIT
// The searches on grids against an explicit graph, and against each other.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/check_route.hpp"
#include "support/explicit_graph.hpp"
#include "support/moving_ai_maps.hpp"
#include "support/random_grids.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/bidirectional_astar.hpp"
#include "tutavia/search/canonical_astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/flow_field.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/jps_plus.hpp"
#include "tutavia/search/penalty_astar.hpp"
#include "tutavia/search/weighted_astar.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/lattice_space.hpp"

namespace {

using namespace tutavia;

/// Scratch memories that live through all queries, as a planner's do.
struct Scratches {
  Dijkstra::Scratch dijkstra;
  AStar::Scratch astar;
  CanonicalAStar::Scratch canonical;
  BidirectionalAStar::Scratch bidirectional;
  Jps::Scratch jps;
  JpsPlus::Scratch jps_plus;
  PenaltyAStar::Scratch penalty;
  WeightedAStar::Scratch weighted;
};

/// Every search that promises a cheapest path finds one.
template <class S>
void check_optimal_searches(const S& space, const Query& query, Scratches& scratch,
                            const std::optional<double>& expected, double tolerance) {
  NoObserver no_observer;
  const auto check = [&](const auto& algorithm, auto& memory) {
    INFO(algorithm.name);
    test::check_route(space, query, algorithm.search(space, query, memory, no_observer), expected,
                      tolerance);
  };
  check(Dijkstra{}, scratch.dijkstra);
  check(AStar{}, scratch.astar);
  check(AStar{.heuristic = HeuristicKind::euclidean}, scratch.astar);
  check(AStar{.heuristic = HeuristicKind::chebyshev}, scratch.astar);
  check(CanonicalAStar{}, scratch.canonical);
  check(BidirectionalAStar{}, scratch.bidirectional);
  check(PenaltyAStar{.turn_penalty = 0}, scratch.penalty);
  check(WeightedAStar{.weight = 1}, scratch.weighted);
  if (space.movement() != MovementRule::four_connected) check(Jps{}, scratch.jps);
  if (space.movement() == MovementRule::no_cut) {
    check(JpsPlus{JpsPlus::prepare(space).value()}, scratch.jps_plus);
  }
}

TEST_CASE("every optimal search finds the explicit graph's cost on random cells, by every rule") {
  const std::uint64_t seed = 400;
  Random random(seed);
  Scratches scratch;
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto rule = static_cast<MovementRule>(random.below(6) < 3 ? 0 : random.below(4));
    const double side = random.below(2) == 0 ? 1.0 : 0.05;
    const auto space =
        CellSpace::build(test::random_grid(random, 60), {.resolution = side, .movement = rule})
            .value();
    const Cell a = test::random_cell(random, space.grid());
    const Cell b = random.below(20) == 0 ? a : test::random_cell(random, space.grid());
    if (!space.grid().is_free(a) || !space.grid().is_free(b)) continue;
    const Query query{.start = space.frame().point(a), .goal = space.frame().point(b)};
    const auto expected = test::explicit_cost(space, query);
    found += expected.has_value();
    check_optimal_searches(space, query, scratch, expected, 1e-7 * side);

    const auto field = FlowField::build(space, std::vector<Point>{query.goal}).value();
    if (expected) CHECK(field.cost(space, a) == Approx(*expected).epsilon(3e-9));
    test::check_route(space, query, field.path(space, query.start), expected, 1e-7 * side);
  }
  CHECK(found > test::scaled(500) / 3);
}

TEST_CASE("every optimal search finds the explicit graph's cost between points off a lattice") {
  const std::uint64_t seed = 410;
  test::WorldGenerator worlds(seed);
  Scratches scratch;
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto rule =
        static_cast<MovementRule>(worlds.random().below(6) < 3 ? 0 : worlds.random().below(4));
    const auto space =
        LatticeSpace::build(world, {.resolution = world.bounds.width() / 30, .movement = rule})
            .value();
    const Query query{.start = worlds.point(world), .goal = worlds.point(world)};
    if (!space.is_free(query.start) || !space.is_free(query.goal) ||
        space.links(query.start).empty() || space.links(query.goal).empty()) {
      continue;
    }
    const bool on_nodes =
        space.links(query.start)[0].length == 0 && space.links(query.goal)[0].length == 0;
    auto expected = test::explicit_cost(space, query);
    if (!on_nodes && space.segment_free(query.start, query.goal)) {
      expected = distance(query.start, query.goal);
    }
    found += expected.has_value();
    // EndpointLink costs are rounded up to 1 / 13860 of a step when paths are compared.
    check_optimal_searches(space, query, scratch, expected, 2.1 * space.frame().resolution / 13860);
  }
  CHECK(found > test::scaled(200) / 5);
}

TEST_CASE("a path longer than 32 bits of cost units is found exactly") {
  // One corridor of width 1 that winds through 1024 x 1024 cells: 524,798 steps.
  constexpr int size = 1024;
  OccupancyGrid maze = OccupancyGrid::blocked(size, size).value();
  for (int y = 0; y < size; y += 2) {
    maze.set_run(y, 0, size - 1, true);
    if (y + 1 < size) maze.set({y % 4 == 0 ? size - 1 : 0, y + 1}, true);
  }
  const auto space = CellSpace::build(std::move(maze)).value();
  const Query query{.start = space.frame().point({0, 0}),
                    .goal = space.frame().point({0, size - 1 - 1})};
  Scratches scratch;
  NoObserver no_observer;
  // 512 rows of 1023 steps, and 511 times 2 steps to the next row.
  constexpr double length = 512.0 * 1023 + 511.0 * 2;
  const auto check = [&](const auto& algorithm, auto& memory) {
    INFO(algorithm.name);
    const auto route = algorithm.search(space, query, memory, no_observer);
    REQUIRE(route);
    CHECK(route->cost == length);
  };
  check(AStar{}, scratch.astar);
  check(CanonicalAStar{}, scratch.canonical);
  check(BidirectionalAStar{}, scratch.bidirectional);
  check(Jps{}, scratch.jps);
  check(JpsPlus{JpsPlus::prepare(space).value()}, scratch.jps_plus);
  check(WeightedAStar{}, scratch.weighted);
}

TEST_CASE("every length of the MovingAI scenarios comes out") {
  std::size_t rows = 0;
  const auto check_map = [&](const test::MovingAiMap& map) {
    const CellSpace& space = map.space;
    const JpsPlus jps_plus{JpsPlus::prepare(space).value()};
    Scratches scratch;
    NoObserver no_observer;
    rows += map.rows.size();
    for (std::size_t i = 0; i < map.rows.size(); ++i) {
      const ScenarioRow& row = map.rows[i];
      INFO(map.name << " line " << row.line);
      const Query query = map.query(row);
      const double tolerance = 0.02 + 1e-5 * row.optimal_length;
      const auto check = [&](const auto& algorithm, auto& memory) {
        INFO(algorithm.name);
        test::check_route(space, query, algorithm.search(space, query, memory, no_observer),
                          row.optimal_length, tolerance);
      };
      check(AStar{}, scratch.astar);
      check(CanonicalAStar{}, scratch.canonical);
      check(BidirectionalAStar{}, scratch.bidirectional);
      check(Jps{}, scratch.jps);
      check(jps_plus, scratch.jps_plus);
      if (i % 5 == 0) check(Dijkstra{}, scratch.dijkstra);
    }
  };
  if (test::for_each_moving_ai_map(test::scaled(50), check_map)) CHECK(rows >= 11 * 50);
}

}  // namespace
