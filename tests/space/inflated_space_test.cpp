// SPDX-License-Identifier: MIT
#include "tutavia/space/inflated_space.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/reference_distance.hpp"
#include "support/scale.hpp"

namespace {

using namespace tutavia;

static_assert(CornerSpace<InflatedSpace>);

constexpr double inf = std::numeric_limits<double>::infinity();

TEST_CASE("clearance is the signed distance that brute force finds") {
  const std::uint64_t seed = 1;
  test::WorldGenerator worlds(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto space = InflatedSpace::build(world).value();
    for (int i = 0; i < 20; ++i) {
      const Point p = worlds.point(world);
      const double expected = static_cast<double>(test::reference_clearance(world, p));
      INFO("point " << p.transpose() << ", expected " << expected);
      if (std::isinf(expected)) {
        CHECK(space.clearance(p) == expected);
      } else if (std::abs(expected) > 1e-9) {  // on an edge, inside and outside are one
        CHECK(std::abs(space.clearance(p) - expected) <= space.distance_error_bound());
        CHECK(space.is_free(p) == (expected >= world.safety_radius));
      }
    }
  }
}

TEST_CASE("the clearance of a point with NaN is NaN, and it is not free") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto space =
      InflatedSpace::build(
          {.bounds = {{0, 0}, {9, 9}}, .safety_radius = 0.5, .obstacles = {Disc{{4, 4}, 1}}})
          .value();
  for (const Point& p : {Point(nan, 1), Point(1, nan), Point(nan, nan)}) {
    CHECK(std::isnan(space.clearance(p)));
    CHECK_FALSE(space.is_free(p));
  }
}

TEST_CASE("a segment is free iff all of its points are") {
  const std::uint64_t seed = 2;
  test::WorldGenerator worlds(seed);
  std::size_t free_segments = 0, blocked_segments = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto space = InflatedSpace::build(world).value();
    const Point p = worlds.point(world), q = worlds.point(world);
    const Point segment[] = {p, q};
    const auto sampled = test::sampled_clearance(world, Curve::polyline(segment), 200);
    const bool free = space.segment_free(p, q);
    CHECK(free == space.segment_free(q, p));
    if (free) CHECK(sampled >= world.safety_radius - space.distance_error_bound());
    const double step = (q - p).norm() / 400;  // no point is farther from a sample
    if (!free) CHECK(sampled <= world.safety_radius + step + space.distance_error_bound());
    ++(free ? free_segments : blocked_segments);
  }
  CHECK(free_segments > 20);
  CHECK(blocked_segments > 20);
}

TEST_CASE("a distance of exactly the safety radius is free, one ulp less is not") {
  const auto space = InflatedSpace::build({.bounds = {{-10, -10}, {10, 10}},
                                           .safety_radius = 0.1,
                                           .obstacles = {Polygon{{{0, 0}, {3, 0}, {3, -1}}}}})
                         .value();
  CHECK(space.is_free({1, 0.1}));
  CHECK_FALSE(space.is_free({1, std::nextafter(0.1, 0.0)}));
  CHECK(space.segment_free({-2, 0.1}, {5, 0.1}));
  CHECK_FALSE(space.segment_free({-2, std::nextafter(0.1, 0.0)}, {5, 0.1}));

  // 3-4-5: the point (3, 4) is exactly 5 from the origin, the radius 5 exactly two parts of 2
  // and 3.
  const auto disc =
      InflatedSpace::build(
          {.bounds = {{-10, -10}, {10, 10}}, .safety_radius = 2, .obstacles = {Disc{{0, 0}, 3}}})
          .value();
  CHECK(disc.is_free({3, 4}));
  CHECK_FALSE(disc.is_free({3, std::nextafter(4.0, 0.0)}));
  CHECK(disc.segment_free({5, -9}, {5, 9}));
}

TEST_CASE("a point deep inside a large polygon is not free, however small the radius") {
  const auto space =
      InflatedSpace::build({.bounds = {{0, 0}, {100, 100}},
                            .safety_radius = 0.01,
                            .obstacles = {Polygon{{{1, 1}, {99, 1}, {99, 99}, {1, 99}},
                                                  {{{40, 40}, {60, 40}, {50, 60}}}}}})
          .value();
  CHECK_FALSE(space.is_free({20, 20}));
  CHECK_FALSE(space.segment_free({20, 20}, {21, 20}));
  CHECK(space.clearance({20, 20}) == Approx(-19));
  CHECK(space.is_free({50, 50}));  // in the hole
  CHECK(space.segment_free({49, 45}, {51, 45}));
}

TEST_CASE("nearest is capped, and names the obstacle and the edge") {
  const auto space =
      InflatedSpace::build(
          {.bounds = {{0, 0}, {100, 100}},
           .safety_radius = 1,
           .obstacles = {Disc{{90, 90}, 2}, Polygon{{{10, 10}, {20, 10}, {20, 20}, {10, 20}}}}})
          .value();
  const NearestObstacle found = space.nearest(Segment{{25, 12}, {25, 30}}, inf);
  CHECK(found.distance == 5);
  CHECK(found.obstacle == 1);
  CHECK(found.edge == 1);
  CHECK(Point(25, 12 + 18 * found.parameter).y() <= 20);
  CHECK(space.nearest(Segment{{25, 12}, {25, 30}}, 4).obstacle == NearestObstacle::none);
  CHECK(space.nearest(Segment{{25, 12}, {25, 30}}, 4).distance == 4);
  CHECK(space.nearest(Segment{{90, 85}, {90, 85}}, inf).distance == 3);
  CHECK(space.nearest(Segment{{90, 90}, {90, 90}}, inf).distance == -2);
}

TEST_CASE("without obstacles everything within the bounds is free and infinitely clear") {
  const auto space = InflatedSpace::build({.bounds = {{0, 0}, {1, 1}}, .safety_radius = 5}).value();
  CHECK(space.is_free({0, 1}));
  CHECK_FALSE(space.is_free({0, 1.0000001}));
  CHECK(space.clearance({0.5, 0.5}) == inf);
}

TEST_CASE("convex corners are found, reflex ones and those of holes are told apart") {
  // An L has five convex corners and a reflex one; a square hole in it has only reflex ones.
  const Ring l{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  const Ring hole{{0.5, 0.5}, {1, 0.5}, {1, 1}, {0.5, 1}};
  for (const bool flip : {false, true}) {
    Ring outer = l;
    if (flip) std::reverse(outer.begin(), outer.end());
    const auto space =
        InflatedSpace::build({.bounds = {{-5, -5}, {9, 9}},
                              .safety_radius = 0.1,
                              .obstacles = {Polygon{outer, {hole}}, Disc{{7, 7}, 1}}})
            .value();
    std::size_t vertices = 0, discs = 0;
    space.for_each_corner({{-1, -1}, {8, 8}}, [&](const Corner& corner) {
      ++(corner.radius > 0 ? discs : vertices);
      CHECK(corner.position != Point(2, 2));
      if (corner.radius == 0) CHECK(corner.exterior_angle == Approx(std::acos(-1) / 2));
    });
    CHECK(vertices == 5);
    CHECK(discs == 1);
  }
}

TEST_CASE("the nearest obstacle is found in a world of no size, too") {
  Workspace world{.bounds = {{1, 0}, {1, 0}}};
  world.obstacles.emplace_back(Polygon{{{0, 2}}});
  const auto space = InflatedSpace::build(world).value();
  CHECK(space.clearance({1, 0}) == Approx(std::sqrt(5.0)));
  CHECK(space.is_free({1, 0}));
}

}  // namespace
