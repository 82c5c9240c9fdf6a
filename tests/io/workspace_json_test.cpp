// SPDX-License-Identifier: MIT
#include "tutavia/io/workspace_json.hpp"

#include "support/catch.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

/// A valid file with one field replaced or added.
std::string with(const std::string& field, const std::string& value) {
  nlohmann::json json = {
      {"bounds", {0, 0, 4, 4}}, {"safety_radius", 0.25}, {"obstacles", nlohmann::json::array()}};
  json[field] = nlohmann::json::parse(value);
  return json.dump();
}

std::string scene_complaint(const std::string& text) {
  const auto file = parse_scene_json(text);
  REQUIRE_FALSE(file);
  CHECK(file.error().code == PlanError::invalid_input);
  return file.error().detail;
}

bool contains(const std::string& text, const std::string& part) {
  INFO(text << " should contain " << part);
  CHECK(text.find(part) != std::string::npos);
  return true;
}

TEST_CASE("scenes survive the way to JSON and back") {
  for (Scene scene : {maps::array(), maps::complex(), maps::maze()}) {
    scene.workspace.obstacles.emplace_back(Disc{{0.1, 1.0 / 3}, 0.7});
    std::get<Polygon>(scene.workspace.obstacles[0]).holes = {{{1, 1}, {1.5, 1}, {1.2, 1.3}}};
    const std::string text = scene_to_json(scene).dump();
    const auto file = parse_scene_json(text);
    REQUIRE(file);
    CHECK(file->warnings.empty());
    CHECK(scene_to_json(file->scene).dump() == text);
    CHECK(file->scene.start == scene.start);
    CHECK(file->scene.goals == scene.goals);
    CHECK(std::get<Disc>(file->scene.workspace.obstacles.back()).center.y() == 1.0 / 3);
  }
}

TEST_CASE("all three kinds of obstacles are read") {
  const auto file = parse_scene_json(with("obstacles", R"([{"bbox":[1,2,3,4]},
      {"center":[1,1],"radius":0.5}, {"type":"wall","polygon":[[0,0],[1,0],[1,1]]}])"));
  REQUIRE(file);
  const auto& obstacles = file->scene.workspace.obstacles;
  CHECK(std::get<Polygon>(obstacles[0]).outer == Ring{{1, 2}, {3, 2}, {3, 4}, {1, 4}});
  CHECK(std::get<Disc>(obstacles[1]).radius == 0.5);
  CHECK(std::get<Polygon>(obstacles[2]).outer.size() == 3);
  CHECK_FALSE(file->scene.resolution.has_value());
  CHECK(file->scene.goals.empty());
  CHECK_FALSE(detail::is_finite(file->scene.start));
}

TEST_CASE("unknown keys at top level are warned of, one line each") {
  const auto file = parse_scene_json(with("paper", "1"));
  REQUIRE(file);
  CHECK(file->warnings == std::vector<std::string>{"unknown key \"paper\" ignored"});
}

TEST_CASE("malformed JSON is reported with line and column") {
  contains(scene_complaint("{\n  \"bounds\": [0, 0, 4 4]\n}"), "line 2, column 22");
  contains(scene_complaint(""), "line 1, column 1");
  contains(scene_complaint("{\"bounds\": [0, 0, 1e999, 4]}"), "1e999");
}

TEST_CASE("every wrong field is named with its place") {
  contains(scene_complaint("[]"), "expected an object");
  contains(scene_complaint("{}"), "\"bounds\" is missing");
  contains(scene_complaint(with("bounds", "[0,0,4]")), "bounds: expected [x0, y0, x1, y1]");
  contains(scene_complaint(with("bounds", "[4,0,0,4]")), "bounds are empty");
  contains(scene_complaint(with("safety_radius", "-0.1")), "safety_radius must not be negative");
  contains(scene_complaint(with("safety_radius", "\"big\"")), "safety_radius: expected a number");
  contains(scene_complaint(with("obstacles", "{}")), "obstacles: expected an array");
  contains(scene_complaint(with("obstacles", "[{\"polygon\":[[0,0],[1]]}]")),
           "obstacles[0].polygon[1]: expected [x, y]");
  contains(scene_complaint(with("obstacles", "[{\"polygon\":[]}]")),
           "obstacles[0].polygon has no points");
  contains(scene_complaint(with("obstacles", "[{\"bbox\":[0,0,1,1]},{\"radius\":1}]")),
           "obstacles[1]: expected");
  contains(scene_complaint(with("obstacles", "[{\"center\":[0,0],\"radius\":-1}]")),
           "obstacles[0].radius");
  contains(scene_complaint(with("goals", "[[1,1],[2,null]]")), "goals[1]: expected [x, y]");
  contains(scene_complaint(with("start", "[1,2,3]")), "start: expected [x, y]");
  contains(scene_complaint(with("name", "7")), "name: expected a string");
}

TEST_CASE("a file that is not there is named") {
  const auto file = read_scene_json("no/such/file.json");
  REQUIRE_FALSE(file);
  contains(file.error().detail, "no/such/file.json");
}

}  // namespace
