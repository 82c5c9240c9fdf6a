// SPDX-License-Identifier: MIT
#include "tutavia/io/wkt.hpp"

#include "support/catch.hpp"

namespace {

using namespace tutavia;

std::string complaint(const std::string& text) {
  const auto obstacles = parse_wkt(text);
  REQUIRE_FALSE(obstacles);
  CHECK(obstacles.error().code == PlanError::invalid_input);
  return obstacles.error().detail;
}

TEST_CASE("every kind of geometry becomes obstacles") {
  const auto obstacles = parse_wkt(
      "# two walls\n"
      "POLYGON((0 0,4 0,4 4,0 0),(1 0.5,2 0.5,2 1,1 0.5))\r\n"
      "multipolygon(((5 5,6 5,6 6,5 5)),\n"
      "  ((7 7,8 7,8 8,7 7)))\n\n"
      "LINESTRING(0 0,1 1,2 0) POINT(1 2)\n"
      "MULTIPOINT((1 1),(2 2))\n"
      "MULTILINESTRING((0 0,1 1),(2 2,3 3))");
  REQUIRE(obstacles);
  REQUIRE(obstacles->size() == 9);
  const auto& polygon = std::get<Polygon>((*obstacles)[0]);
  CHECK(polygon.outer == Ring{{0, 0}, {4, 0}, {4, 4}, {0, 0}});
  REQUIRE(polygon.holes.size() == 1);
  CHECK(polygon.holes[0][1] == Point(2, 0.5));
  CHECK(std::get<Polygon>((*obstacles)[2]).outer[1] == Point(8, 7));
  CHECK(std::get<Polygon>((*obstacles)[3]).outer == Ring{{0, 0}, {1, 1}, {2, 0}, {1, 1}, {0, 0}});
  CHECK(std::get<Disc>((*obstacles)[4]).center == Point(1, 2));
  CHECK(std::get<Disc>((*obstacles)[6]).center == Point(2, 2));
  CHECK(parse_wkt("")->empty());
  CHECK(parse_wkt("# nothing\n\n")->empty());
}

TEST_CASE("malformed WKT is reported with the line at which the geometry begins") {
  CHECK(complaint("POINT(0 0)\nPOLYGON((0 0,1 x))").find("line 2: ") == 0);
  CHECK(complaint("\n\nCIRCLE(0 0 1)").find("line 3: unknown geometry \"CIRCLE\"") == 0);
  CHECK(complaint("POINT(1 1)\nPOLYGON((0 0,\n1 1").find("line 2: ") == 0);
  CHECK(complaint(")").find("line 1: ") == 0);
  CHECK(complaint("POINT(1 2 3)").find("line 1: ") == 0);
}

}  // namespace
