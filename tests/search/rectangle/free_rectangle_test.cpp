// SPDX-License-Identifier: MIT
#include "tutavia/search/rectangle/free_rectangle.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

bool same(const CellRun& a, const CellRun& b) { return a.first == b.first && a.last == b.last; }
bool is(const CellRectangle& r, const CellRun& columns, const CellRun& rows) {
  return same(r.runs[0], columns) && same(r.runs[1], rows);
}

TEST_CASE("an interval names its cells, its middle and what is beyond it") {
  const CellInterval row{0, 3, 2, 6, -1}, column{1, 3, 2, 6, 1};
  CHECK(row.cell(2) == Cell{2, 3});
  CHECK(row.middle() == Cell{4, 3});
  CHECK(row.beyond().cell(2) == Cell{2, 2});
  CHECK(column.cell(2) == Cell{3, 2});
  CHECK(column.beyond().cell(2) == Cell{4, 2});
  CHECK(row.run().size() == 5);
  CHECK(CellRun{}.size() == 0);
}

TEST_CASE("a rectangle has four edges, and clips intervals") {
  const CellRectangle r{{CellRun{2, 5}, CellRun{1, 3}}};
  CHECK(r.contains({2, 3}));
  CHECK_FALSE(r.contains({6, 3}));
  CHECK_FALSE(r.contains({2, 0}));
  CHECK(r.edge(0, 1).cell(2) == Cell{2, 3});
  CHECK(r.edge(0, -1).cell(5) == Cell{5, 1});
  CHECK(r.edge(1, 1).cell(1) == Cell{5, 1});
  CHECK(r.edge(1, -1).cell(3) == Cell{2, 3});
  const CellInterval clipped = r.clip({0, 2, 0, 4, 1});
  CHECK(clipped.first == 2);
  CHECK(clipped.last == 4);
  CHECK(r.clip({0, 7, 0, 4, 1}).run().size() <= 0);  // another row
  CHECK(r.clip({0, 2, 6, 9, 1}).run().size() <= 0);  // beside it
}

TEST_CASE("a rectangle grows forwards first, then to both sides") {
  OccupancyGrid grid = test::free_grid(8, 5);
  grid.set({2, 4}, false);  // stops it ahead
  grid.set({6, 2}, false);  // stops it on the right
  const auto space = CellSpace::build(grid).value();
  const FreeRectangles rectangles(space);
  CHECK(is(rectangles.grow({0, 0, 2, 3, 1}), {0, 5}, {0, 3}));
  CHECK(is(rectangles.grow({0, 0, 3, 3, 1}), {3, 5}, {0, 4}));
  CHECK(is(rectangles.grow({1, 0, 2, 2, 1}), {0, 5}, {0, 3}));
}

TEST_CASE("no rectangle that grew can be larger on any side, and none holds a blocked cell") {
  const std::uint64_t seed = 55;
  Random random(seed);
  std::size_t cells = 0;
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 20)).value();
    const FreeRectangles rectangles(space);
    const Cell start = test::random_cell(random, space.grid());
    if (!space.grid().is_free(start)) continue;
    const CellRectangle r = rectangles.grow_around(start);
    CHECK(r.contains(start));
    for (int y = r.runs[1].first; y <= r.runs[1].last; ++y) {
      for (int x = r.runs[0].first; x <= r.runs[0].last; ++x, ++cells) {
        if (!space.grid().is_free(Cell{x, y})) FAIL_CHECK("cell (" << x << ", " << y << ")");
      }
    }
    for (const int axis : {0, 1}) {
      for (const int side : {1, -1}) {
        const CellInterval edge = r.edge(axis, side);
        CHECK_FALSE(rectangles.is_free(axis, edge.line + side, edge.run()));
      }
    }
  }
  CHECK(cells > test::scaled(1000));
}

TEST_CASE("free runs of a line are cut to what is asked for, and there are none beyond the grid") {
  OccupancyGrid grid = test::free_grid(10, 3);
  for (const int x : {2, 5, 6}) grid.set({x, 1}, false);
  const auto space = CellSpace::build(grid).value();
  const FreeRectangles rectangles(space);
  const auto runs = [&](int axis, int line, const CellRun& within) {
    std::vector<CellRun> found;
    rectangles.append_free_runs(axis, line, within, found);
    return found;
  };
  const auto found = runs(0, 1, {1, 8});
  REQUIRE(found.size() == 3);
  CHECK(same(found[0], {1, 1}));
  CHECK(same(found[1], {3, 4}));
  CHECK(same(found[2], {7, 8}));
  CHECK(runs(1, 5, {0, 2}).size() == 2);  // column 5 is blocked in its middle
  CHECK(runs(0, 1, {5, 6}).empty());
  CHECK(runs(0, -1, {0, 9}).empty());
  CHECK(runs(0, 3, {0, 9}).empty());
}

}  // namespace
