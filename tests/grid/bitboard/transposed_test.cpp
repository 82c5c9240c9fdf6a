// SPDX-License-Identifier: MIT
#include "tutavia/grid/bitboard/transposed.hpp"

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

TEST_CASE("64 x 64 bits are transposed", "[grid]") {
  const std::uint64_t seed = 2;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(20); ++round) {
    INFO("seed " << seed << ", round " << round);
    std::array<std::uint64_t, 64> rows, columns{};
    for (std::size_t i = 0; i < 64; ++i) {
      rows[i] = random();
      for (std::size_t j = 0; j < 64; ++j) columns[j] |= (rows[i] >> j & 1u) << i;
    }
    detail::transpose_64(rows);
    CHECK(rows == columns);
  }
}

TEST_CASE("a transposed grid has rows for columns, at every size around a word", "[grid]") {
  const std::uint64_t seed = 3;
  Random random(seed);
  for (const int width : {1, 61, 62, 63, 64, 65, 130}) {
    for (const int height : {1, 2, 62, 63, 128, 200}) {
      INFO("seed " << seed << ", " << width << " x " << height);
      const OccupancyGrid grid = test::noise_grid(random, width, height, 0.4);
      const OccupancyGrid other = detail::transposed(grid);
      REQUIRE(other.width() == height);
      REQUIRE(other.height() == width);
      std::size_t wrong = 0;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          if (other.is_free(Cell{y, x}) != grid.is_free(Cell{x, y})) ++wrong;
        }
      }
      CHECK(wrong == 0);
      CHECK(detail::transposed(other).words() == grid.words());  // the blocked frame included
    }
  }
}

TEST_CASE("a grid of too many columns has no transpose", "[grid]") {
  const OccupancyGrid wide = OccupancyGrid::blocked(70'000'000, 1).value();
  const auto refused = detail::check_transpose(wide);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::limit_exceeded);
  CHECK(detail::check_transpose(OccupancyGrid::blocked(1000, 1000).value()));
}

}  // namespace
