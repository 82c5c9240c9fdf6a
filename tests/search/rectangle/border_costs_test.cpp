// SPDX-License-Identifier: MIT
#include "tutavia/search/rectangle/border_costs.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

TEST_CASE("from one cell all others cost their octile distance") {
  BorderCosts reach;
  reach.reset({0, 0, 5, 5, 1}, [](int) { return Cost{0}; });
  const CellInterval top{0, 3, 0, 9, 1}, right{1, 9, 0, 3, 1};
  reach.reach(top);
  for (int x = 0; x <= 9; ++x) CHECK(reach[x] == octile_cost({5, 0}, {x, 3}));
  reach.reach(right);
  for (int y = 0; y <= 3; ++y) CHECK(reach[y] == octile_cost({5, 0}, {9, y}));
}

TEST_CASE("a costly cell is reached more cheaply through its neighbour") {
  BorderCosts reach;
  const auto cost_of = [](int x) { return x == 1 ? 100 * straight_cost : Cost{0}; };
  reach.reset({0, 0, 0, 1, 1}, cost_of);
  CHECK(reach.reach(Cell{1, 0}).cost == straight_cost);
  CHECK(reach.reach(Cell{4, 0}).cost == 4 * straight_cost);
}

TEST_CASE("the cells of every line cost what trying all cells of the interval finds") {
  const std::uint64_t seed = 54;
  Random random(seed);
  const auto upto = [&](int n) { return static_cast<int>(random.below(static_cast<unsigned>(n))); };
  BorderCosts reach;
  for (std::size_t round = 0; round < test::scaled(1000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const int width = 1 + upto(25), depth = upto(12), left = upto(10), right = upto(10);
    const int axis = upto(2), side = upto(2) == 0 ? 1 : -1, line = 20;
    const CellInterval from{axis, line, 30, 30 + width - 1, side};
    std::vector<Cost> costs;
    for (int i = 0; i < width; ++i) {
      costs.push_back(static_cast<Cost>(random.below(8 * static_cast<unsigned>(straight_cost))));
    }
    reach.reset(from, [&](int u) { return costs[static_cast<std::size_t>(u - from.first)]; });
    const auto expected = [&](Cell cell) {
      Cost least = std::numeric_limits<Cost>::max();
      for (int i = 0; i < width; ++i) {
        least = std::min(least, costs[static_cast<std::size_t>(i)] +
                                    octile_cost(cell, from.cell(from.first + i)));
      }
      return least;
    };
    const int low = std::min(line, line + side * depth), high = std::max(line, line + side * depth);
    const CellInterval lines[] = {
        {axis, line + side * depth, from.first - left, from.last + right, side},  // across
        {1 - axis, from.first - left, low, high, -1},                             // both ends
        {1 - axis, from.last + right, low, high, 1},
        {1 - axis, from.first + upto(width), low, high, 1}};  // and through it
    for (const CellInterval& other : lines) {
      reach.reach(other);
      for (int v = other.first; v <= other.last; ++v) {
        if (reach[v] != expected(other.cell(v))) FAIL_CHECK("axis " << other.axis << ", " << v);
        const auto [cost, place] = reach.reach(other.cell(v));
        if (cost != expected(other.cell(v)) || place < from.first || place > from.last) {
          FAIL_CHECK("one cell, axis " << other.axis << ", " << v);
        }
      }
    }
  }
}

}  // namespace
