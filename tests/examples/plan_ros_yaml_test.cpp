// SPDX-License-Identifier: MIT
/// \file
/// tutavia-plan on ROS maps, run as a user runs it.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/program_folder.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/io/ros_map.hpp"

namespace {

using namespace tutavia;
using nlohmann::json;

using test::Outcome;

/// A folder with maps in it.
struct RosFolder : test::ProgramFolder {
  RosFolder() : ProgramFolder("tutavia_ros", TUTAVIA_PLAN) {}

  /// The results of a run that has to succeed.
  json results_of(const std::string& arguments) const {
    const Outcome outcome = run(arguments + " --json r.json");
    INFO(arguments << ": " << outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(read("r.json"));
  }
};

bool has_part(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string yaml_of(const std::string& image, const std::string& origin) {
  return "image: " + image + "\nresolution: 0.05\norigin: " + origin +
         "\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

std::string text_of(const Point& p) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "%.17g,%.17g", p.x(), p.y());
  return text.data();
}

Point point_of(const json& value) { return {value[0].get<double>(), value[1].get<double>()}; }

/// A room of 2 m x 1.6 m with a wall from below, another from above, and a pillar.
std::string room_image() {
  std::string text = "P2 40 32 255\n";
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 40; ++x) {
      const bool border = x == 0 || y == 0 || x == 39 || y == 31;
      const bool wall = (x == 12 && y > 10) || (x == 25 && y < 22) || (x / 3 == 6 && y / 3 == 5);
      text += border || wall ? "0 " : "254 ";
    }
  }
  return text;
}

RosMap frame_with(const Point& origin, double yaw) {
  RosMap map;
  map.origin = origin;
  map.yaw = yaw;
  return map;
}

/// Compares two results piece by piece; `turn` takes points of one to those of the other.
template <class Turn>
void check_turned(const json& flat, const json& turned, double yaw, Turn turn) {
  REQUIRE(flat["status"] == "success");
  REQUIRE(turned["status"] == "success");
  CHECK(turned["metrics"]["length"].get<double>() ==
        Approx(flat["metrics"]["length"].get<double>()).epsilon(1e-9));
  CHECK(turned["certificate"]["lower"].get<double>() ==
        Approx(flat["certificate"]["lower"].get<double>()).margin(1e-9));
  for (const char* curve : {"route", "curve"}) {
    REQUIRE(flat[curve].size() == turned[curve].size());
    for (std::size_t i = 0; i < flat[curve].size(); ++i) {
      const json &a = flat[curve][i], &b = turned[curve][i];
      REQUIRE(a["type"] == b["type"]);
      for (std::size_t k = 0; k < a["points"].size(); ++k) {
        CHECK(distance(turn(point_of(a["points"][k])), point_of(b["points"][k])) < 1e-9);
      }
      if (a.contains("center")) {
        CHECK(distance(turn(point_of(a["center"])), point_of(b["center"])) < 1e-9);
        const double angle = b["start_angle"].get<double>() - a["start_angle"].get<double>();
        CHECK(std::remainder(angle - yaw, 8 * std::atan(1)) == Approx(0).margin(1e-9));
      }
      if (a.contains("heading")) {
        const double angle = b["heading"].get<double>() - a["heading"].get<double>();
        CHECK(std::remainder(angle - yaw, 8 * std::atan(1)) == Approx(0).margin(1e-9));
      }
    }
  }
}

TEST_CASE("a turned ROS map has the plans of the map that is not turned, in its own frame") {
  const RosFolder folder;
  folder.write("room.pgm", room_image());
  folder.write("flat.yaml", yaml_of("room.pgm", "[-21.2, -14.9, 0]"));
  folder.write("turned.yaml", yaml_of("room.pgm", "[-21.2, -14.9, 1.56]"));
  const Point origin{-21.2, -14.9};
  const RosMap flat = frame_with(origin, 0), turned = frame_with(origin, 1.56);
  const auto turn = [&](const Point& p) { return to_map_frame(turned, to_grid_frame(flat, p)); };
  const Point start{-20.93, -14.71}, goals[] = {{-19.41, -13.52}, {-20.05, -14.6}};
  const auto task = [&](const char* map, auto place) {
    return std::string("--grid ").append(map) + " --start=" + text_of(place(start)) +
           " --goal=" + text_of(place(goals[0])) + " --goal=" + text_of(place(goals[1])) + " ";
  };
  const auto as_it_is = [](const Point& p) { return p; };
  for (const std::string algorithms :
       {"--search astar,jps,theta_star --smoother none,taut_string,delta --radius 0.07",
        "--search astar --smoother clothoid,b_spline,bezier --radius 0.06",
        "--search rea_star,any_angle --smoother string_pull,none", "--search jps --buffer 1"}) {
    CAPTURE(algorithms);
    const json a = folder.results_of(task("flat.yaml", as_it_is) + algorithms);
    const json b = folder.results_of(task("turned.yaml", turn) + algorithms);
    REQUIRE(a["results"].size() == b["results"].size());
    for (std::size_t i = 0; i < a["results"].size(); ++i) {
      CAPTURE(i);
      const json& result = b["results"][i];
      CHECK(point_of(result["start"]) == turn(start));
      CHECK(point_of(result["goal"]) == turn(goals[i % 2]));
      CHECK(point_of(result["curve"].front()["points"].front()) == turn(start));
      CHECK(point_of(result["curve"].back()["points"].back()) == turn(goals[i % 2]));
      const Point nearest = to_grid_frame(turned, point_of(result["certificate"]["point"]));
      CHECK(Box{{0, 0}, {2, 1.6}}.contains(nearest));
      check_turned(a["results"][i], result, 1.56, turn);
    }
  }
}

TEST_CASE("headings and gears of a vehicle on a turned ROS map are those of its frame") {
  const RosFolder folder;
  folder.write("room.pgm", room_image());
  folder.write("flat.yaml", yaml_of("room.pgm", "[-21.2, -14.9, 0]"));
  folder.write("turned.yaml", yaml_of("room.pgm", "[-21.2, -14.9, 1.5707963267948966]"));
  const double yaw = std::atan(1) * 2;
  const RosMap flat = frame_with({-21.2, -14.9}, 0), turned = frame_with({-21.2, -14.9}, yaw);
  const auto turn = [&](const Point& p) { return to_map_frame(turned, to_grid_frame(flat, p)); };
  const auto results = [&](const char* map, const Point& start, const char* heading,
                           const Point& goal, const char* goal_heading, const char* smoother) {
    return folder.results_of(std::string("--grid ") + map + " --start=" + text_of(start) + "," +
                             heading + " --goal=" + text_of(goal) + "," + goal_heading +
                             " --reverse --turning-radius 0.2 --footprint disc:0.04 --smoother " +
                             smoother)["results"][0];
  };
  const Point start{-20.93, -14.71}, goal{-20.05, -13.8};
  // A shortcut may divide the same curve into other pieces.
  for (const char* smoother : {"none", "vehicle_shortcut"}) {
    const json flat_length =
        results("flat.yaml", start, "45", goal, "180", smoother)["metrics"]["length"];
    const json turned_length = results("turned.yaml", turn(start), "135", turn(goal), "-90",
                                       smoother)["metrics"]["length"];
    CHECK(flat_length.get<double>() == Approx(turned_length.get<double>()).epsilon(1e-9));
  }
  const json a = results("flat.yaml", start, "45", goal, "180", "none");
  const json b = results("turned.yaml", turn(start), "135", turn(goal), "-90", "none");
  REQUIRE(a["curve"].size() == b["curve"].size());
  for (std::size_t i = 0; i < a["curve"].size(); ++i) {
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const Point there = turn(point_of(a["curve"][i]["points"][end]));
      CHECK(distance(there, point_of(b["curve"][i]["points"][end])) < 1e-9);
    }
  }
  CHECK(a["gears"] == b["gears"]);
  CHECK(a["vehicle"] == b["vehicle"]);
  for (const char* heading : {"start_heading", "goal_heading"}) {
    const double angle = b[heading].get<double>() - a[heading].get<double>();
    CHECK(std::remainder(angle - yaw, 8 * std::atan(1)) == Approx(0).margin(1e-9));
  }
  CHECK(b["start_heading"].get<double>() == Approx(3 * std::atan(1)));
  CHECK(b["goal_heading"].get<double>() == Approx(-2 * std::atan(1)));
}

TEST_CASE("tables, pictures, traces and failures of a turned ROS map are in its frame") {
  const RosFolder folder;
  folder.write("room.pgm", room_image());
  folder.write("turned.yaml", yaml_of("room.pgm", "[10, 20, 1.5707963267948966]"));
  // A quarter turn: x of the grid is y of the map, and y of the grid is -x of the map.
  const std::string task = "--grid turned.yaml --start 9.8,20.3 --goal 8.7,21.7 ";
  const Outcome shown =
      folder.run(task +
                 "--search rea_star --buffer 1 --svg p.svg --show visited,passages,profile "
                 "--trace t.jsonl");
  INFO(shown.err);
  REQUIRE(shown.code == 0);
  CHECK(has_part(shown.out, "start (9.8, 20.3)"));
  CHECK(has_part(shown.out, "turned by 1.5707963267948966 rad about its origin (10, 20)"));
  CHECK(has_part(shown.out, "\n(8.7, 21.7) "));
  CHECK(has_part(folder.read("p.svg"), "</svg>"));
  std::istringstream trace(folder.read("t.jsonl"));
  std::size_t rectangles = 0;
  for (std::string line; std::getline(trace, line);) {
    const json event = json::parse(line);
    if (event["event"] != "rectangle") continue;
    ++rectangles;
    for (const char* corner : {"min", "max"}) {
      const Point p = point_of(event[corner]);
      CHECK((8.4 <= p.x() && p.x() <= 10 && 20 <= p.y() && p.y() <= 22));
    }
  }
  CHECK(rectangles > 0);
  const Outcome outside = folder.run("--grid turned.yaml --start 10.2,20.3 --goal 8.7,21.7");
  CHECK(outside.code == 1);
  CHECK(has_part(outside.out, "start (10.2, 20.3) lies outside the bounds"));
  const Outcome blocked =
      folder.run("--grid turned.yaml --start 9.99,20.3 --goal 8.7,21.7 --radius 0.1 --json r.json");
  CHECK(blocked.code == 1);
  const json result = json::parse(folder.read("r.json"))["results"][0];
  CHECK(result["status"] == "start_blocked");
  CHECK(has_part(blocked.out, "start (9.99, 20.3) lies in"));
  CHECK(has_part(blocked.out, "the nearest safe point is (9.8"));
  CHECK(distance(point_of(result["nearest_safe_point"]), {9.85, 20.3}) < 0.03);
}

TEST_CASE("the frame of a ROS map is printed as map_server publishes it") {
  const RosFolder folder;
  folder.write("room.pgm", room_image());
  struct Frame {
    const char* origin;
    double x, y, yaw;
  };
  for (const auto& [text, x, y, yaw] : {Frame{"[-21.2, -14.9, 0]", -21.2, -14.9, 0},
                                        {"[-21.2, -14.9, 1.56]", -21.2, -14.9, 1.56},
                                        {"[0.1, +3e2, -2.5]", 0.1, 300, -2.5},
                                        {"[1, 2, -nan]", 1, 2, 0},
                                        {"[1, 2, 7]", 1, 2, 7}}) {
    CAPTURE(text);
    folder.write("room.yaml", yaml_of("room.pgm", text));
    const RosMap frame = frame_with({x, y}, yaw);
    const std::string task =
        "--grid room.yaml --start=" + text_of(to_map_frame(frame, {0.2, 0.2})) +
        " --goal=" + text_of(to_map_frame(frame, {1.7, 0.2}));
    const json map = folder.results_of(task)["map"];
    CHECK(map["origin"] == json{x, y});
    // The message has the yaw as a quaternion and the resolution in single precision.
    CHECK(std::sin(map["yaw"].get<double>() / 2) == std::sin(yaw / 2));
    CHECK(std::cos(map["yaw"].get<double>() / 2) == std::cos(yaw / 2));
    CHECK(map["yaw"].get<double>() == yaw);
    CHECK(map["resolution"].get<float>() == 0.05F);
    CHECK(map["width"] == 40);
    CHECK(map["height"] == 32);
  }
}

TEST_CASE("unknown cells of a ROS map are blocked, free, or cost a multiple of their length") {
  const RosFolder folder;
  // A corridor of unknown cells, straight ahead, and a detour of 8 more steps round a wall.
  folder.write("a.pgm",
               "P2 7 6 255\n254 254 254 254 254 254 254\n254 0 0 0 0 0 254\n254 0 0 0 0 0 254\n"
               "254 0 0 0 0 0 254\n254 0 0 0 0 0 254\n254 205 205 205 205 205 254\n");
  folder.write("a.yaml",
               "image: a.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n"
               "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const std::string task = "--grid a.yaml --start 0.5,0.5 --goal 6.5,0.5 --smoother none ";
  const auto length = [&](const std::string& options) {
    return folder.results_of(task + options)["results"][0]["metrics"]["length"].get<double>();
  };
  CHECK(length("") == Approx(16));
  CHECK(length("--unknown blocked") == Approx(16));
  CHECK(length("--unknown free") == Approx(6));
  for (const std::string search :
       {"", "--search astar", "--search dijkstra", "--search astar:heuristic=euclidean"}) {
    CAPTURE(search);
    // The straight way costs 6 steps, of which 5 are unknown: 1 + 5 N.
    CHECK(length(search + " --unknown cost:1") == Approx(6));
    CHECK(length(search + " --unknown cost:2.9") == Approx(6));
    CHECK(length(search + " --unknown cost:3.1") == Approx(16));
    CHECK(length(search + " --unknown cost:8.96") == Approx(16));
  }
  const Outcome smoothed =
      folder.run("--grid a.yaml --start 0.5,0.5 --goal 6.5,0.5 --unknown cost:5");
  CHECK(smoothed.code == 0);
  CHECK(has_part(smoothed.err, "smoothers know no costs, and clothoid may lead through unknown"));
}

TEST_CASE("what is wrong with a ROS map is one line that names the option that helps") {
  const RosFolder folder;
  folder.write("a.pgm", "P2 3 2 255 254 0 254 254 205 254\n");
  folder.write("a.yaml", yaml_of("a.pgm", "[-1, 2, 0]"));
  const std::string task = "--grid a.yaml --start=-0.975,2.025 --goal=-0.875,2.025 ";
  const Outcome blocked = folder.run(task);
  CHECK(blocked.code == 1);
  CHECK(blocked.err ==
        "tutavia-plan: a.yaml: 1 unknown cells are blocked; --unknown free or cost:N "
        "lets paths cross them\n");
  CHECK(folder.run(task + "--unknown free").code == 0);
  folder.write("free.yaml", "image: a.pgm\nresolution: 0.05\norigin: [-1, 2, 0]\n");
  const Outcome wide = folder.run("--grid free.yaml --start=-0.975,2.025 --goal=-0.875,2.025");
  CHECK(wide.code == 0);
  CHECK(has_part(wide.err, "tutavia-plan: free.yaml: the key free_thresh is missing: 0.25 is"));
  CHECK(has_part(wide.err, "grey 205, which map_saver writes for unknown cells, counts as free"));
  folder.write("bad.yaml", "image: a.pgm\nresolution: five\n");
  for (const auto& [arguments, message] : std::vector<std::pair<std::string, std::string>>{
           {"--grid bad.yaml",
            "bad.yaml: line 2: expected resolution: a number above 0, found five"},
           {"--grid none.yaml", "none.yaml: cannot be read"},
           {"--grid a.pgm", "a.pgm: give the .yaml file that names this image"},
           {"--grid a.yaml --unknown cost:0.5",
            "--unknown cost:N: expected N from 1 to 8.96, got \"cost:0.5\""},
           {"--grid a.yaml --unknown cost:nan",
            "--unknown cost:N: expected N from 1 to 8.96, got \"cost:nan\""},
           {"--grid a.yaml --unknown maybe",
            "--unknown: expected blocked, free or cost:N, got \"maybe\""},
           {"--grid a.yaml --unknown cost:2 --search jps",
            "--unknown cost:2: jps takes no costs of cells; give --search auto, astar or dijkstra"},
           {"--grid a.yaml --unknown cost:2 --compare",
            "--unknown cost:2: --compare runs searches that take no costs"},
           {"--map maze --unknown free", "--unknown is for ROS maps (--grid FILE.yaml)"}}) {
    CAPTURE(arguments);
    const Outcome refused = folder.run(arguments + " --start 0,0 --goal 1,1");
    CHECK(refused.code == 2);
    CHECK(refused.err == "tutavia-plan: " + message + "\n");
  }
}

}  // namespace
