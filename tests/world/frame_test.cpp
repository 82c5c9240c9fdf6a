// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/world/frame.hpp"

namespace {

using namespace tutavia;

TEST_CASE("a frame places cell (x, y) at origin + resolution (x, y)", "[world]") {
  const Frame frame{{10, -5}, 0.25};
  CHECK(frame.point({0, 0}) == Point(10, -5));
  CHECK(frame.point({4, 8}) == Point(11, -3));
  CHECK(frame.point({-2, -1}) == Point(9.5, -5.25));
  CHECK(Frame{}.point({3, -7}) == Point(3, -7));
}

TEST_CASE("the nearest cell is found on both sides of half a step", "[world]") {
  const Frame frame{{10, -5}, 0.25};
  CHECK(frame.nearest_cell({10.12, -5.12}) == Cell{0, 0});
  CHECK(frame.nearest_cell({10.13, -5.13}) == Cell{1, -1});
  CHECK(frame.nearest_cell({9.87, -4.87}) == Cell{-1, 1});
  CHECK(frame.nearest_cell({9.88, -4.88}) == Cell{0, 0});
}

TEST_CASE("every cell is the nearest to its own point, up to 2^30 cells away", "[world]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(1000); ++round) {
    const Frame frame{{random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3)},
                      random.uniform(0.01, 2)};
    const auto coordinate = [&] {
      const int limit = round % 2 == 0 ? 100 : 1 << 30;
      return static_cast<int>(random.below(2 * static_cast<std::uint64_t>(limit))) - limit;
    };
    const Cell cell{coordinate(), coordinate()};
    INFO("round " << round << " cell " << cell.x << ", " << cell.y);
    CHECK(frame.nearest_cell(frame.point(cell)) == cell);
  }
}

TEST_CASE("no other cell is nearer than the nearest one", "[world]") {
  const std::uint64_t seed = 2;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    const Frame frame{{random.uniform(-5, 5), random.uniform(-5, 5)}, random.uniform(0.1, 2)};
    const Point p{random.uniform(-9, 9), random.uniform(-9, 9)};
    const Cell nearest = frame.nearest_cell(p);
    const double distance = (frame.point(nearest) - p).norm();
    INFO("round " << round);
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        CHECK(distance <= (frame.point(nearest + Cell{dx, dy}) - p).norm() + 1e-13);
      }
    }
    CHECK(distance <= frame.resolution * std::sqrt(0.5) + 1e-13);
  }
}

}  // namespace
