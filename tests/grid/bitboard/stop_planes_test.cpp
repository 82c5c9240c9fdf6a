// SPDX-License-Identifier: MIT
#include "tutavia/grid/bitboard/stop_planes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

bool is_free(const OccupancyGrid& grid, Cell cell) {
  return grid.contains(cell) && grid.is_free(cell);
}

/// A jump stops at a blocked cell, and where a side is free and the cell behind it is not.
bool has_to_stop(const OccupancyGrid& grid, Cell cell, std::size_t step) {
  if (!is_free(grid, cell)) return true;
  for (const std::size_t turn : {2u, 6u}) {
    const Cell side = cell + steps[(step + turn) % 8];
    if (is_free(grid, side) && !is_free(grid, side - steps[step])) return true;
  }
  return false;
}

int walk(const OccupancyGrid& grid, Cell from, std::size_t step) {
  int count = 1;
  Cell cell = from + steps[step];
  for (; !has_to_stop(grid, cell, step); ++count) cell = cell + steps[step];
  return count;
}

/// The planes of a grid, with the places of its cells.
struct Jumps {
  explicit Jumps(const OccupancyGrid& grid) : planes(grid), places(grid) {}

  int jump(Cell from, std::size_t step) const { return planes.plane(step).jump(places.of(from)); }
  bool is_stop(Cell cell, std::size_t step) const {
    return planes.plane(step).is_stop(places.of(cell));
  }

  StopPlanes planes;
  Places places;
};

void check_all_jumps(const OccupancyGrid& grid) {
  const Jumps jumps(grid);
  std::size_t wrong = 0;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      for (std::size_t step = 0; step < 8; step += 2) {
        const int expected = walk(grid, {x, y}, step), found = jumps.jump({x, y}, step);
        const bool stop = has_to_stop(grid, {x, y}, step);
        if (found == expected && jumps.is_stop({x, y}, step) == stop) continue;
        if (++wrong == 1) {
          FAIL_CHECK("cell " << x << ", " << y << ", step " << step << ": jumps " << found
                             << ", walks " << expected << ", stops " << stop);
        }
      }
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("a jump goes as far as a walk that looks at every cell", "[grid]") {
  const std::uint64_t seed = 1;
  Random random(seed);
  CAPTURE(seed);
  test::for_each_grid_around_words(random, test::scaled(1), [](const OccupancyGrid& grid) {
    CAPTURE(grid.width(), grid.height());
    check_all_jumps(grid);
  });
}

TEST_CASE("in the open a jump ends at the border of the grid", "[grid]") {
  Random random(0);
  for (const int width : {1, 63, 64, 65, 1000}) {
    for (const int height : {1, 62, 128, 300}) {
      CAPTURE(width, height);
      const Jumps jumps(test::noise_grid(random, width, height, 0));
      const Cell cell{width / 3, height / 2};
      CHECK(jumps.jump(cell, 0) == width - cell.x);
      CHECK(jumps.jump(cell, 2) == height - cell.y);
      CHECK(jumps.jump(cell, 4) == cell.x + 1);
      CHECK(jumps.jump(cell, 6) == cell.y + 1);
    }
  }
}

TEST_CASE("a jump stops one cell past a corner, where its side opens", "[grid]") {
  Random random(0);
  OccupancyGrid grid = test::noise_grid(random, 9, 9, 0);
  grid.set({4, 4}, false);
  const Jumps jumps(grid);
  for (const int aside : {-1, 1}) {
    CAPTURE(aside);
    CHECK(jumps.jump({0, 4 + aside}, 0) == 5);
    CHECK(jumps.jump({8, 4 + aside}, 4) == 5);
    CHECK(jumps.jump({4 + aside, 0}, 2) == 5);
    CHECK(jumps.jump({4 + aside, 8}, 6) == 5);
  }
  CHECK(jumps.jump({0, 2}, 0) == 9);  // two rows off, nothing is in the way
  CHECK(jumps.jump({0, 4}, 0) == 4);
  CHECK(jumps.jump({4, 4}, 0) == 5);
}

TEST_CASE("stop planes take half a byte per cell of the padded grid", "[grid]") {
  for (const int width : {1, 62, 63, 130}) {
    for (const int height : {1, 62, 63, 130}) {
      CAPTURE(width, height);
      const OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
      const Places places(grid);
      const auto rows = static_cast<std::size_t>(height + 2);
      const auto columns = static_cast<std::size_t>(width + 2);
      const std::size_t bits = rows * places.row_stride() + columns * places.column_stride();
      CHECK(StopPlanes(grid).memory() == 2 * (bits / 8 + 2 * sizeof(std::uint64_t)));
    }
  }
  CHECK(StopPlanes(OccupancyGrid()).memory() > 0);
}

}  // namespace
