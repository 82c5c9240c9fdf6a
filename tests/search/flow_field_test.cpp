// SPDX-License-Identifier: MIT
#include "tutavia/search/flow_field.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "support/catch.hpp"
#include "support/explicit_graph.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("a flow field leads to the nearest of many goals") {
  const std::uint64_t seed = 450;
  Random random(seed);
  std::size_t found = 0, unreached = 0;
  for (std::size_t round = 0; round < test::scaled(40); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space =
        CellSpace::build(test::random_grid(random, 30), {.movement = test::all_rules[round % 4]})
            .value();
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
}

TEST_CASE("a flow field has the cost of the shortest path from every cell, by every rule") {
  const std::uint64_t seed = 451;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(40); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space =
        CellSpace::build(test::random_grid(random, 40), {.movement = test::all_rules[round % 4]})
            .value();
    const OccupancyGrid& grid = space.grid();
    const Cell goal = test::random_cell(random, grid);
    if (!grid.is_free(goal)) continue;
    const Point goals[] = {space.frame().point(goal)};
    const auto field = FlowField::build(space, goals).value();
    // Every cell costs what its cheapest neighbour costs and the step from there: the only costs
    // for which that holds are those of shortest paths.
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        const Cell cell{x, y};
        if (!grid.is_free(cell) || cell == goal) continue;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t step = 0; step < steps.size(); ++step) {
          if (!grid.can_step(cell, step, space.movement())) continue;
          least = std::min(least, field.cost(space, cell + steps[step]) +
                                      detail::in_metres(detail::step_cost(step), 1));
        }
        CHECK(field.cost(space, cell) == Approx(least).epsilon(1e-9));
      }
    }
    CHECK(field.cost(space, goal) == 0);
  }
}

TEST_CASE("a flow field stops at its budget") {
  const auto space = CellSpace::build(test::free_grid(60, 60)).value();
  const Point goals[] = {{30.5, 30.5}};
  CHECK(FlowField::build(space, goals)->stats().expanded >= 3600);
  const auto few = FlowField::build(space, goals, {.max_expansions = 10});
  REQUIRE_FALSE(few);
  CHECK(few.error().code == PlanError::budget_exhausted);
  CHECK_FALSE(FlowField::build(space, goals, Budget::for_seconds(0)));
}

TEST_CASE("a flow field without goals is refused") {
  const auto space = CellSpace::build(test::free_grid(3, 3)).value();
  CHECK_FALSE(FlowField::build(space, std::vector<Point>{}));
}

}  // namespace
