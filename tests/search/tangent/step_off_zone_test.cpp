// SPDX-License-Identifier: MIT
#include "tutavia/search/tangent/step_off_zone.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using detail::step_off_zone;

InflatedSpace above_a_wall(std::vector<Obstacle> others = {}) {
  others.emplace_back(Polygon{{{0, 0}, {9, 0}, {9, 1}, {0, 1}}});
  return InflatedSpace::build(
             {.bounds = {{0, 0}, {9, 9}}, .safety_radius = 0.5, .obstacles = std::move(others)})
      .value();
}

TEST_CASE("a point away from safety zones stays, and one on a zone's boundary steps off it") {
  const auto space = above_a_wall();
  CHECK(*step_off_zone(space, {4, 3}) == Point(4, 3));
  const auto beside = step_off_zone(space, {4, 1.5});
  REQUIRE(beside);
  CHECK(std::abs(beside->x() - 4) < 1e-12);
  CHECK(beside->y() > 1.5);
  CHECK(beside->y() < 1.5 + 1e-12);
  CHECK(space.segment_free({4, 1.5}, *beside));
}

TEST_CASE("between two zones there is no step") {
  const auto space = above_a_wall({Polygon{{{0, 2}, {9, 2}, {9, 3}, {0, 3}}}});
  REQUIRE(space.is_free({4, 1.5}));
  CHECK_FALSE(step_off_zone(space, {4, 1.5}));
}

}  // namespace
