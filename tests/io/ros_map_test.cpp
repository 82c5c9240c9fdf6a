// SPDX-License-Identifier: MIT
#include "tutavia/io/ros_map.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;

std::string grid_complaint(const Expected<OccupancyGrid, Failure>& result) {
  REQUIRE_FALSE(result);
  CHECK(result.error().code == PlanError::invalid_input);
  return result.error().detail;
}

TEST_CASE("the grid of a map has its row 0 at the bottom and unknown cells as asked") {
  RosMap map;
  map.width = 3;
  map.height = 2;
  map.values = {0, -1, 100, 100, -1, 0};
  const auto blocked = to_grid(map, RosMap::UnknownCells::blocked);
  REQUIRE(blocked);
  CHECK(blocked->width() == 3);
  CHECK(blocked->height() == 2);
  CHECK(blocked->count_free() == 2);
  CHECK(blocked->is_free(Cell{0, 0}));
  CHECK(blocked->is_free(Cell{2, 1}));
  const auto free = to_grid(map, RosMap::UnknownCells::free);
  REQUIRE(free);
  CHECK(free->count_free() == 4);
  CHECK(free->is_free(Cell{1, 0}));
  CHECK(free->is_free(Cell{1, 1}));
}

TEST_CASE("cells of a map are blocked from the asked value on") {
  RosMap map;
  map.width = 5;
  map.height = 1;
  map.values = {0, 49, 50, 99, 100};
  const auto count = [&](int occupied_at) {
    return to_grid(map, RosMap::UnknownCells::blocked, occupied_at)->count_free();
  };
  CHECK(to_grid(map, RosMap::UnknownCells::blocked)->count_free() == 4);
  CHECK(count(100) == 4);
  CHECK(count(99) == 3);
  CHECK(count(50) == 2);
  CHECK(count(1) == 1);
  for (const int occupied_at : {0, -1, 101}) {
    const auto grid = to_grid(map, RosMap::UnknownCells::blocked, occupied_at);
    REQUIRE_FALSE(grid);
    CHECK(grid.error().code == PlanError::invalid_option);
    CHECK(grid.error().detail ==
          "occupied_at: expected 1 to 100, found " + std::to_string(occupied_at));
  }
}

TEST_CASE("a map whose values do not fit becomes no grid") {
  RosMap map;
  map.width = 2;
  map.height = 2;
  map.values = {0, 0, 0};
  CHECK(grid_complaint(to_grid(map, RosMap::UnknownCells::free)) ==
        "expected 2 x 2 values, found 3");
  map.values = {0, 0, 0, 101};
  CHECK(grid_complaint(to_grid(map, RosMap::UnknownCells::free)) ==
        "values[3]: expected -1 to 100, found 101");
  map.values = {0, -2, 0, 0};
  CHECK(grid_complaint(to_grid(map, RosMap::UnknownCells::free)) ==
        "values[1]: expected -1 to 100, found -2");
  map.values = {};
  map.width = -2;
  CHECK(grid_complaint(to_grid(map, RosMap::UnknownCells::free)) == "grid size is negative");
  map.width = map.height = std::numeric_limits<int>::max();
  CHECK(grid_complaint(to_grid(map, RosMap::UnknownCells::free)).find("values, found 0") !=
        std::string::npos);
}

TEST_CASE("points go from the map frame to the grid frame and back") {
  RosMap map;
  map.origin = {-10, 4};
  CHECK(to_grid_frame(map, {-10, 4}) == Point(0, 0));
  CHECK(to_grid_frame(map, {-8, 5}) == Point(2, 1));
  CHECK(to_map_frame(map, {2, 1}) == Point(-8, 5));
  map.origin = {1, 2};
  map.yaw = std::numbers::pi / 2;  // the image's rows run along the map's y axis
  CHECK(distance(to_map_frame(map, {3, 0}), {1, 5}) < 1e-15);
  CHECK(distance(to_map_frame(map, {0, 1}), {0, 2}) < 1e-15);
  CHECK(distance(to_grid_frame(map, {1, 5}), {3, 0}) < 1e-15);
  CHECK(distance(to_grid_frame(map, {0, 2}), {0, 1}) < 1e-15);
  const std::uint64_t seed = 5;
  CAPTURE(seed);
  Random random(seed);
  const auto point = [&] { return Point(random.uniform(-50, 50), random.uniform(-50, 50)); };
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    map.origin = point();
    map.yaw = random.uniform(-7, 7);
    const Point p = point(), q = point();
    CAPTURE(round);
    REQUIRE(distance(to_map_frame(map, to_grid_frame(map, p)), p) < 1e-12);
    REQUIRE(distance(to_grid_frame(map, to_map_frame(map, p)), p) < 1e-12);
    REQUIRE(distance(to_grid_frame(map, p), to_grid_frame(map, q)) ==
            Approx(distance(p, q)).epsilon(1e-12));
  }
}

TEST_CASE("a costmap is blocked from the asked cost on and where it knows nothing as asked") {
  const std::vector<std::uint8_t> costs = {0, 252, 253, 254, 255, 1};
  const auto grid = grid_from_costmap(costs, 3, 2, 253, RosMap::UnknownCells::blocked);
  REQUIRE(grid);
  CHECK(grid->count_free() == 3);
  CHECK(grid->is_free(Cell{1, 0}));
  CHECK_FALSE(grid->is_free(Cell{2, 0}));
  CHECK(grid->is_free(Cell{2, 1}));
  CHECK(grid_from_costmap(costs, 3, 2, 254, RosMap::UnknownCells::blocked)->count_free() == 4);
  CHECK(grid_from_costmap(costs, 3, 2, 254, RosMap::UnknownCells::free)->count_free() == 5);
  CHECK(grid_from_costmap(costs, 3, 2, 1, RosMap::UnknownCells::free)->count_free() == 2);
  CHECK(grid_complaint(grid_from_costmap(costs, 3, 3, 254, RosMap::UnknownCells::free)) ==
        "expected 3 x 3 values, found 6");
  CHECK(grid_complaint(grid_from_costmap(costs, -3, -2, 254, RosMap::UnknownCells::free)) ==
        "grid size is negative");
  for (const int blocked_at : {0, 255}) {
    const auto refused = grid_from_costmap(costs, 3, 2, blocked_at, RosMap::UnknownCells::free);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == PlanError::invalid_option);
  }
}

}  // namespace
