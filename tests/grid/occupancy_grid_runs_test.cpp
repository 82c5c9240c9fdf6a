// SPDX-License-Identifier: MIT
// Runs of cells of OccupancyGrid, and what it knows by index.
#include "tutavia/grid/occupancy_grid.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;

constexpr int widths[] = {1, 2, 8, 9, 55, 56, 57, 58, 61, 62, 63, 64, 65, 113, 126, 127, 190, 400};

/// Cells of a row in runs, mostly longer than a word where `longest` is.
std::vector<bool> random_row(Random& random, int width, int longest) {
  std::vector<bool> row;
  bool free = random.below(2) == 0;
  while (row.size() < static_cast<std::size_t>(width)) {
    row.insert(row.end(), 1 + random.below(static_cast<std::uint64_t>(longest)), free);
    free = !free;
  }
  row.resize(static_cast<std::size_t>(width));
  return row;
}

OccupancyGrid random_grid(Random& random, int width, int height) {
  OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
  for (int y = 0; y < height; ++y) {
    const std::vector<bool> row = random_row(random, width, random.below(2) == 0 ? 4 : 150);
    for (int x = 0; x < width; ++x) grid.set({x, y}, row[static_cast<std::size_t>(x)]);
  }
  return grid;
}

TEST_CASE("an index leads back to its cell, on grids of every width and up to the largest index",
          "[grid]") {
  const std::uint64_t seed = 2;
  Random random(seed);
  std::vector<int> all(std::begin(widths), std::end(widths));
  for (const int width : {1000, 4094, 12345, 1 << 20, 99999999}) all.push_back(width);
  for (std::size_t i = 0; i < test::scaled(40); ++i) {
    all.push_back(static_cast<int>(random.below(200000)));
  }
  for (const int width : all) {
    CAPTURE(seed, width);
    // Cells far above the top row have no memory, but places.
    const OccupancyGrid grid = OccupancyGrid::blocked(width, 1).value();
    const OccupancyGrid::View view = grid.view();
    const std::uint64_t stride = grid.stride(), largest = (std::uint64_t{1} << 32) - 64 - 1;
    REQUIRE(stride >= static_cast<std::uint64_t>(width) + 2);
    std::size_t wrong = 0;
    const auto check = [&](std::uint64_t index) {
      if (index > largest) return;
      const Cell cell{static_cast<int>(index % stride) - 1, static_cast<int>(index / stride) - 1};
      if (view.cell(index) != cell || view.index(cell) != index) ++wrong;
    };
    for (int round = 0; round < 300; ++round) {
      check(random.below(largest + 1));
      const std::uint64_t row = stride * random.below(largest / stride + 1);
      for (const std::uint64_t offset : {std::uint64_t{0}, std::uint64_t{1}, stride - 1}) {
        check(row + offset);
      }
    }
    check(0);
    check(largest);
    check(largest / stride * stride);
    check(largest / stride * stride - 1);
    CHECK(wrong == 0);
  }
}

TEST_CASE("a neighbourhood holds the eight neighbours of any cell, the blocked frame included",
          "[grid]") {
  const std::uint64_t seed = 3;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(3); ++round) {
    for (const int width : widths) {
      const int height = 1 + static_cast<int>(random.below(5));
      INFO("seed " << seed << ", round " << round << ", " << width << " x " << height);
      const OccupancyGrid grid = random_grid(random, width, height);
      std::size_t wrong = 0;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          unsigned expected = 0, place = 0;
          for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
              if (dx == 0 && dy == 0) continue;
              const Cell cell{x + dx, y + dy};
              if (grid.contains(cell) && grid.is_free(cell)) expected |= 1u << place;
              ++place;
            }
          }
          if (grid.view().neighbourhood(grid.index({x, y})) != expected) ++wrong;
        }
      }
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("a run sets its cells, as far as they lie in the grid, and no others", "[grid]") {
  const std::uint64_t seed = 4;
  Random random(seed);
  for (const int width : widths) {
    INFO("seed " << seed << ", width " << width);
    constexpr int height = 4;
    OccupancyGrid grid = random_grid(random, width, height);
    OccupancyGrid model = grid;
    for (std::size_t round = 0; round < test::scaled(100); ++round) {
      const auto any = [&] {
        const auto size = static_cast<std::uint64_t>(width);
        return static_cast<int>(random.below(size + 40)) - 20;
      };
      const int y = static_cast<int>(random.below(height + 4)) - 2, first = any(), last = any();
      const bool free = random.below(2) == 0;
      grid.set_run(y, first, last, free);
      for (int x = first; x <= last; ++x) {
        if (model.contains({x, y})) model.set({x, y}, free);
      }
      if (grid.words() != model.words()) {
        FAIL("row " << y << ", from " << first << " to " << last << ", free " << free);
      }
    }
    constexpr int most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();
    grid.set_run(2, least, most, true);
    CHECK(grid.run_end(2, 0, true) == width);
    grid.set_run(2, least, most, false);
    CHECK(grid.run_end(2, 0, false) == width);
    grid.set_run(least, 0, 5, true);
    grid.set_run(most, 0, 5, true);
    grid.set_run(2, 5, 4, true);
    model.set_run(2, 0, width - 1, false);
    CHECK(grid.words() == model.words());
  }
}

TEST_CASE("runs are found from left to right, each as long as can be", "[grid]") {
  const std::uint64_t seed = 5;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(10); ++round) {
    for (const int width : widths) {
      INFO("seed " << seed << ", round " << round << ", width " << width);
      const OccupancyGrid grid = random_grid(random, width, 3);
      for (const int y : {0, 1, 2}) {
        for (const bool free : {false, true}) {
          std::vector<std::pair<int, int>> expected;
          for (int x = 0; x < width; ++x) {
            if (grid.is_free(Cell{x, y}) != free) continue;
            const bool goes_on = !expected.empty() && expected.back().second == x - 1;
            if (goes_on) {
              expected.back().second = x;
            } else {
              expected.emplace_back(x, x);
            }
          }
          std::vector<std::pair<int, int>> runs;
          grid.for_each_run(y, free, [&](int first, int last) { runs.emplace_back(first, last); });
          if (runs != expected) FAIL_CHECK("row " << y << ", free " << free);
          for (int x = 0; x <= width; ++x) {
            int end = x;
            while (end < width && grid.is_free(Cell{end, y}) == free) ++end;
            if (grid.run_end(y, x, free) != end) FAIL_CHECK("end from " << x << ", free " << free);
          }
        }
      }
    }
  }
}

TEST_CASE("a row without free cells has one blocked run and no free one", "[grid]") {
  for (const int width : widths) {
    CAPTURE(width);
    const OccupancyGrid grid = OccupancyGrid::blocked(width, 1).value();
    int runs = 0;
    grid.for_each_run(0, true, [&](int, int) { ++runs; });
    CHECK(runs == 0);
    grid.for_each_run(0, false, [&](int first, int last) {
      ++runs;
      CHECK(first == 0);
      CHECK(last == width - 1);
    });
    CHECK(runs == 1);
  }
}

}  // namespace
