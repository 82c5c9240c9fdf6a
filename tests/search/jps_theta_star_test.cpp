// SPDX-License-Identifier: MIT
#include "tutavia/search/jps_theta_star.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "support/free_route.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("JPS_Theta* keeps the searcher contract, whenever it uses lines of sight") {
  test::searcher_contract(JpsThetaStar{});
  test::searcher_contract(JpsThetaStar{.lines_of_sight = JpsThetaStar::LineOfSight::in_search});
  test::searcher_contract(JpsThetaStar{.lines_of_sight = JpsThetaStar::LineOfSight::never});
}

TEST_CASE("JPS_Theta* keeps its bound and gains by lines of sight on random grids", "[soak]") {
  const std::uint64_t seed = 530;
  Random random(seed);
  JpsThetaStar::Scratch scratch;
  AStar::Scratch grid_scratch;
  NoObserver no_observer;
  std::size_t found = 0;
  double worst = 0, jumps = 0, after = 0, during = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 60)).value();
    const Query query = test::random_query(random, space);
    const auto shortest = AStar{}.search(space, query, grid_scratch, no_observer);
    const auto search = [&](JpsThetaStar::LineOfSight use) {
      return JpsThetaStar{.lines_of_sight = use}.search(space, query, scratch, no_observer);
    };
    const auto never = search(JpsThetaStar::LineOfSight::never),
               pruned = search(JpsThetaStar::LineOfSight::after_search),
               looked = search(JpsThetaStar::LineOfSight::in_search);
    REQUIRE(never.has_value() == shortest.has_value());
    REQUIRE(pruned.has_value() == shortest.has_value());
    REQUIRE(looked.has_value() == shortest.has_value());
    if (!shortest) continue;
    ++found;
    for (const auto* route : {&*never, &*pruned, &*looked}) {
      CHECK(route->curve.start() == query.start);
      CHECK(route->curve.end() == query.goal);
      REQUIRE(test::is_free(space, *route));
      CHECK(route->cost <= 2 * shortest->cost * (1 + 1e-12));
    }
    CHECK(pruned->cost <= never->cost * (1 + 1e-12));
    CHECK(never->cost >= shortest->cost * (1 - 1e-8));
    if (shortest->cost > 0) worst = std::max(worst, never->cost / shortest->cost);
    jumps += never->cost;
    after += pruned->cost;
    during += looked->cost;
  }
  INFO(found << " paths, the longest " << worst
             << " times the shortest on the grid; lines of sight after the search take off "
             << 100 * (1 - after / jumps) << " %, during it " << 100 * (1 - during / jumps)
             << " %");
  CHECK(found > test::scaled(300) / 3);
  CHECK(after < jumps);
}

TEST_CASE("with weights of at most 1 JPS_Theta* finds shortest grid paths before it straightens") {
  Random random(531);
  JpsThetaStar::Scratch scratch;
  AStar::Scratch grid_scratch;
  NoObserver no_observer;
  const JpsThetaStar exact{
      .far_weight = 1, .near_weight = 0.5, .lines_of_sight = JpsThetaStar::LineOfSight::never};
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    const auto space = CellSpace::build(test::random_grid(random, 40)).value();
    const Query query = test::random_query(random, space);
    const auto shortest = AStar{}.search(space, query, grid_scratch, no_observer);
    const auto route = exact.search(space, query, scratch, no_observer);
    REQUIRE(route.has_value() == shortest.has_value());
    if (!route) continue;
    ++found;
    CHECK(route->cost == Approx(shortest->cost).epsilon(1e-8));
  }
  CHECK(found > test::scaled(100) / 3);
}

TEST_CASE("the map of the JPS_Theta* paper") {
  // 20 rows of 30 cells, the first one on top; reconstructed from the paper's figure.
  constexpr std::array<std::string_view, 20> rows{
      "..#.......#...................", "..#.......#...................",
      ".##.......#.........#.........", ".##.......#.........#..#####..",
      ".######...#...................", "..........#...................",
      "..............................", ".......##.....................",
      "........................##....", "..................##....##....",
      "..................##....##....", "........................##....",
      ".......##...............##....", ".......##.....................",
      ".......##............##.......", ".......##............##.......",
      ".......##............##...#...", ".....................##...#...",
      ".....###.............##...#...", ".....###..................#..."};
  OccupancyGrid grid = OccupancyGrid::blocked(30, 20).value();
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 30; ++x) {
      grid.set({x, y}, rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] != '#');
    }
  }
  const auto space = CellSpace::build(grid).value();
  const Query query{.start = space.frame().point(Cell{0, 0}),
                    .goal = space.frame().point(Cell{28, 19})};
  NoObserver no_observer;
  AStar::Scratch grid_scratch;
  JpsThetaStar::Scratch scratch;
  const auto astar = AStar{}.search(space, query, grid_scratch, no_observer).value();
  CHECK(astar.cost == Approx(25 + 11 * std::sqrt(2.0)));  // 40.55, as the paper prints it
  const auto never = JpsThetaStar{.lines_of_sight = JpsThetaStar::LineOfSight::never}
                         .search(space, query, scratch, no_observer)
                         .value();
  const auto pruned = JpsThetaStar{}.search(space, query, scratch, no_observer).value();
  const auto looked = JpsThetaStar{.lines_of_sight = JpsThetaStar::LineOfSight::in_search}
                          .search(space, query, scratch, no_observer)
                          .value();
  const auto text = [](const Route& route) {
    return std::to_string(route.curve.length()) + " m, " +
           std::to_string(measure(route.curve).turning_points) + " turns, " +
           std::to_string(route.stats.expanded) + " expanded";
  };
  INFO("A*: " << text(astar));
  INFO("JPS, weighted: " << text(never));
  INFO("JPS_Theta*: " << text(pruned));
  INFO("JPS_Theta*, in search: " << text(looked));
  CHECK(pruned.cost < never.cost);
  CHECK(pruned.cost < astar.cost);
}

TEST_CASE("JPS_Theta* refuses weights that are none, and other movement rules") {
  const auto space = CellSpace::build(OccupancyGrid::blocked(3, 3).value()).value();
  JpsThetaStar::Scratch scratch;
  NoObserver no_observer;
  for (const double weight : {-1.0, 1e300, std::nan("")}) {
    for (const JpsThetaStar& bad :
         {JpsThetaStar{.far_weight = weight}, JpsThetaStar{.near_weight = weight}}) {
      const auto route = bad.search(space, {.start = {1, 1}, .goal = {1, 1}}, scratch, no_observer);
      REQUIRE_FALSE(route);
      CHECK(route.error().code == PlanError::invalid_option);
    }
  }
  const auto other =
      CellSpace::build(OccupancyGrid::blocked(3, 3).value(), {.movement = MovementRule::allow})
          .value();
  CHECK(JpsThetaStar{}
            .search(other, {.start = {1, 1}, .goal = {1, 1}}, scratch, no_observer)
            .error()
            .code == PlanError::invalid_option);
}

}  // namespace
