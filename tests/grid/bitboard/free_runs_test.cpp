// SPDX-License-Identifier: MIT
#include "tutavia/grid/bitboard/free_runs.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using detail::CellBox;
using detail::FreeRuns;

FreeRuns::Piece piece_at(const OccupancyGrid& grid, Cell cell) {
  return static_cast<FreeRuns::Piece>(grid.index(cell));
}

using EqualRuns = FreeRuns::EqualRuns;

/// The free run of a cell, with equal runs above and below it if these are joined, by walking.
CellBox walked(const OccupancyGrid& grid, Cell cell, EqualRuns equal) {
  CellBox box{cell.x, cell.y, cell.x + 1, cell.y + 1};
  while (grid.is_free(Cell{box.x0 - 1, cell.y})) --box.x0;
  while (grid.is_free(Cell{box.x1, cell.y})) ++box.x1;
  const auto is_run = [&](int y) {
    if (equal == EqualRuns::apart || y < 0 || y >= grid.height()) return false;
    bool is_free = true;
    for (int x = box.x0; x < box.x1; ++x) is_free = is_free && grid.is_free(Cell{x, y});
    return is_free && !grid.is_free(Cell{box.x0 - 1, y}) && !grid.is_free(Cell{box.x1, y});
  };
  while (is_run(box.y0 - 1)) --box.y0;
  while (is_run(box.y1)) ++box.y1;
  return box;
}

TEST_CASE("any cell of a run opens all of it, over many words of a row", "[grid]") {
  const std::uint64_t seed = 41;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(20); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double density = round % 2 == 0 ? 0.01 : 0.3;
    const OccupancyGrid grid = test::noise_grid(random, 300, 4, density);
    const EqualRuns equal = round % 4 < 2 ? EqualRuns::apart : EqualRuns::joined;
    const FreeRuns runs(grid, equal);
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        if (!grid.is_free(Cell{x, y})) continue;
        if (runs.open(piece_at(grid, {x, y})) != walked(grid, {x, y}, equal)) {
          FAIL_CHECK("cell (" << x << ", " << y << ")");
        }
      }
    }
  }
}

TEST_CASE("exits are the sides that a run shares with its neighbours, ends as seen from within",
          "[grid]") {
  OccupancyGrid grid = test::free_grid(6, 3);
  grid.set({2, 2}, false);  // above the middle run: cells 0-1 and 3-5
  for (const int x : {0, 1, 2, 5}) grid.set({x, 0}, false);  // below it: cells 3-4
  const FreeRuns runs(grid);
  std::vector<std::tuple<Cell, Cell, CellBox>> exits;
  runs.for_each_exit({0, 1, 6, 2}, [&](Cell right, Cell left, FreeRuns::Piece piece) {
    exits.emplace_back(right, left, runs.open(piece));
  });
  CHECK(exits == std::vector<std::tuple<Cell, Cell, CellBox>>{{{3, 1}, {5, 1}, {3, 0, 5, 1}},
                                                              {{2, 2}, {0, 2}, {0, 2, 2, 3}},
                                                              {{6, 2}, {3, 2}, {3, 2, 6, 3}}});
}

TEST_CASE("equal runs of successive rows can be joined, others can not", "[grid]") {
  OccupancyGrid grid = test::free_grid(6, 5);
  grid.set({0, 3}, false);
  const FreeRuns runs(grid, EqualRuns::joined);
  CHECK(FreeRuns(grid).open(piece_at(grid, {4, 1})) == CellBox{0, 1, 6, 2});
  CHECK(runs.open(piece_at(grid, {4, 1})) == CellBox{0, 0, 6, 3});
  CHECK(runs.open(piece_at(grid, {4, 3})) == CellBox{1, 3, 6, 4});
  CHECK(runs.open(piece_at(grid, {4, 4})) == CellBox{0, 4, 6, 5});
}

TEST_CASE("exits between columns are those of all exits that reach into them, in full", "[grid]") {
  const std::uint64_t seed = 43;
  Random random(seed);
  std::size_t compared = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    OccupancyGrid grid = test::noise_grid(random, 200, 3, 0.1);
    grid.set_run(1, 0, 199, true);
    const FreeRuns runs(grid);
    const CellBox box = runs.open(piece_at(grid, {0, 1}));
    const int x0 = static_cast<int>(random.below(210)) - 5;
    const int x1 = x0 + 1 + static_cast<int>(random.below(60));
    for (const bool above : {false, true}) {
      using Exit = std::tuple<Cell, Cell, FreeRuns::Piece>;
      std::vector<Exit> expected, found;
      runs.for_each_exit(box, [&](Cell right, Cell left, FreeRuns::Piece piece) {
        const auto [first, last] = std::minmax(right.x, left.x);
        const bool reaches = first < x1 && last > x0 && right.y == (above ? box.y1 : box.y0);
        if (reaches) expected.emplace_back(right, left, piece);
      });
      runs.for_each_exit_between(box, above ? FreeRuns::Exits::above : FreeRuns::Exits::below, x0,
                                 x1, [&](Cell right, Cell left, FreeRuns::Piece piece) {
                                   found.emplace_back(right, left, piece);
                                 });
      CHECK(found == expected);
      compared += expected.size();
    }
  }
  CHECK(compared > test::scaled(300));
}

TEST_CASE("runs that touch at a corner alone are no neighbours", "[grid]") {
  OccupancyGrid grid = test::free_grid(2, 2);
  grid.set({0, 0}, false);
  grid.set({1, 1}, false);
  int exits = 0;
  FreeRuns(grid).for_each_exit({0, 1, 1, 2}, [&](Cell, Cell, FreeRuns::Piece) { ++exits; });
  CHECK(exits == 0);
}

TEST_CASE("the runs near a cell are those of the 3 x 3 cells around it, each once", "[grid]") {
  const std::uint64_t seed = 42;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(50); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid grid = test::noise_grid(random, 7, 5, 0.4);
    const EqualRuns equal = round % 2 == 0 ? EqualRuns::apart : EqualRuns::joined;
    const FreeRuns runs(grid, equal);
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        std::set<std::pair<int, int>> expected;
        std::multiset<std::pair<int, int>> found;
        for (int row = y - 1; row <= y + 1; ++row) {
          for (int column = x - 1; column <= x + 1; ++column) {
            if (!grid.contains({column, row}) || !grid.is_free(Cell{column, row})) continue;
            const CellBox box = walked(grid, {column, row}, equal);
            expected.insert({box.x0, box.y0});
          }
        }
        runs.for_each_near({x, y}, [&](FreeRuns::Piece piece) {
          const CellBox box = runs.open(piece);
          found.insert({box.x0, box.y0});
        });
        CHECK(found == std::multiset(expected.begin(), expected.end()));
      }
    }
  }
}

TEST_CASE("a run holds its border, and nothing beyond it", "[grid]") {
  OccupancyGrid grid = test::free_grid(5, 1);
  grid.set({0, 0}, false);
  const FreeRuns runs(grid);
  const auto corner = [](Cell c) { return Point(c.x, c.y); };
  const auto piece = piece_at(grid, {2, 0});
  for (const Point& p : {Point(1, 0), Point(5, 1), Point(3, 0.5)}) {
    CHECK(runs.holds(piece, p, corner));
  }
  for (const Point& p : {Point(0.9, 0.5), Point(3, 1.1), Point(5.1, 0.5)}) {
    CHECK_FALSE(runs.holds(piece, p, corner));
  }
}

}  // namespace
