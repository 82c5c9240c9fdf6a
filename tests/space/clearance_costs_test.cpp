// SPDX-License-Identifier: MIT
#include "tutavia/space/clearance_costs.hpp"

#include <limits>
#include <utility>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

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

TEST_CASE("clearance costs fall linearly from the safety radius on, and blocked cells have none") {
  // A wall at the left: centres lie 0.5, 1.5, 2.5, ... from it.
  OccupancyGrid grid = test::free_grid(8, 1);
  grid.set({0, 0}, false);
  const auto space = CellSpace::build(std::move(grid), {.safety_radius = 0.5}).value();
  const auto costs = clearance_costs(space, {.distance = 4, .weight = 2}).value();
  const int expected[] = {0, 64, 48, 32, 16, 0, 0, 0};  // 32 x 2 x (1 - gap / 4)
  for (int x = 0; x < 8; ++x) {
    CAPTURE(x);
    CHECK((*costs)[{x, 0}] == expected[x]);
  }
}

TEST_CASE("clearance costs refuse a distance or a weight without a meaning") {
  const auto space = CellSpace::build(test::free_grid(3, 3)).value();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, infinity, nan}) {
    CAPTURE(bad);
    CHECK_FALSE(clearance_costs(space, {.distance = bad}));
  }
  for (const double bad : {-0.1, 8.0, nan}) {
    CAPTURE(bad);
    CHECK_FALSE(clearance_costs(space, {.weight = bad}));
  }
  CHECK(clearance_costs(space, {.weight = 0}));
  CHECK(clearance_costs(space, {.weight = 255.0 / 32}));
}

}  // namespace
