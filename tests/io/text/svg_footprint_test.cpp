// SPDX-License-Identifier: MIT
#include "tutavia/io/text/svg_footprint.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace tutavia;

double total_sweep(const std::vector<Arc>& arcs) {
  double sum = 0;
  for (const Arc& arc : arcs) sum += arc.sweep;
  return sum;
}

TEST_CASE("the outline of one disc is a circle, and a point has none") {
  const auto circle = detail::outline_of({{{1, 2}, 0.5}});
  REQUIRE(circle.size() == 1);
  CHECK(circle[0].center == Point(1, 2));
  CHECK(circle[0].radius == 0.5);
  CHECK(circle[0].sweep == 2 * std::numbers::pi);
  CHECK(detail::outline_of({FootprintDisc{}}).empty());
  CHECK(detail::outline_of({}).empty());
}

TEST_CASE("discs within others add nothing, equal ones count once, and those apart stay whole") {
  const FootprintDisc disc{{0, 0}, 1};
  CHECK(detail::outline_of({disc, {{0.5, 0}, 0.5}, {{0.2, 0.1}, 0.3}}).size() == 1);
  CHECK(detail::outline_of({disc, disc, disc}).size() == 1);
  CHECK(total_sweep(detail::outline_of({disc, {{3, 0}, 1}})) == Approx(4 * std::numbers::pi));
  // Two discs a radius apart: each loses a third.
  CHECK(total_sweep(detail::outline_of({disc, {{1, 0}, 1}})) ==
        Approx(2 * 2 * std::numbers::pi * 2 / 3));
}

TEST_CASE("every point of an outline lies on one circle and within no other") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-2, 2), radius(0, 1.5);
  for (int world = 0; world < 300; ++world) {
    std::vector<FootprintDisc> discs;
    for (int i = 0; i < 1 + world % 7; ++i) {
      discs.push_back({{coordinate(random), coordinate(random)}, radius(random)});
    }
    const auto outline = detail::outline_of(discs);
    const auto depth = [&](const Point& p) {  // in the disc that contains it deepest
      double most = -1;
      for (const FootprintDisc& disc : discs) {
        most = std::max(most, disc.radius - distance(disc.offset, p));
      }
      return most;
    };
    for (const Arc& arc : outline) {
      for (double t = 0; t <= 1; t += 0.125) CHECK(std::abs(depth(arc.point(t))) < 1e-9);
    }
    // And the whole border is there: a circle's part without others is as long as its arcs.
    double free = 0, drawn = total_sweep(outline);
    constexpr int steps = 2000;
    for (const FootprintDisc& disc : discs) {
      for (int k = 0; k < steps; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / steps;
        const Point p = disc.offset + disc.radius * Point(std::cos(angle), std::sin(angle));
        free += depth(p) < 1e-12 ? 2 * std::numbers::pi / steps : 0;
      }
    }
    CHECK(drawn == Approx(free).margin(0.05));
  }
}

TEST_CASE("a footprint is placed ahead of the reference point, turned with the vehicle") {
  const Pose pose{{10, 5}, std::numbers::pi / 2};
  CHECK(distance(detail::placed(Point(2, 1), pose), {9, 7}) < 1e-12);
  const Arc arc = detail::placed(Arc::around({2, 0}, 1, 0, 1), pose);
  CHECK(distance(arc.center, {10, 7}) < 1e-12);
  CHECK(distance(arc.a, {10, 8}) < 1e-12);
  CHECK(arc.sweep == 1);
}

TEST_CASE("poses are 10 to 25, equally far apart, with both ends") {
  VehiclePath path;
  path.push_back(Segment{{0, 0}, {20, 0}}, Gear::forward);
  path.push_back(Segment{{20, 0}, {10, 0}}, Gear::reverse);
  for (const auto& [spacing, count] :
       {std::pair{0.1, 25}, {1.25, 25}, {2.0, 16}, {3.0, 11}, {7.0, 10}, {1e9, 10}}) {
    INFO(spacing);
    const auto poses = detail::poses_along(path, spacing);
    CHECK(poses.size() == static_cast<std::size_t>(count));
    CHECK(poses.front().position == Point(0, 0));
    CHECK(poses.back().position == Point(10, 0));
    const double step = 30.0 / (count - 1);
    CHECK(poses[1].position.x() == Approx(step));
    CHECK(poses[poses.size() - 2].position.x() == Approx(10 + step));
    for (const Pose& pose : poses) CHECK(pose.heading == Approx(0).margin(1e-12));
  }
}

}  // namespace
