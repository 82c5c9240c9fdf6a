// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/grid/movement.hpp"

namespace {

using namespace tutavia;

// The ratio is not below sqrt(2): its square is not below 2.
static_assert(diagonal_cost * diagonal_cost >= 2 * straight_cost * straight_cost);

TEST_CASE("a diagonal costs sqrt(2) straight steps to a relative 1.4e-9", "[grid]") {
  const double ratio = static_cast<double>(diagonal_cost) / static_cast<double>(straight_cost);
  CHECK(ratio / std::sqrt(2.0) - 1 < 1.4e-9);
}

TEST_CASE("the steps run counterclockwise from +x, each opposite to the fourth next", "[grid]") {
  CHECK(steps[0] == Cell{1, 0});
  CHECK(steps[2] == Cell{0, 1});
  for (std::size_t i = 0; i < steps.size(); ++i) {
    CAPTURE(i);
    const Cell step = steps[i], next = steps[(i + 1) % 8];
    CHECK(step.x * next.y - step.y * next.x == 1);
    CHECK(step + steps[(i + 4) % 8] == Cell{0, 0});
    CHECK(detail::is_diagonal(i) == (step.x != 0 && step.y != 0));
    CHECK(detail::step_cost(i) == octile_cost({0, 0}, step));
    CHECK(detail::step_cost(i) == (detail::is_diagonal(i) ? diagonal_cost : straight_cost));
  }
}

TEST_CASE("the octile cost is that of the cheapest walk over free cells", "[grid]") {
  constexpr int size = 9, centre = 4;
  std::array<std::array<Cost, size>, size> cost{};
  for (auto& row : cost) row.fill(std::numeric_limits<Cost>::max() / 2);
  cost[centre][centre] = 0;
  for (int sweep = 0; sweep < size * size; ++sweep) {  // Bellman and Ford
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        for (std::size_t i = 0; i < 8; ++i) {
          const Cell to = Cell{x, y} + steps[i];
          if (to.x < 0 || to.y < 0 || to.x >= size || to.y >= size) continue;
          Cost& known = cost.at(static_cast<std::size_t>(to.y)).at(static_cast<std::size_t>(to.x));
          const Cost through =
              cost.at(static_cast<std::size_t>(y)).at(static_cast<std::size_t>(x)) +
              detail::step_cost(i);
          if (through < known) known = through;
        }
      }
    }
  }
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      CAPTURE(x, y);
      CHECK(octile_cost({centre, centre}, {x, y}) ==
            cost.at(static_cast<std::size_t>(y)).at(static_cast<std::size_t>(x)));
    }
  }
}

TEST_CASE("the octile cost is a metric, exact and free of overflow for all cells", "[grid]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  const auto coordinate = [&] { return static_cast<int>(static_cast<std::uint32_t>(random())); };
  for (std::size_t round = 0; round < test::scaled(1000); ++round) {
    const Cell a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    const Cell c{coordinate(), coordinate()};
    INFO("round " << round);
    CHECK(octile_cost(a, b) > 0);
    CHECK(octile_cost(a, b) == octile_cost(b, a));
    CHECK(octile_cost(a, a) == 0);
    CHECK(octile_cost(a, c) <= octile_cost(a, b) + octile_cost(b, c));
    const double dx = static_cast<double>(a.x) - b.x, dy = static_cast<double>(a.y) - b.y;
    const double straight =
        static_cast<double>(octile_cost(a, b)) / static_cast<double>(straight_cost);
    CHECK(straight >= std::hypot(dx, dy) * (1 - 1e-15));  // never below the straight line
    CHECK(straight <= 1.0823923 * std::hypot(dx, dy));    // nor above 1 / cos(22.5 degrees)
  }
  constexpr int low = std::numeric_limits<int>::min(), high = std::numeric_limits<int>::max();
  CHECK(octile_cost({low, low}, {high, high}) == diagonal_cost * 0xFFFFFFFF);
  CHECK(octile_cost({high, 0}, {low, 0}) == straight_cost * 0xFFFFFFFF);
}

}  // namespace
