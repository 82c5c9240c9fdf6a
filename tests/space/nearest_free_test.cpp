// SPDX-License-Identifier: MIT
#include "tutavia/space/nearest_free.hpp"

#include <limits>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("the way out of a zone is the shortest one") {
  const auto space = InflatedSpace::build({.bounds = {{0, 0}, {10, 10}},
                                           .safety_radius = 0.5,
                                           .obstacles = {Polygon{{{2, 2}, {5, 2}, {5, 8}, {2, 8}}},
                                                         Disc{{8, 8}, 1}}})
                         .value();
  CHECK(nearest_free_point(space, {4.5, 5}).value().isApprox(Point(5.5, 5), 1e-12));
  CHECK(nearest_free_point(space, {5.1, 8.2})
            .value()
            .isApprox(Point(5, 8) + 0.5 * Point(0.1, 0.2).normalized(), 1e-12));
  CHECK(nearest_free_point(space, {8, 7.9}).value().isApprox(Point(8, 6.5), 1e-12));
  CHECK(nearest_free_point(space, {8, 8}).value().isApprox(Point(8, 6.5), 1));
  CHECK(nearest_free_point(space, {9, 1}).value() == Point(9, 1));
  CHECK(nearest_free_point(space, {12, 1}).value() == Point(10, 1));
  CHECK_FALSE(nearest_free_point(space, {std::numeric_limits<double>::quiet_NaN(), 1}));
}

TEST_CASE("between two zones the nearest free point is where their boundaries cross") {
  const auto space = InflatedSpace::build({.bounds = {{-9, -9}, {9, 9}},
                                           .safety_radius = 1,
                                           .obstacles = {Disc{{-1, 0}, 0.25}, Disc{{1, 0}, 0.25}}})
                         .value();
  const Point out = nearest_free_point(space, {0, 0.1}).value();
  CHECK(out.isApprox(Point(0, 0.75), 1e-9));
  CHECK(space.is_free(out));
}

TEST_CASE("where nothing is free there is no nearest free point") {
  const auto space =
      InflatedSpace::build(
          {.bounds = {{0, 0}, {1, 1}}, .safety_radius = 3, .obstacles = {Disc{{0.5, 0.5}, 0}}})
          .value();
  CHECK_FALSE(nearest_free_point(space, {0.2, 0.2}));
}

TEST_CASE("no sampled free point is nearer than the one returned") {
  const std::uint64_t seed = 9;
  test::WorldGenerator worlds(seed);
  std::size_t blocked = 0, found = 0;
  for (std::size_t round = 0; round < test::scaled(150); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto space = InflatedSpace::build(world).value();
    const Point p = worlds.point(world);
    if (space.is_free(p)) continue;
    ++blocked;
    const auto out = nearest_free_point(space, p);
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 4000; ++i) {
      const Point q = worlds.point(world);
      if (space.is_free(q)) nearest = std::min(nearest, (q - p).norm());
    }
    if (out) {
      ++found;
      CHECK(space.is_free(*out));
      CHECK((*out - p).norm() <= nearest + 1e-9 * (1 + space.largest_coordinate()));
    } else {
      CHECK(nearest == std::numeric_limits<double>::infinity());
    }
  }
  CHECK(blocked > 20);
  CHECK(found > blocked / 2);
}

}  // namespace
