// SPDX-License-Identifier: MIT
/// \file
/// Files and texts as people have them, and exactly what the readers of GeoJSON and workspace JSON
/// make of them.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "support/catch.hpp"
#include "support/input_table.hpp"
#include "support/obstacle_text.hpp"
#include "support/reference_json.hpp"
#include "support/reference_wkt.hpp"
#include "support/same_obstacles.hpp"
#include "tutavia/io/geo_json.hpp"
#include "tutavia/io/wkt.hpp"
#include "tutavia/io/workspace_json.hpp"

namespace {

using namespace tutavia;
using namespace std::string_view_literals;
using test::InputRow;

constexpr InputRow geo_json_files[] = {
    {"27-geojson/bbox6.geojson",
     "polygon (3 2,8 2,8 9,3 9,3 2)\n"
     "! the file.features[0].geometry.coordinates[0][0]: ordinates beyond x and y are dropped\n"},
    {"27-geojson/bom.geojson",
     "polygon (3 2,8 2,8 9,3 9,3 2)\n"
     "polygon (3 10,8 10,3 10)\n"},
    {"27-geojson/collection.geojson",
     "polygon (3 2,8 2,8 9,3 9,3 2)\n"
     "polygon (3 10,8 10,3 10)\n"},
    {"27-geojson/emptymulti.geojson",
     "polygon (3 2,8 2,8 9,3 9,3 2)\n"
     "! crs urn:ogc:def:crs:EPSG::25832 is ignored; coordinates are taken as metres\n"},
    {"27-geojson/emptypoint.geojson",
     "polygon (3 2,8 2,8 9,3 9,3 2)\n"
     "! crs urn:ogc:def:crs:EPSG::25832 is ignored; coordinates are taken as metres\n"},
    {"27-geojson/emptypoly.geojson",
     "polygon (3 2,8 2,8 9,3 9,3 2)\n"
     "! crs urn:ogc:def:crs:EPSG::25832 is ignored; coordinates are taken as metres\n"},
    {"27-geojson/geo.json",
     "polygon (3 2,3 9,8 9,8 2,3 2)\n"
     "! the file.features[1].geometry.coordinates[0][0][0]: ordinates beyond x and y are dropped\n"
     "! crs urn:ogc:def:crs:EPSG::25832 is ignored; coordinates are taken as metres\n"},
    {"27-geojson/name_null.geojson", "polygon (3 2,8 2,8 9,3 9,3 2)\n"},
    {"27-geojson/nullgeom.geojson",
     "polygon (3 2,3 9,8 9,8 2,3 2)\n"
     "! the file.features[1].geometry.coordinates[0][0][0]: ordinates beyond x and y are dropped\n"
     "! crs urn:ogc:def:crs:EPSG::25832 is ignored; coordinates are taken as metres\n"},
    {"27-geojson/onlyempty.geojson", ""},
    {"27-geojson/strings.geojson",
     "error: the file.features[0].geometry.coordinates[0][0]: expected 2 to 4 numbers\n"},
    {"27-geojson/unclosed.geojson",
     "polygon (3 2,8 2,8 9,3 9)\n"
     "! the file.features[0].geometry.coordinates[0]: a ring that does not end where it begins is "
     "closed\n"
     "! crs urn:ogc:def:crs:EPSG::25832 is ignored; coordinates are taken as metres\n"},
};

constexpr InputRow geo_json_texts[] = {
    {R"({"type":"Point","coordinates":[1,2],"bbox":[0,0,-5,4,4,5],"name":null,)"
     R"("start":null})",
     "disc 1 2 r 0\n"},
    {R"({"type":"Feature","properties":{"radius":null},"geometry":{"type":"Point",)"
     R"("coordinates":[1,2]}})",
     "disc 1 2 r 0\n"},
    {R"({"type":"Feature","properties":{"radius":0.5},"geometry":{"type":"MultiPoint",)"
     R"("coordinates":[[1,2],[],[3,4]]}})",
     "disc 1 2 r 0.5\n"
     "disc 3 4 r 0.5\n"},
    {R"({"type":"GeometryCollection","geometries":[{"type":"LineString",)"
     R"("coordinates":[]},{"type":"Polygon","coordinates":[[]]},{"type":"MultiPolygon",)"
     R"("coordinates":[[],[[]]]}]})",
     ""},
    {R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,0]],[],[[1,0.5],[2,0.5],)"
     R"([2,1],[1,0.5]]]})",
     "polygon (0 0,4 0,4 4,0 0) hole (1 0.5,2 0.5,2 1,1 0.5)\n"},
    {R"({"type":"Point","coordinates":[1,2]}
{"type":"Point","coordinates":[3,4]}
)",
     "disc 1 2 r 0\n"
     "disc 3 4 r 0\n"},
    {"\036{\"type\":\"Feature\",\"properties\":null,\"geometry\":null}\n"
     "\036{\"type\":\"LineString\",\n"
     "\"coordinates\":[[1,2,3],[4,5,6]]}\n",
     "polygon (1 2,4 5,1 2)\n"
     "! line 2: the object.coordinates[0]: ordinates beyond x and y are dropped\n"},
    {"\036{\"type\":\"Point\",\"coordinates\":[1,2],\"safety_radius\":1}\n", "disc 1 2 r 0\n"},
    {R"({"type":"LineString","coordinates":[[8.5401,47.3701],[8.5402,47.3702]],)"
     R"("crs":{"type":"link"}})",
     "polygon (8.5401 47.3701,8.5402 47.3702,8.5401 47.3701)\n"
     "! crs of unknown form is ignored; coordinates are taken as metres\n"
     "! the coordinates look like degrees of longitude and latitude; planning is in metres: "
     "project them first\n"},
    {R"({"type":"LineString","coordinates":[[85.4,47.3],[85.9,47.8]],"crs":null})",
     "polygon (85.4 47.3,85.9 47.8,85.4 47.3)\n"},
    {"\357\273\277{\"type\":\"Point\",\"coordinates\":[1e0,-2.5E-1,3,4]}",
     "disc 1 -0.25 r 0\n"
     "! the file.coordinates: ordinates beyond x and y are dropped\n"},
    {R"({"type":"Polygon","coordinates":[[[0,0],["4",0],[4,4],[0,0]]]})",
     "error: the file.coordinates[0][1]: expected 2 to 4 numbers\n"},
    {R"({"type":"Polygon","coordinates":[[[0,0],[4,0,"5"],[4,4],[0,0]]]})",
     "error: the file.coordinates[0][1]: expected 2 to 4 numbers\n"},
    {R"({"type":"Polygon","coordinates":[[[0,0],[4,0,1],[4,4],[0,0]]]})",
     "error: the file.coordinates[0][1]: a position of 3 ordinates in a geometry of 2\n"},
    {R"({"type":"Point","coordinates":[1,2,null]})",
     "error: the file.coordinates: expected 2 to 4 numbers\n"},
    {R"({"type":"Point","coordinates":[1]})",
     "error: the file.coordinates: expected 2 to 4 numbers\n"},
    {R"({"type":"Point","coordinates":[1,2,3,4,5]})",
     "error: the file.coordinates: expected 2 to 4 numbers\n"},
    {R"({"type":"Point","coordinates":null})", "error: the file.coordinates: expected an array\n"},
    {R"({"type":"Point","coordinates":[1,1e400]})",
     "error: line 1, column 38: number overflow parsing '1e400'\n"},
    {R"({"type":"Point","coordinates":[1,1e-400]})",
     "error: line 1, column 34: the number 1e-400 is too small for a double\n"},
    {R"({"type":"Point","coordinates":[1,NaN]})",
     "error: line 1, column 34: syntax error while parsing value - invalid literal; last read: "
     "'1,N'\n"},
    {R"({"type":"Point","coordinates":[1,-Infinity]})",
     "error: line 1, column 35: syntax error while parsing value - invalid number; expected digit "
     "after '-'; last read: '-I'\n"},
    {R"({"type":"Point","coordinates":[1,1e]})",
     "error: line 1, column 36: syntax error while parsing value - invalid number; expected '+', "
     "'-', or digit after exponent; last read: '1e]'\n"},
    {R"({"type":"Point","coordinates":[1,01]})",
     "error: line 1, column 35: syntax error while parsing array - unexpected number literal; "
     "expected ']'\n"},
    {R"({"type":"Point","coordinates":[1,+2]})",
     "error: line 1, column 34: syntax error while parsing value - invalid literal; last read: "
     "'1,+'\n"},
    {R"({"type":"Point","coordinates":[1,2])",
     "error: line 1, column 36: syntax error while parsing object - unexpected end of input; "
     "expected '}'\n"},
    {"{\"type\":\"Point\",\"coordinates\":[1,2]}\000"sv,
     "error: line 1, column 37: expected JSON, found byte 0x00\n"},
    {R"({"type":"Point","coordinates":[1,2]}})",
     "error: line 1, column 37: syntax error while parsing value - unexpected '}'; expected end of "
     "input\n"},
    {R"({"type":"Point",
"coordinates":[1,2],
"coordinates":[3,4]})",
     "error: line 3, column 13: the key \"coordinates\" stands in its object twice\n"},
    {"{\"type\":\"Point\",\"name\":\"\303(\",\"coordinates\":[1,2]}",
     "error: line 1, column 26: syntax error while parsing value - invalid string: ill-formed "
     "UTF-8 byte; last read: '\"<0xC3>('\n"},
    {R"({"type":"Point","coordinates":[1,2]}
{"type":"Point","coordinates":[3]}
)",
     "error: line 2: the object.coordinates: expected 2 to 4 numbers\n"},
    {R"({"type":"Point","coordinates":[1,2]}
{"type":"Point","coordi)",
     "error: line 2, column 24: syntax error while parsing object key - invalid string: missing "
     "closing quote; last read: '\"coordi'; expected string literal\n"},
    {"\036", "error: line 1, column 2: expected JSON, found nothing\n"},
    {R"({"type":"Polygon","coordinates":[[],[[1,1],[2,1],[2,2]]]})",
     "error: the file.coordinates[1]: expected no hole without an outer ring\n"},
    {R"({"type":"Feature","properties":3,"geometry":null})",
     "error: the file.properties: expected an object or null\n"},
    {R"({"type":"Feature","properties":{"radius":"1"},"geometry":null})",
     "error: the file.properties.radius: expected a number\n"},
    {R"({"type":"Feature","properties":{}})", "error: the file: \"geometry\" is missing\n"},
    {R"({"type":"point","coordinates":[1,2]})",
     "error: the file.coordinates: unknown geometry type \"point\"\n"},
    {R"({"type":"Point","coordinates":[1,2],"bbox":[0,0,1,4,4]})",
     "error: bbox: expected 4 or 6 numbers\n"},
    {"POINT(1 2)",
     "error: line 1, column 1: syntax error while parsing value - invalid literal; last read: "
     "'P'\n"},
    {"", "error: line 1, column 1: expected JSON, found nothing\n"},
    {" \r\n\t", "error: line 2, column 2: expected JSON, found nothing\n"},
};

constexpr InputRow scene_files[] = {
    {"08-wkt-mixed/true.json", "polygon (3 2,8 2,8 9,3 9)\n"},
    {"08-wkt-mixed/wall_true.json", "polygon (5 2,5 8)\n"},
    {"11-ewkt/twin.json",
     "1 obstacles of 26 points in (417567.15219999 4845371.80649999,417820.587299988 "
     "4845383.75009999)\n"},
    {"17-epf84/r0.5.json",
     "polygon (-79.80000000000001 -79.80000000000001,447.8 -79.80000000000001,447.8 "
     "527.8,-79.80000000000001 527.8) hole (161 47,247 47,247 7,361 7,361 441,7 441,7 7,161 7)\n"
     "polygon (272 172,272 36,136 36,136 172,155.6 172,155.6 332.4,252.4 332.4,252.4 172)\n"},
    {"17-epf84/r0.json",
     "polygon (-79.80000000000001 -79.80000000000001,447.8 -79.80000000000001,447.8 "
     "527.8,-79.80000000000001 527.8) hole (161 47,247 47,247 7,361 7,361 441,7 441,7 7,161 7)\n"
     "polygon (272 172,272 36,136 36,136 172,155.6 172,155.6 332.4,252.4 332.4,252.4 172)\n"},
    {"17-epf84/r5.json",
     "polygon (-79.80000000000001 -79.80000000000001,447.8 -79.80000000000001,447.8 "
     "527.8,-79.80000000000001 527.8) hole (161 47,247 47,247 7,361 7,361 441,7 441,7 7,161 7)\n"
     "polygon (272 172,272 36,136 36,136 172,155.6 172,155.6 332.4,252.4 332.4,252.4 172)\n"},
    {"18-epf23/r0.json",
     "polygon (-7 -7,7 -7,7 7,-7 7) hole (5 5,-5 5,-5 -5,5 -5)\n"
     "polygon (-5 1,-5 2,5 2,5 1)\n"},
    {"18-epf23/r01.json",
     "polygon (-7 -7,7 -7,7 7,-7 7) hole (5 5,-5 5,-5 -5,5 -5)\n"
     "polygon (-5 1,-5 2,5 2,5 1)\n"},
    {"19-epf102/r0.5.json",
     "1 obstacles of 27 points in (25992.841684201943 17106.256279306985,26177.92392905305 "
     "17268.350420693016)\n"},
    {"19-epf102/r0.json",
     "1 obstacles of 27 points in (25992.841684201943 17106.256279306985,26177.92392905305 "
     "17268.350420693016)\n"},
    {"19-epf102/r2.json",
     "1 obstacles of 27 points in (25992.841684201943 17106.256279306985,26177.92392905305 "
     "17268.350420693016)\n"},
    {"20-epf12/ccw.json",
     "polygon (-5007.122832936626 -3937.5479901933263,3967.300128849401 "
     "-3937.5479901933263,3967.300128849401 5799.031669387568,-5007.122832936626 "
     "5799.031669387568) hole (-2670.0220709984246 2849.785328817447,-534.0066345219713 "
     "4408.091718018869,2347.252358687458 3455.8632661053057,-290.58214669197565 "
     "122.69563577652582,2576.3601774807016 -1781.9414137932943,-3616.182881567927 "
     "-2546.608038824627)\n"},
    {"20-epf12/close.json",
     "1 obstacles of 13 points in (-6115.813958951911 -4479.581419703414,5914.677113176896 "
     "5671.836627899827)\n"},
    {"20-epf12/cw.json",
     "polygon (-5007.122832936626 -3937.5479901933263,3967.300128849401 "
     "-3937.5479901933263,3967.300128849401 5799.031669387568,-5007.122832936626 "
     "5799.031669387568) hole (-3616.182881567927 -2546.608038824627,2576.3601774807016 "
     "-1781.9414137932943,-290.58214669197565 122.69563577652582,2347.252358687458 "
     "3455.8632661053057,-534.0066345219713 4408.091718018869,-2670.0220709984246 "
     "2849.785328817447)\n"},
    {"21-nav2d26/r1.json",
     "polygon (-322.20000000000005 -175.20000000000002,1394.2 -175.20000000000002,1394.2 "
     "1007.2,-322.20000000000005 1007.2) hole (72 79,78 252,974 230,990 453,625 684,197 383,-77 "
     "616,-33 658,249 437,618 762,975 509,1128 545,1032 450,1010 318,1135 303,1149 228,1032 "
     "259,1011 210,1069 70,470 93,954 109,944 172,389 177,378 110)\n"},
    {"21-nav2d26/r2.json",
     "polygon (-322.20000000000005 -175.20000000000002,1394.2 -175.20000000000002,1394.2 "
     "1007.2,-322.20000000000005 1007.2) hole (72 79,78 252,974 230,990 453,625 684,197 383,-77 "
     "616,-33 658,249 437,618 762,975 509,1128 545,1032 450,1010 318,1135 303,1149 228,1032 "
     "259,1011 210,1069 70,470 93,954 109,944 172,389 177,378 110)\n"},
    {"21-nav2d26/r5.json",
     "polygon (-322.20000000000005 -175.20000000000002,1394.2 -175.20000000000002,1394.2 "
     "1007.2,-322.20000000000005 1007.2) hole (72 79,78 252,974 230,990 453,625 684,197 383,-77 "
     "616,-33 658,249 437,618 762,975 509,1128 545,1032 450,1010 318,1135 303,1149 228,1032 "
     "259,1011 210,1069 70,470 93,954 109,944 172,389 177,378 110)\n"},
    {"22-pvg39/r0.json", "polygon (3 2,6 2,6 7,3 7)\n"},
    {"22-pvg39/r02.json", "polygon (3 2,6 2,6 7,3 7)\n"},
    {"23-p2t90/r0.json",
     "polygon (329800 51800,620200 51800,620200 361200,329800 361200) hole (374000 96000,374000 "
     "317000,576000 317000,576000 96000)\n"
     "polygon (449000 291000,393000 205000,419000 177000)\n"
     "polygon (539000 138000,419000 177000,420000 139000)\n"},
    {"23-p2t90/r100.json",
     "polygon (329800 51800,620200 51800,620200 361200,329800 361200) hole (374000 96000,374000 "
     "317000,576000 317000,576000 96000)\n"
     "polygon (449000 291000,393000 205000,419000 177000)\n"
     "polygon (539000 138000,419000 177000,420000 139000)\n"},
    {"23-p2t90/r1000.json",
     "polygon (329800 51800,620200 51800,620200 361200,329800 361200) hole (374000 96000,374000 "
     "317000,576000 317000,576000 96000)\n"
     "polygon (449000 291000,393000 205000,419000 177000)\n"
     "polygon (539000 138000,419000 177000,420000 139000)\n"},
    {"23-p2t90/small_r0.1.json",
     "polygon (-2 -2,12 -2,12 12,-2 12) hole (10 0,10 10,0 10,0 0)\n"
     "polygon (2 1,3 3,1 2)\n"
     "polygon (3 3,6 4,4 7)\n"},
    {"23-p2t90/small_r0.json",
     "polygon (-2 -2,12 -2,12 12,-2 12) hole (10 0,10 10,0 10,0 0)\n"
     "polygon (2 1,3 3,1 2)\n"
     "polygon (3 3,6 4,4 7)\n"},
    {"24-earcut45/pocket.json",
     "polygon (10 10,25 10,25 40,10 40) hole (15 30,20 35,10 40) hole (15 15,15 20,20 15)\n"},
    {"25-earcut52/obstacle.json", "1 obstacles of 107 points in (1176 240,2040 1160)\n"},
    {"25-earcut52/r0.json", "6 obstacles of 105 points in (992 56,2224 1344)\n"},
    {"25-earcut52/r1.json", "6 obstacles of 105 points in (992 56,2224 1344)\n"},
    {"25-earcut52/r3.json", "6 obstacles of 105 points in (992 56,2224 1344)\n"},
    {"26-latlon/deg.json",
     "polygon (37.3778 -122.0419,37.3779 -122.0419,37.3779 -122.0418,37.3778 -122.0418)\n"
     "! the coordinates look like degrees of longitude and latitude; planning is in metres: "
     "project them first\n"},
    {"31-link/slot.json",
     "polygon (1 1,4.7 1,4.7 6,1 6)\n"
     "polygon (5.32 1,9 1,9 6,5.32 6)\n"},
    {"33-touch/adjacent.json",
     "polygon (0 0,4 0,4 4,0 4)\n"
     "polygon (4 0,8 0,8 4,4 4)\n"},
    {"33-touch/adjacent_r.json",
     "polygon (0 0,4 0,4 4,0 4)\n"
     "polygon (4 0,8 0,8 4,4 4)\n"},
    {"33-touch/earcut161.json",
     "! the coordinates look like degrees of longitude and latitude; planning is in metres: "
     "project them first\n"
     "1 obstacles of 11 points in (-0.6167274713516235 0.25103136897087097,-0.6128724217414856 "
     "0.2511403560638428)\n"},
    {"33-touch/p2t17.json",
     "polygon (384 640,256 512,384 512) hole (280 525,400 525,400 535,280 535)\n"},
    {"33-touch/tjunction.json",
     "polygon (0 0,4 0,4 2,4 4,0 4)\n"
     "polygon (4 0.5,8 0.5,8 3.5,4 3.5)\n"},
};

constexpr InputRow scene_texts[] = {
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[{"bbox":[1,2,3,4]},)"
     R"({"center":[5,6],"radius":0.5}],"name":null})",
     "polygon (1 2,3 2,3 4,1 4)\n"
     "disc 5 6 r 0.5\n"},
    {"\357\273\277{\"bounds\":[0,0,9,9],\"safety_radius\":1,\"obstacles\":[{\"polygon\":[[0,0],[1,"
     "0],[1,1]],\"holes\":[[[0.5,0.1],[0.6,0.1],[0.6,0.2]]]}]}",
     "polygon (0 0,1 0,1 1) hole (0.5 0.1,0.6 0.1,0.6 0.2)\n"},
    {R"({"bounds":[8.5,47.3,8.5011,47.3011],"safety_radius":0.00001,"obstacles":[]})",
     "! the coordinates look like degrees of longitude and latitude; planning is in metres: "
     "project them first\n"},
    {"{\"bounds\":[0,0,9,9],\"safety_radius\":1,\"obstacles\":[],\"h\303\266he\":1}",
     "! unknown key \"h<0xC3><0xB6>he\" ignored\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[{"polygon":[[0,0],[1,0],[1,)"
     R"(1]],"center":[5,6],"radius":1}]})",
     "error: obstacles[0]: expected one of \"polygon\", \"bbox\" and \"center\"\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[{"polygon":[[0,0],[1,0,2],[1,)"
     R"(1]]}]})",
     "error: obstacles[0].polygon[1]: expected [x, y]\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[{"polygon":[[0,0],[1,"0"],[1,)"
     R"(1]]}]})",
     "error: obstacles[0].polygon[1]: expected [x, y]\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[{"center":[5,6]}]})",
     "error: obstacles[0]: expected \"polygon\", \"bbox\" or \"center\" and \"radius\"\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[{"center":[5,6],)"
     R"("radius":-1}]})",
     "error: obstacles[0].radius must not be negative, and must be finite, and 0 or between 2^-400 "
     "and 2^400 in magnitude\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[{"center":[5,6],)"
     R"("radius":1e999}]})",
     "error: line 1, column 81: number overflow parsing '1e999'\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[{"center":[5,6],)"
     R"("radius":1e-999}]})",
     "error: line 1, column 77: the number 1e-999 is too small for a double\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[{"center":[5,1e300],)"
     R"("radius":1}]})",
     "error: obstacles[0].center must be finite, and 0 or between 2^-400 and 2^400 in magnitude\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[{"polygon":[]}]})",
     "error: obstacles[0].polygon has no points\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[],
"obstacles":[]})",
     "error: line 2, column 11: the key \"obstacles\" stands in its object twice\n"},
    {"{\"bounds\":[0,0,9,9],\"safety_radius\":1,\"obstacles\":[]}\000{}"sv,
     "error: line 1, column 54: expected JSON, found byte 0x00\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[{"bbox":[1,2,3]}]})",
     "error: obstacles[0].bbox: expected [x0, y0, x1, y1]\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obstacles":[NaN]})",
     "error: line 1, column 52: syntax error while parsing value - invalid literal; last read: "
     "'\"obstacles\":[N'\n"},
    {R"({"bounds":[0,0,9,9],"safety_radius":1,"obs)",
     "error: line 1, column 43: syntax error while parsing object key - invalid string: missing "
     "closing quote; last read: '\"obs'; expected string literal\n"},
};

std::string scene_file_text(const Expected<SceneFile, Failure>& file) {
  return file ? test::short_text(file->scene.workspace.obstacles, file->warnings)
              : test::exact_text(file.error());
}
std::string geo_json_text(const std::string& text) { return scene_file_text(parse_geo_json(text)); }
std::string scene_text(const std::string& text) { return scene_file_text(parse_scene_json(text)); }

TEST_CASE("GeoJSON files and texts are read or refused exactly as the table says") {
  test::check_files(geo_json_files, {".geojson"}, {"27-geojson/geo.json"}, geo_json_text);
  test::check_texts(geo_json_texts, geo_json_text);
}
TEST_CASE("workspace files and texts are read or refused exactly as the table says") {
  test::check_files(scene_files, {".json"}, {}, scene_text, "27-geojson");
  test::check_texts(scene_texts, scene_text);
}

TEST_CASE("second walks over JSON refuse the same inputs") {
  test::check_refused(geo_json_files, geo_json_texts, [](const std::string& text) {
    return !test::ReferenceGeoJson::read(text).has_value();
  });
  test::check_refused(scene_files, scene_texts, [](const std::string& text) {
    const auto workspace = test::reference_scene(text);
    return !workspace || !validate(*workspace);
  });
}

TEST_CASE("members of GeoJSON beside its type are read from one object alone") {
  const std::string point = R"({"type":"Point","coordinates":[1,2],"bbox":[0,1,-5,4,6,5],)"
                            R"("safety_radius":0.5,"name":null,"start":[3,4]})";
  const auto one = parse_geo_json(point);
  REQUIRE(one);
  const Box& bounds = one->scene.workspace.bounds;
  CHECK((bounds.min == Point(0, 1) && bounds.max == Point(4, 6)));
  CHECK(one->scene.workspace.safety_radius == 0.5);
  CHECK(one->scene.name.empty());
  CHECK(one->scene.start == Point(3, 4));
  const auto two = parse_geo_json(point + "\n" + point);
  REQUIRE(two);
  CHECK_FALSE(detail::is_finite(two->scene.workspace.bounds.min));
  CHECK_FALSE(detail::is_finite(two->scene.start));
  CHECK(two->scene.workspace.obstacles.size() == 2);
}

}  // namespace
