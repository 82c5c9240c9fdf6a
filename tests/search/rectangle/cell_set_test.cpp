// SPDX-License-Identifier: MIT
#include "tutavia/search/rectangle/cell_set.hpp"

#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

TEST_CASE("a set of cells answers as a table of them does") {
  const std::uint64_t seed = 56;
  Random random(seed);
  const auto upto = [&](int n) { return static_cast<int>(random.below(static_cast<unsigned>(n))); };
  CellSet cells;
  for (int round = 0; round < 100; ++round) {
    INFO("seed " << seed << ", round " << round);
    const int width = 1 + upto(80), height = 1 + upto(6);
    cells.reset(test::free_grid(width, height));
    OccupancyGrid table = OccupancyGrid::blocked(width, height).value();  // free: a member
    for (int i = upto(4); i > 0; --i) {
      const int x = upto(width), y = upto(height);
      const CellRectangle r{{CellRun{x, x + upto(width - x)}, CellRun{y, y + upto(height - y)}}};
      cells.add(r);
      for (int v = r.runs[1].first; v <= r.runs[1].last; ++v) {
        table.set_run(v, r.runs[0].first, r.runs[0].last, true);
      }
    }
    const Cell single{upto(width), upto(height)};
    cells.add(single);
    table.set(single, true);
    for (int i = 0; i < 50; ++i) {
      const int axis = upto(2), along = axis == 0 ? width : height;
      const int line = upto(axis == 0 ? height : width), first = upto(along);
      const CellInterval asked{axis, line, first, first + upto(along - first), 1};
      bool all = true, any = false;
      for (int u = asked.first; u <= asked.last; ++u) {
        all = all && table.is_free(asked.cell(u));
        any = any || table.is_free(asked.cell(u));
      }
      CHECK(cells.holds(asked) == all);
      CHECK(cells.meets(asked) == any);
    }
    const CellRectangle everything{{CellRun{0, width - 1}, CellRun{0, height - 1}}};
    std::vector<Cell> expected, visited;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (table.is_free(Cell{x, y})) expected.push_back({x, y});
      }
    }
    cells.for_each_in(everything, [&](Cell cell) { visited.push_back(cell); });
    CHECK(visited == expected);
  }
}

TEST_CASE("a set begins again with none, be the grid of the same size or another") {
  CellSet cells;
  for (const int width : {5, 5, 70}) {
    cells.reset(test::free_grid(width, 2));
    CHECK_FALSE(cells.meets({0, 1, 0, width - 1, 1}));
    cells.add(Cell{3, 1});
    CHECK(cells.meets({0, 1, 0, width - 1, 1}));
  }
}

}  // namespace
