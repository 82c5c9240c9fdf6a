// SPDX-License-Identifier: MIT
#include "tutavia/geometry/areal.hpp"

#include "support/catch.hpp"

/// A type of a user: a square around a point.
struct Pad {
  tutavia::Point centre;
  double half;
};

template <>
struct tutavia::ArealTraits<Pad> {
  static std::vector<Polygon> polygons(const Pad& pad) {
    return to_polygons(Box::around({pad.centre}).inflated(pad.half));
  }
};

namespace {

using namespace tutavia;

static_assert(Areal<Polygon> && Areal<std::vector<Polygon>> && Areal<Ring> && Areal<Box>);
static_assert(Areal<Pad> && !Areal<Point> && !Areal<double>);

TEST_CASE("polygons, rings and boxes are areas, and types with traits of their own") {
  const Ring triangle{{0, 0}, {2, 0}, {0, 2}};
  const Polygon with_hole{{{-9, -9}, {9, -9}, {0, 9}}, {triangle}};
  REQUIRE(to_polygons(triangle).size() == 1);
  CHECK(to_polygons(triangle)[0].outer == triangle);
  CHECK(to_polygons(with_hole).at(0).holes == with_hole.holes);
  CHECK(to_polygons(std::vector<Polygon>{with_hole, with_hole}).size() == 2);
  CHECK(to_polygons(Box{{1, 2}, {3, 5}}).at(0).outer == Ring{{1, 2}, {3, 2}, {3, 5}, {1, 5}});
  CHECK(to_polygons(Pad{{1, 1}, 1}).at(0).outer == Ring{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
}

}  // namespace
