// SPDX-License-Identifier: MIT
#include "tutavia/search/grid/grid_query.hpp"

#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

std::vector<Cell> appended(const std::vector<Cell>& path) {
  std::vector<Cell> cells;
  for (const Cell cell : path) append_cell(cells, cell);
  return cells;
}

TEST_CASE("of cells in line only the ends are kept") {
  CHECK(appended({{0, 0}, {1, 0}, {2, 0}, {5, 0}}) == std::vector<Cell>{{0, 0}, {5, 0}});
  CHECK(appended({{0, 0}, {2, 1}, {6, 3}}) == std::vector<Cell>{{0, 0}, {6, 3}});
  CHECK(appended({{0, 0}, {1, 1}, {2, 1}}) == std::vector<Cell>{{0, 0}, {1, 1}, {2, 1}});
  CHECK(appended({{0, 0}, {2, 1}, {3, 2}}) == std::vector<Cell>{{0, 0}, {2, 1}, {3, 2}});
  CHECK(appended({{0, 0}, {3, 0}, {1, 0}}) ==  // back again
        std::vector<Cell>{{0, 0}, {3, 0}, {1, 0}});
  CHECK(appended({{4, 4}, {4, 4}, {4, 4}}) == std::vector<Cell>{{4, 4}});
}

TEST_CASE("links cost their lengths in steps, rounded up") {
  EndpointLinks links;
  links.push_back({{1, 2}, 0.5});
  links.push_back({{2, 2}, 0.5 + 1e-9});
  const CellLinks costs(links, 0.5);
  CHECK(costs.cost_of({1, 2}) == straight_cost);
  CHECK(costs.cost_of({2, 2}) == straight_cost + 1);
  CHECK_FALSE(costs.cost_of({3, 2}));
  CHECK_FALSE(costs.is_cell());
  CHECK(in_metres(2 * straight_cost, 0.5) == 1);
}

TEST_CASE("a query between cell centres is linked to those cells alone") {
  const auto space = CellSpace::build(test::free_grid(5, 5)).value();
  const Query query{.start = {0.5, 0.5}, .goal = {4.5, 2.5}};
  const auto linked = link_to_grid(space, query, StraightSegment::tried_first).value();
  CHECK(linked.starts.is_cell());
  CHECK(linked.goals.is_cell());
  CHECK(linked.start_cell == Cell{0, 0});
  CHECK(linked.goal_cell == Cell{4, 2});
  CHECK(linked.goal_offset == 0);
  CHECK_FALSE(linked.is_straight);  // the grid is searched
  CHECK(linked.exit_cost({4, 2}) == Cost{0});
  CHECK_FALSE(linked.exit_cost({3, 2}));
  const GridQuery back = linked.reversed();
  CHECK(back.start_cell == Cell{4, 2});
  CHECK(back.goal_cell == Cell{0, 0});
}

TEST_CASE("a query off the grid takes its straight segment where that is free and asked for") {
  const auto space = CellSpace::build(test::free_grid(5, 5)).value();
  const Query query{.start = {0.7, 0.6}, .goal = {4.4, 2.1}};
  CHECK(link_to_grid(space, query, StraightSegment::tried_first)->is_straight);
  const auto linked = link_to_grid(space, query, StraightSegment::ignored).value();
  CHECK_FALSE(linked.is_straight);
  CHECK(linked.starts.size() > 1);
  for (const auto& [cell, cost] : linked.goals) {
    CHECK(linked.near_goal(cell));
    CHECK(cost - octile_cost(cell, linked.goal_cell) >= linked.goal_offset);
  }
}

TEST_CASE("a free end without a cell that it reaches has no path at this resolution") {
  // The radius leaves no cell free, but the grid's free corner is far enough from the blocked one.
  OccupancyGrid grid = test::free_grid(2, 2);
  grid.set({0, 0}, false);
  const auto space = CellSpace::build(std::move(grid), {.safety_radius = 1.2}).value();
  REQUIRE(space.grid().count_free() == 0);
  REQUIRE(space.is_free({2, 2}));
  const Query query{.start = {2, 2}, .goal = {1.9, 2}};
  CHECK(link_to_grid(space, query, StraightSegment::tried_first)->is_straight);
  const auto refused = link_to_grid(space, query, StraightSegment::ignored);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::unreachable_at_resolution);
  CHECK(refused.error().detail.find("the start is free, but") == 0);
}

TEST_CASE("a path through cells leaves out those at which the query starts and ends") {
  const auto space = CellSpace::build(test::free_grid(5, 5)).value();
  const Query query{.start = {0.5, 0.5}, .goal = {4.5, 2.5}};
  const auto linked = link_to_grid(space, query, StraightSegment::ignored).value();
  const std::vector<Cell> cells{{4, 2}, {2, 2}, {0, 0}};  // from the goal to the start
  const Curve path = path_through(cells, linked, query, space.frame());
  REQUIRE(path.pieces().size() == 2);
  CHECK(path.start() == query.start);
  CHECK(end_of(path.pieces()[0]) == Point(2.5, 2.5));
  CHECK(path.end() == query.goal);
  const Query nowhere{.start = {0.5, 0.5}, .goal = {0.5, 0.5}};
  const auto there = link_to_grid(space, nowhere, StraightSegment::ignored).value();
  CHECK(path_through(std::vector<Cell>{{0, 0}}, there, nowhere, space.frame()).length() == 0);
}

}  // namespace
