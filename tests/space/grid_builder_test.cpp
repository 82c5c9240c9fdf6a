// SPDX-License-Identifier: MIT
#include "tutavia/space/grid_builder.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("deciding nodes in blocks gives what deciding them one by one gives") {
  const std::uint64_t seed = 4;
  test::WorldGenerator worlds(seed);
  std::size_t nodes = 0, free_nodes = 0, ties = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto space = InflatedSpace::build(world).value();
    const double delta = world.bounds.width() / 33, r = world.safety_radius;
    const SampledGrid sampled = grid_builder(space).build({.resolution = delta}).value();
    const double threshold = std::sqrt(r * r + delta * delta / 2);
    std::size_t wrong = 0;
    for (int y = 0; y < sampled.grid.height(); ++y) {
      for (int x = 0; x < sampled.grid.width(); ++x) {
        const double clearance = space.clearance(sampled.frame.point({x, y}));
        ++nodes;
        if (std::abs(clearance - threshold) < 1e-8 * delta + 4 * space.distance_error_bound()) {
          ++ties;
          continue;
        }
        const bool expected = clearance > threshold;
        free_nodes += expected ? 1 : 0;
        if (sampled.grid.is_free({x, y}) != expected) ++wrong;
      }
    }
    CHECK(wrong == 0);
  }
  CHECK(ties * 100 < nodes);
  CHECK(free_nodes * 4 > nodes);
  CHECK(free_nodes * 4 < 3 * nodes);
}

TEST_CASE("any 1-Lipschitz clearance function can be sampled") {
  const auto ring = [](const Point& p) -> double { return 2 - std::abs(p.norm() - 5); };
  const auto sampled =
      GridBuilder(ring, Box{{-8, -8}, {8, 8}}, 0.5, 1e-14).build({.resolution = 0.25}).value();
  CHECK(sampled.grid.is_free(sampled.frame.nearest_cell({5, 0})));
  CHECK(sampled.grid.is_free(sampled.frame.nearest_cell({0, -6.25})));
  CHECK_FALSE(sampled.grid.is_free(sampled.frame.nearest_cell({0, -6.5})));
  CHECK_FALSE(sampled.grid.is_free(sampled.frame.nearest_cell({0, 0})));
}

TEST_CASE("the work grows with the boundary, not with the area") {
  std::size_t calls = 0;
  const auto wall = [&calls](const Point& p) -> double {
    ++calls;
    return std::abs(p.x());
  };
  const auto sampled =
      GridBuilder(wall, Box{{-50, -50}, {50, 50}}, 0, 0).build({.resolution = 0.1}).value();
  CHECK(sampled.grid.count_free() > 990'000);
  CHECK(calls < 50'000);
}

}  // namespace
