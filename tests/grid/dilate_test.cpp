// SPDX-License-Identifier: MIT
#include "tutavia/grid/dilate.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;

/// The squared distance from the centre of a cell to the nearest blocked square, half a cell being
/// the unit: centres are odd, corners even.
std::int64_t squared_distance(const OccupancyGrid& grid, Cell cell) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  const std::int64_t cx = 2 * cell.x + 1, cy = 2 * cell.y + 1;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.is_free(Cell{x, y})) continue;
      const std::int64_t dx = cx - std::clamp<std::int64_t>(cx, 2 * x, 2 * x + 2);
      const std::int64_t dy = cy - std::clamp<std::int64_t>(cy, 2 * y, 2 * y + 2);
      least = std::min(least, dx * dx + dy * dy);
    }
  }
  return least;
}

std::size_t count_wrong(const OccupancyGrid& grid, std::int64_t least) {
  const OccupancyGrid result = dilated(grid, least);
  std::size_t wrong = 0;
  if (result.width() != grid.width() || result.height() != grid.height()) ++wrong;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const Cell cell{x, y};
      const bool expected = grid.is_free(cell) && squared_distance(grid, cell) >= least;
      if (result.is_free(cell) != expected) ++wrong;
    }
  }
  return wrong;
}

TEST_CASE("cells are free where their centres are far enough from all blocked squares", "[grid]") {
  const std::uint64_t seed = 1;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    const bool wide = round % 10 == 0;
    const int width = static_cast<int>(random.below(12)) + (wide ? 57 : 1);
    const int height = 1 + static_cast<int>(random.below(12));
    const double density = wide ? 0.01 : random.uniform() * random.uniform();
    const OccupancyGrid grid = test::noise_grid(random, width, height, density);
    const auto least = static_cast<std::int64_t>(random.below(wide ? 2000 : 120));
    INFO("seed " << seed << ", round " << round << ", " << width << " x " << height << ", least "
                 << least);
    CHECK(count_wrong(grid, least) == 0);
  }
}

TEST_CASE("every distance up to several cells takes just the cells that are nearer", "[grid]") {
  OccupancyGrid grid = OccupancyGrid::blocked(13, 11).value();
  for (int y = 0; y < 11; ++y) grid.set_run(y, 0, 12, true);
  grid.set({6, 5}, false);
  for (std::int64_t least = 0; least <= 130; ++least) {
    CAPTURE(least);
    CHECK(count_wrong(grid, least) == 0);
  }
  // Right beside it 1, diagonally 2, then 9, 10 and 18: sums of two odd squares, or one.
  CHECK(dilated(grid, 1).count_free() == 13 * 11 - 1);
  CHECK(dilated(grid, 2).count_free() == 13 * 11 - 1 - 4);
  CHECK(dilated(grid, 3).count_free() == 13 * 11 - 1 - 8);
  CHECK(dilated(grid, 9).count_free() == 13 * 11 - 1 - 8);
  CHECK(dilated(grid, 10).count_free() == 13 * 11 - 1 - 12);
}

TEST_CASE("no distance changes nothing, and a distance beyond the grid leaves no free cell",
          "[grid]") {
  Random random(2);
  const OccupancyGrid grid = test::noise_grid(random, 70, 9, 0.02);
  CHECK(dilated(grid, 0).words() == grid.words());
  CHECK(dilated(grid, 1).words() == grid.words());
  CHECK(dilated(grid, 20000).count_free() == 0);
  const OccupancyGrid open = test::noise_grid(random, 70, 9, 0);
  CHECK(dilated(open, 20000).words() == open.words());
  CHECK(dilated(OccupancyGrid(), 5).count_free() == 0);
}

}  // namespace
