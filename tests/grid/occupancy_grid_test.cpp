// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

namespace {

using namespace tutavia;

OccupancyGrid make(int width, int height) { return OccupancyGrid::blocked(width, height).value(); }

TEST_CASE("a new grid has the asked size and not one free cell", "[grid]") {
  const OccupancyGrid grid = make(5, 3);
  CHECK(grid.width() == 5);
  CHECK(grid.height() == 3);
  CHECK(grid.count_free() == 0);
  CHECK_FALSE(grid.is_free(Cell{2, 1}));
  CHECK(OccupancyGrid().width() == 0);
  CHECK(OccupancyGrid().height() == 0);
  CHECK(make(0, 7).height() == 7);
  CHECK_FALSE(OccupancyGrid().contains({0, 0}));
  CHECK_FALSE(OccupancyGrid().is_free(Cell{0, 0}));
}

TEST_CASE("a grid contains its cells and not those of its frame", "[grid]") {
  const OccupancyGrid grid = make(3, 2);
  for (int y = -1; y <= 2; ++y) {
    for (int x = -1; x <= 3; ++x) {
      CAPTURE(x, y);
      CHECK(grid.contains({x, y}) == (x >= 0 && x < 3 && y >= 0 && y < 2));
    }
  }
}

TEST_CASE("padding stays blocked and rows apart at every width around a word", "[grid]") {
  for (const int width : {1, 2, 61, 62, 63, 64, 65, 126, 127, 130}) {
    CAPTURE(width);
    OccupancyGrid grid = make(width, 3);
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < width; ++x) grid.set({x, y}, true);
    }
    CHECK(grid.count_free() == static_cast<std::size_t>(3 * width));
    std::set<std::size_t> indices;
    for (int y = -1; y <= 3; ++y) {
      for (int x = -1; x <= width; ++x) {
        const std::size_t index = grid.index({x, y});
        indices.insert(index);
        if (grid.is_free(Cell{x, y}) != grid.contains({x, y}) || grid.cell(index) != Cell{x, y} ||
            grid.is_free(index) != grid.contains({x, y}) || index >= grid.index_count()) {
          FAIL("cell " << x << ", " << y);
        }
      }
    }
    CHECK(indices.size() == static_cast<std::size_t>(5 * (width + 2)));
    CHECK(grid.index({0, 1}) - grid.index({0, 0}) == grid.stride());
    CHECK(grid.index_count() == 5 * grid.stride());
  }
}

TEST_CASE("set() changes one cell and no other", "[grid]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  OccupancyGrid grid = make(70, 9);
  std::set<std::pair<int, int>> free;
  for (std::size_t round = 0; round < test::scaled(2000); ++round) {
    const Cell cell{static_cast<int>(random.below(70)), static_cast<int>(random.below(9))};
    const bool value = random.below(2) == 0;
    grid.set(cell, value);
    if (value) {
      free.insert({cell.x, cell.y});
    } else {
      free.erase({cell.x, cell.y});
    }
    INFO("round " << round);
    REQUIRE(grid.is_free(cell) == value);
    REQUIRE(grid.count_free() == free.size());
  }
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 70; ++x) {
      if (grid.is_free(Cell{x, y}) != (free.count({x, y}) > 0)) FAIL("cell " << x << ", " << y);
    }
  }
}

TEST_CASE("can_step() follows the rules in every 3 x 3 neighbourhood", "[grid]") {
  for (int pattern = 0; pattern < 512; ++pattern) {
    OccupancyGrid grid = make(3, 3);
    const auto free = [&](int x, int y) { return (pattern >> (3 * y + x) & 1) != 0; };
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 3; ++x) grid.set({x, y}, free(x, y));
    }
    for (std::size_t i = 0; i < 8; ++i) {
      const int dx = steps[i].x, dy = steps[i].y;
      const bool target = free(1 + dx, 1 + dy), diagonal = dx != 0 && dy != 0;
      const bool beside_x = free(1 + dx, 1), beside_y = free(1, 1 + dy);
      const auto can = [&](MovementRule rule) { return grid.can_step({1, 1}, i, rule); };
      CAPTURE(pattern, i);
      REQUIRE(can(MovementRule::allow) == target);
      REQUIRE(can(MovementRule::four_connected) == (target && !diagonal));
      REQUIRE(can(MovementRule::no_cut) == (target && (!diagonal || (beside_x && beside_y))));
      REQUIRE(can(MovementRule::no_squeeze) == (target && (!diagonal || beside_x || beside_y)));
    }
  }
}

TEST_CASE("no step leaves the grid", "[grid]") {
  OccupancyGrid grid = make(1, 1);
  grid.set({0, 0}, true);
  for (const MovementRule rule : test::all_rules) {
    for (std::size_t i = 0; i < 8; ++i) CHECK_FALSE(grid.can_step({0, 0}, i, rule));
  }
}

TEST_CASE("a grid that is too large is refused before anything is allocated", "[grid]") {
  constexpr std::int64_t huge = std::int64_t{1} << 31;
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  const auto refused = [](std::int64_t width, std::int64_t height, std::int64_t max_cells) {
    const auto grid = OccupancyGrid::blocked(width, height, max_cells);
    CAPTURE(width, height, max_cells);
    REQUIRE_FALSE(grid.has_value());
    CHECK(grid.error().code == PlanError::limit_exceeded);
    CHECK(grid.error().detail.find(std::to_string(width)) != std::string::npos);
    CHECK(grid.error().detail.find(std::to_string(max_cells)) != std::string::npos);
  };
  refused(huge, huge, std::int64_t{1} << 30);
  refused(huge, huge, largest);
  refused(largest, largest, largest);
  refused(largest, 0, largest);
  refused(0, largest, largest);
  refused(1, std::int64_t{1} << 27, largest);  // few cells, but their padded rows are too many
  refused(10, 10, 99);
  CHECK(OccupancyGrid::blocked(10, 10, 100).has_value());
}

TEST_CASE("a negative size is invalid input", "[grid]") {
  CHECK(OccupancyGrid::blocked(-1, 5).error().code == PlanError::invalid_input);
  CHECK(OccupancyGrid::blocked(5, -1).error().code == PlanError::invalid_input);
  CHECK(OccupancyGrid::blocked(std::numeric_limits<std::int64_t>::min(), 5).error().code ==
        PlanError::invalid_input);
}

}  // namespace
