// SPDX-License-Identifier: MIT
/// \file
/// Files and texts as people have them, and exactly what the readers of WKT and MovingAI make of
/// them.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "support/catch.hpp"
#include "support/input_table.hpp"
#include "support/obstacle_text.hpp"
#include "support/reference_csv.hpp"
#include "support/reference_moving_ai.hpp"
#include "support/reference_wkt.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/io/wkt.hpp"

namespace {

using namespace tutavia;
using namespace std::string_view_literals;
using test::InputRow;

constexpr InputRow wkt_files[] = {
    {"08-wkt-mixed/hole.wkt",
     "error: line 1, column 15: a vertex of 3 ordinates in a geometry of 2\n"},
    {"08-wkt-mixed/multi_z0.wkt",
     "polygon (3 2,8 2,8 9,3 9,3 2)\n"
     "! line 1, column 16: ordinates beyond x and y are dropped\n"},
    {"08-wkt-mixed/one.wkt",
     "error: line 1, column 20: a vertex of 3 ordinates in a geometry of 2\n"},
    {"08-wkt-mixed/polygonz.wkt",
     "polygon (3 2,6 2,6 7,3 7,3 2)\n"
     "! line 1, column 13: ordinates beyond x and y are dropped\n"},
    {"08-wkt-mixed/wall_z.wkt",
     "polygon (5 2,5 8,5 2)\n"
     "! line 1, column 12: ordinates beyond x and y are dropped\n"},
    {"08-wkt-mixed/z0.wkt",
     "polygon (3 2,8 2,8 9,3 9,3 2)\n"
     "! line 1, column 10: ordinates beyond x and y are dropped\n"},
    {"08-wkt-mixed/z5.wkt",
     "polygon (3 2,8 2,8 9,3 9,3 2)\n"
     "! line 1, column 10: ordinates beyond x and y are dropped\n"},
    {"09-wkt-empty/empty.wkt", "polygon (3 2,6 2,6 7,3 7,3 2)\n"},
    {"09-wkt-empty/empty1.wkt", ""},
    {"09-wkt-empty/qgis.wkt", "polygon (3 2,6 2,6 7,3 7,3 2)\n"},
    {"09-wkt-empty/std.wkt", "polygon (3 2,6 2,6 7,3 7,3 2)\n"},
    {"10-wkt-collection/poly.wkt",
     "polygon (3 2,6 2,6 7,3 7,3 2)\n"
     "polygon (3 9,6 9,3 9)\n"},
    {"10-wkt-collection/shapely.wkt", "disc 1 2 r 0\n"},
    {"11-ewkt/nosrid.wkt",
     "1 obstacles of 26 points in (417567.15219999 4845371.80649999,417820.587299988 "
     "4845383.75009999)\n"},
    {"11-ewkt/one.wkt",
     "polygon (574009 6028393,574019 6028393,574019 6028403,574009 6028403,574009 6028393)\n"
     "! line 1, column 1: SRID=25832 is ignored; coordinates are taken as metres\n"},
    {"12-wkt-zm/bom.wkt", "polygon (0 0,4 0,4 4,0 0)\n"},
    {"12-wkt-zm/comma.wkt",
     "error: line 1, column 11: expected the second ordinate of a vertex, found \",0,\"\n"},
    {"12-wkt-zm/exp.wkt", "polygon (100 20,-0.0015 5,100 20)\n"},
    {"12-wkt-zm/exp3.wkt",
     "polygon (1 2,4 5,1 2)\n"
     "! line 1, column 12: ordinates beyond x and y are dropped\n"},
    {"12-wkt-zm/junk.wkt", "error: line 1, column 31: unknown geometry \"x\"\n"},
    {"12-wkt-zm/line.wkt",
     "polygon (639766.97 3274404.094,639758.48 3274442.959,639766.97 3274404.094)\n"
     "! line 1, column 18: ordinates beyond x and y are dropped\n"},
    {"12-wkt-zm/m.wkt",
     "disc 1 2 r 0\n"
     "! line 1, column 10: ordinates beyond x and y are dropped\n"},
    {"12-wkt-zm/missing.wkt",
     "error: line 2, column 1: expected ',' or ')', found \"POLYGON((10\" (the geometry begins at "
     "line 1)\n"},
    {"12-wkt-zm/multi.wkt",
     "polygon (-80.214554 25.769598,-80.2147 25.774514,-80.212983 25.77456,-80.212977 "
     "25.773597,-80.214554 25.769598)\n"
     "! line 1, column 16: ordinates beyond x and y are dropped\n"
     "! the coordinates look like degrees of longitude and latitude; planning is in metres: "
     "project them first\n"},
    {"12-wkt-zm/nan.wkt", "error: line 1, column 7: expected a number, found \"nan\"\n"},
    {"12-wkt-zm/neg.wkt",
     "polygon (1 2,4 5,1 2)\n"
     "! line 1, column 12: ordinates beyond x and y are dropped\n"},
    {"12-wkt-zm/one_number.wkt",
     "error: line 1, column 13: expected the second ordinate of a vertex, found \",4\"\n"},
    {"12-wkt-zm/quoted.wkt", "polygon (0 0,4 0,4 4,0 0)\n"},
    {"12-wkt-zm/semicolon.wkt",
     "polygon (0 0,4 0,4 4,0 0)\n"
     "polygon (10 0,14 0,14 4,10 0)\n"},
    {"12-wkt-zm/three.wkt",
     "polygon (639766.97 3274404.094,639758.48 3274442.959,639766.97 3274404.094)\n"
     "! line 1, column 18: ordinates beyond x and y are dropped\n"},
    {"33-touch/merged.wkt",
     "polygon (0 0,4 0,4 4,0 4,0 0)\n"
     "polygon (4 0,8 0,8 4,4 4,4 0)\n"},
    {"34-bom-crlf/bom.wkt", "polygon (3 2,8 2,8 9,3 9,3 2)\n"},
    {"34-bom-crlf/comma.wkt",
     "polygon (3 2,8 2,8 9,3 9,3 2)\n"
     "polygon (3 10,8 10,8 11,3 11,3 10)\n"},
    {"34-bom-crlf/crlf.wkt",
     "polygon (3 2,8 2,8 9,3 9,3 2)\n"
     "disc 9 9 r 0\n"},
    {"34-bom-crlf/curve.wkt", "error: line 1, column 1: unknown geometry \"CURVEPOLYGON\"\n"},
    {"34-bom-crlf/cut.wkt",
     "error: line 1, column 34: expected ',' or ')', found the end of the text\n"},
    {"34-bom-crlf/empty.wkt", ""},
    {"34-bom-crlf/le.wkt", ""},
    {"34-bom-crlf/lower.wkt", "polygon (3 2,8 2,8 9,3 9,3 2)\n"},
    {"34-bom-crlf/mp1.wkt",
     "disc 9 9 r 0\n"
     "disc 10 10 r 0\n"},
    {"34-bom-crlf/mp2.wkt",
     "disc 9 9 r 0\n"
     "disc 10 10 r 0\n"},
    {"34-bom-crlf/mpe.wkt", ""},
    {"34-bom-crlf/pe.wkt", ""},
    {"34-bom-crlf/pe2.wkt", "polygon (3 2,8 2,8 9,3 9,3 2)\n"},
    {"34-bom-crlf/pe3.wkt", "disc 1000 2000 r 0\n"},
    {"34-bom-crlf/pe4.wkt",
     "polygon (0 0,1 0,1 1,0 0)\n"
     "polygon (2 2,3 2,3 3,2 2)\n"
     "disc 1 1 r 0\n"},
    {"34-bom-crlf/ring.wkt", "polygon (3 2,8 2,8 9,3 2,8 9,8 2,3 2)\n"},
    {"34-bom-crlf/semicolon.wkt", "polygon (3 2,8 2,8 9,3 9,3 2)\n"},
    {"34-bom-crlf/tri.wkt", "polygon (3 2,8 2,8 9,3 2)\n"},
    {"34-bom-crlf/unclosed.wkt",
     "polygon (3 2,8 2,8 9,3 9)\n"
     "! line 1, column 9: a ring that does not end where it begins is closed\n"},
    {"34-bom-crlf/upper.WKT", "polygon (3 2,8 2,8 9,3 9,3 2)\n"},
};

// The second half is broken.
constexpr InputRow wkt_texts[] = {
    {"POINT Z (1 2 3)\n"
     "POINT M (4 5 6)\n"
     "POINT ZM (7 8 9 10)",
     "disc 1 2 r 0\n"
     "disc 4 5 r 0\n"
     "disc 7 8 r 0\n"
     "! line 1, column 10: ordinates beyond x and y are dropped\n"},
    {"POINTZ(1 2 3) LINESTRINGM(0 0 1,1 1 2) POLYGONZM((0 0 1 1,4 0 1 1,4 4 1 1,0 0 1 1))",
     "disc 1 2 r 0\n"
     "polygon (0 0,1 1,0 0)\n"
     "polygon (0 0,4 0,4 4,0 0)\n"
     "! line 1, column 8: ordinates beyond x and y are dropped\n"},
    {"point z empty;Polygon ZM Empty;MULTIPOINT M EMPTY;TRIANGLE EMPTY;LINEARRING EMPTY", ""},
    {"MULTIPOLYGON Z (((0 0 1,4 0 1,4 4 1,0 0 1),(1 .5 1,2 .5 1,2 1 1,1 .5 1)),EMPTY)",
     "polygon (0 0,4 0,4 4,0 0) hole (1 0.5,2 0.5,2 1,1 0.5)\n"
     "! line 1, column 19: ordinates beyond x and y are dropped\n"},
    {"GEOMETRYCOLLECTION(GEOMETRYCOLLECTION(POINT(1 2)),LINESTRING EMPTY,GEOMETRYCOLLECTION())",
     "disc 1 2 r 0\n"},
    {"SRID=4326;POINT(1 2)\n"
     "srid=4326;POINT(3 4)\n"
     "SRID=-1; POINT(5 6)",
     "disc 1 2 r 0\n"
     "disc 3 4 r 0\n"
     "disc 5 6 r 0\n"
     "! line 1, column 1: SRID=4326 is ignored; coordinates are taken as metres\n"
     "! line 3, column 1: SRID=-1 is ignored; coordinates are taken as metres\n"},
    {"POINT(1 2)\n"
     "# between\n"
     ";POINT(3 4),\n"
     "# after\n"
     "POINT(5 6);",
     "disc 1 2 r 0\n"
     "disc 3 4 r 0\n"
     "disc 5 6 r 0\n"},
    {"\"SRID=5;POINT(1 2)\",\"POINT(3 4)\"\n"
     "\" POINT EMPTY \"",
     "disc 1 2 r 0\n"
     "disc 3 4 r 0\n"
     "! line 1, column 2: SRID=5 is ignored; coordinates are taken as metres\n"},
    {"LINEARRING(0 0,4 0,4 4)",
     "polygon (0 0,4 0,4 4,0 0,4 4,4 0,0 0)\n"
     "! line 1, column 11: a ring that does not end where it begins is closed\n"},
    {"TRIANGLE((0 0,4 0,4 4))\n"
     "TRIANGLE Z ((0 0 1,4 0 1,4 4 1,0 0 1))",
     "polygon (0 0,4 0,4 4)\n"
     "polygon (0 0,4 0,4 4,0 0)\n"
     "! line 1, column 10: a ring that does not end where it begins is closed\n"
     "! line 2, column 14: ordinates beyond x and y are dropped\n"},
    {"MULTILINESTRING((0 0,1 1),EMPTY,(),(2 2,3 3))",
     "polygon (0 0,1 1,0 0)\n"
     "polygon (2 2,3 3,2 2)\n"},
    {"\357\273\277\r\n"
     "# after the mark\r\n"
     "POINT(1 2)\r\n",
     "disc 1 2 r 0\n"},
    {"POLYGON((8.54 47.37,8.5412 47.37,8.5412 47.3711,8.54 47.37))",
     "polygon (8.54 47.37,8.5412 47.37,8.5412 47.3711,8.54 47.37)\n"
     "! the coordinates look like degrees of longitude and latitude; planning is in metres: "
     "project them first\n"},
    {"POLYGON((30 20,30.5 20,30.5 20.5,30 20))", "polygon (30 20,30.5 20,30.5 20.5,30 20)\n"},
    {"POLYGON((0.1234567 0.2,5.1 0.3,4 4,0.1234567 0.2))",
     "polygon (0.1234567 0.2,5.1 0.3,4 4,0.1234567 0.2)\n"},
    {"POINT(8.5417 47.3769)", "disc 8.5417 47.3769 r 0\n"},
    {"LINESTRING(0.1 1e-3,123456789.12345679 -0.30000000000000004)",
     "polygon (0.1 0.001,123456789.12345679 -0.30000000000000004,0.1 0.001)\n"},
    {"MULTIPOINT Z (1 2 3,(4 5 6))\n"
     "POINT(00012 -0)",
     "disc 1 2 r 0\n"
     "disc 4 5 r 0\n"
     "disc 12 -0 r 0\n"
     "! line 1, column 15: ordinates beyond x and y are dropped\n"},
    {"POLYGON((0 0,4 0,4 4,0 0),(),EMPTY)", "polygon (0 0,4 0,4 4,0 0)\n"},
    {"GEOMETRYCOLLECTION Z (POINT(1 2 3),POINT Z (4 5 6),POINT EMPTY)",
     "disc 1 2 r 0\n"
     "disc 4 5 r 0\n"
     "! line 1, column 29: ordinates beyond x and y are dropped\n"},
    {"POINT(1 2", "error: line 1, column 10: expected ')', found the end of the text\n"},
    {"POINT(1",
     "error: line 1, column 8: expected the second ordinate of a vertex, found the end of the "
     "text\n"},
    {"POLYGON((0 0,4 0,4 4,",
     "error: line 1, column 22: expected a number, found the end of the text\n"},
    {"MULTIPOLYGON(((0 0,4 0,4 4,0 0))",
     "error: line 1, column 33: expected ',' or ')', found the end of the text\n"},
    {"GEOMETRYCOLLECTION(POINT(1 2)",
     "error: line 1, column 30: expected ',' or ')', found the end of the text\n"},
    {"POINT(1 2),",
     "error: line 1, column 12: expected a geometry after ',', found the end of the text\n"},
    {"LINES", "error: line 1, column 1: unknown geometry \"LINES\"\n"},
    {"LINESTRING(0 0;1 1)",
     "error: line 1, column 14: expected the second ordinate of a vertex, found \"0;1\"\n"},
    {"LINESTRING(1,5 2,5;3,5 4,5)",
     "error: line 1, column 13: expected the second ordinate of a vertex, found \",5\"\n"},
    {"POINT(1e 2)", "error: line 1, column 7: expected a number, found \"1e\"\n"},
    {"POINT(1e+ 2)", "error: line 1, column 7: expected a number, found \"1e+\"\n"},
    {"POINT(1e5.5 2)", "error: line 1, column 7: expected a number, found \"1e5.5\"\n"},
    {"POINT(1e400 0)", "error: line 1, column 7: a number beyond the range of double\n"},
    {"POINT(0 -1e-400)", "error: line 1, column 9: a number beyond the range of double\n"},
    {"POINT Z (1 2 1e999)", "error: line 1, column 14: a number beyond the range of double\n"},
    {"POINT Z (1 2 NaN)", "error: line 1, column 14: expected a number, found \"NaN)\"\n"},
    {"POINT(Infinity 0)", "error: line 1, column 7: expected a number, found \"Infinity\"\n"},
    {"POINT(1\000 2)"sv, "error: line 1, column 7: expected a number, found \"1\" and byte 0x00\n"},
    {"POINT(\302\265 2)", "error: line 1, column 7: expected a number, found byte 0xC2\n"},
    {"POINT(1 2\302\260)",
     "error: line 1, column 9: expected the second ordinate of a vertex, found \"2\" and byte "
     "0xC2\n"},
    {"POINT(1 2)\n"
     "\357\273\277POINT(3 4)",
     "error: line 2, column 1: expected a geometry, found byte 0xEF\n"},
    {"\377\376P\000O\000"sv, "error: line 1, column 1: expected a geometry, found byte 0xFF\n"},
    {"SRID=x;POINT(1 2)",
     "error: line 1, column 6: expected a whole number after SRID=, found \"x;POINT(1\"\n"},
    {"SRID =4326;POINT(1 2)", "error: line 1, column 5: expected '=' after SRID, found \" \"\n"},
    {"SRID=99999999999;POINT(1 2)",
     "error: line 1, column 6: expected a whole number after SRID=, found "
     "\"99999999999;POINT(1\"\n"},
    {"\"POINT(1 2)\n"
     "POINT(3 4)",
     "error: line 2, column 1: expected '\"' at the end of the geometry, found \"POINT(3\" (the "
     "geometry begins at line 1)\n"},
    {"# walls\rPOLYGON((3 0,4 0,4 12,3 12,3 0))\r",
     "error: line 1, column 8: a line end without a line feed; lines end with LF or with CR LF\n"},
    {"POINT(1 2) # comment", "error: line 1, column 12: expected a geometry, found \"#\"\n"},
    {"POINT(1 2);\n"
     ";POINT(3 4)",
     "error: line 2, column 1: expected a geometry, found \";POINT(3\"\n"},
    {"{\"type\":\"Point\",\"coordinates\":[1,2]}",
     "error: line 1, column 1: expected a geometry, found \"{\"type\":\"Point\",\"coo\"\n"},
    {"<gml:Point/>", "error: line 1, column 1: expected a geometry, found \"<gml:Point/>\"\n"},
    {"0101000000000000000000F03F",
     "error: line 1, column 1: expected a geometry, found \"01010000000000000000\"\n"},
    {"POLYHEDRALSURFACE(((0 0,1 0,1 1,0 0)))",
     "error: line 1, column 1: unknown geometry \"POLYHEDRALSURFACE\"\n"},
    {"BOX(0 0,1 1)", "error: line 1, column 1: unknown geometry \"BOX\"\n"},
    {"MULTIPOINT(1 2 3,4 5)",
     "error: line 1, column 18: a vertex of 2 ordinates in a geometry of 3\n"},
    {"POLYGON((0 0,4 0,4 4,0 0),(1 1 1,2 1 1,2 2 1,1 1 1))",
     "error: line 1, column 28: a vertex of 3 ordinates in a geometry of 2\n"},
    {"GEOMETRYCOLLECTION M (POINT ZM (1 2 3 4))",
     "error: line 1, column 23: a geometry of 4 ordinates in a collection of 3\n"},
    {"TRIANGLE((0 0,4 0,4 4,0 4))", "error: line 1, column 10: a TRIANGLE of 4 corners\n"},
    {"POLYGON(EMPTY,EMPTY)",
     "error: line 1, column 15: a hole in a polygon without an outer ring\n"},
    {"GEOMETRYCOLLECTION(EMPTY)", "error: line 1, column 20: unknown geometry \"EMPTY\"\n"},
    {"POINT(1 2)\n"
     "\n"
     "\n"
     "POLYGON((0 0,\n"
     "4 0,\n"
     "4 x",
     "error: line 6, column 3: expected the second ordinate of a vertex, found \"x\" (the geometry "
     "begins at line 4)\n"},
};

constexpr InputRow csv_texts[] = {
    {"id,wkt\n"
     "1,\"POLYGON((0 0,4 0,4 4,0 0))\"\n"
     "2,POINT(1 2)\n",
     "polygon (0 0,4 0,4 4,0 0)\n"
     "disc 1 2 r 0\n"},
    {"\357\273\277wkt;name\r\n"
     "\"LINESTRING Z (0 0 1,1 1 1)\";\"a;\"\"b\"\"\"\r\n"
     ";empty\r\n",
     "polygon (0 0,1 1,0 0)\n"
     "! line 2, column 16: ordinates beyond x and y are dropped\n"},
    {"id,geom\n"
     "1,POINT(1 2)\n",
     "error: line 1, column 1: expected a header with a column \"wkt\", found \"id,geom\"\n"},
    {"id,wkt\n"
     "1,LINESTRING(0 0,1 1)\n",
     "error: line 2, column 1: expected 2 cells as in the header, found 3\n"},
    {"id,wkt\n"
     "1,\"POINT(1 2)\n",
     "error: line 2, column 3: a quote that is not closed\n"},
    {"id,wkt\n"
     "1,\"POINT(1 x)\"\n",
     "error: line 2, column 12: expected the second ordinate of a vertex, found \"x)\"\n"},
    {"wkt,wkt\n", "error: line 1, column 5: a second column \"wkt\"\n"},
    {"id;wkt;x\r1;POLYGON((3 0,4 0,4 12,3 12,3 0));2\r",
     "error: line 1, column 1: expected a header with a column \"wkt\", found \"id;wkt;x\"\n"},
    {"id,wkt\n1,POINT(1 2)\r2,POINT(3 4)\n",
     "error: line 2, column 13: a line end without a line feed; lines end with LF or with CR LF\n"},
};

constexpr InputRow map_files[] = {
    {"13-jps-gap/column.map",
     ".@@@@\n"
     ".@@@@\n"
     ".@@@@\n"
     "@@@@@\n"
     ".@@@@\n"},
    {"13-jps-gap/diag.map",
     ".@@@@\n"
     "@.@@@\n"
     "@@.@@\n"
     "@@@@@\n"
     "@@@@.\n"},
    {"13-jps-gap/row.map",
     "...@.\n"
     "@@@@@\n"
     "@@@@@\n"
     "@@@@@\n"
     "@@@@@\n"},
    {"14-towers/map.map",
     ".............\n"
     ".............\n"
     "....@........\n"
     "....@........\n"
     "....@........\n"
     "....@........\n"
     "....@@@@@@@@.\n"
     ".............\n"
     "@@@@@@@@@@@@.\n"
     ".............\n"
     ".@@@@@@@@@@@@\n"
     ".............\n"
     ".............\n"},
    {"15-open/open.map", "12000 free cells of 100 x 120\n"},
    {"16-pf170/g.map",
     "......\n"
     "@@@@@.\n"
     ".@....\n"
     "@@....\n"
     "......\n"
     "......\n"},
    {"30-movingai/E.map",
     "error: line 5: expected one of . G @ O T in row 0, column 3, found \"E\"\n"},
    {"30-movingai/S.map",
     "error: line 5: expected one of . G @ O T in row 0, column 2, found \"S\", which only some "
     "neighbours may enter: MovingAiOptions::directional says how to read it\n"},
    {"30-movingai/blank.map", "error: line 5: expected 4 cells in row 0, found 0\n"},
    {"30-movingai/bom.map",
     "....\n"
     ".@@.\n"
     "....\n"},
    {"30-movingai/crlf.map",
     "....\n"
     ".@@.\n"
     "....\n"},
    {"30-movingai/empty.map",
     "error: line 1: expected type, width and height before map, found the end of the file\n"},
    {"30-movingai/hash.map",
     "error: line 6: expected one of . G @ O T in row 1, column 1, found \"#\"\n"},
    {"30-movingai/huge.map",
     "error: limit_exceeded: grid of 200000 x 200000 cells needed, 1073741824 cells and 2^32 - 64 "
     "bits of padded rows allowed\n"},
    {"30-movingai/more.map",
     "error: line 8: expected nothing after the last row, found \"....\"\n"},
    {"30-movingai/noeol.map",
     "....\n"
     ".@@.\n"
     "....\n"},
    {"30-movingai/norows.map", "error: line 5: expected row 0 of 3, found the end of the file\n"},
    {"30-movingai/notype.map",
     "error: line 3: expected type, width and height before map, found \"map\"\n"},
    {"30-movingai/ok.map",
     "....\n"
     ".@@.\n"
     "....\n"},
    {"30-movingai/quad.map", "error: line 1: expected type octile or tile, found \"type quad\"\n"},
    {"30-movingai/space.map",
     "error: line 5: expected one of . G @ O T in row 0, column 2, found \" \"\n"},
    {"30-movingai/swapped.map", "error: line 5: expected 3 cells in row 0, found 4\n"},
    {"30-movingai/tile.map",
     "....\n"
     ".@@.\n"
     "....\n"},
    {"30-movingai/trail.map", "error: line 5: expected 4 cells in row 0, found 3\n"},
    {"30-movingai/trail2.map",
     "....\n"
     ".@@.\n"
     "....\n"},
    {"30-movingai/x.map",
     "error: line 5: expected one of . G @ O T in row 0, column 1, found \"x\"\n"},
    {"30-movingai/zero.map",
     "error: line 2: expected height from 1 to 2^63 - 1, found \"height 0\"\n"},
    {"31-link/corridor.map",
     "@@@@@@@@@@@@\n"
     "@@@@@@@@@@@@\n"
     "............\n"
     "............\n"
     "@@@@@@@@@@@@\n"
     "@@@@@@@@@@@@\n"},
    {"33-touch/cells.map",
     "............\n"
     "............\n"
     "..@@@@@@@@..\n"
     "..@@@@@@@@..\n"
     "..@@@@@@@@..\n"
     "..@@@@@@@@..\n"
     "............\n"
     "............\n"},
};

constexpr InputRow map_texts[] = {
    {"Type Octile\n"
     "HEIGHT 2\n"
     "Width 3\n"
     "Map\n"
     ".G@\n"
     "OT.\n",
     "..@\n"
     "@@.\n"},
    {"\357\273\277width 3\r\n"
     "height 1 \r\n"
     "\r\n"
     "type TILE\t\r\n"
     "map \r\n"
     ".@. \r\n"
     "\r\n",
     ".@.\n"},
    {"type octile\n"
     "height 1\n"
     "width 1\n"
     "map\n"
     "T",
     "@\n"},
    {"type octile\n"
     "height 1\n"
     "width 2\n"
     "map\n"
     ".\000\n"sv,
     "error: line 5: expected one of . G @ O T in row 0, column 1, found byte 0x00\n"},
    {"type octile\n"
     "height 1\n"
     "width 2\n"
     "map\n"
     "\303.\n",
     "error: line 5: expected one of . G @ O T in row 0, column 0, found byte 0xC3\n"},
    {"type octile\n"
     "height -1\n",
     "error: line 2: expected height from 1 to 2^63 - 1, found \"height -1\"\n"},
    {"type octile\n"
     "height 1\n"
     "width 1e1\n"
     "map\n"
     "..\n",
     "error: line 3: expected width from 1 to 2^63 - 1, found \"width 1e1\"\n"},
    {"type octile\n"
     "height 2\n"
     "width 2\n"
     "map\n"
     "..",
     "error: line 6: expected row 1 of 2, found the end of the file\n"},
    {"type octile\n"
     "height 1\n"
     "width",
     "error: line 3: expected width from 1 to 2^63 - 1, found \"width\"\n"},
    {"\377\376t\000y\000p\000e\000"sv,
     "error: line 1: expected type, width, height (each once) or map, found byte 0xFF\n"},
    {"type octile\n"
     "height 1\n"
     "width 2\n"
     "map\n"
     "...\n",
     "error: line 5: expected 2 cells in row 0, found 3\n"},
    {"type octile\n"
     "height 1\n"
     "width 2\n"
     "map ..\n",
     "error: line 4: expected type, width, height (each once) or map, found \"map ..\"\n"},
    {"type octile\n"
     "type octile\n",
     "error: line 2: expected type, width, height (each once) or map, found \"type octile\"\n"},
    {"type octile\n"
     "height 1\n"
     "width 2\n"
     "map\n"
     ".W\n",
     "error: line 5: expected one of . G @ O T in row 0, column 1, found \"W\", which only some "
     "neighbours may enter: MovingAiOptions::directional says how to read it\n"},
    {"type \001octile\n",
     "error: line 1: expected type octile or tile, found \"type \" and byte 0x01\n"},
    {"typ\303\251 octile\n",
     "error: line 1: expected type, width, height (each once) or map, found \"typ\" and byte "
     "0xC3\n"},
};

constexpr InputRow scenario_texts[] = {
    {"\357\273\277Version 1.0\r\n"
     "0 a.map 5 4  1 2 3 0 4.82843 \r\n"
     "\r\n",
     "a.map from 1 2 to 3 0: 4.82843\n"},
    {"version 1\n"
     "7\tmaps/b.map\t9\t9\t0\t0\t8\t8\t1e1\n",
     "maps/b.map from 0 0 to 8 8: 10\n"},
    {"version 1\n"
     "0 a.map 5 4 1 2 3 0 1e\n",
     "error: line 2: expected a length in column 9, found \"1e\"\n"},
    {"version 1\n"
     "0 a.map 5 4 1 2 3 0 1e999\n",
     "error: line 2: expected a length in column 9, found \"1e999\"\n"},
    {"version 1\n"
     "0 a.map 5 4 1 2 3 0 inf\n",
     "error: line 2: expected a length in column 9, found \"inf\"\n"},
    {"version 1\n"
     "0 a.map 5 4 1 2 3\n",
     "error: line 2: expected 9 columns, found 7\n"},
    {"version 1\n"
     "0 a.map 5 4 1 2 3\000 0 4\n"sv,
     "error: line 2: expected a number from 0 to 2^31 - 1 in column 7, found \"3\" and byte "
     "0x00\n"},
    {"version\2401\n", "error: line 1: expected version 1, found \"version\" and byte 0xA0\n"},
    {"0 a.map 5 4 1 2 3 0 4\n",
     "error: line 1: expected version 1, found \"0 a.map 5 4 1 2 3 0 4\"\n"},
};

std::string text_of(const Expected<WktObstacles, Failure>& read) {
  return read ? test::short_text(read->obstacles, read->warnings) : test::exact_text(read.error());
}
std::string wkt_text(const std::string& text) { return text_of(parse_wkt(text)); }
std::string csv_text(const std::string& text) {
  return text_of(parse_wkt(text, {.csv_column = "wkt"}));
}
/// The rows of a map with '.' for free, or their number for many cells.
std::string map_text(const std::string& text) {
  const auto grid = parse_moving_ai_map(text);
  if (!grid) return test::exact_text(grid.error());
  std::string cells;
  std::size_t free = 0;
  for (int y = 0; y < grid->height(); ++y) {
    for (int x = 0; x < grid->width(); ++x) {
      const bool is_free = grid->is_free(Cell{x, y});
      free += is_free ? 1 : 0;
      cells += is_free ? '.' : '@';
    }
    cells += '\n';
  }
  if (cells.size() <= 400) return cells;
  return std::to_string(free) + " free cells of " + std::to_string(grid->width()) + " x " +
         std::to_string(grid->height()) + "\n";
}
std::string scenario_text(const std::string& text) {
  const auto rows = parse_moving_ai_scenario(text);
  if (!rows) return test::exact_text(rows.error());
  const auto cell = [](const Cell& c) { return std::to_string(c.x) + " " + std::to_string(c.y); };
  std::string all;
  for (const ScenarioRow& row : *rows) {
    all.append(row.map).append(" from ").append(cell(row.start)).append(" to ");
    all.append(cell(row.goal)).append(": ").append(test::exact_text(row.optimal_length)) += '\n';
  }
  return all;
}

std::string content(std::string text) {
  return text.rfind("\xEF\xBB\xBF", 0) == 0 ? text.substr(3) : text;
}

TEST_CASE("WKT files are read or refused exactly as the table says") {
  test::check_files(wkt_files, {".wkt", ".WKT"}, {}, wkt_text);
}
TEST_CASE("WKT texts are read or refused exactly as the table says") {
  test::check_texts(wkt_texts, wkt_text);
  test::check_texts(csv_texts, csv_text);
}
TEST_CASE("MovingAI maps are read or refused exactly as the table says") {
  test::check_files(map_files, {".map"}, {}, map_text);
  test::check_texts(map_texts, map_text);
}
TEST_CASE("MovingAI scenarios are read or refused exactly as the table says") {
  test::check_texts(scenario_texts, scenario_text);
}

TEST_CASE("second parsers of WKT and MovingAI refuse the same inputs") {
  test::check_refused(wkt_files, wkt_texts, [](const std::string& text) {
    return !test::ReferenceWkt::read(content(text)).has_value();
  });
  test::check_refused(map_files, map_texts, [](const std::string& text) {
    return !test::reference_moving_ai_map(text, '?').has_value();
  });
  for (const InputRow& row : scenario_texts) {
    INFO(row.input);
    CHECK(row.is_refused() !=
          test::reference_moving_ai_scenario(std::string(row.input)).has_value());
  }
}

TEST_CASE("a polygon with an SRID taken away is that of its twin in JSON") {
  const auto read = parse_wkt(test::read_input("11-ewkt/nosrid.wkt"));
  REQUIRE(read);
  REQUIRE(read->obstacles.size() == 1);
  const Ring& ring = std::get<Polygon>(read->obstacles[0]).outer;
  CHECK(ring.size() == 26);
  CHECK(ring[0] == Point(417820.587299988, 4845374.41139999));
  CHECK(ring.front() == ring.back());
}

}  // namespace
