// SPDX-License-Identifier: MIT
/// \file
/// The command line of tutavia-plan, run as a user runs it.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/program_folder.hpp"

namespace {

namespace fs = std::filesystem;

using tutavia::test::Outcome;

std::string read(const fs::path& path) { return tutavia::test::file_text(path); }

struct Folder : tutavia::test::ProgramFolder {
  Folder() : ProgramFolder("tutavia_plan", TUTAVIA_PLAN) {}
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// The columns of the comparison of smoothers, after the name.
enum Column : std::size_t {
  planned,
  length_m,
  over_taut,
  max_curvature,
  angle,
  joint,
  min_clearance,
  mean_clearance,
  travel_s,
  micros,
  proofs
};

/// The rows of the comparison of smoothers, which is the last table: the figures by the name.
std::map<std::string, std::vector<std::string>> comparison_rows(const std::string& out) {
  std::map<std::string, std::vector<std::string>> rows;
  std::istringstream table(out.substr(std::min(out.find("\nsmoother "), out.size() - 1) + 1));
  std::string line;
  for (std::getline(table, line); std::getline(table, line) && !line.empty();) {
    std::istringstream fields(line);
    std::string name, field;
    fields >> name;
    while (fields >> field) rows[name].push_back(field);
  }
  return rows;
}

TEST_CASE("a trace holds every step of the searches, a line of JSON for each") {
  Folder folder;
  const std::string task = "--map maze --goal 14,6 --search astar,rea_star,rrt --smoother none ";
  const Outcome outcome = folder.run(task + "--json r.json --trace t.jsonl");
  REQUIRE(outcome.code == 0);
  const auto results = nlohmann::json::parse(read(folder / "r.json"))["results"];
  std::map<std::string, std::map<std::string, std::size_t>> counts;
  std::string search, line;
  std::istringstream lines(read(folder / "t.jsonl"));
  while (std::getline(lines, line)) {
    const auto json = nlohmann::json::parse(line);
    const auto event = json["event"].get<std::string>();
    if (event == "search") {
      search = json["search"].get<std::string>();
      CHECK(json["goal"] == nlohmann::json{14.0, 6.0});
    }
    ++counts[search][event];
  }
  REQUIRE(counts.size() == 3);
  for (const auto& result : results) {
    const auto& events = counts[result["search"].get<std::string>()];
    CHECK(events.at("search") == 1);
    if (result["search"] == "rrt") continue;  // it counts tries, most of which add no node
    CHECK(events.at("expanded") == result["stats"]["expanded"].get<std::size_t>());
  }
  CHECK(counts["rea_star"]["rectangle"] == counts["rea_star"]["expanded"]);
  CHECK(counts["rrt"]["edge"] == counts["rrt"]["generated"]);
  CHECK(folder.run(task + "--trace no_folder/t.jsonl").code == 2);
}

TEST_CASE("a trace for Posthoc holds one search") {
  Folder folder;
  const std::string task = "--map maze --search astar ";
  REQUIRE(folder.run(task + "--goal 14,6 --trace t.trace.json").code == 0);
  const auto trace = nlohmann::json::parse(read(folder / "t.trace.json"));
  CHECK(trace["version"] == "1.4.0");
  CHECK(trace["events"].size() > 1000);
  const Outcome many = folder.run(task + "--trace t.trace.json");
  CHECK(many.code == 2);
  CHECK(contains(many.err, "--trace: a .trace.json file holds one search"));
}

TEST_CASE("a trace has every search once, and of a query that fails nothing but that") {
  Folder folder;
  // The second goal lies in an obstacle: what the tree of the first was is not told again.
  const std::string goals = "--map array --goal 6,8.3 --goal 2.5,4 ";
  const Outcome outcome =
      folder.run(goals + "--search rrt --smoother none,shortcut --trace t.jsonl");
  CHECK(outcome.code == 1);
  std::vector<std::string> lines;
  std::istringstream text(read(folder / "t.jsonl"));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  std::size_t searches = 0;
  for (const std::string& line : lines) searches += contains(line, "\"event\":\"search\"") ? 1 : 0;
  CHECK(searches == 2);
  CHECK(contains(lines.back(), "\"status\":\"goal_blocked\""));
  REQUIRE(folder.run("--map array --compare --search rrt --svg with.svg --trace c.jsonl").code ==
          0);
  REQUIRE(folder.run("--map array --compare --search rrt --svg without.svg").code == 0);
  CHECK(read(folder / "with.svg") == read(folder / "without.svg"));
}

TEST_CASE("without options tutavia-plan plans the maze and writes maze.svg") {
  const Folder folder;
  const Outcome outcome = folder.run("");
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "search auto, smoother clothoid"));
  for (const char* goal : {"(14.5, 14.5)", "(7, 14)", "(14, 6)", "(2, 14)"}) {
    CHECK(contains(outcome.out, goal));
  }
  CHECK(contains(read(folder / "maze.svg"), "</svg>"));
  CHECK(folder.files() == 1);
}

TEST_CASE("every built-in map is planned with proof, and the result file says so") {
  const Folder folder;
  for (const char* map : {"array", "complex", "maze"}) {
    const Outcome outcome = folder.run(std::string("--json - --map ") + map);
    CHECK(outcome.code == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json["tutavia"] == 1);
    REQUIRE(json["results"].size() == 4);
    for (const auto& result : json["results"]) {
      CHECK(result["status"] == "success");
      CHECK(result["certificate"]["status"] == "proved");
      CHECK(result["certificate"]["lower"] >= 0.3);
    }
  }
  CHECK(folder.files() == 0);
}

TEST_CASE("lists of algorithms run in every combination, comparison runs them all") {
  const Folder folder;
  const Outcome lists =
      folder.run("--search dijkstra,astar --smoother none,shortcut --goal 14,6 --json r.json");
  CHECK(lists.code == 0);
  CHECK(nlohmann::json::parse(read(folder / "r.json"))["results"].size() == 4);
  const Outcome names = folder.run("--list");
  CHECK(names.code == 0);
  CHECK(contains(names.out, "search: auto dijkstra astar"));
  CHECK(contains(names.out, "smoother: none shortcut "));
  CHECK(contains(names.out, " delta bezier "));
  const Outcome comparison = folder.run("--compare --map array");
  CHECK(comparison.code == 0);
  CHECK(contains(comparison.out, "all searches, smoother clothoid"));
  CHECK(contains(comparison.out, "all smoothers, search auto"));
}

TEST_CASE("A+B names a pipeline, whose first smoother is followed by the next") {
  const Folder folder;
  const Outcome outcome = folder.run(
      "--goal 14,6 --json r.json"
      " --smoother none,taut_string,none+taut_string,redundant_node_removal+taut_string+none");
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "search auto, smoother none+taut_string;"));
  const auto results = nlohmann::json::parse(read(folder / "r.json"))["results"];
  REQUIRE(results.size() == 4);
  CHECK(results[2]["smoother"] == "none+taut_string");
  CHECK(results[3]["smoother"] == "redundant_node_removal+taut_string+none");
  CHECK(results[2]["curve"] == results[1]["curve"]);
  CHECK(results[3]["curve"] != results[0]["curve"]);
  for (const auto& result : results) CHECK(result["fell_back"] == false);

  // The other way round the string is asked to pull a curve, which it refuses.
  const Outcome refused = folder.run("--goal 14,6 --smoother bezier+taut_string");
  CHECK(refused.code == 0);
  CHECK(contains(refused.out, "fell back to the route"));

  CHECK(contains(folder.run("--list").out, "A+B"));
  CHECK(contains(folder.run("--help").out, "A+B"));
}

TEST_CASE("with --compare all smoothers are set against the taut strings of the same routes") {
  const Folder folder;
  for (const std::string map : {"array", "complex", "maze"}) {
    const Outcome outcome = folder.run("--compare --json r.json --svg p.svg --map " + map);
    REQUIRE(outcome.code == 0);
    CHECK(contains(read(folder / "p.svg"), "</svg>"));
    const auto rows = comparison_rows(outcome.out);
    REQUIRE(rows.size() >= 9);
    for (const auto& [smoother, figures] : rows) {
      INFO(map << ", " << smoother);
      REQUIRE(figures.size() >= 12);
      CHECK(figures[planned] == "4/4");
      // Only what may go over to the other side of an obstacle can be shorter.
      if (smoother != "homotopy_refine") CHECK(std::stod(figures[over_taut]) >= 0.999);
      CHECK(std::stod(figures.back()) >= 0.9999);  // never than the optimum
      CHECK(std::stod(figures[min_clearance]) >= 0.3);
      CHECK(std::stod(figures[mean_clearance]) > std::stod(figures[min_clearance]));
      // At 1 m/s, from rest and to rest at 0.5 m/s^2.
      CHECK(std::stod(figures[travel_s]) >= std::stod(figures[length_m]) + 4 * 2 - 0.01);
      CHECK(std::stoul(figures[proofs]) > 0);
    }
    CHECK(rows.at("taut_string")[over_taut] == "1.0000");
    CHECK(std::stod(rows.at("none")[over_taut]) > 1.01);
    // Stops at corners take time.
    CHECK(std::stod(rows.at("none")[travel_s]) > 1.2 * std::stod(rows.at("taut_string")[travel_s]));
    CHECK(rows.at("none")[max_curvature] == "0.0000");
    CHECK(std::stod(rows.at("none")[joint]) >= 45);
    CHECK(rows.at("taut_string")[max_curvature] == "3.3333");  // one over the safety radius
    CHECK(rows.at("taut_string")[joint] == "0.00");
    CHECK(std::stod(rows.at("taut_string")[micros]) > 0);

    // The results of the smoothers come last in the file, goal by goal.
    const auto results = nlohmann::json::parse(read(folder / "r.json"))["results"];
    const std::size_t first = results.size() - 4 * rows.size();
    for (std::size_t i = first; i < results.size(); i += 4) {
      const auto& figures = rows.at(results[i]["smoother"].get<std::string>());
      double length = 0, curvature = 0, deflection = 0, mean = 0;
      for (std::size_t goal = 0; goal < 4; ++goal) {
        const auto& result = results[i + goal];
        const auto& metrics = result["metrics"];
        CHECK(result["search"] == "auto");
        CHECK(result["found_by"] == "astar");
        CHECK(result["route"] == results[first + goal]["route"]);
        length += metrics["length"].get<double>();
        curvature = std::max(curvature, metrics["max_curvature"].get<double>());
        deflection = std::max(deflection, metrics["max_joint_deflection"].get<double>());
        mean += metrics["mean_clearance"].get<double>() / 4;
      }
      CHECK(std::stod(figures[length_m]) == Approx(length).margin(1e-4));
      CHECK(std::stod(figures[max_curvature]) == Approx(curvature).margin(1e-4));
      CHECK(std::stod(figures[joint]) == Approx(deflection * 180 / std::numbers::pi).margin(0.01));
      CHECK(std::stod(figures[mean_clearance]) == Approx(mean).margin(1e-4));
    }
  }
}

TEST_CASE("with --compare one sees what falls back, what has no plan and the pipeline asked for") {
  const Folder folder;
  const Outcome pipeline = folder.run("--compare --smoother bezier+taut_string");
  CHECK(pipeline.code == 0);
  const auto rows = comparison_rows(pipeline.out);
  REQUIRE(rows.count("bezier+taut_string") == 1);
  CHECK(rows.at("bezier+taut_string")[length_m] == rows.at("none")[length_m]);
  CHECK(contains(pipeline.out, "(4 fell back to the route)"));

  const Outcome partly = folder.run("--compare --goal 14,6 --goal 9,3");
  CHECK(partly.code == 1);
  CHECK(comparison_rows(partly.out).at("taut_string")[planned] == "1/2");
  CHECK(comparison_rows(partly.out).at("taut_string")[over_taut] == "1.0000");
  const Outcome none = folder.run("--compare --goal 9,3");
  CHECK(none.code == 1);
  CHECK(comparison_rows(none.out).at("delta") == std::vector<std::string>{"0/1"});
  const Outcome nowhere = folder.run("--compare --goal 2,1");  // the start
  CHECK(nowhere.code == 0);
  CHECK(comparison_rows(nowhere.out).at("delta")[over_taut] == "1.0000");
  CHECK_FALSE(contains(nowhere.out, "nan"));
}

TEST_CASE("a goal without a plan gives exit code 1 and stands in the table and the JSON") {
  const Folder folder;
  const Outcome outcome = folder.run("--goal 14,6 --goal 9,3 --json r.json --svg p.svg");
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.out, "goal_blocked"));
  const auto json = nlohmann::json::parse(read(folder / "r.json"));
  CHECK(json["results"][0]["status"] == "success");
  CHECK(json["results"][1]["status"] == "goal_blocked");
  CHECK(contains(read(folder / "p.svg"), "</svg>"));
  CHECK(folder.run("--start 9,3").code == 1);
  CHECK(contains(folder.run("--goal 17,3").out, "goal_out_of_bounds"));
  CHECK(contains(folder.run("--goal=-1,3").out, "goal_out_of_bounds"));
  CHECK(contains(folder.run("--goal 14,6 --time-limit 0").out, "budget_exhausted"));
  const fs::path closed = folder.write("closed.json", R"({"bounds":[0,0,4,4],"safety_radius":0.1,
      "start":[1,1],"goals":[[3,3]],"obstacles":[{"polygon":[[2,0],[2.2,0],[2.2,4],[2,4]]}]})");
  const Outcome unreachable = folder.run("--workspace closed.json");
  CHECK(unreachable.code == 1);
  CHECK(contains(unreachable.out, "unreachable: no path among the obstacles"));
  CHECK(contains(folder.run("--workspace closed.json --search astar").out,
                 "unreachable_at_resolution: no path on the grid at resolution 0.02 m"));
}

TEST_CASE("a path that the lattice misses is found by default, and named as the remedy else") {
  const Folder folder;
  folder.write("slot.json", R"({"bounds":[0,0,6,4],"safety_radius":0.3,"resolution":0.25,
      "start":[1,1],"goals":[[5,1]],"obstacles":[
      {"polygon":[[3,0],[3.2,0],[3.2,1.7],[3,1.7]]},
      {"polygon":[[3,2.32],[3.2,2.32],[3.2,4],[3,4]]}]})");
  const Outcome plan = folder.run("--workspace slot.json --json r.json");
  CHECK(plan.code == 0);
  CHECK(contains(plan.out, "  by tangent_graph"));
  const auto json = nlohmann::json::parse(read(folder / "r.json"));
  CHECK(json["results"][0]["search"] == "auto");
  CHECK(json["results"][0]["found_by"] == "tangent_graph");
  CHECK(json["results"][0]["optimum"]["ratio"].get<double>() == Approx(1).epsilon(0.02));
  const Outcome none = folder.run("--workspace slot.json --search astar");
  CHECK(none.code == 1);
  CHECK(contains(none.out, "unreachable_at_resolution"));
  CHECK(contains(none.out, "--search auto finds a path of 4.50"));
  CHECK(contains(none.out, " m, --resolution 0.0"));
}

TEST_CASE("bad usage and bad input give exit code 2 and one line that says what and where") {
  const Folder folder;
  const std::string open = R"({"bounds":[0,0,4,4],"safety_radius":0.1,"obstacles":[])";
  folder.write("no_goal.json", open + R"(,"start":[1,1]})");
  folder.write("no_start.json", open + R"(,"goals":[[1,1]]})");
  folder.write("malformed.json", "{\n  \"bounds\": [0, 0 4, 4]\n}");
  folder.write("negative.json", R"({"bounds":[0,0,4,4],"safety_radius":-1,"obstacles":[]})");
  folder.write("infinite.json",
               R"({"bounds":[0,0,4,4],"safety_radius":1,"obstacles":[{"polygon":[[0,1e999]]}]})");
  const std::size_t files = folder.files();
  struct Case {
    std::string arguments, expected;
  };
  for (const Case& bad : {
           Case{"--workspace no_goal.json", "no goal"},
           Case{"--workspace no_start.json", "no start"},
           Case{"--workspace malformed.json", "malformed.json: line 2, column 19: syntax error"},
           Case{"--workspace negative.json", "safety_radius must not be negative"},
           Case{"--workspace infinite.json", "1e999"},
           Case{"--workspace missing.json", "missing.json: cannot be read"},
           Case{"--radius -0.1", "safety_radius"},
           Case{"--radius nan", "safety_radius"},
           Case{"--resolution 0", "resolution must be positive"},
           Case{"--resolution nan", "resolution must be positive"},
           Case{"--resolution 1e-7", "160000001 x 160000001 cells needed"},
           Case{"--goal 1", "--goal: expected X,Y"},
           Case{"--goal 1,nan", "--goal: expected X,Y"},
           Case{"--goal inf,1", "--goal: expected X,Y"},
           Case{"--start 1,2,3,4", "--start: expected X,Y"},
           Case{"--map castle", "unknown map \"castle\""},
           Case{"--search dstar", "unknown name \"dstar\""},
           Case{"--smoother delta,silk", "unknown name \"silk\""},
           Case{"--smoother taut_string+silk", "unknown name \"silk\"; known: none shortcut"},
           Case{"--smoother none,silk+bezier", "unknown name \"silk\""},
           Case{"--smoother taut_string+", "unknown name \"\""},
           Case{"--smoother +bezier", "unknown name \"\""},
           Case{"--smoother none++bezier", "unknown name \"\""},
           Case{"--search astar+jps", "unknown name \"astar+jps\""},
           Case{"--smoother ''", "unknown name \"\""},
           Case{"--colour red", "--colour"},
           Case{"--map maze --workspace no_goal.json", "--map"},
           Case{"--time-limit -1", "--time-limit"},
           Case{"--seed x", "x"},
           Case{"--svg no_folder/maze.svg", "no_folder/maze.svg: No such file"},
           Case{"--json no_folder/maze.json", "no_folder/maze.json: No such file"},
           Case{"--compare --search astar,dijkstra", "--compare"},
       }) {
    INFO("tutavia-plan " << bad.arguments);
    const Outcome outcome = folder.run(bad.arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, bad.expected));
    CHECK(lines(outcome.err) == 1);
    CHECK(folder.files() == files);
  }
}

TEST_CASE("WKT and GeoJSON files are planned in, with what they lack given as options") {
  const Folder folder;
  folder.write("wall.wkt", "# a wall\nPOLYGON((4 0,5 0,5 4,4 4,4 4))\n");
  folder.write("wall.geojson", R"({"type":"Polygon","coordinates":[[[4,0],[5,0],[5,4],[4,4]]],
      "safety_radius":0.3,"start":[1,2],"goals":[[8,2]]})");
  const Outcome wkt = folder.run("--workspace wall.wkt --start 1,2 --goal 8,2 --radius 0.3");
  CHECK(wkt.code == 0);
  CHECK(contains(wkt.out, "1 repeated points removed"));
  CHECK(folder.run("--workspace wall.geojson --bounds 0,-1,9,5").code == 0);
  CHECK(folder.run("--workspace wall.geojson --bounds 0,0,9,4").code == 1);
  const Outcome no_radius = folder.run("--workspace wall.wkt --start 1,2 --goal 8,2");
  CHECK(no_radius.code == 2);
  CHECK(contains(no_radius.err, "no safety radius"));
  CHECK(folder.run("--workspace wall.geojson --bounds 0,0,9").code == 2);
  CHECK(contains(folder.run("--workspace wall.shp").err, "unknown kind of file"));
}

TEST_CASE("a column of CSV is planned in, and extensions may be in any case") {
  const Folder folder;
  folder.write("walls.CSV", "id;shape\n1;LINESTRING(5 2,5 8)\n");
  folder.write("wall.Wkt", "LINESTRING(5 2,5 8)");
  const std::string task = " --start 3.5,4 --goal 9,4 --radius 0.3";
  CHECK(folder.run("--workspace walls.CSV --wkt-column shape" + task).code == 0);
  CHECK(folder.run("--workspace wall.Wkt" + task).code == 0);
  const auto complaint = [&](const std::string& options) {
    const Outcome outcome = folder.run(options);
    CHECK(outcome.code == 2);
    CHECK(lines(outcome.err) == 1);
    return outcome.err;
  };
  CHECK(contains(complaint("--workspace walls.CSV" + task), "give --wkt-column NAME"));
  CHECK(contains(complaint("--workspace walls.CSV --wkt-column wkt" + task),
                 "walls.CSV: line 1, column 1: expected a header with a column \"wkt\""));
  CHECK(contains(complaint("--map maze --wkt-column shape"), "--wkt-column is for --workspace"));
}

TEST_CASE("a file without obstacles has bounds round the start and the goals") {
  const Folder folder;
  folder.write("empty.wkt", "POINT EMPTY");
  CHECK(folder.run("--workspace empty.wkt --start 1,2 --goal 8,2 --radius 0.3").code == 0);
  CHECK(folder.run("--workspace empty.wkt --start 1,2 --goal 1,2 --radius 0").code == 0);
  folder.write("far.wkt", "POINT(1 1)\nPOINT(1e300 1)");
  const Outcome far = folder.run("--workspace far.wkt --start 1,2 --goal 8,2 --radius 0.3");
  CHECK(far.code == 2);
  CHECK(contains(far.err, "far.wkt: obstacles[1].center must be finite"));
  folder.write("far.geojson", R"({"type":"Point","coordinates":[1e300,1]})");
  CHECK(contains(folder.run("--workspace far.geojson --start 1,2 --goal 8,2 --radius 0.3").err,
                 "far.geojson: obstacles[0].center must be finite"));
}

TEST_CASE("swamp and water of a MovingAI map are read as --terrain says") {
  const Folder folder;
  folder.write("swamp.MAP", "type octile\nheight 1\nwidth 3\nmap\n.S.\n");
  const std::string task = "--grid swamp.MAP --start 0.5,0.5 --goal 2.5,0.5";
  const Outcome refused = folder.run(task);
  CHECK(refused.code == 2);
  CHECK(contains(refused.err, "found \"S\", which only some neighbours may enter: --terrain says"));
  CHECK(folder.run(task + " --terrain free").code == 0);
  CHECK(folder.run(task + " --terrain blocked").code == 1);
  CHECK(folder.run(task + " --terrain swamp").code == 2);
  CHECK(contains(folder.run("--map maze --terrain free").err, "--terrain is for"));
}

TEST_CASE("a wall of vertices with three ordinates stands where its file says") {
  const Folder folder;
  folder.write("wall.wkt", "LINESTRING(5 2 0,5 8 0)");
  const Outcome plan = folder.run(
      "--workspace wall.wkt --start 3.5,4 --goal 9,4 --radius 0.3 --bounds 0,0,12,12 "
      "--search tangent_graph --smoother none --json wall.json");
  CHECK(plan.code == 0);
  CHECK(contains(plan.err, "wall.wkt: line 1, column 12: ordinates beyond x and y are dropped"));
  CHECK(lines(plan.err) == 1);
  // Round the lower end of the wall, at a distance of 0.3 m from (5, 2).
  const auto result = nlohmann::json::parse(read(folder / "wall.json"))["results"][0];
  CHECK(result["metrics"]["length"].get<double>() == Approx(7.4175).margin(1e-4));
}

TEST_CASE("every row of the input contract can be reached from the command line") {
  const Folder folder;
  const auto world = [&](const std::string& obstacles, const std::string& more = "") {
    folder.write("w.json",
                 R"({"bounds":[0,0,10,10],"safety_radius":0.5,"start":[1,5],"goals":[[9,5]],
        "resolution":0.1,"obstacles":[)" +
                     obstacles + "]" + more + "}");
    return folder.run("--workspace w.json");
  };
  // Read, corrected or kept, and planned around.
  for (const char* obstacles : {
           R"({"polygon":[[4,3],[4,3],[6,3],[6,7],[6,7],[4,7]]})",             // repeated points
           R"({"polygon":[[4,3],[4,7],[6,7],[6,3]]})",                         // clockwise
           R"({"polygon":[[4,3],[6,3],[6,7],[4,7],[4,3]]})",                   // closed
           R"({"polygon":[[5,3],[5,7]]})",                                     // a wall
           R"({"polygon":[[5,5]]})",                                           // a point
           R"({"center":[5,5],"radius":0})",                                   // a point
           R"({"polygon":[[4,3],[6,7],[6,3],[4,7]]})",                         // crosses itself
           R"({"bbox":[4,3,5,7]},{"bbox":[5,3,6,7]},{"bbox":[4.2,4,4.8,6]})",  // touch, nest
           R"({"polygon":[[4,1e-300],[6,3],[6,7]]})",                          // too tiny: refused
       }) {
    INFO(obstacles);
    const Outcome outcome = world(obstacles);
    if (contains(obstacles, "1e-300")) {
      CHECK(outcome.code == 2);
      CHECK(contains(outcome.err, "obstacles[0].polygon[0]"));
    } else {
      CHECK(outcome.code == 0);
      CHECK(contains(outcome.out, "proved"));
    }
  }
  CHECK(folder.run("--workspace w.json").code == 2);
  world(R"({"polygon":[[4,3],[6,7],[6,3],[4,7]]})");
  const Outcome strict = folder.run("--workspace w.json --strict");
  CHECK(strict.code == 2);
  CHECK(contains(strict.err, "obstacles[0] crosses itself"));

  CHECK(contains(world(R"({"polygon":[[1e12,0],[1e12,1],[2e12,0]]})").err, "too large"));
  CHECK(world(R"({"bbox":[1.5,4,2,6]})").code == 0);  // the start is at exactly the radius
  const Outcome blocked = world(R"({"bbox":[1.25,4,2,6]})");
  CHECK(blocked.code == 1);
  CHECK(contains(blocked.out, "start_blocked"));
  CHECK(contains(blocked.out, "nearest safe point is (0.7"));
  world("");
  const Outcome point = folder.run("--workspace w.json --goal 1,5");
  CHECK(point.code == 0);
  CHECK(contains(point.out, "0.0000"));
  CHECK(folder.run("--workspace w.json --resolution 1e-6").code == 2);
}

TEST_CASE("unknown keys of a workspace file are warned of and change nothing") {
  const Folder folder;
  folder.write("scene.json", R"({"bounds":[0,0,4,4],"safety_radius":0.1,"obstacles":[],
      "start":[1,1],"goals":[[3,3]],"colour":"red"})");
  const Outcome outcome = folder.run("--workspace scene.json");
  CHECK(outcome.code == 0);
  CHECK(outcome.err == "tutavia-plan: scene.json: unknown key \"colour\" ignored\n");
  CHECK(contains(outcome.out, "lattice 0.02 m"));
}

TEST_CASE("grid maps are planned on their cells, and bad ones refused with the place") {
  const Folder folder;
  folder.write("room.map",
               "type octile\r\nheight 3\r\nwidth 5 \r\nmap\r\n.....\r\n.@@@.\r\n.....\r\n");
  const std::string task = " --grid room.map --start 0.5,1.5 --goal 4.5,1.5 ";
  const Outcome plain =
      folder.run(task + "--search astar,jps,jps_plus --smoother none --json r.json");
  REQUIRE(plain.code == 0);
  const auto results = nlohmann::json::parse(read(folder / "r.json"))["results"];
  REQUIRE(results.size() == 3);
  // Down one cell, along four and back up: no diagonal may cut the blocked corners.
  for (const auto& result : results) CHECK(result["metrics"]["length"].get<double>() == 6);
  // Pulled taut, around two of those corners, whatever it was pulled from.
  const std::string pulled = "--search any_angle,astar,jps --smoother string_pull --json r.json";
  REQUIRE(folder.run(task + pulled).code == 0);
  const auto taut = nlohmann::json::parse(read(folder / "r.json"));
  for (const auto& result : taut["results"]) {
    CHECK(result["metrics"]["length"].get<double>() == Approx(3 + std::sqrt(2)));
  }
  CHECK(folder.run(task + "--svg room.svg").code == 0);
  CHECK(contains(read(folder / "room.svg"), "<svg"));
  CHECK(folder.run(task + "--radius 0.5").code == 0);  // exactly as wide as the corridor
  CHECK(folder.run(task + "--radius 0.51").code == 1);

  const auto refused = [&](const std::string& arguments, const std::string& part) {
    const Outcome outcome = folder.run(arguments);
    INFO(arguments << ": " << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(lines(outcome.err) == 1);
    CHECK(contains(outcome.err, part));
  };
  folder.write("short.map", "type octile\nheight 3\nwidth 5\nmap\n.....\n");
  folder.write("odd.map", "type octile\nheight 1\nwidth 3\nmap\n.x.\n");
  refused("--grid short.map --start 0.5,0.5 --goal 1.5,0.5", "short.map: line 6");
  refused("--grid odd.map --start 0.5,0.5 --goal 1.5,0.5", "odd.map: line 5");
  refused("--grid none.map --start 0.5,0.5 --goal 1.5,0.5", "none.map");
  refused("--grid room.pdf --start 0.5,0.5 --goal 1.5,0.5", "unknown kind of file");
  refused("--grid room.map --goal 1.5,0.5", "no start");
  refused(task + "--resolution 2", "--grid brings its own resolution");
}

TEST_CASE("algorithms take options, and results say all of them") {
  const Folder folder;
  const Outcome outcome = folder.run(
      "--goal 14,6 --json r.json --search astar:heuristic=euclidean,jps,"
      "rrt_star:max_iterations=2000,goal_bias=0.1"
      " --smoother "
      "delta:join=paper,delta:join=tangent,corner_threshold=0.4,shortcut+bezier:trim=1");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.out, "search astar:heuristic=euclidean, smoother delta:join=paper;"));
  CHECK(contains(outcome.out, "search jps, smoother delta:join=tangent,corner_threshold=0.4;"));
  CHECK(contains(
      outcome.out,
      "search rrt_star:max_iterations=2000,goal_bias=0.1, smoother shortcut+bezier:trim=1;"));
  const auto results = nlohmann::json::parse(read(folder / "r.json"))["results"];
  REQUIRE(results.size() == 9);
  CHECK(results[0]["search"] == "astar");
  CHECK(results[0]["smoother"] == "delta");
  CHECK(results[2]["smoother"] == "shortcut+bezier");
  CHECK(results[0]["options"]["search"] ==
        nlohmann::json{{"heuristic", "euclidean"}, {"successors", "canonical"}});
  CHECK(results[3]["options"]["search"] == nlohmann::json::object());
  const auto tree = results[6]["options"]["search"];
  CHECK(tree.size() == 5);
  CHECK(tree["step"].is_null());
  CHECK(tree["max_iterations"] == 2000);
  CHECK(tree["goal_bias"].get<double>() == 0.1);
  CHECK(tree["neighbours"] == "k_nearest");
  const auto paper = results[0]["options"]["smoother"];
  const auto tangent = results[1]["options"]["smoother"];
  CHECK(paper["join"] == "paper");
  CHECK(tangent["join"] == "tangent");
  CHECK(tangent["corner_threshold"].get<double>() == 0.4);
  CHECK(tangent["min_exterior_angle"].get<double>() == 20 * std::numbers::pi / 180);
  CHECK(results[0]["curve"] != results[1]["curve"]);
  const auto stages = results[2]["options"]["smoother"];
  REQUIRE(stages.size() == 2);
  CHECK(stages[0] == nlohmann::json::object());
  CHECK(stages[1]["trim"] == 1.0);
}

TEST_CASE("options reach the algorithms: a tree of few iterations finds nothing") {
  const Folder folder;
  const Outcome few =
      folder.run("--goal 14,6 --search rrt:max_iterations=3,rrt:max_iterations=20000");
  CHECK(few.code == 1);
  CHECK(contains(few.out, "budget_exhausted"));
  CHECK(contains(few.out, "proved"));
  CHECK(
      folder.run("--goal 14,6 --search jps_plus --smoother clothoid:spirals=cubic_beziers").code ==
      0);
  CHECK(folder.run("--goal 14,6 --smoother delta:corner_threshold=0.05 --svg p.svg").code == 0);
  CHECK(contains(read(folder / "p.svg"), "</svg>"));
}

TEST_CASE("with --compare the chosen options stand beside the defaults") {
  const Folder folder;
  const Outcome outcome = folder.run(
      "--compare --goal 14,6 --search weighted_astar:weight=2 --smoother delta:join=paper");
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "\nweighted_astar "));
  CHECK(contains(outcome.out, "\nweighted_astar:weight=2 "));
  const auto rows = comparison_rows(outcome.out);
  REQUIRE(rows.count("delta") == 1);
  REQUIRE(rows.count("delta:join=paper") == 1);
  CHECK(rows.at("delta")[joint] != rows.at("delta:join=paper")[joint]);
}

TEST_CASE("with --edges paper_strict A* finds the published lengths") {
  const Folder folder;
  const std::string task = "--edges paper_strict --goal 14.5,14.5 --smoother none ";
  const Outcome outcome = folder.run(task + "--search astar,theta_star,jps --json r.json");
  CHECK(outcome.code == 1);
  const auto results = nlohmann::json::parse(read(folder / "r.json")).at("results");
  REQUIRE(results.size() == 3);
  CHECK(results[0].at("metrics").at("length").get<double>() == Approx(22.7782).epsilon(2e-6));
  CHECK(results[1].at("metrics").at("length").get<double>() < 20);
  CHECK(results[2].at("status") == "invalid_option");
  CHECK(folder.run("--edges strict").code == 2);
  CHECK(contains(folder.run("--edges paper_strict --movement allow").err, "by_edge"));
}

TEST_CASE("a trace holds two variants of one search") {
  const Folder folder;
  REQUIRE(folder
              .run("--goal 14,6 --search astar,astar:heuristic=chebyshev --smoother none,shortcut "
                   "--trace t.jsonl")
              .code == 0);
  std::istringstream trace(read(folder / "t.jsonl"));
  std::string line;
  std::size_t searches = 0;
  while (std::getline(trace, line)) searches += contains(line, "\"event\":\"search\"") ? 1 : 0;
  CHECK(searches == 2);
}

TEST_CASE("errors in options give exit code 2 and one line with the option and what it takes") {
  const Folder folder;
  struct Case {
    std::string arguments, expected;
  };
  for (const Case& bad : {
           Case{"--search rrt_star:iteration=5",
                "--search rrt_star: unknown option \"iteration\"; did you mean max_iterations?"},
           Case{"--search rrt_sta:max_iterations=5",
                "--search: unknown name \"rrt_sta\"; did you mean rrt_star?"},
           Case{"--search astar,rrt_sta", "did you mean rrt_star?"},
           Case{"--smoother shortcut+bezir:trim=1", "did you mean bezier?"},
           Case{"--search rrt_star:max_iterations=x",
                "--search rrt_star: max_iterations: expected a whole number from 0 to 4294967295, "
                "got "
                "\"x\""},
           Case{"--search rrt_star:max_iterations=1,max_iterations=2",
                "\"max_iterations\" is given twice"},
           Case{"--smoother delta:join=glue", "join: expected paper or tangent, got \"glue\""},
           Case{"--search rrt_star:", "expected OPTION=VALUE"},
           Case{"--search max_iterations=5",
                "expected NAME:OPTION=VALUE, got \"max_iterations=5\""},
           Case{"--search jps:weight=2", "unknown option \"weight\"; there are none"},
           Case{"--search any_angle", "--search: any_angle works on grid maps alone (--grid)"},
           Case{"--search weighted_astar:weight=0.5",
                "--search weighted_astar:weight=0.5: weight must lie between 1 and 1000"},
           Case{"--smoother shortcut+bezier:fullness=2",
                "--smoother bezier:fullness=2: fullness must lie in (0, 1]"},
           Case{"--compare --smoother bezier:fullness=2", "fullness must lie in (0, 1]"},
           Case{"--serch astar", "unknown option --serch; did you mean --search?"},
           Case{"--movment=allow", "unknown option --movment; did you mean --movement?"},
           Case{"astar", "unexpected argument \"astar\""},
           Case{"--movement diagonal",
                "--movement: expected no_cut, no_squeeze, allow or four_connected, got "
                "\"diagonal\""},
           Case{"--buffer 1", "--buffer is for the cells of --grid; on a workspace give --radius"},
           Case{"--help-rrt_sta", "did you mean rrt_star?"},
           Case{"--help-", "unknown name \"\""},
       }) {
    INFO("tutavia-plan " << bad.arguments);
    const Outcome outcome = folder.run("--goal 14,6 --json r.json " + bad.arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, bad.expected));
    CHECK(lines(outcome.err) == 1);
    CHECK(folder.files() == 0);
  }
}

TEST_CASE("the option --help-NAME prints the options of any algorithm") {
  const Folder folder;
  std::istringstream list(folder.run("--list").out);
  std::string line, name;
  std::size_t names = 0;
  for (int row = 0; row < 8 && std::getline(list, line); ++row) {
    std::istringstream words(line.substr(line.find(':') + 1));
    while (words >> name) {
      const Outcome help = folder.run("--help-" + name);
      INFO(name);
      CHECK(help.code == 0);
      CHECK(help.out.find(name + " (--" + (row < 4 ? "search" : "smoother") + "): ") == 0);
      ++names;
    }
  }
  CHECK(names == 36 + 4);  // of which `none` stands twice
  const Outcome tree = folder.run("--help-rrt_star");
  CHECK(lines(tree.out) == 8);  // the name, how options are given, the head and five options
  CHECK(contains(tree.out, "iterations "));
  CHECK(contains(tree.out, "k_nearest|radius"));
  CHECK(contains(folder.run("--help-delta").out, "paper|tangent"));
  CHECK(contains(folder.run("--help-tangent_graph").out, " inf "));
  CHECK(contains(folder.run("--help-jps").out, "It has no options."));
  CHECK(contains(folder.run("--help").out, "--help-NAME"));
  CHECK(contains(folder.run("--list").out, "--help-NAME"));
}

TEST_CASE("the movement rule holds on lattices and on grid maps") {
  const Folder folder;
  folder.write("step.map", "type octile\nheight 2\nwidth 2\nmap\n.@\n@.\n");
  const auto length = [&](const std::string& arguments) {
    const Outcome outcome = folder.run(arguments + " --smoother none --json r.json");
    INFO(arguments << outcome.err);
    if (outcome.code != 0) return -1.0;
    const auto results = nlohmann::json::parse(read(folder / "r.json"))["results"];
    return results[0]["metrics"]["length"].template get<double>();
  };
  folder.write("room.map", "type octile\nheight 3\nwidth 5\nmap\n.....\n.@@@.\n.....\n");
  const std::string room = "--grid room.map --start 0.5,1.5 --goal 4.5,1.5";
  CHECK(length(room) == 6);
  CHECK(length(room + " --movement no_squeeze") == Approx(2 + 2 * std::sqrt(2)));
  CHECK(length(room + " --movement four_connected") == 6);
  const std::string maze = "--map maze --goal 14,6";
  CHECK(length(maze + " --movement four_connected") > length(maze));
  CHECK(length(maze + " --movement allow") <= length(maze));
  const Outcome refused = folder.run(maze + " --movement allow --search sb_rea_star");
  CHECK(refused.code == 1);
  CHECK(contains(refused.out, "invalid_option"));
}

TEST_CASE("the option --buffer keeps paths off the cells around blocked ones") {
  const Folder folder;
  folder.write("wall.map",
               "type octile\nheight 7\nwidth 7\nmap\n"
               ".......\n.......\n.......\n...@...\n.......\n.......\n.......\n");
  const std::string task = "--grid wall.map --start 0.5,3.5 --goal 6.5,3.5 --json r.json ";
  const auto clearance = [&](const std::string& arguments) {
    const Outcome outcome = folder.run(task + arguments);
    INFO(arguments << outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(outcome.err.empty());
    const auto results = nlohmann::json::parse(read(folder / "r.json"))["results"];
    double farthest = 0;
    for (const auto& piece : results[0]["route"]) {
      for (const auto& point : piece["points"]) {
        farthest = std::max(farthest, std::abs(point[1].get<double>() - 3.5));
      }
    }
    return farthest;
  };
  CHECK(clearance("") == 1);
  CHECK(clearance("--buffer 0") == 1);
  CHECK(clearance("--buffer 1") == 2);
  CHECK(clearance("--buffer 2") == 3);
  CHECK(folder.run(task + "--buffer 3").code == 1);
  CHECK(folder.run(task + "--buffer 1 --svg p.svg").code == 0);
  CHECK(contains(read(folder / "p.svg"), ">safety buffer<"));
  CHECK(folder.run(task + "--svg p.svg").code == 0);
  CHECK_FALSE(contains(read(folder / "p.svg"), ">safety buffer<"));

  // The cell of a goal in the buffer stays free, which is said.
  const Outcome near = folder.run("--grid wall.map --start 0.5,3.5 --goal 4.5,3.5 --buffer 1");
  CHECK(near.code == 0);
  CHECK(near.err ==
        "tutavia-plan: --buffer: cell (4, 3) of the start or a goal lies in the buffer and stays "
        "free\n");
  const Outcome shut = folder.run("--grid wall.map --start 0.5,3.5 --goal 4.5,3.5 --buffer 2");
  CHECK(shut.code == 1);
  CHECK(folder.run(task + "--buffer -1").code == 2);
  CHECK(contains(folder.run(task + "--buffer=-1").err, "--buffer: the width of a safety buffer"));
  CHECK(folder.run(task + "--buffer x").code == 2);
  CHECK(folder.run("--grid wall.map --start 1e300,3.5 --goal 4.5,3.5 --buffer 1").code == 1);
}

TEST_CASE("the option --show chooses what a picture shows of the searches") {
  const Folder folder;
  const auto picture = [&](const std::string& arguments) {
    const Outcome outcome = folder.run(arguments + " --svg p.svg");
    INFO(arguments << ": " << outcome.err);
    CHECK(outcome.code == 0);
    return read(folder / "p.svg");
  };
  const std::string maze = "--map maze --goal 14,6 ";
  const std::string plain = picture(maze);
  CHECK(contains(plain, ">safety zone, 0.3 m<"));
  CHECK_FALSE(contains(plain, ">visited<"));
  CHECK_FALSE(contains(plain, ">curvature [1/m]<"));
  const std::string visited = picture(maze + "--show visited,profile");
  CHECK(contains(visited, ">visited<"));
  CHECK(contains(visited, ">curvature [1/m]<"));
  CHECK_FALSE(contains(visited, ">safety zone, 0.3 m<"));

  const std::string tree = "--map rrt_scene_1 --search safe_rrt_star:max_iterations=800 --seed 5 ";
  const std::string grown = picture(tree + "--smoother b_spline");
  CHECK(contains(grown, ">tree<"));
  CHECK(contains(grown, ">path of the tree, before nodes are removed<"));
  CHECK(contains(grown, ">risk zone, 2 m beyond<"));
  // Two smoothers of one search: its tree is drawn once.
  const auto edges = [](const std::string& svg) {
    std::size_t paths = 0;
    for (std::size_t i = 0; (i = svg.find("#6fa58f", i)) != std::string::npos; ++i) ++paths;
    return std::pair(paths, std::count(svg.begin(), svg.end(), 'L') > 0);
  };
  CHECK(edges(picture(tree + "--smoother none,b_spline")) == edges(grown));
  const std::string bare = picture(tree + "--show profile");
  CHECK_FALSE(contains(bare, ">tree<"));
  CHECK_FALSE(contains(bare, "path of the tree"));
  CHECK_FALSE(contains(bare, "risk zone"));

  const std::string both = picture("--map array --goal 14,8.4 --search sb_rea_star");
  CHECK(contains(both, ">forward rectangle<"));
  CHECK(contains(both, ">backward passage<"));
  CHECK_FALSE(contains(picture("--map array --search sb_rea_star --show tree"), "rectangle<"));
  CHECK(contains(picture(maze + "--compare --show profile"), ">curvature [1/m]<"));
}

TEST_CASE("a --show that no picture can obey is refused") {
  const Folder folder;
  const auto refused = [&](const std::string& arguments, const std::string& message) {
    INFO(arguments);
    const Outcome outcome = folder.run(arguments);
    CHECK(outcome.code == 2);
    CHECK(outcome.err == "tutavia-plan: " + message + "\n");
    CHECK(folder.files() == 0);
  };
  refused("--svg p.svg --show visted", "--show: unknown part \"visted\"; did you mean visited?");
  refused("--svg p.svg --show tree,rainbow",
          "--show: unknown part \"rainbow\"; expected visited, tree, zones, passages, profile or "
          "footprint");
  refused(
      "--svg p.svg --show ''",
      "--show: unknown part \"\"; expected visited, tree, zones, passages, profile or footprint");
  refused("--show zones", "--show is for a picture; give --svg FILE");
  refused(
      "--compare --svg p.svg --show visited",
      "--compare draws curves of many searches; --show takes zones, profile and footprint there");
}

TEST_CASE("the legend calls curves as the user wrote the algorithms, with goal and length") {
  const Folder folder;
  const std::string task = "--map maze --goal 14,6 --search astar,weighted_astar:weight=2 ";
  REQUIRE(folder.run(task + "--smoother none,shortcut+bezier:trim=0.4 --svg p.svg").code == 0);
  const std::string svg = read(folder / "p.svg");
  for (const std::string search : {"astar", "weighted_astar:weight=2"}) {
    for (const std::string smoother : {"none", "shortcut+bezier:trim=0.4"}) {
      INFO(search << ", " << smoother);
      CHECK(contains(svg, ">" + search + ", " + smoother + ", 1"));
    }
  }
  REQUIRE(folder.run("--map array --goal 14,8.4 --goal 10,15.2 --svg p.svg").code == 0);
  CHECK(contains(read(folder / "p.svg"), ">auto, clothoid, to (14, 8.4), 1"));
  CHECK(contains(read(folder / "p.svg"), ">auto, clothoid, to (10, 15.2), 1"));
}

TEST_CASE("a picture shows how the search of one query proceeds, animated or in steps") {
  const Folder folder;
  const std::string task = "--map maze --goal 14,6 --search astar ";
  REQUIRE(folder.run(task + "--animate --svg a.svg").code == 0);
  CHECK(contains(read(folder / "a.svg"), "<animateMotion"));
  CHECK(contains(read(folder / "a.svg"), "#b3d9f5"));  // visited nodes
  REQUIRE(folder.run(task + "--steps 3 --svg s.svg").code == 0);
  CHECK_FALSE(contains(read(folder / "s.svg"), "<animate"));
  CHECK(contains(read(folder / "s.svg"), "width=\"300.00\""));
  for (const auto& [line, error] : {std::pair{"--map maze --steps 3", "--steps: give --svg FILE"},
                                    {"--map maze --animate --svg m.svg", "--animate: give one"},
                                    {"--map maze --steps 1 --svg m.svg", "--steps"},
                                    {"--map maze --steps 3 --show profile --svg m.svg", "profile"},
                                    {"--map maze --steps 3 --animate --svg m.svg", "two pictures"},
                                    {"--compare --animate --svg m.svg", "--compare runs many"}}) {
    const Outcome outcome = folder.run(line);
    INFO(line << ": " << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, error));
  }
}

TEST_CASE("a picture shows how the route of one query is smoothed") {
  const Folder folder;
  const std::string task = "--map maze --goal 14,6 --search astar ";
  REQUIRE(folder.run(task + "--smoother delta --smoothing-steps --show profile --svg d.svg").code ==
          0);
  const std::string delta = read(folder / "d.svg");
  for (const std::string part :
       {"Bezier with control polygon", "end of a piece", "critical corner", "curvature [1/m]"}) {
    INFO(part);
    CHECK(contains(delta, ">" + part + "<"));
  }
  CHECK(contains(delta, ">least clearance, 0.300 m<"));
  folder.write("wall.map", "type octile\nheight 3\nwidth 5\nmap\n.....\n..@..\n..@..\n");
  const std::string cells = "--grid wall.map --start 0.5,2.5 --goal 4.5,2.5 --search jps ";
  REQUIRE(folder.run(cells + "--smoother string_pull --smoothing-steps --svg c.svg").code == 0);
  CHECK(contains(read(folder / "c.svg"), ">least clearance, 0.000 m<"));

  const std::string own = " --smoothing-steps --svg m.svg";
  for (const auto& [line, error] :
       {std::pair{task + "--smoothing-steps", "--smoothing-steps: give --svg FILE"},
        {task + "--smoother none" + own, "--smoothing-steps: --smoother none smooths nothing"},
        {task + "--smoother delta,bezier" + own, "--smoothing-steps: give one --goal"},
        {task + "--steps 3" + own, "--steps and --smoothing-steps are two pictures"},
        {task + "--animate" + own, "--animate and --smoothing-steps are two pictures"},
        {"--compare" + own, "--smoothing-steps: --compare runs many"},
        {task + "--show visited" + own, "--smoothing-steps: it draws no search"}}) {
    const Outcome outcome = folder.run(line);
    INFO(line << ": " << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, error));
  }
}

TEST_CASE("a picture without a plan shows what was searched, where to, and why there is none") {
  const Folder folder;
  folder.write("wall.map", "type octile\nheight 3\nwidth 5\nmap\n..@..\n..@..\n..@..\n");
  const std::string task = "--grid wall.map --start 0.5,0.5 --goal 4.5,2.5 --smoother none ";
  CHECK(folder.run(task + "--search astar,rrt:max_iterations=99 --show visited,tree --svg p.svg")
            .code == 1);
  const std::string svg = read(folder / "p.svg");
  CHECK(contains(svg, ">visited<"));
  CHECK(contains(svg, ">tree<"));
  CHECK(contains(svg, ">goal<"));
  CHECK(contains(svg, ">astar, none: no plan (unreachable_at_resolution)<"));
  CHECK(contains(svg, ">rrt:max_iterations=99, none: no plan (budget_exhausted)<"));
  // Rows run downwards, as in the file: the goal lies in the lower right corner.
  CHECK(contains(svg, "<circle cx=\"736.00\" cy=\"446.00\" r=\"7.00\" fill=\"#7a8794\""));
}

}  // namespace
