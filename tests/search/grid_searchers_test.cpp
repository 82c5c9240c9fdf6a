// SPDX-License-Identifier: MIT
// The searches on grids against an explicit graph, and against each other.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/explicit_graph.hpp"
#include "support/free_route.hpp"
#include "support/moving_ai_maps.hpp"
#include "support/prepared.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
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
#include "tutavia/space/clearance_costs.hpp"
#include "tutavia/space/lattice_space.hpp"

namespace {

using namespace tutavia;

/// Checks one answer against the length of the explicit graph: the same within `tolerance`, and a
/// route in free space from start to goal.
template <class S>
void check_route(const S& space, const Query& query, const Expected<Route, Failure>& route,
                 const std::optional<double>& expected, double tolerance) {
  REQUIRE(route.has_value() == expected.has_value());
  if (!route) {
    CHECK(route.error().code == PlanError::unreachable_at_resolution);
    return;
  }
  CHECK(route->cost == Approx(*expected).epsilon(0).margin(tolerance));
  CHECK(route->curve.start() == query.start);
  CHECK(route->curve.end() == query.goal);
  CHECK(test::is_free(space, *route));
}

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
    check_route(space, query, algorithm.search(space, query, memory, no_observer), expected,
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
  if (space.movement() == MovementRule::no_cut) {
    check(Jps{}, scratch.jps);
    check(JpsPlus{JpsPlus::prepare(space).value()}, scratch.jps_plus);
  } else {
    const auto refused = Jps{}.search(space, query, scratch.jps, no_observer);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == PlanError::invalid_option);
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
    check_route(space, query, field.path(space, query.start), expected, 1e-7 * side);
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

TEST_CASE("searches with cell costs find the explicit graph's price") {
  const std::uint64_t seed = 420;
  Random random(seed);
  Scratches scratch;
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
    check_route(space, query,
                AStar{.costs = costs}.search(space, query, scratch.astar, no_observer), expected,
                1e-7);
    check_route(space, query, Dijkstra{costs}.search(space, query, scratch.dijkstra, no_observer),
                expected, 1e-7);
  }
  CHECK(found > test::scaled(100) / 4);
}

TEST_CASE("penalty A* minimises length plus penalty times turning") {
  const std::uint64_t seed = 430;
  Random random(seed);
  Scratches scratch;
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
    check_route(space, query,
                PenaltyAStar{penalty}.search(space, query, scratch.penalty, no_observer), expected,
                0.01);
  }
  CHECK(found > test::scaled(100) / 4);
}

TEST_CASE("weighted A* keeps its bound, and A* by Manhattan distance that of sqrt 2") {
  const std::uint64_t seed = 440;
  Random random(seed);
  Scratches scratch;
  NoObserver no_observer;
  bool longer = false;
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 60)).value();
    const Query query = test::random_query(random, space);
    if (!space.is_free(query.start) || !space.is_free(query.goal)) continue;
    const double weight = random.uniform(1, 4);
    const auto best = AStar{}.search(space, query, scratch.astar, no_observer);
    const auto fast = WeightedAStar{weight}.search(space, query, scratch.weighted, no_observer);
    const auto greedy = AStar{.heuristic = HeuristicKind::manhattan}.search(
        space, query, scratch.astar, no_observer);
    REQUIRE(best.has_value() == fast.has_value());
    REQUIRE(best.has_value() == greedy.has_value());
    if (!best) continue;
    ++found;
    CHECK(fast->cost <= weight * best->cost * (1 + 1e-9));
    CHECK(greedy->cost <= 1.4142136 * best->cost * (1 + 1e-9));
    longer = longer || fast->cost > best->cost + 1e-9;
  }
  CHECK(longer);
  CHECK(found > test::scaled(100) / 3);
}

TEST_CASE("a flow field leads to the nearest of many goals") {
  const std::uint64_t seed = 450;
  Random random(seed);
  std::size_t found = 0, unreached = 0;
  for (std::size_t round = 0; round < test::scaled(40); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 30)).value();
    std::vector<Point> goals;
    for (int i = 0; i < 3; ++i) {
      const Cell cell = test::random_cell(random, space.grid());
      if (space.grid().is_free(cell)) goals.push_back(space.frame().point(cell));
    }
    const Cell start = test::random_cell(random, space.grid());
    if (goals.empty() || !space.grid().is_free(start)) continue;
    const auto field = FlowField::build(space, goals).value();
    std::optional<double> nearest;
    for (const Point& goal : goals) {
      const auto cost =
          test::explicit_cost(space, {.start = space.frame().point(start), .goal = goal});
      if (cost && (!nearest || *cost < *nearest)) nearest = cost;
    }
    const auto route = field.path(space, space.frame().point(start));
    REQUIRE(route.has_value() == nearest.has_value());
    if (!nearest) {
      const auto near = field.nearest_reached(space, space.frame().point(start));
      REQUIRE(near);
      CHECK(field.reached(space, *near));
      ++unreached;
      continue;
    }
    ++found;
    CHECK(route->cost == Approx(*nearest).epsilon(1e-9));
    CHECK(std::find(goals.begin(), goals.end(), route->curve.end()) != goals.end());
  }
  CHECK(found > test::scaled(40) / 2);
  CHECK(unreached > 0);
  const auto space = CellSpace::build(test::random_grid(random, 5)).value();
  CHECK_FALSE(FlowField::build(space, std::vector<Point>{}));
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

TEST_CASE("the searches on grids keep the searcher contract") {
  test::searcher_contract(WeightedAStar{});
  test::searcher_contract(CanonicalAStar{});
  test::searcher_contract(BidirectionalAStar{});
  test::searcher_contract(PenaltyAStar{});
  test::searcher_contract(Jps{});
  test::searcher_contract(test::PreparedEachTime<JpsPlus>{});
}

TEST_CASE("searches refuse options without a meaning") {
  const auto space = CellSpace::build(OccupancyGrid::blocked(3, 3).value()).value();
  const Query query{.start = {0.5, 0.5}, .goal = {2.5, 0.5}};
  const auto code = [&](const auto& algorithm) {
    typename std::decay_t<decltype(algorithm)>::Scratch scratch;
    NoObserver no_observer;
    const auto route = algorithm.search(space, query, scratch, no_observer);
    REQUIRE_FALSE(route);
    return route.error().code;
  };
  CHECK(code(WeightedAStar{0.5}) == PlanError::invalid_option);
  CHECK(code(WeightedAStar{std::nan("")}) == PlanError::invalid_option);
  CHECK(code(PenaltyAStar{-1}) == PlanError::invalid_option);
  CHECK(code(JpsPlus{}) == PlanError::invalid_option);
  const CellCosts other(OccupancyGrid::blocked(4, 3).value());
  CHECK(code(AStar{.costs = std::make_shared<CellCosts>(other)}) == PlanError::invalid_option);
  CHECK_FALSE(clearance_costs(space, {.distance = 0}));
  CHECK_FALSE(clearance_costs(space, {.weight = 8}));
}

TEST_CASE("clearance costs keep paths away from walls") {
  OccupancyGrid hall = OccupancyGrid::blocked(21, 11).value();
  for (int y = 1; y < 10; ++y) hall.set_run(y, 0, 20, true);
  const auto space = CellSpace::build(std::move(hall)).value();
  const auto costs = clearance_costs(space, {.distance = 3, .weight = 4}).value();
  CHECK((*costs)[{10, 1}] == 107);  // 32 x 4 x (1 - 0.5 / 3), rounded
  CHECK((*costs)[{10, 5}] == 0);
  AStar::Scratch scratch;
  NoObserver no_observer;
  const Query query{.start = space.frame().point({0, 1}), .goal = space.frame().point({20, 1})};
  const auto close = AStar{}.search(space, query, scratch, no_observer).value();
  const auto far = AStar{.costs = costs}.search(space, query, scratch, no_observer).value();
  CHECK(close.curve.length() == 20);
  CHECK(far.curve.length() > 20);
  CHECK(space.clearance(far.curve.at(far.curve.length() / 2).position) >= 3);
}

TEST_CASE("with cell costs the straight segment between points off the grid is no shortcut") {
  OccupancyGrid hall = OccupancyGrid::blocked(21, 11).value();
  for (int y = 0; y < 11; ++y) hall.set_run(y, 0, 20, true);
  const auto space = CellSpace::build(std::move(hall)).value();
  auto costs = std::make_shared<CellCosts>(space.grid());
  for (int y = 0; y < 5; ++y) costs->set({10, y}, 255);
  const Query query{.start = {0.75, 0.5}, .goal = {20.25, 0.5}};
  Scratches scratch;
  NoObserver no_observer;
  const auto plain = AStar{}.search(space, query, scratch.astar, no_observer).value();
  CHECK(plain.curve.length() == 19.5);
  const auto dear = AStar{.costs = costs}.search(space, query, scratch.astar, no_observer);
  check_route(space, query, dear, test::explicit_cost(space, query, costs.get()), 1e-3);
  CHECK(dear->curve.length() > 19.5);
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
        check_route(space, query, algorithm.search(space, query, memory, no_observer),
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
