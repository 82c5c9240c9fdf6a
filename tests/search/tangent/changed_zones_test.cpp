// SPDX-License-Identifier: MIT
#include "tutavia/search/tangent/changed_zones.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/segment.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using detail::ChangedZones;

const Box bounds{{0, 0}, {100, 100}};

bool are_near(const Box& changed, double margin, const Point& a, const Point& b,
              double radius = 0) {
  const std::vector<Box> boxes{changed};
  return ChangedZones(boxes, bounds, margin).are_near(a, b, radius);
}

TEST_CASE("a segment is near a change that it crosses, or that margin and radius bring to it") {
  const Box changed{{40, 40}, {60, 60}};
  CHECK(are_near(changed, 0, {0, 0}, {100, 100}));
  CHECK(are_near(changed, 0, {50, 50}, {50, 50}));
  CHECK_FALSE(are_near(changed, 0, {0, 65}, {100, 65}));
  CHECK(are_near(changed, 6, {0, 65}, {100, 65}));
  CHECK(are_near(changed, 0, {0, 65}, {100, 65}, 6));
  CHECK(are_near(changed, 3, {0, 65}, {100, 65}, 3));
  CHECK_FALSE(are_near(changed, 0, {0, 50}, {30, 50}));  // ends before it
  // Its box meets the change, the segment passes the corner (60, 40).
  CHECK_FALSE(are_near(changed, 0, {45, 20}, {85, 60}));
}

TEST_CASE("changes beyond the bounds are near to nothing") {
  CHECK_FALSE(are_near({{200, 0}, {300, 100}}, 0, {0, 0}, {100, 100}));
  CHECK(are_near({{200, 0}, {300, 100}}, 101, {0, 50}, {100, 50}));
  CHECK_FALSE(ChangedZones({}, bounds, 1000).are_near({0, 0}, {100, 100}, 1000));
}

TEST_CASE("a segment is near a box exactly where its samples say so") {
  const std::uint64_t seed = 53;
  Random random(seed);
  std::size_t near = 0, far = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto any = [&] { return Point(random.uniform(0, 100), random.uniform(0, 100)); };
    const Point low = any();
    const Box changed{low, low + Point(random.uniform(0, 20), random.uniform(0, 20))};
    const Segment edge{any(), any()};
    const double radius = random.uniform(0, 5);
    const bool found = are_near(changed, 0, edge.a, edge.b, radius);
    // By samples 0.03 apart at most: those of a slightly smaller and of a slightly larger box.
    const Box zone = Box{changed.min, changed.max.cwiseMin(bounds.max)}.inflated(radius);
    bool inside = false, beside = false;
    for (int i = 0; i <= 5000; ++i) {
      const Point p = edge.point(i / 5000.0);
      inside = inside || zone.contains(p);
      beside = beside || zone.inflated(0.03).contains(p);
    }
    if (inside) CHECK(found);
    if (!beside) CHECK_FALSE(found);
    ++(found ? near : far);
  }
  CHECK(std::min(near, far) > test::scaled(15));
}

}  // namespace
