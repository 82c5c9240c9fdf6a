// SPDX-License-Identifier: MIT
#include "../../examples/drive/contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <variant>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace drive_program;

constexpr double infinite = std::numeric_limits<double>::infinity();

Motion random_motion(Random& random) {
  const Pose from{{random.uniform(-2, 2), random.uniform(-2, 2)}, random.uniform(-4, 4)};
  Twist twist{random.uniform(-0.5, 1), random.uniform(-2, 2)};
  if (random.below(4) == 0) twist.omega = 0;
  if (random.below(6) == 0) twist.v = 0;
  return {from, twist, random.uniform(0.05, 3)};
}

MovingObstacle random_obstacle(Random& random) {
  MovingObstacle obstacle;
  const Point center{random.uniform(-2, 2), random.uniform(-2, 2)};
  const double size = random.uniform(0, 0.8);
  if (random.below(2) == 0) {
    obstacle.shape = Disc{center, size};
  } else {
    Polygon polygon;
    const auto corners = static_cast<int>(1 + random.below(5));
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners + random.uniform(0, 0.5);
      polygon.outer.emplace_back(center.x() + size * std::cos(angle),
                                 center.y() + size * std::sin(angle));
    }
    obstacle.shape = polygon;
  }
  if (random.below(3) != 0) obstacle.velocity = {random.uniform(-1, 1), random.uniform(-1, 1)};
  return obstacle;
}

/// The distance of a point from an obstacle, 0 inside a polygon.
double plain_distance(const Point& p, const Obstacle& obstacle) {
  if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
    return (p - disc->center).norm() - disc->radius;
  }
  const Polygon& polygon = std::get<Polygon>(obstacle);
  if (contains(polygon, p)) return 0;
  double least = infinite;
  const std::size_t n = polygon.outer.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = polygon.outer[i], d = polygon.outer[(i + 1) % n] - a;
    const double t = d.squaredNorm() > 0 ? (p - a).dot(d) / d.squaredNorm() : 0;
    least = std::min(least, (p - a - std::clamp(t, 0.0, 1.0) * d).norm());
  }
  return least;
}

TEST_CASE("the judge's approach is the least of dense samples, to within their spacing") {
  Random random(1);
  std::size_t close = 0;
  for (std::size_t round = 0; round < test::scaled(400); ++round) {
    CAPTURE(round);
    const Motion motion = random_motion(random);
    const MovingObstacle obstacle = random_obstacle(random);
    const Approach found = approach(motion, obstacle);
    constexpr int samples = 4000;
    double least = infinite;
    for (int i = 0; i <= samples; ++i) {
      const double time = motion.duration * i / samples;
      least = std::min(least, plain_distance(motion.at(time).position, at_time(obstacle, time)));
    }
    const double speed = std::abs(motion.twist.v) + obstacle.velocity.norm();
    const double spacing = 0.5 * speed * motion.duration / samples;
    REQUIRE(found.distance <= least + 1e-9);
    REQUIRE(found.distance >= least - spacing - 1e-9);
    if (found.distance < 0.3) ++close;
    if (found.distance <= 0) continue;
    const Point there = motion.at(found.time).position;
    REQUIRE(plain_distance(there, at_time(obstacle, found.time)) ==
            Approx(found.distance).margin(1e-9));
  }
  CHECK(20 * close > test::scaled(400));
}

TEST_CASE("the judge sees what is met between two ends that are far away") {
  // The robot crosses the path of a disc that passes at the same time.
  const Motion motion{{{-1, 0}, 0}, {1, 0}, 2};
  const MovingObstacle passes{Disc{{0, -1}, 0.1}, {0, 1}};
  CHECK(approach(motion, passes).distance == Approx(-0.1));
  CHECK(approach(motion, passes).time == Approx(1));
  const MovingObstacle late{Disc{{0, -2}, 0.1}, {0, 1}};
  CHECK(approach(motion, late).distance == Approx(std::sqrt(0.5) - 0.1));
}

TEST_CASE("the judge finds the map's obstacles, and that the robot is inside one") {
  const auto map = InflatedSpace::build({.bounds = {{0, 0}, {9, 9}},
                                         .safety_radius = 0.3,
                                         .obstacles = {Polygon{{{3, 0}, {4, 0}, {4, 9}, {3, 9}}},
                                                       Disc{{1, 5}, 0.5}}})
                       .value();
  CHECK(approach(map, {{{1, 1}, 0}, {1, 0}, 1}, 5).distance == Approx(1));
  CHECK(approach(map, {{{1, 1}, 0}, {1, 0}, 3}, 5).distance == Approx(0).margin(1e-9));
  CHECK(approach(map, {{{1, 1}, 0}, {0, 0}, 1}, 9).distance == Approx(2));
  CHECK(approach(map, {{{1, 2}, std::numbers::pi / 2}, {1, 0}, 2}, 9).distance == Approx(0.5));
  CHECK(approach(map, {{{3.5, 1}, 0}, {0, 0}, 1}, 9).distance == 0);
  CHECK(approach(map, {{{7, 1}, 0}, {0, 0}, 1}, 0.5).distance == 0.5);
}

}  // namespace
