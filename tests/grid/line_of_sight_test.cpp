// SPDX-License-Identifier: MIT
#include "tutavia/grid/line_of_sight.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "support/catch.hpp"
#include "support/corner_paths.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/grid/bitboard/transposed.hpp"

namespace {

using namespace tutavia;

/// Whether the closed square of a cell meets the closed segment between two centres; separating
/// axes, in half cells.
bool touches(Cell cell, Cell a, Cell b) {
  const auto [x0, x1] = std::minmax({2 * a.x, 2 * b.x});
  const auto [y0, y1] = std::minmax({2 * a.y, 2 * b.y});
  const int x = 2 * cell.x, y = 2 * cell.y;
  if (x + 1 < x0 || x - 1 > x1 || y + 1 < y0 || y - 1 > y1) return false;
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
  const std::int64_t side = dx * (y - 2 * a.y) - dy * (x - 2 * a.x);
  return std::abs(side) <= std::abs(dx) + std::abs(dy);
}

bool sees(const OccupancyGrid& grid, Cell a, Cell b) {
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (!grid.is_free(Cell{x, y}) && touches({x, y}, a, b)) return false;
    }
  }
  return true;
}

TEST_CASE("lines of sight between all pairs of cells are what squares and segments say") {
  const std::uint64_t seed = 5;
  Random random(seed);
  std::size_t seen = 0, pairs = 0, wrong = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    const OccupancyGrid grid = test::random_grid(random, 24);
    const Cell a = test::random_cell(random, grid);
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        const bool expected = sees(grid, a, {x, y});
        if (line_of_sight(grid.view(), a, {x, y}) != expected ||
            line_of_sight(grid.view(), {x, y}, a) != expected) {
          ++wrong;
        }
        seen += expected ? 1 : 0;
        ++pairs;
      }
    }
    CAPTURE(seed, round);
    REQUIRE(wrong == 0);
  }
  CHECK(seen > pairs / 20);
  CHECK(seen < pairs / 2);
}

TEST_CASE("one blocked cell hides exactly the cells behind it, over many words of a row") {
  const int width = 300, height = 7;
  for (const Cell hole : {Cell{0, 3}, Cell{57, 2}, Cell{64, 3}, Cell{150, 6}, Cell{299, 0}}) {
    OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
    for (int y = 0; y < height; ++y) grid.set_run(y, 0, width - 1, true);
    grid.set(hole, false);
    std::size_t wrong = 0;
    for (int ay = 0; ay < height; ++ay) {
      for (int by = 0; by < height; ++by) {
        for (int ax = 0; ax < width; ax += 13) {
          for (int bx = 0; bx < width; ++bx) {
            const Cell a{ax, ay}, b{bx, by};
            if (line_of_sight(grid.view(), a, b) == touches(hole, a, b)) ++wrong;
          }
        }
      }
    }
    CAPTURE(hole.x, hole.y);
    CHECK(wrong == 0);
  }
}

TEST_CASE("lines across the largest grids do not overflow") {
  OccupancyGrid grid = OccupancyGrid::blocked(1 << 20, 60).value();
  for (int y = 0; y < 60; ++y) grid.set_run(y, 0, (1 << 20) - 1, true);
  CHECK(line_of_sight(grid.view(), {0, 0}, {(1 << 20) - 1, 59}));
  grid.set({(1 << 19) + 7, 30}, false);
  CHECK_FALSE(line_of_sight(grid.view(), {0, 0}, {(1 << 20) - 1, 59}));
  CHECK(line_of_sight(grid.view(), {0, 59}, {(1 << 20) - 1, 40}));
}

TEST_CASE("lines of sight between all pairs of corners are what the competition's rules say") {
  const std::uint64_t seed = 6;
  Random random(seed);
  std::size_t seen = 0, pairs = 0, wrong = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    const OccupancyGrid grid = test::random_grid(random, 20), columns = detail::transposed(grid);
    const test::CornerRules rules(grid);
    const Cell a = test::random_cell(random, grid) +
                   Cell{static_cast<int>(random.below(2)), static_cast<int>(random.below(2))};
    for (int y = 0; y <= grid.height(); ++y) {
      for (int x = 0; x <= grid.width(); ++x) {
        const Cell b{x, y};
        const bool expected = a == b || rules.allows(test::corner_of(a), test::corner_of(b));
        if (detail::corner_line_of_sight(grid.view(), columns.view(), a, b) != expected ||
            detail::corner_line_of_sight(grid.view(), columns.view(), b, a) != expected) {
          ++wrong;
        }
        seen += expected ? 1 : 0;
        ++pairs;
      }
    }
    CAPTURE(seed, round);
    REQUIRE(wrong == 0);
  }
  CHECK(seen > pairs / 20);
  CHECK(seen < pairs / 2);
}

TEST_CASE("corners see each other along walls over many words of a row") {
  OccupancyGrid grid = OccupancyGrid::blocked(400, 2).value();
  grid.set_run(0, 0, 199, true);
  grid.set_run(1, 150, 399, true);
  const OccupancyGrid columns = detail::transposed(grid);
  const auto sees = [&](int from, int to) {
    return detail::corner_line_of_sight(grid.view(), columns.view(), {from, 1}, {to, 1});
  };
  CHECK(sees(0, 400));  // the two overlap from 150 to 199
  for (const int hole : {150, 170, 199}) {
    grid.set({hole, 1}, false);
    CHECK(sees(0, 200));
    CHECK(sees(0, 400) == (hole != 199));
    grid.set({hole, 0}, false);
    CHECK_FALSE(sees(0, 400));
    grid.set({hole, 0}, true);
    grid.set({hole, 1}, true);
  }
  // Free below up to 149, above from 150 on: two blocked cells touch by a corner at 150.
  grid.set_run(0, 150, 199, false);
  CHECK(sees(0, 150));
  CHECK(sees(150, 400));
  CHECK_FALSE(sees(0, 400));
  CHECK_FALSE(sees(149, 151));
}

}  // namespace
