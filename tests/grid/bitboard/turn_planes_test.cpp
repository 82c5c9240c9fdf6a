// SPDX-License-Identifier: MIT
#include "tutavia/grid/bitboard/turn_planes.hpp"

#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/grid/bitboard/stop_planes.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

bool is_free_cell(const OccupancyGrid& grid, Cell cell) {
  return grid.contains(cell) && grid.is_free(cell);
}

/// Whether a walk in a straight direction meets a cell with a free side behind which a blocked cell
/// lies, before a blocked cell.
bool leads_to_jump_point(const OccupancyGrid& grid, Cell cell, std::size_t step) {
  while (true) {
    cell = cell + steps[step];
    if (!is_free_cell(grid, cell)) return false;
    for (const std::size_t turn : {2u, 6u}) {
      const Cell side = cell + steps[(step + turn) % 8];
      if (is_free_cell(grid, side) && !is_free_cell(grid, side - steps[step])) return true;
    }
  }
}

/// The number of diagonal steps after which a walk first ends or may turn.
int walk_diagonal(const OccupancyGrid& grid, Cell cell, std::size_t step) {
  const std::size_t left = (step + 1) % 8, right = step - 1;
  for (int count = 1;; ++count) {
    const bool allowed = is_free_cell(grid, cell + steps[step]) &&
                         is_free_cell(grid, cell + steps[left]) &&
                         is_free_cell(grid, cell + steps[right]);
    if (!allowed) return count;
    cell = cell + steps[step];
    if (leads_to_jump_point(grid, cell, left) || leads_to_jump_point(grid, cell, right)) {
      return count;
    }
  }
}

void check_all_turns(const OccupancyGrid& grid) {
  const TurnPlanes turns(grid, StopPlanes(grid));
  std::size_t wrong = 0;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (!grid.is_free(Cell{x, y})) continue;
      for (std::size_t step = 1; step < 8; step += 2) {
        const TurnPlanes::Plane plane = turns.plane(step);
        const int expected = walk_diagonal(grid, {x, y}, step),
                  found = plane.jump(plane.bit({x, y}));
        if (found == expected) continue;
        if (++wrong == 1) {
          FAIL_CHECK("cell " << x << ", " << y << ", step " << step << ": jumps " << found
                             << ", walks " << expected);
        }
      }
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("a diagonal jump goes as far as a walk that looks at every cell", "[grid]") {
  const std::uint64_t seed = 1;
  Random random(seed);
  CAPTURE(seed);
  test::for_each_grid_around_words(random, test::scaled(1), [](const OccupancyGrid& grid) {
    CAPTURE(grid.width(), grid.height());
    check_all_turns(grid);
  });
}

TEST_CASE("diagonals wrap around grids far higher than wide, and wider than high", "[grid]") {
  Random random(2);
  for (const double density : {0.0, 0.01, 0.2}) {
    CAPTURE(density);
    check_all_turns(test::noise_grid(random, 3, 1500, density));
    check_all_turns(test::noise_grid(random, 1500, 3, density));
    check_all_turns(test::noise_grid(random, 1, 700, density));
  }
}

TEST_CASE("a diagonal turns towards what is round the corner", "[grid]") {
  Random random(0);
  OccupancyGrid grid = test::noise_grid(random, 20, 20, 0);
  grid.set({12, 6}, false);  // its corners stop jumps in the rows above and below it
  const TurnPlanes turns(grid, StopPlanes(grid));
  const TurnPlanes::Plane north_east = turns.plane(1), south_west = turns.plane(5);
  CHECK(north_east.jump(north_east.bit({0, 0})) == 5);    // row 5 passes below it
  CHECK(north_east.jump(north_east.bit({5, 5})) == 2);    // row 7 passes above it
  CHECK(north_east.jump(north_east.bit({13, 13})) == 7);  // to the border
  CHECK(south_west.jump(south_west.bit({19, 19})) == 6);  // column 13 passes to the right of it
}

TEST_CASE("turn planes take half a byte per cell of the padded columns", "[grid]") {
  for (const int width : {1, 62, 130}) {
    for (const int height : {1, 62, 130}) {
      CAPTURE(width, height);
      const OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
      const std::size_t words =
          static_cast<std::size_t>(width + 2) * (Places(grid).column_stride() / 64);
      CHECK(TurnPlanes(grid, StopPlanes(grid)).memory() == 4 * 8 * (words + 1));
    }
  }
  CHECK(TurnPlanes(OccupancyGrid(), StopPlanes(OccupancyGrid())).memory() > 0);
}

}  // namespace
