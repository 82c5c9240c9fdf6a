// SPDX-License-Identifier: MIT
/// \file
/// The engine of the playground's page: its requests and replies.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "../../examples/playground/engine/engine.hpp"
#include "support/catch.hpp"

namespace {

using nlohmann::json;
using playground::Engine;

json ask(Engine& engine, const json& request, std::string_view bytes = {}) {
  return json::parse(engine.call(request.dump(), bytes).json);
}

/// The engine on a built-in map.
struct OnMaze {
  Engine engine{};
  json scene = ask(engine, {{"do", "builtin"}, {"name", "maze"}})["workspace"];

  OnMaze() { ask(engine, {{"do", "scene"}, {"workspace", scene}}); }
  json plan(json request) {
    request["do"] = "plan";
    request["start"] = scene["start"];
    request["goal"] = scene["goals"][0];
    return ask(engine, request);
  }
};

std::string error_of(const json& reply) { return reply.value("error", "(no error)"); }

std::string file(const std::string& name) {
  std::ifstream stream(std::string(TUTAVIA_TEST_DATA "/") + name, std::ios::binary);
  REQUIRE(stream);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The nodes of a YAML file of plain keys, `origin` a list.
json yaml_nodes(const std::vector<std::pair<std::string, std::string>>& keys,
                const std::vector<std::string>& origin) {
  json nodes = json::array({{{"kind", "map"}, {"line", 1}, {"children", json::array()}}});
  const auto add = [&](json node) {
    nodes.push_back(std::move(node));
    return nodes.size() - 1;
  };
  std::size_t line = 0;
  const auto add_key = [&](const std::string& key) {
    nodes[0]["children"].push_back(add({{"kind", "scalar"}, {"line", ++line}, {"text", key}}));
  };
  for (const auto& [key, value] : keys) {
    add_key(key);
    nodes[0]["children"].push_back(add({{"kind", "scalar"}, {"line", line}, {"text", value}}));
  }
  add_key("origin");
  json children = json::array();
  for (const std::string& item : origin) {
    children.push_back(add({{"kind", "scalar"}, {"line", line}, {"text", item}}));
  }
  nodes[0]["children"].push_back(add({{"kind", "list"}, {"line", line}, {"children", children}}));
  return nodes;
}

const std::vector<std::pair<std::string, std::string>> rooms_keys{{"image", "rooms.pgm"},
                                                                  {"resolution", "0.1"},
                                                                  {"negate", "0"},
                                                                  {"occupied_thresh", "0.65"},
                                                                  {"free_thresh", "0.196"}};

TEST_CASE("the playground's catalogue names every algorithm, and where it works") {
  Engine engine;
  const json catalogue = ask(engine, {{"do", "catalogue"}});
  CHECK(catalogue["searches"].size() == 25);
  CHECK(catalogue["smoothers"].size() == 14);
  const auto find = [&](const char* kind, const char* name) {
    const json& list = catalogue[kind];
    return *std::find_if(list.begin(), list.end(),
                         [&](const json& item) { return item["name"] == name; });
  };
  CHECK(find("searches", "hybrid_astar")["for_vehicles"] == true);
  CHECK(find("searches", "rrt_star")["options"].size() > 3);
  CHECK(find("smoothers", "homotopy_refine")["on_cells"] == false);
  CHECK(find("smoothers", "none")["for_vehicles"] == true);
}

TEST_CASE("the playground's samples lie on the proved curve") {
  OnMaze maze;
  const json reply = maze.plan({{"search", "auto"},
                                {"smoother", "clothoid"},
                                {"optimum", true},
                                {"speed",
                                 {{"max_speed", 1},
                                  {"max_acceleration", 0.5},
                                  {"max_deceleration", 0.5},
                                  {"max_lateral_acceleration", 0.5}}}});
  INFO(error_of(reply));
  REQUIRE(reply["result"]["status"] == "success");
  const json &curve = reply["curve"], &result = reply["result"];
  const auto along = curve["s"].get<std::vector<double>>();
  CHECK(along.size() >= 300);
  CHECK(std::is_sorted(along.begin(), along.end()));
  CHECK(along.back() == result["metrics"]["length"]);
  CHECK(curve["x"].front() == maze.scene["start"][0]);
  CHECK(curve["y"].back() == maze.scene["goals"][0][1]);
  for (const double clearance : curve["clearance"].get<std::vector<double>>()) {
    CHECK(clearance >= result["certificate"]["lower"].get<double>());
  }
  CHECK(curve["pieces"].size() == result["curve"].size());
  CHECK(result["optimum"]["ratio"].get<double>() < 1.01);
  CHECK(reply["speed"]["duration"].get<double>() > along.back());
  CHECK_FALSE(reply.contains("refused"));
}

TEST_CASE("the playground shows where a spline is not safe that nobody checked") {
  OnMaze maze;
  const json request{{"search", "astar"}, {"smoother", "clothoid"}, {"unchecked", true}};
  const json reply = maze.plan(request);
  INFO(error_of(reply));
  REQUIRE(reply["result"]["certificate"]["status"] == "proved");
  const json &certificate = reply["unchecked"]["certificate"], &curve = reply["unchecked"]["curve"];
  CHECK(certificate["status"] == "violated");
  CHECK(certificate["upper"].get<double>() < 0.3);
  const auto clearance = curve["clearance"].get<std::vector<double>>();
  CHECK(*std::min_element(clearance.begin(), clearance.end()) < 0.3);
  CHECK(curve["x"].front() == maze.scene["start"][0]);
  CHECK(curve["y"].back() == maze.scene["goals"][0][1]);
}

TEST_CASE("the playground says why a smoother gave no curve") {
  OnMaze maze;
  const json reply =
      maze.plan({{"search", "astar"}, {"smoother", "clothoid:min_turning_radius=6"}});
  REQUIRE(reply["result"]["fell_back"] == true);
  INFO(reply["smoother_failure"]);
  CHECK(reply["smoother_failure"].get<std::string>().size() > 10);
  CHECK(reply["curve"]["x"] == reply["route"]["x"]);
}

TEST_CASE("the playground records the events of a search up to a number") {
  OnMaze maze;
  const json reply = maze.plan({{"search", "astar"}, {"smoother", "none"}, {"events", 10}});
  const json& events = reply["events"];
  CHECK(events["kinds"].get<std::string>().size() == 10);
  CHECK(events["coordinates"].size() == 20);
  CHECK(events["left_out"].get<int>() > 100);
  CHECK(events["cell_size"] == 0.2);
  const json rectangles =
      maze.plan({{"search", "rrt_connect"}, {"smoother", "none"}, {"events", 100000}});
  CHECK(rectangles["events"]["kinds"].get<std::string>().find('t') != std::string::npos);
}

TEST_CASE("the playground plans a car with its headings") {
  OnMaze maze;
  const json car{{"min_turning_radius", 0.5},
                 {"reverse", true},
                 {"car", {{"length", 0.6}, {"width", 0.3}, {"wheelbase", 0.4}}}};
  const json reply = maze.plan({{"search", "hybrid_astar"},
                                {"smoother", "vehicle_shortcut"},
                                {"vehicle", car},
                                {"start_heading", 0.5},
                                {"goal_heading", 1.5}});
  INFO(error_of(reply));
  REQUIRE(reply["result"]["status"] == "success");
  CHECK(std::abs(reply["curve"]["heading"].front().get<double>() - 0.5) < 1e-9);
  CHECK(reply["curve"]["gear"].size() == reply["curve"]["x"].size());
  CHECK(reply["footprint"].size() > 3);
  json bad = car;
  bad["car"]["width"] = 2;
  CHECK(error_of(maze.plan({{"search", "hybrid_astar"}, {"smoother", "none"}, {"vehicle", bad}}))
            .starts_with("car: expected 0 < width"));
}

TEST_CASE("the playground's pictures are those of the library") {
  OnMaze maze;
  const json plan{{"search", "astar"},
                  {"smoother", "clothoid"},
                  {"start", maze.scene["start"]},
                  {"goal", maze.scene["goals"][1]}};
  const std::string svg = ask(maze.engine, {{"do", "svg"}, {"plans", {plan}}})["svg"];
  CHECK(svg.starts_with("<svg"));
  CHECK(svg.find("astar, clothoid") != std::string::npos);
}

TEST_CASE("the playground reads a ROS map as the library does, also one that is turned") {
  Engine engine;
  const std::string image = file("ros_map/rooms.pgm");
  const auto open = [&](const std::vector<std::string>& origin) {
    return engine.call(json{{"do", "open_ros"},
                            {"name", "rooms"},
                            {"yaml", yaml_nodes(rooms_keys, origin)},
                            {"unknown", "blocked"}}
                           .dump(),
                       image);
  };
  const auto straight = open({"-2.2", "-1.4", "0.0"});
  json cells = json::parse(straight.json)["cells"];
  CHECK(cells["origin"] == json({-2.2, -1.4}));
  CHECK(cells["resolution"] == 0.1);
  CHECK(straight.bytes.size() ==
        cells["width"].get<std::size_t>() * cells["height"].get<std::size_t>());

  const auto turned = open({"-2.2", "-1.4", "1.5"});
  CHECK(turned.bytes == straight.bytes);
  cells = json::parse(turned.json)["cells"];
  CHECK(cells["map"]["yaw"] == 1.5);
  ask(engine, {{"do", "scene"}, {"cells", cells}}, turned.bytes);
  const json reply = ask(engine, {{"do", "plan"},
                                  {"search", "astar"},
                                  {"smoother", "none"},
                                  {"start", {0.55, 0.55}},
                                  {"goal", {0.95, 0.55}}});
  INFO(error_of(reply) << reply["result"].value("detail", ""));
  REQUIRE(reply["result"]["status"] == "success");
  // Points of the page are in the frame of the grid, the result in that of the map.
  CHECK(reply["curve"]["x"].front() == 0.55);
  const double x = reply["result"]["start"][0];
  CHECK(std::abs(x - (-2.2 + std::cos(1.5) * 0.55 - std::sin(1.5) * 0.55)) < 1e-12);

  const json bad = json::parse(open({"-2.2", "x", "0"}).json);
  CHECK(error_of(bad) == "line 6: expected origin: x, y and yaw, found x");
}

TEST_CASE("the playground opens files by their names, and says what is wrong with them") {
  Engine engine;
  const auto open = [&](const char* name, std::string_view text) {
    return ask(engine, {{"do", "open"}, {"name", name}}, text);
  };
  CHECK(open("a.WKT", "POLYGON((0 0, 1 0, 1 1, 0 0))")["workspace"]["obstacles"].size() == 1);
  const json map = open("a.map", "type octile\nheight 2\nwidth 3\nmap\n.@.\n...\n");
  CHECK(map["cells"]["width"] == 3);
  CHECK(map["cells"]["y_down"] == true);
  CHECK(open("a.geojson", R"({"type":"Point","coordinates":[1,2]})")["warnings"].size() == 1);
  const json square = open("a.geojson", R"({"type":"Polygon","safety_radius":1,
      "coordinates":[[[0,0],[2,0],[2,2],[0,2],[0,0]]]})");
  CHECK(square["workspace"]["bounds"] == json({-4, -4, 6, 6}));  // the robot passes outside
  CHECK(open("a.json", file("parking.json"))["workspace"]["obstacles"].size() > 1);
  CHECK(error_of(open("a.json", "{")).starts_with("line 1"));
  CHECK(error_of(open("a.txt", "")).starts_with("a.txt: unknown kind of file"));
  CHECK(error_of(open("a.map", "type octile\nheight 1\nwidth 1\nmap\nS\n")).find("terrain") !=
        std::string::npos);
  const json csv = ask(engine, {{"do", "open"}, {"name", "a.csv"}, {"wkt_column", "shape"}},
                       "id,shape\n1,\"POINT(1 1)\"\n");
  CHECK(csv["workspace"]["obstacles"].size() == 1);
  const json rows = ask(engine, {{"do", "open_scenarios"}, {"name", "a.scen"}},
                        "version 1\n0\ta.map\t3\t2\t0\t0\t2\t0\t2.8\n");
  CHECK(rows["scenarios"][0]["goal"] == json({2.5, 0.5}));
}

TEST_CASE("the playground answers bad requests by texts") {
  Engine engine;
  CHECK(error_of(json::parse(engine.call("{", {}).json)).find("parse error") != std::string::npos);
  CHECK(error_of(ask(engine, {{"do", "nothing"}})) == "no request is named nothing");
  CHECK(error_of(ask(engine, json::object())) == "\"do\" is missing");
  CHECK(error_of(ask(engine, {{"do", "plan"}})) == "there is no scene yet");
  CHECK(error_of(ask(engine, {{"do", "scene"}})) == "a scene has \"workspace\" or \"cells\"");
  const json cells{
      {"width", 3}, {"height", 2}, {"resolution", 1}, {"origin", {0, 0}}, {"safety_radius", 0}};
  CHECK(error_of(ask(engine, {{"do", "scene"}, {"cells", cells}}, "123")) ==
        "expected 3 x 2 values, found 3");

  OnMaze maze;
  CHECK(error_of(maze.plan({{"search", "astr"}, {"smoother", "none"}})) ==
        "search: unknown name \"astr\"; did you mean astar?");
  CHECK(error_of(maze.plan({{"search", "rrt:max_iterations=x"}, {"smoother", "none"}}))
            .find("expected a whole number") != std::string::npos);
  CHECK(error_of(maze.plan({{"search", "astar,jps"}, {"smoother", "none"}})) ==
        "search: one is planned with at a time");
  CHECK(error_of(maze.plan({{"search", "hybrid_astar"}, {"smoother", "clothoid"}}))
            .find("keeps no headings") != std::string::npos);
}

}  // namespace
