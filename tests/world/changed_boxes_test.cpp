// SPDX-License-Identifier: MIT
#include "tutavia/world/changed_boxes.hpp"

#include <algorithm>

#include "support/catch.hpp"

namespace {

using namespace tutavia;

const Polygon square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
const Polygon ring{{{-1, -1}, {3, -1}, {3, 3}, {-1, 3}}, {square.outer}};
const Disc middle{{5, 5}, 2};

std::vector<Box> changed(std::vector<Obstacle> before, std::vector<Obstacle> after) {
  return changed_boxes({.bounds = {}, .safety_radius = 1, .obstacles = std::move(before)},
                       {.bounds = {}, .safety_radius = 1, .obstacles = std::move(after)});
}

TEST_CASE("workspaces with the same obstacles in any order do not differ") {
  CHECK(changed({}, {}).empty());
  CHECK(changed({square, middle, ring}, {ring, square, middle}).empty());
}

TEST_CASE("boxes of obstacles that came, went and moved") {
  const auto came = changed({square}, {square, middle});
  REQUIRE(came.size() == 1);
  CHECK(came[0].min == Point(3, 3));
  CHECK(came[0].max == Point(7, 7));
  CHECK(changed({square, middle}, {square}).size() == 1);
  const auto moved = changed({middle, square}, {Disc{{5, 6}, 2}, square});
  REQUIRE(moved.size() == 2);
  CHECK(std::max(moved[0].max.y(), moved[1].max.y()) == 8);
  CHECK(std::min(moved[0].max.y(), moved[1].max.y()) == 7);
}

TEST_CASE("an obstacle that stands there twice is another than one that stands there once") {
  CHECK(changed({square, square}, {square}).size() == 1);
  CHECK(changed({square, square}, {square, square}).empty());
}

TEST_CASE("the same edges as a hole and as an obstacle of its own are different obstacles") {
  // Their edges alone could not tell: the square is free in one and filled in the other.
  CHECK(changed({ring}, {Polygon{ring.outer}, square}).size() == 3);
}

}  // namespace
