// SPDX-License-Identifier: MIT
#include "tutavia/grid/safety_buffer.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"

namespace {

using namespace tutavia;

/// Whether a blocked cell lies within `width` columns and rows of a cell.
bool is_near_blocked(const OccupancyGrid& grid, Cell cell, int width) {
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const bool near = std::max(std::abs(x - cell.x), std::abs(y - cell.y)) <= width;
      if (near && !grid.is_free(Cell{x, y})) return true;
    }
  }
  return false;
}

TEST_CASE("a safety buffer blocks what is near to a cell that was blocked, and nothing else") {
  const std::uint64_t seed = 17;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    const OccupancyGrid grid = test::random_grid(random, round % 20 == 0 ? 80 : 14);
    const int width = static_cast<int>(random.below(4));
    const std::array exempt{test::random_cell(random, grid), test::random_cell(random, grid)};
    INFO("seed " << seed << ", round " << round << ", width " << width);
    const BufferedGrid buffered = with_safety_buffer(grid, exempt, width).value();
    std::size_t wrong = 0;
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        const Cell cell{x, y};
        const bool swallowed = grid.is_free(cell) && is_near_blocked(grid, cell, width);
        const bool is_exempt = std::count(exempt.begin(), exempt.end(), cell) > 0;
        const auto reported = std::count(buffered.exempted.begin(), buffered.exempted.end(), cell);
        if (buffered.grid.is_free(cell) != (grid.is_free(cell) && (!swallowed || is_exempt))) {
          ++wrong;
        }
        if (reported != (swallowed && is_exempt ? 1 : 0)) ++wrong;
      }
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("a safety buffer of any width is refused only where it means nothing") {
  OccupancyGrid grid = OccupancyGrid::blocked(70, 3).value();
  for (int y = 0; y < 3; ++y) grid.set_run(y, 1, 69, true);
  const int most = std::numeric_limits<int>::max();
  CHECK(with_safety_buffer(grid, {}, most).value().grid.count_free() == 0);
  CHECK(with_safety_buffer(grid, {}, 0).value().grid.words() == grid.words());
  CHECK(with_safety_buffer(grid, {}, -1).error().code == PlanError::invalid_option);
  const std::array outside{Cell{70, 0}};
  CHECK(with_safety_buffer(grid, outside).error().code == PlanError::invalid_input);
  CHECK(with_safety_buffer(OccupancyGrid{}).value().grid.count_free() == 0);
}

}  // namespace
