// SPDX-License-Identifier: MIT
#include "tutavia/io/wkt.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace tutavia;

std::string wkt_complaint(const std::string& text) {
  const auto read = parse_wkt(text);
  INFO(text);
  REQUIRE_FALSE(read);
  CHECK(read.error().code == PlanError::invalid_input);
  return read.error().detail;
}

std::vector<Obstacle> obstacles(const std::string& text) {
  const auto read = parse_wkt(text);
  INFO(text);
  REQUIRE(read);
  CHECK(read->warnings.empty());
  return read->obstacles;
}

/// The outer ring of the only obstacle.
Ring outer(const std::vector<Obstacle>& obstacles) {
  REQUIRE(obstacles.size() == 1);
  return std::get<Polygon>(obstacles[0]).outer;
}

TEST_CASE("every kind of geometry becomes obstacles") {
  const auto all = obstacles(
      "# two walls\n"
      "POLYGON((0 0,4 0,4 4,0 0),(1 0.5,2 0.5,2 1,1 0.5))\r\n"
      "multipolygon(((5 5,6 5,6 6,5 5)),\n"
      "  ((7 7,8 7,8 8,7 7)))\n\n"
      "LINESTRING(0 0,1 1,2 0) POINT(1 2)\n"
      "MULTIPOINT((1 1),(2 2))\n"
      "MULTILINESTRING((0 0,1 1),(2 2,3 3))");
  REQUIRE(all.size() == 9);
  const auto& polygon = std::get<Polygon>(all[0]);
  CHECK(polygon.outer == Ring{{0, 0}, {4, 0}, {4, 4}, {0, 0}});
  REQUIRE(polygon.holes.size() == 1);
  CHECK(polygon.holes[0][1] == Point(2, 0.5));
  CHECK(std::get<Polygon>(all[2]).outer[1] == Point(8, 7));
  CHECK(std::get<Polygon>(all[3]).outer == Ring{{0, 0}, {1, 1}, {2, 0}, {1, 1}, {0, 0}});
  CHECK(std::get<Disc>(all[4]).center == Point(1, 2));
  CHECK(std::get<Disc>(all[6]).center == Point(2, 2));
  CHECK(obstacles("").empty());
  CHECK(obstacles("# nothing\n\n").empty());
  CHECK(obstacles("# no line end").empty());
}

TEST_CASE("numbers and points are read in every way that the standard writes them") {
  CHECK(outer(obstacles("LINESTRING(1e2 2E+1,-1.5e-3 +5)"))[0] == Point(100, 20));
  CHECK(outer(obstacles("LINESTRING(1e2 2E+1,-1.5e-3 +5)"))[1] == Point(-0.0015, 5));
  CHECK(outer(obstacles("linestring\t( .5 -.5 ,\n5. -0 )"))[0] == Point(0.5, -0.5));
  for (const char* text : {"MULTIPOINT(9 8, 10 11)", "MULTIPOINT ( (9 8) ,(10 11))",
                           "MULTIPOINT(9 8,(10 11))", "MULTIPOINT(EMPTY,9 8,(10 11))"}) {
    const auto points = obstacles(text);
    REQUIRE(points.size() == 2);
    CHECK(std::get<Disc>(points[0]).center == Point(9, 8));
    CHECK(std::get<Disc>(points[1]).center == Point(10, 11));
  }
}

TEST_CASE("a third and a fourth ordinate are dropped, and that is said once") {
  const Ring square{{3, 2}, {8, 2}, {8, 9}, {3, 2}};
  for (const char* text :
       {"POLYGON((3 2 5,8 2 5,8 9 5,3 2 5))", "POLYGON((3 2 0,8 2 0,8 9 0,3 2 0))",
        "POLYGON((3 2 5.2 1,8 2 5.2 1,8 9 5.2 1,3 2 5.2 1))",
        "POLYGON((3 2 0 -1.79769e+308,8 2 0 -1.79769e+308,8 9 1 0,3 2 1 0))"}) {
    const auto read = parse_wkt(text);
    REQUIRE(read);
    CHECK(outer(read->obstacles) == square);
    CHECK(read->warnings ==
          std::vector<std::string>{"line 1, column 10: ordinates beyond x and y are dropped"});
  }
  const auto read = parse_wkt("POINT(1 2)\nLINESTRING(5 2 0,5 8 0)\nPOINT(1 2 3) POINT(1 2 3 4)");
  REQUIRE(read);
  REQUIRE(read->obstacles.size() == 4);
  CHECK(std::get<Polygon>(read->obstacles[1]).outer == Ring{{5, 2}, {5, 8}, {5, 2}});
  CHECK(std::get<Disc>(read->obstacles[3]).center == Point(1, 2));
  CHECK(read->warnings ==
        std::vector<std::string>{"line 2, column 12: ordinates beyond x and y are dropped"});
}

TEST_CASE("what is EMPTY is no obstacle") {
  for (const char* text : {"POINT EMPTY", "polygon empty", "MULTIPOLYGON EMPTY", "LINESTRING EMPTY",
                           "MULTIPOINT(EMPTY, EMPTY)", "MULTILINESTRING(EMPTY)", "POLYGON(EMPTY)",
                           "MULTIPOLYGON(EMPTY,(EMPTY))"}) {
    CHECK(obstacles(text).empty());
  }
  CHECK(outer(obstacles("POLYGON EMPTY\nPOLYGON((3 2, 6 2, 6 7, 3 7, 3 2))")).size() == 5);
  CHECK(outer(obstacles("MULTIPOLYGON(EMPTY,((3 2,6 2,6 7,3 7,3 2)))")).size() == 5);
  CHECK(std::get<Polygon>(obstacles("POLYGON((3 2,6 2,6 7,3 2),EMPTY)")[0]).holes.empty());
  CHECK(std::get<Disc>(obstacles("POINT(7 8)POINT EMPTY")[0]).center == Point(7, 8));
}

struct BadWkt {
  const char* text;
  const char* expected;
};

template <std::size_t N>
void check_bad_wkt(const BadWkt (&cases)[N]) {
  for (const BadWkt& bad : cases) {
    INFO(bad.text);
    const std::string detail = wkt_complaint(bad.text);
    INFO(detail);
    CHECK(detail.find(bad.expected) != std::string::npos);
  }
}

TEST_CASE("anything else is an error that says where, and never an obstacle") {
  const BadWkt cases[] = {
      BadWkt{"LINESTRING(1,4 5)",
             "line 1, column 13: expected the second ordinate of a vertex, found \",4\""},
      BadWkt{"POLYGON((0,0, 4,0, 4,4, 0,0))",
             "line 1, column 11: expected the second ordinate of a vertex, found \",0,\""},
      BadWkt{"LINESTRING(1,5 2,5, 3,5 4,5)", "line 1, column 13: "},
      BadWkt{"Polygon((0 1, 1 2, 3 4 5, 0 1))",
             "line 1, column 20: a vertex of 3 ordinates in a geometry of 2"},
      BadWkt{"POLYGON((0 0 1, 5 0 5, 5 5 1, 0 0 1), (1 1, 2 1, 2 2, 1 1))",
             "line 1, column 40: a vertex of 2 ordinates in a geometry of 3"},
      BadWkt{"MULTIPOINT((1 2),(1 2 3))", "a vertex of 3 ordinates in a geometry of 2"},
      BadWkt{"POINT(1 2 3 4 5)", "line 1, column 15: expected ')', found \"5)\""},
      BadWkt{"POINT(0 0)\nPOLYGON((0 0,1 x))", "line 2, column 16: expected the second"},
      BadWkt{"\n\nCIRCLE(0 0 1)", "line 3, column 1: unknown geometry \"CIRCLE\""},
      BadWkt{"POINT(1 1)\nPOLYGON((0 0,\n1 1",
             "line 3, column 4: expected ',' or ')', found the end of the text (the geometry "
             "begins at line 2)"},
      BadWkt{"POLYGON((0 0, 4 0, 4 4, 0 0)\nPOLYGON((10 0, 14 0, 14 4, 10 0))",
             "line 2, column 1: expected ',' or ')', found \"POLYGON((10\""},
      BadWkt{")", "line 1, column 1: expected a geometry, found \")\""},
      BadWkt{"POLYGON((0 0, 4 0, 4 4, 0 0)) x", "line 1, column 31: unknown geometry \"x\""},
      BadWkt{"POLYGON((0 0, 4 0, 4 4, 0 0)))", "line 1, column 30: expected a geometry"},
      BadWkt{"POINT", "line 1, column 6: expected '(' or EMPTY, found the end of the text"},
      BadWkt{"POINT()", "line 1, column 7: expected a number, found \")\""},
      BadWkt{"POINT(EMPTY)", "line 1, column 7: expected a number"},
      BadWkt{"POINT EMPTYPOINT(1 2)", "line 1, column 7: expected '(' or EMPTY"},
      BadWkt{"POINT(1 2, 3 4)", "line 1, column 10: expected ')'"},
      BadWkt{"MULTIPOINT((1 2, 3 4))", "line 1, column 16: expected ')'"},
      BadWkt{"POINT(1)", "line 1, column 8: expected the second ordinate"},
      BadWkt{"POINT(nan nan)", "line 1, column 7: expected a number"},
      BadWkt{"POINT(1 inf)", "line 1, column 9: expected the second ordinate"},
      BadWkt{"POINT(1 -infinity)", "line 1, column 9: expected the second ordinate"},
      BadWkt{"POINT(1 0x10)", "line 1, column 9: expected the second ordinate"},
      BadWkt{"POINT(1 2d0)", "line 1, column 9: expected the second ordinate"},
      BadWkt{"POINT(1 +-2)", "line 1, column 9: expected the second ordinate"},
      BadWkt{"POINT(1 1e999)", "line 1, column 9: a number beyond the range of double"},
      BadWkt{"POINT(1.2.3)", "line 1, column 7: expected a number"},
      BadWkt{"POLYGON(0 0,4 0,4 4,0 0)", "line 1, column 9: expected '(' or EMPTY"},
      BadWkt{"POLYGON(((0 0,4 0,4 4,0 0)))", "line 1, column 10: expected a number"},
      BadWkt{"POLYGON((0 0,4 0,,4 4))", "line 1, column 18: expected a number"},
      BadWkt{"POLYGON(EMPTY,(0 0,4 0,4 4,0 0))", "a hole in a polygon without an outer ring"},
      BadWkt{"POLYGON((0 0,4 0 # corner\n,4 4))", "line 1, column 18: expected ',' or ')'"},
  };
  check_bad_wkt(cases);
  using namespace std::string_literals;
  CHECK(wkt_complaint("POINT(1 2\0)"s) ==
        "line 1, column 9: expected the second ordinate of a vertex, found \"2\" and byte 0x00");
  CHECK(wkt_complaint("\0"s) == "line 1, column 1: expected a geometry, found byte 0x00");
}

TEST_CASE("errors in tags, SRIDs, separators and quotes say where") {
  const BadWkt cases[] = {
      BadWkt{"TRIANGLE((0 0,4 0,4 4,0 4,0 0))", "line 1, column 10: a TRIANGLE of 4 corners"},
      BadWkt{"TRIANGLE((0 0,4 0,4 4,0 0),(1 1,2 1,2 2,1 1))", "line 1, column 27: expected ')'"},
      BadWkt{"POINT Z (1 2)", "a vertex of 2 ordinates in a geometry of 3"},
      BadWkt{"POINT ZM (1 2 3)", "a vertex of 3 ordinates in a geometry of 4"},
      BadWkt{"POINTM(1 2 3 4)", "a vertex of 4 ordinates in a geometry of 3"},
      BadWkt{"POINT Z M (1 2 3 4)", "line 1, column 9: expected '(' or EMPTY, found \"M\""},
      BadWkt{"POINT(1 2),", "line 1, column 12: expected a geometry after ',', found the end"},
      BadWkt{"POINT(1 2),,POINT(1 2)", "line 1, column 12: expected a geometry, found"},
      BadWkt{";POINT(1 2)", "line 1, column 1: expected a geometry, found \";POINT(1\""},
      BadWkt{"SRID=;POINT(1 2)", "line 1, column 6: expected a whole number after SRID="},
      BadWkt{"SRID=1.5;POINT(1 2)", "line 1, column 7: expected ';' after the SRID"},
      BadWkt{"SRID=4326", "line 1, column 10: expected ';' after the SRID, found the end of"},
      BadWkt{"\"POINT(1 2)", "line 1, column 12: expected '\"' at the end of the geometry"},
      BadWkt{"POINT(1 1e-999)", "line 1, column 9: a number beyond the range of double"},
      BadWkt{"POINT(1\xC2\xA0 2)",
             "line 1, column 7: expected a number, found \"1\" and byte 0xC2"},
      BadWkt{"\x80", "line 1, column 1: expected a geometry, found byte 0x80"},
  };
  check_bad_wkt(cases);
}

TEST_CASE("collections are read to a depth of 16, and hand their tag to their members") {
  std::string nested = "POINT(1 2)";
  for (int i = 0; i < 16; ++i) nested = "GEOMETRYCOLLECTION(" + nested + ")";
  CHECK(obstacles(nested).size() == 1);
  CHECK(wkt_complaint("GEOMETRYCOLLECTION(" + nested + ")")
            .find("column 305: collections are nested more than 16 deep") != std::string::npos);
  CHECK(parse_wkt("GEOMETRYCOLLECTION Z (POINT(1 2 3),POINTZ(4 5 6),POINT EMPTY)"));
  CHECK(parse_wkt("GEOMETRYCOLLECTION(POINT(1 2),POINT(1 2 3))"));
  CHECK(wkt_complaint("GEOMETRYCOLLECTION Z (POINT(1 2))").find("a vertex of 2 ordinates") !=
        std::string::npos);
  CHECK(wkt_complaint("GEOMETRYCOLLECTION ZM (POINT Z (1 2 3))") ==
        "line 1, column 24: a geometry of 3 ordinates in a collection of 4");
  CHECK(wkt_complaint("GEOMETRYCOLLECTION(SRID=1;POINT(1 2))").find("unknown geometry") !=
        std::string::npos);
}

TEST_CASE("a column of CSV is read, and errors in it are placed in the file") {
  const auto column = [](const std::string& text) {
    return parse_wkt(text, {.csv_column = "wkt"});
  };
  const auto read = column(
      "\xEF\xBB\xBFid,wkt,name\r\n1,\"LINESTRING(0 0,\n1 1)\",a\r\n\r\n2,,\"b, \"\"c\"\"\"\r\n"
      "3,\"SRID=5;POINT(7 8);\",\n4, POINT(9 9) ,d");
  REQUIRE(read);
  REQUIRE(read->obstacles.size() == 3);
  CHECK(std::get<Disc>(read->obstacles[1]).center == Point(7, 8));
  CHECK(std::get<Disc>(read->obstacles[2]).center == Point(9, 9));
  CHECK(read->warnings ==
        std::vector<std::string>{
            "line 6, column 4: SRID=5 is ignored; coordinates are taken as metres"});
  CHECK(column("\"wkt\";\"id\"\nPOLYGON((0 0,1 0,1 1,0 0));1")->obstacles.size() == 1);
  CHECK(column("id\twkt\n1\tLINESTRING(0 0,1 1)")->obstacles.size() == 1);
  CHECK(column("wkt\n")->obstacles.empty());
  const auto refused = [&](const std::string& text) {
    const auto result = column(text);
    REQUIRE_FALSE(result);
    return result.error().detail;
  };
  CHECK(refused("id,wkt\n1,\"POINT(1 2)\"\n2,\"POINT(1\"\n") ==
        "line 3, column 11: expected the second ordinate of a vertex, found the end of the cell");
  CHECK(refused("id,WKT\n") ==
        "line 1, column 1: expected a header with a column \"wkt\", found \"id,WKT\"");
  CHECK(refused("") ==
        "line 1, column 1: expected a header with a column \"wkt\", found the end of the text");
  CHECK(refused("wkt,wkt\n") == "line 1, column 5: a second column \"wkt\"");
  CHECK(refused("id,wkt\n1,POINT(1 2),x\n") ==
        "line 2, column 1: expected 2 cells as in the header, found 3");
  CHECK(refused("id,wkt\n1,LINESTRING(0 0,1 1)\n") ==
        "line 2, column 1: expected 2 cells as in the header, found 3");
  CHECK(refused("id,wkt\n1,\"POINT(1 2)\n") == "line 2, column 3: a quote that is not closed");
  CHECK(refused("id,wkt\n1,\"POINT(1 2)\"x\n") ==
        "line 2, column 15: expected a separator after a quoted cell, found \"x\"");
  CHECK(refused("wkt\n# no comment\n") == "line 2, column 1: expected a geometry, found \"#\"");
}

}  // namespace
