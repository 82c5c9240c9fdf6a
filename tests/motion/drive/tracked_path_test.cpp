// SPDX-License-Identifier: MIT
#include "tutavia/motion/drive/tracked_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using detail::TrackedPath;

TrackedPath tracked(const std::vector<Point>& points) {
  return TrackedPath(Curve::polyline(points));
}

TEST_CASE("a tracked path has samples at equal steps, from its start to its end") {
  const TrackedPath path = tracked({{0, 0}, {2, 0}, {2, 1.27}});
  CHECK(path.length() == Approx(3.27));
  CHECK(path.samples().front().position == Point(0, 0));
  CHECK(path.samples().back().position == Point(2, 1.27));
  CHECK(path.remaining() == path.length());
  for (double s = -1; s < 5; s += 0.07) {
    CAPTURE(s);
    const double at = path.near(s).s;
    CHECK(at >= std::clamp(s, 0.0, path.length()) - 1e-9);
    CHECK(at < std::max(0.0, s) + TrackedPath::step + 1e-9);
  }
  CHECK(TrackedPath().empty());
}

TEST_CASE("progress follows a robot within half a step, and no farther than it is") {
  TrackedPath path = tracked({{0, 0}, {3, 0}, {3, 3}});
  Random random(3);
  for (double s = 0; s < 6; s += 0.04) {
    CAPTURE(s);
    const Point on = s < 3 ? Point(s, 0) : Point(3, s - 3);
    const double off = path.advance(on + Point(0.02 * random.uniform(), 0));
    CHECK(off < 0.08);
    CHECK(std::abs(path.progress() - s) < 0.1);
    CHECK(path.remaining() == Approx(6 - path.progress()));
  }
}

TEST_CASE("progress stays on its part of a path that comes back, and falls back a little") {
  TrackedPath path = tracked({{0, 0}, {5, 0}, {5, 0.2}, {0, 0.2}});
  path.advance({0.5, 0});
  CHECK(path.progress() == Approx(0.5).margin(0.06));
  // The way back passes nearer.
  CHECK(path.advance({0.6, 0.15}) < 0.2);
  CHECK(path.progress() == Approx(0.6).margin(0.06));
  path.advance({0.4, 0});
  CHECK(path.progress() == Approx(0.4).margin(0.06));
  // A robot far ahead of its progress is followed while the path comes nearer to it.
  CHECK(path.advance({4, 0}) < 0.1);
  CHECK(path.progress() == Approx(4).margin(0.06));
}

TEST_CASE("a path of one point has no length, and a robot is as far off as it is from it") {
  TrackedPath path = tracked({{1, 1}, {1, 1}});
  REQUIRE_FALSE(path.empty());
  CHECK(path.length() == 0);
  CHECK(path.advance({1, 3}) == Approx(2));
  CHECK(path.progress() == 0);
  CHECK(path.near(1).position == Point(1, 1));
  const std::vector<MovingObstacle> upon{{Disc{{1, 1.2}, 0.1}}};
  CHECK(path.first_block(upon, 0.3, 0.4, 4));
  CHECK_FALSE(path.first_block(upon, 0.05, 0.4, 4));
}

TEST_CASE("the first block is where the robot would first come too near to an obstacle") {
  TrackedPath path = tracked({{0, 0}, {10, 0}});
  path.advance({0.6, 0});
  const MovingObstacle far{Disc{{5, 0.2}, 0.1}}, near{Disc{{3, 0}, 0.5}}, beside{Disc{{2, 1}, 0.2}};
  const auto block = [&](const std::vector<MovingObstacle>& observed, double ahead = 8) {
    return path.first_block(observed, 0.3, 0.5, ahead);
  };
  REQUIRE(block({far, beside, near}));
  CHECK(block({far, beside, near})->obstacle == 2);
  CHECK(block({far, beside, near})->s == Approx(2.2).margin(0.11));
  CHECK(block({near, far})->obstacle == 0);
  CHECK_FALSE(block({beside}));
  CHECK_FALSE(block({far}, 3));
  CHECK_FALSE(block({}));
  // What the robot has passed blocks nothing.
  CHECK_FALSE(block({{Disc{{0, 0}, 0.1}}}));
}

TEST_CASE("a block by an obstacle that moves is where they meet") {
  const TrackedPath path = tracked({{0, 0}, {10, 0}});
  Random random(11);
  constexpr double speed = 0.5, clearance = 0.3, ahead = 6;
  std::size_t met = 0, missed = 0;
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    CAPTURE(round);
    const MovingObstacle obstacle{Disc{{random.uniform(1, 6), random.uniform(-2, 2)}, 0.2},
                                  {random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4)}};
    // The way until the robot is nearer than a distance, in steps of a centimetre.
    const auto way_until = [&](double least) {
      double s = 0;
      for (; s <= ahead; s += 0.01) {
        const Disc there = std::get<Disc>(at_time(obstacle, s / speed));
        if (distance(there.center, {s, 0}) - there.radius < least) break;
      }
      return s;
    };
    const auto block = path.first_block(std::vector{obstacle}, clearance, speed, ahead);
    if (block) CHECK(block->s >= way_until(clearance) - 0.011);
    // In half a step both move by 0.11 m at most, so no sample may be so near.
    const double deep = way_until(clearance - 0.12);
    if (deep <= ahead) REQUIRE(block);
    if (block) CHECK(block->s <= std::min(deep, ahead) + TrackedPath::step);
    ++(block ? met : missed);
  }
  CHECK(missed > 20);
  CHECK(met > 20);
}

}  // namespace
