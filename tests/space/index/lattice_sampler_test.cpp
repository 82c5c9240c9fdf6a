// SPDX-License-Identifier: MIT
#include "tutavia/space/index/lattice_sampler.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using detail::SampledGrid;

constexpr std::int64_t any_number = std::int64_t{1} << 28;

TEST_CASE("deciding nodes in blocks gives what deciding them one by one gives") {
  const std::uint64_t seed = 4;
  test::WorldGenerator worlds(seed);
  std::size_t nodes = 0, free_nodes = 0, ties = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto space = InflatedSpace::build(world).value();
    const double delta = world.bounds.width() / 33, r = world.safety_radius;
    const auto clearance_at = [&space](const Point& p) { return space.clearance(p); };
    const SampledGrid sampled =
        detail::sample_lattice(clearance_at, world.bounds, r, space.distance_error_bound(), delta,
                               any_number)
            .value();
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
      detail::sample_lattice(ring, Box{{-8, -8}, {8, 8}}, 0.5, 1e-14, 0.25, any_number).value();
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
      detail::sample_lattice(wall, Box{{-50, -50}, {50, 50}}, 0, 0, 0.1, any_number).value();
  CHECK(sampled.grid.count_free() > 990'000);
  CHECK(calls < 50'000);
}

TEST_CASE("a resolution that makes no lattice is refused") {
  const auto code = [](double resolution, std::int64_t max_nodes) {
    const auto everywhere = [](const Point&) -> double { return 1; };
    const auto sampled =
        detail::sample_lattice(everywhere, Box{{-50, -50}, {50, 50}}, 0, 0, resolution, max_nodes);
    REQUIRE_FALSE(sampled);
    return sampled.error().code;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, infinity, std::nan("")}) {
    CHECK(code(bad, any_number) == PlanError::invalid_option);
  }
  CHECK(code(1e-9, any_number) == PlanError::limit_exceeded);
  CHECK(code(1, 10'000) == PlanError::limit_exceeded);  // 101 x 101
}

TEST_CASE("the default resolution is 1/200 of the larger side") {
  CHECK(detail::default_resolution(Box{{0, 0}, {10, 40}}) == 0.2);
}

}  // namespace
