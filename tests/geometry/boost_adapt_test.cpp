// SPDX-License-Identifier: MIT
#include "tutavia/geometry/boost_adapt.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/geometries.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace tutavia;
namespace bg = boost::geometry;

using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint>;  // closed and clockwise
using IntPoint = bg::model::point<int, 2, bg::cs::cartesian>;

static_assert(Areal<BoostPolygon> && Areal<bg::model::multi_polygon<BoostPolygon>>);
static_assert(Areal<bg::model::ring<BoostPoint>> && Areal<bg::model::box<IntPoint>>);
static_assert(Areal<Polygon> && Areal<Ring> && Areal<Box> && Areal<std::vector<Polygon>>);
static_assert(!Areal<BoostPoint> && !Areal<bg::model::linestring<BoostPoint>> && !Areal<double>);
using Space = bg::model::point<double, 3, bg::cs::cartesian>;
using Globe = bg::model::point<double, 2, bg::cs::geographic<bg::degree>>;
static_assert(!Areal<bg::model::box<Space>> && !Areal<bg::model::polygon<Globe>>);

/// A square of side 4 with a square hole of side 1, as this library's users may write it.
Polygon square_with_hole() {
  return {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}};
}

TEST_CASE("the types of the library are models of Boost.Geometry") {
  BOOST_CONCEPT_ASSERT((bg::concepts::Point<Point>));
  BOOST_CONCEPT_ASSERT((bg::concepts::Box<Box>));
  BOOST_CONCEPT_ASSERT((bg::concepts::Ring<Ring>));
  BOOST_CONCEPT_ASSERT((bg::concepts::Polygon<Polygon>));
  BOOST_CONCEPT_ASSERT((bg::concepts::MultiPolygon<std::vector<Polygon>>));
  const Polygon polygon = square_with_hole();
  CHECK(bg::is_valid(polygon));
  CHECK(bg::area(polygon) == 15);
  CHECK(bg::perimeter(polygon) == 20);
  CHECK(bg::area(polygon.outer) == 16);
  CHECK(bg::area(Box{{0, 0}, {2, 3}}) == 6);
  CHECK(bg::area(std::vector<Polygon>{polygon}) == 15);
  CHECK(bg::within(Point(3, 3), polygon));
  CHECK_FALSE(bg::within(Point(1.5, 1.5), polygon));
  CHECK(bg::within(Point(1, 1), Box{{0, 0}, {2, 3}}));
  CHECK(bg::distance(Point(7, 8), polygon) == Approx(5));
  CHECK(bg::return_envelope<Box>(polygon).max == Point(4, 4));
  CHECK(bg::return_centroid<Point>(Box{{0, 0}, {2, 3}}) == Point(1, 1.5));
}

TEST_CASE("polygons are read from WKT, and written") {
  Polygon polygon;
  bg::read_wkt("POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 2,2 1,1 1))", polygon);
  CHECK(polygon.outer == square_with_hole().outer);  // open: the last point is not repeated
  CHECK(polygon.holes == square_with_hole().holes);
  Polygon again;
  std::ostringstream text;
  text << bg::wkt(polygon);
  bg::read_wkt(text.str(), again);
  CHECK(again.outer == polygon.outer);
  CHECK(again.holes == polygon.holes);
  Point point;
  bg::read_wkt("POINT(1.5 -2)", point);
  CHECK(point == Point(1.5, -2));
}

TEST_CASE("a ring of any orientation, closed or not, is corrected to the stated one") {
  for (const Ring& ring : {Ring{{0, 0}, {0, 4}, {4, 4}, {4, 0}},          // clockwise
                           Ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}},  // closed
                           Ring{{0, 0}, {0, 4}, {4, 4}, {4, 0}, {0, 0}}}) {
    Polygon polygon{ring};
    bg::correct(polygon);
    CHECK(polygon.outer.size() == 4);
    CHECK(bg::area(polygon) == 16);
  }
}

TEST_CASE("polygons are converted to those of Boost.Geometry and back") {
  BoostPolygon boost_polygon;
  bg::convert(square_with_hole(), boost_polygon);
  CHECK(boost_polygon.outer().size() == 5);
  CHECK(bg::area(boost_polygon) == 15);
  Polygon back;
  bg::convert(boost_polygon, back);
  CHECK(back.outer.size() == 4);
  CHECK(bg::area(back) == 15);
  bg::model::box<BoostPoint> boost_box;
  bg::convert(Box{{1, 2}, {3, 4}}, boost_box);
  Box box;
  bg::convert(boost_box, box);
  CHECK(box.min == Point(1, 2));
  CHECK(box.max == Point(3, 4));
}

TEST_CASE("algorithms of Boost.Geometry write polygons") {
  const Polygon left{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, right{{{1, 0}, {3, 0}, {3, 2}, {1, 2}}};
  std::vector<Polygon> both, common, rest, wide;
  bg::union_(left, right, both);
  REQUIRE(both.size() == 1);
  CHECK(bg::area(both) == 6);
  bg::intersection(left, right, common);
  CHECK(bg::area(common) == 2);
  bg::difference(left, right, rest);
  CHECK(bg::area(rest) == 2);
  bg::buffer(left, wide, bg::strategy::buffer::distance_symmetric<double>(1),
             bg::strategy::buffer::side_straight(), bg::strategy::buffer::join_miter(),
             bg::strategy::buffer::end_flat(), bg::strategy::buffer::point_square());
  CHECK(bg::area(wide) == Approx(16));
  Ring hull;
  bg::convex_hull(both, hull);
  CHECK(bg::area(hull) == 6);
}

TEST_CASE("every areal type of Boost.Geometry becomes polygons") {
  BoostPolygon polygon;
  bg::read_wkt("POLYGON((0 0,0 4,4 4,4 0,0 0),(1 1,2 1,2 2,1 2,1 1))", polygon);
  const auto from_polygon = to_polygons(polygon);
  REQUIRE(from_polygon.size() == 1);
  CHECK(from_polygon[0].outer == Ring{{0, 0}, {0, 4}, {4, 4}, {4, 0}});
  REQUIRE(from_polygon[0].holes.size() == 1);
  CHECK(from_polygon[0].holes[0] == Ring{{1, 1}, {2, 1}, {2, 2}, {1, 2}});

  bg::model::multi_polygon<BoostPolygon> several;
  bg::read_wkt("MULTIPOLYGON(((0 0,0 1,1 1,0 0)),((5 5,5 6,6 6,5 5)))", several);
  REQUIRE(to_polygons(several).size() == 2);
  CHECK(to_polygons(several)[1].outer.front() == Point(5, 5));

  bg::model::ring<IntPoint, false, false> ring;  // counterclockwise and open, of integers
  bg::read_wkt("POLYGON((0 0,3 0,3 3,0 0))", ring);
  REQUIRE(to_polygons(ring).size() == 1);
  CHECK(to_polygons(ring)[0].outer == Ring{{0, 0}, {3, 0}, {3, 3}});

  const bg::model::box<IntPoint> box(IntPoint(1, 2), IntPoint(3, 5));
  REQUIRE(to_polygons(box).size() == 1);
  CHECK(to_polygons(box)[0].outer == Ring{{1, 2}, {3, 2}, {3, 5}, {1, 5}});
  CHECK(to_polygons(BoostPolygon{})[0].outer.empty());
  CHECK(to_polygons(bg::model::multi_polygon<BoostPolygon>{}).empty());
}

}  // namespace
