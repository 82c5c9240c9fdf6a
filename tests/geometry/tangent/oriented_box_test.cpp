// SPDX-License-Identifier: MIT
#include "tutavia/geometry/tangent/oriented_box.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using detail::OrientedBox;

TEST_CASE("a band is measured along and across the line from its first point") {
  // 3-4-5: along (0.8, 0.6), from 0 to 10, and 1 to the left of it.
  const OrientedBox band({{0, 0}, {8, 6}, {3.4, 3.8}}, {8, 6});
  CHECK_FALSE(band.is_far({4, 3}, 0.01));
  CHECK_FALSE(band.is_far({3.4, 3.8}, 0.01));
  CHECK(band.is_far({2.8, 4.6}, 0.9));  // 2 to the left, 1 beyond the band
  CHECK_FALSE(band.is_far({2.8, 4.6}, 1.1));
  CHECK(band.is_far({4.6, 2.2}, 0.9));  // 1 to the right
  CHECK(band.is_far({8.8, 6.6}, 0.9));  // 1 beyond the end
  CHECK_FALSE(band.is_far({8.8, 6.6}, 1.1));
}

TEST_CASE("a band that ends where it starts is a rectangle along the axes") {
  const OrientedBox band({{1, 1}, {3, 2}}, {1, 1});
  CHECK_FALSE(band.is_far({2, 1.5}, 0));
  CHECK(band.is_far({2, 2.5}, 0.4));
}

TEST_CASE("along an axis a band has one box, slanted and long it has several") {
  const auto count = [](const Point& end, double margin) {
    int boxes = 0;
    OrientedBox({{0, 0}, end}, end).for_each_box(margin, [&](const Box&) { ++boxes; });
    return boxes;
  };
  CHECK(count({100, 0}, 1) == 1);
  CHECK(count({0, -100}, 1) == 1);
  CHECK(count({100, 100}, 1) > 4);
  CHECK(count({100, 100}, 100) == 1);  // as wide as long
  CHECK(count({1e6, 1e6}, 1e-3) == 32);
}

TEST_CASE("whatever is not far from a band lies in one of its boxes") {
  const std::uint64_t seed = 33;
  Random random(seed);
  std::size_t near = 0, far = 0;
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto any = [&] { return Point(random.uniform(-10, 10), random.uniform(-10, 10)); };
    const std::vector<Point> points{any(), any(), any()};
    const OrientedBox band(points, points[1]);
    const double margin = random.uniform(0.01, 1);
    std::vector<Box> boxes;
    band.for_each_box(margin, [&](const Box& box) { boxes.push_back(box); });
    for (const Point& p : points) CHECK_FALSE(band.is_far(p, 1e-9));
    for (int i = 0; i < 50; ++i) {
      const Point p = any();
      ++(band.is_far(p, margin) ? far : near);
      if (band.is_far(p, 0)) continue;
      bool in_box = false;
      for (const Box& box : boxes) in_box = in_box || box.inflated(1e-9).contains(p);
      CHECK(in_box);
    }
  }
  CHECK(std::min(near, far) > test::scaled(500));
}

}  // namespace
