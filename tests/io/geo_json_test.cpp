// SPDX-License-Identifier: MIT
#include "tutavia/io/geo_json.hpp"

#include "support/catch.hpp"

namespace {

using namespace tutavia;

std::string complaint(const std::string& text) {
  const auto file = parse_geo_json(text);
  REQUIRE_FALSE(file);
  CHECK(file.error().code == PlanError::invalid_input);
  return file.error().detail;
}

TEST_CASE("features, collections and bare geometries become obstacles") {
  const auto file = parse_geo_json(R"({"type":"FeatureCollection","bbox":[0,0,9,9],"name":"yard",
      "safety_radius":0.3,"start":[1,1],"goals":[[8,8]],"resolution":0.1,"features":[
      {"type":"Feature","properties":{"radius":2},"geometry":{"type":"Point","coordinates":[1,2,9]}},
      {"type":"Feature","properties":null,"geometry":null},
      {"type":"Feature","geometry":{"type":"GeometryCollection","geometries":[
        {"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,0]],[[1,0.5],[2,0.5],[2,1],[1,0.5]]]},
        {"type":"LineString","coordinates":[[0,0],[1,1]]},
        {"type":"MultiPoint","coordinates":[[5,5],[6,6]]}]}},
      {"type":"Feature","properties":{},"geometry":{"type":"MultiPolygon","coordinates":
        [[[[5,5],[6,5],[6,6]]],[[[7,7],[8,7],[8,8]]]]}}]})");
  REQUIRE(file);
  const Scene& scene = file->scene;
  CHECK(scene.name == "yard");
  CHECK(scene.workspace.bounds.max == Point(9, 9));
  CHECK(scene.workspace.safety_radius == 0.3);
  CHECK(scene.goals.size() == 1);
  const auto& obstacles = scene.workspace.obstacles;
  REQUIRE(obstacles.size() == 7);
  CHECK(std::get<Disc>(obstacles[0]).radius == 2);
  CHECK(std::get<Polygon>(obstacles[1]).holes.size() == 1);
  CHECK(std::get<Polygon>(obstacles[2]).outer.size() == 3);
  CHECK(std::get<Disc>(obstacles[4]).center == Point(6, 6));
  CHECK(std::get<Disc>(obstacles[4]).radius == 0);
  CHECK(validate(scene.workspace));
}

TEST_CASE("without bounds and radius the workspace is not valid until they are set") {
  auto file = parse_geo_json(R"({"type":"Point","coordinates":[1,2]})");
  REQUIRE(file);
  CHECK_FALSE(validate(file->scene.workspace));
  file->scene.workspace.bounds = {{0, 0}, {4, 4}};
  CHECK_FALSE(validate(file->scene.workspace));
  file->scene.workspace.safety_radius = 0.5;
  CHECK(validate(file->scene.workspace));
}

TEST_CASE("everything malformed is named with its place") {
  CHECK(complaint("{\n\"type\" 1}").find("line 2, column 8: syntax error") == 0);
  CHECK(complaint("[]") == "the file: expected an object");
  CHECK(complaint("{}") == "the file: \"type\" is missing");
  CHECK(complaint(R"({"type":"Circle","coordinates":[]})") ==
        "the file.coordinates: unknown geometry type \"Circle\"");
  CHECK(complaint(R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":
      {"type":"Polygon","coordinates":[[[0,0],[1]]]}}]})") ==
        "the file.features[0].geometry.coordinates[0][1]: expected 2 to 4 numbers");
  std::string nested = R"({"type":"Point","coordinates":[1,2]})";
  for (int i = 0; i < 40; ++i) {
    nested = R"({"type":"GeometryCollection","geometries":[)" + nested + "]}";
  }
  CHECK(complaint(nested).find("nested less than 16 deep") != std::string::npos);
}

}  // namespace
