// SPDX-License-Identifier: MIT
#include "tutavia/search/jump_table.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;

/// A straight jump, cell by cell, from the definition: it stops where a side opens behind a blocked
/// cell.
int walk_straight(const OccupancyGrid& grid, Cell from, std::size_t step) {
  const Cell d = steps[step], side{d.y, d.x};
  for (int n = 1;; ++n) {
    const Cell at{from.x + n * d.x, from.y + n * d.y};
    if (!grid.is_free(at)) return 1 - n;
    for (const Cell beside : {at + side, at - side}) {
      if (grid.is_free(beside) && !grid.is_free(beside - d)) return n;
    }
  }
}

/// A diagonal jump: it stops where a straight jump in one of its two directions comes to a stop.
int walk_diagonally(const OccupancyGrid& grid, Cell from, std::size_t step) {
  const Cell d = steps[step];
  Cell at = from;
  for (int n = 1;; ++n) {
    if (!grid.can_step(at, step, MovementRule::no_cut)) return 1 - n;
    at = at + d;
    if (walk_straight(grid, at, d.x > 0 ? 0 : 4) > 0) return n;
    if (walk_straight(grid, at, d.y > 0 ? 2 : 6) > 0) return n;
  }
}

/// How many jumps of every `stride`th cell of every `stride`th row the table has wrong; `compared`
/// grows by those that were looked at.
std::size_t count_wrong(const OccupancyGrid& grid, const JumpTable& table, std::size_t& compared,
                        int stride = 1) {
  std::size_t wrong = 0;
  for (int y = 0; y < grid.height(); y += stride) {
    for (int x = 0; x < grid.width(); x += stride) {
      const Cell cell{x, y};
      if (!grid.is_free(cell)) continue;
      for (std::size_t step = 0; step < steps.size(); ++step) {
        const int expected = detail::is_diagonal(step) ? walk_diagonally(grid, cell, step)
                                                       : walk_straight(grid, cell, step);
        if (table.jump(grid.index(cell), step) != expected) ++wrong;
        ++compared;
      }
    }
  }
  return wrong;
}

}  // namespace

TEST_CASE("a jump table holds what walking cell by cell finds, by one thread or two") {
  const std::size_t rounds = test::scaled(60);
  std::size_t compared = 0;
  for (std::uint64_t seed = 8100; seed < 8100 + rounds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const OccupancyGrid grid = test::random_grid(random, 40);
    const JumpTable table = JumpTable::build(grid);
    REQUIRE(count_wrong(grid, table, compared) == 0);
    REQUIRE(JumpTable::build(grid, JumpTable::Threads::two).to_bytes() == table.to_bytes());
  }
  CHECK(compared > 1000 * rounds);
}

TEST_CASE("jumps longer than a byte holds are found in legs") {
  // Around the ends of the first and the second leg: a wall and a jump point at every distance.
  for (const int length : {125, 126, 127, 128, 252, 253, 254}) {
    CAPTURE(length);
    OccupancyGrid grid = OccupancyGrid::blocked(length + 4, length + 4).value();
    for (int y = 0; y < grid.height(); ++y) grid.set_run(y, 0, length + 3, true);
    SECTION("empty") {}
    SECTION("one blocked cell") { grid.set({length, length}, false); }
    SECTION("a wall") { grid.set_run(length / 2, 0, length, false); }
    SECTION("a corridor") {
      for (int y = 1; y < length + 3; ++y) grid.set_run(y, 0, length + 3, false);
      grid.set({length, 1}, true);
    }
    std::size_t compared = 0;
    REQUIRE(count_wrong(grid, JumpTable::build(grid), compared, 19) == 0);
    CHECK(compared > 50);
  }
}

TEST_CASE("jump tables are written and read, and those of other grids and damaged ones refused") {
  Random random(17);
  const OccupancyGrid grid = test::random_grid(random, 40);
  const std::string bytes = JumpTable::build(grid).to_bytes();
  const auto loaded = JumpTable::from_bytes(bytes, grid);
  REQUIRE(loaded);
  CHECK(loaded->to_bytes() == bytes);
  CHECK(loaded->matches(grid));
  CHECK_FALSE(JumpTable::from_bytes(bytes.substr(0, bytes.size() - 1), grid));
  CHECK_FALSE(JumpTable::from_bytes("", grid));
  OccupancyGrid other = grid;
  other.set({0, 0}, !other.is_free(Cell{0, 0}));
  CHECK_FALSE(loaded->matches(other));
  CHECK_FALSE(JumpTable::from_bytes(bytes, other));
  std::string damaged = bytes;
  damaged[damaged.size() - 1] = 0x7F;
  CHECK_FALSE(JumpTable::from_bytes(damaged, grid));
}
