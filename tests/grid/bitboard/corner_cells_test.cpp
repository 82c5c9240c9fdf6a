// SPDX-License-Identifier: MIT
#include "tutavia/grid/bitboard/corner_cells.hpp"

#include "support/catch.hpp"
#include "support/random_grids.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

TEST_CASE("a corner knows its four cells, and what walls do there", "[grid]") {
  for (unsigned pattern = 0; pattern < 16; ++pattern) {
    CAPTURE(pattern);
    OccupancyGrid grid = test::free_grid(2, 2);
    const auto is_free = [&](int x, int y) { return (pattern >> (x + 2 * y) & 1u) != 0; };
    int free_cells = 0;
    for (const Cell cell : {Cell{0, 0}, Cell{1, 0}, Cell{0, 1}, Cell{1, 1}}) {
      grid.set(cell, is_free(cell.x, cell.y));
      free_cells += is_free(cell.x, cell.y);
    }
    const CornerCells around(grid, {1, 1});
    CHECK(around.sw == is_free(0, 0));
    CHECK(around.se == is_free(1, 0));
    CHECK(around.nw == is_free(0, 1));
    CHECK(around.ne == is_free(1, 1));
    CHECK(around.any_free() == (free_cells > 0));
    const bool diagonal = free_cells == 2 && is_free(0, 0) == is_free(1, 1);
    CHECK(around.is_double() == diagonal);
    // Walls turn at one or three free cells, and end where two meet by a corner.
    CHECK(around.is_vertex() == (free_cells % 2 == 1 || diagonal));
  }
}

TEST_CASE("what lies beyond the grid is blocked", "[grid]") {
  const OccupancyGrid grid = test::free_grid(3, 2);
  const CornerCells low(grid, {0, 0}), high(grid, {3, 2}), side(grid, {3, 1});
  CHECK((low.ne && !low.nw && !low.sw && !low.se));
  CHECK((!high.ne && !high.nw && high.sw && !high.se));
  CHECK(low.is_vertex());
  CHECK((side.nw && side.sw && !side.ne && !side.se));
  CHECK_FALSE(side.is_vertex());
}

}  // namespace
