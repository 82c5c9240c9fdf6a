// SPDX-License-Identifier: MIT
#include "tutavia/smooth/route/critical_corners.hpp"

#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using detail::critical_corners;

using std::numbers::pi;

InflatedSpace room_with(std::vector<Obstacle> obstacles) {
  return InflatedSpace::build({.bounds = {{0, 0}, {20, 20}},
                               .safety_radius = 0.5,
                               .obstacles = std::move(obstacles)})
      .value();
}

TEST_CASE("corners are critical whose safety zone comes within the threshold of the path") {
  const auto space = room_with({Polygon{{{5, 5}, {9, 5}, {9, 9}, {5, 9}}}});
  const std::vector<Point> below{{0, 3}, {20, 3}};  // 2 from the square, 1.5 from the zone
  CHECK(critical_corners(space, below, 1.4, 0).empty());
  const auto corners = critical_corners(space, below, 1.6, 0);
  REQUIRE(corners.size() == 2);
  for (const Corner& corner : corners) CHECK(corner.position.y() == 5);
  CHECK(critical_corners(space, below, 5.6, 0).size() == 4);
}

TEST_CASE("a corner that turns less than asked is not critical, a disc always is") {
  // A triangle with a right angle and two of 45 degrees: exterior angles pi / 2 and 3 pi / 4.
  const auto space = room_with({Polygon{{{5, 5}, {9, 5}, {5, 9}}}, Disc{{13, 5}, 1}});
  const std::vector<Point> around{{4, 4}, {19, 4}, {4, 19}};
  CHECK(critical_corners(space, around, 10, 0).size() == 4);
  CHECK(critical_corners(space, around, 10, 0.6 * pi).size() == 3);
  CHECK(critical_corners(space, around, 10, 0.8 * pi).size() == 1);
  const auto disc = critical_corners(space, {{13, 3}, {13, 2}}, 0.6, 0.8 * pi);  // 2 - 1 - 0.5
  REQUIRE(disc.size() == 1);
  CHECK(disc[0].radius == 1);
  CHECK(critical_corners(space, {{13, 3}, {13, 2}}, 0.4, 0.8 * pi).empty());
}

TEST_CASE("corners come in the order of their numbers, none twice, however often they are passed") {
  const auto space = room_with({Polygon{{{5, 5}, {9, 5}, {9, 9}, {5, 9}}}, Disc{{13, 5}, 1}});
  const std::vector<Point> loops{{4, 4}, {11, 4}, {4, 4}, {11, 4}, {11, 11}, {4, 4}};
  const auto corners = critical_corners(space, loops, 3, 0);
  REQUIRE(corners.size() == 5);
  for (std::size_t i = 1; i < corners.size(); ++i) CHECK(corners[i - 1].id < corners[i].id);
}

TEST_CASE("a path of one point or none passes no corner") {
  const auto space = room_with({Disc{{13, 5}, 1}});
  CHECK(critical_corners(space, {}, 100, 0).empty());
  CHECK(critical_corners(space, {{13, 7}}, 100, 0).empty());
}

}  // namespace
