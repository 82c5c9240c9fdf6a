// SPDX-License-Identifier: MIT
#include "tutavia/search/theta_star.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "support/free_route.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/lazy_theta_star.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("Theta* keeps the searcher contract") { test::searcher_contract(ThetaStar{}); }
TEST_CASE("Lazy Theta* keeps the searcher contract") { test::searcher_contract(LazyThetaStar{}); }

/// Where A* finds a path, so does `algorithm`; in free space, and about as short at most.
template <class A>
void check_on_cells(const A& algorithm, std::uint64_t seed, double largest_ratio) {
  Random random(seed);
  typename A::Scratch scratch;
  AStar::Scratch grid_scratch;
  NoObserver no_observer;
  double length = 0, grid_length = 0;
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO(A::name << ", seed " << seed << ", round " << round);
    const auto rule = static_cast<MovementRule>(random.below(2) == 0 ? 0 : random.below(4));
    const double radius = random.below(3) == 0 ? random.uniform(0, 1.5) : 0;
    const auto space =
        CellSpace::build(test::random_grid(random, 50), {.safety_radius = radius, .movement = rule})
            .value();
    // Half of the ends lie off the centres of their cells.
    const auto place = [&] {
      const Point p = space.frame().point(test::random_cell(random, space.grid()));
      return random.below(2) == 0 ? p : Point(p.x() + random.uniform(-0.4, 0.4), p.y() + 0.25);
    };
    const Query query{.start = place(), .goal = place()};
    const auto expected = AStar{}.search(space, query, grid_scratch, no_observer);
    const auto route = algorithm.search(space, query, scratch, no_observer);
    REQUIRE(route.has_value() == expected.has_value());
    if (!route) {
      CHECK(route.error().code == expected.error().code);
      continue;
    }
    ++found;
    REQUIRE(test::is_free(space, *route));
    CHECK(route->curve.start() == query.start);
    CHECK(route->curve.end() == query.goal);
    CHECK(route->cost == Approx(route->curve.length()));
    CHECK(route->cost <= largest_ratio * expected->cost);
    CHECK(route->cost >= distance(query.start, query.goal) * (1 - 1e-12));
    length += route->cost;
    grid_length += expected->cost;
  }
  CHECK(found > test::scaled(300) / 4);
  CHECK(length < 0.99 * grid_length);
}

TEST_CASE("Theta* finds free paths wherever A* does") { check_on_cells(ThetaStar{}, 510, 1.01); }
TEST_CASE("Lazy Theta* finds free paths wherever A* does") {
  check_on_cells(LazyThetaStar{}, 520, 1.01);
}

TEST_CASE("on an empty grid the path is one segment") {
  OccupancyGrid grid = OccupancyGrid::blocked(80, 30).value();
  for (int y = 0; y < 30; ++y) grid.set_run(y, 0, 79, true);
  const auto space = CellSpace::build(grid).value();
  NoObserver no_observer;
  ThetaStar::Scratch scratch;
  for (const Cell goal : {Cell{79, 29}, Cell{1, 28}, Cell{79, 0}, Cell{0, 1}, Cell{0, 0}}) {
    const Query query{.start = space.frame().point(Cell{0, 0}), .goal = space.frame().point(goal)};
    CHECK(ThetaStar{}.search(space, query, scratch, no_observer).value().curve.pieces().size() ==
          1);
    CHECK(
        LazyThetaStar{}.search(space, query, scratch, no_observer).value().curve.pieces().size() ==
        1);
  }
}

}  // namespace
