// SPDX-License-Identifier: MIT
/// \file
/// tutavia-plan for vehicles, run as a user runs it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/program_folder.hpp"

namespace {

using nlohmann::json;
using tutavia::test::Outcome;

constexpr double right_angle = std::numbers::pi / 2;

/// A folder with an open room in it.
struct VehicleFolder : tutavia::test::ProgramFolder {
  VehicleFolder() : ProgramFolder("tutavia_vehicle", TUTAVIA_PLAN) {
    write("room.json", R"({"bounds":[0,0,12,8],"safety_radius":0.1,"resolution":0.2,
        "start":[2,2],"goals":[[9,2],[9,6]],"obstacles":[{"center":[6,4],"radius":0.5}]})");
  }

  /// The results of a run that has to succeed.
  json results_of(const std::string& arguments) const {
    const Outcome outcome = run(arguments + " --json r.json");
    INFO(arguments << ": " << outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(read("r.json"))["results"];
  }
};

bool shows(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string parking = "--workspace " TUTAVIA_TEST_DATA
                            "/parking.json --start=-8,1.5,0 --goal 0,-4.6,90 --turning-radius 5 "
                            "--reverse --footprint car:4.5,1.8,2.7 ";

TEST_CASE("a car parks backwards into a bay, proved with its whole footprint") {
  const VehicleFolder folder;
  const Outcome outcome = folder.run(parking + "--json r.json");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(shows(outcome.out, "search hybrid_astar, smoother vehicle_shortcut;"));
  CHECK(shows(outcome.out, " ms  cusps\n"));
  const json result = json::parse(folder.read("r.json"))["results"][0];
  CHECK(result["status"] == "success");
  CHECK(result["search"] == "hybrid_astar");
  CHECK(result["smoother"] == "vehicle_shortcut");
  CHECK(result["options"]["search"]["vehicle.min_turning_radius"] == 5.0);
  CHECK(result["options"]["search"]["vehicle.reverse"] == true);
  CHECK(result["certificate"]["status"] == "proved");
  CHECK(result["certificate"]["lower"].get<double>() >= 0.1);
  CHECK(result["metrics"]["max_curvature"].get<double>() <= 0.2 * (1 + 1e-9));
  CHECK(result["start_heading"].get<double>() == Approx(0).margin(1e-9));
  CHECK(result["goal_heading"].get<double>() == Approx(right_angle));
  REQUIRE(result["gears"].size() == result["curve"].size());
  CHECK(result["gears"].front() == "forward");
  CHECK(result["gears"].back() == "reverse");
  CHECK(result["cusps"].size() % 2 == 1);
  const std::string row = outcome.out.substr(outcome.out.find("(0, -4.6)"));
  const std::string cusps = std::to_string(result["cusps"].size());
  CHECK(row.substr(row.find('\n') - 7, 7) == std::string(7 - cusps.size(), ' ') + cusps);
  const json& vehicle = result["vehicle"];
  CHECK(vehicle["min_turning_radius"] == 5.0);
  CHECK(vehicle["reverse"] == true);
  CHECK(vehicle["footprint"].size() > 3);
  // Figures of a point are none of the car.
  CHECK_FALSE(result.contains("optimum"));
  CHECK_FALSE(result["metrics"].contains("mean_clearance"));
}

TEST_CASE("a heading, a turning radius, a footprint and --reverse each mean a vehicle") {
  const VehicleFolder folder;
  struct Case {
    std::string arguments;
    double radius;
    bool reverse;
    std::size_t discs;
  };
  for (const Case& given :
       {Case{"--start 2,2,0", 1, false, 1}, Case{"--goal 9,6,90", 1, false, 1},
        Case{"--turning-radius 2", 2, false, 1}, Case{"--turning-radius 0", 0, false, 1},
        Case{"--reverse", 1, true, 1}, Case{"--footprint disc:0.2", 1, false, 1},
        Case{"--footprint 'discs:0,0,0.3;0.5,0,0.3'", 1, false, 2},
        Case{"--search hybrid_astar", 1, true, 1},
        Case{"--search hybrid_astar --start 2,2,0", 1, false, 1},
        Case{"--search hybrid_astar:vehicle.min_turning_radius=3 --reverse "
             "--footprint disc:0.2",
             3, true, 1}}) {
    INFO(given.arguments);
    for (const json& result : folder.results_of("--workspace room.json " + given.arguments)) {
      CHECK(result["search"] == "hybrid_astar");
      CHECK(result["smoother"] == "vehicle_shortcut");
      CHECK(result["vehicle"]["min_turning_radius"] == given.radius);
      CHECK(result["vehicle"]["reverse"] == given.reverse);
      CHECK(result["vehicle"]["footprint"].size() == given.discs);
      const json& options = result["options"]["search"];
      CHECK(options["vehicle.min_turning_radius"] == given.radius);
      CHECK(options["vehicle.reverse"] == given.reverse);
      CHECK(result["gears"].size() == result["curve"].size());
    }
  }
  const json discs =
      folder.results_of("--workspace room.json --footprint 'discs:0,0,0.3;0.5,-0.1,0.25'");
  CHECK(discs[0]["vehicle"]["footprint"] ==
        json::array({{{"offset", {0.0, 0.0}}, {"radius", 0.3}},
                     {{"offset", {0.5, -0.1}}, {"radius", 0.25}}}));
  const json plain = folder.results_of("--workspace room.json");
  CHECK(plain[0]["search"] == "auto");
  CHECK_FALSE(plain[0].contains("vehicle"));
  CHECK_FALSE(plain[0].contains("gears"));
}

TEST_CASE("every goal keeps its own heading") {
  const VehicleFolder folder;
  const json results = folder.results_of(
      "--workspace room.json --start 2,2,180 --goal 9,2,-45 --goal 9,6 --goal 9,6,450 --reverse");
  REQUIRE(results.size() == 3);
  for (const json& result : results) {
    CHECK(std::abs(result["start_heading"].get<double>()) == Approx(std::numbers::pi));
  }
  CHECK(results[0]["goal_heading"].get<double>() == Approx(-right_angle / 2));
  CHECK(results[2]["goal_heading"].get<double>() == Approx(right_angle));
  CHECK(results[1]["metrics"]["length"].get<double>() <=
        results[2]["metrics"]["length"].get<double>() + 1e-9);
}

TEST_CASE("headings of a MovingAI map turn from x towards y, which grows downwards") {
  const VehicleFolder folder;
  std::string map = "type octile\nheight 9\nwidth 9\nmap\n";
  for (int y = 0; y < 9; ++y) map += ".........\n";
  folder.write("open.map", map);
  const json results = folder.results_of("--grid open.map --start 4.5,1.5,90 --goal 4.5,7.5,90");
  CHECK(results[0]["metrics"]["length"].get<double>() == Approx(6));
  CHECK(results[0]["start_heading"].get<double>() == Approx(right_angle));
  REQUIRE(folder.run("--grid open.map --start 4.5,1.5,90 --goal 4.5,7.5,90 --svg p.svg").code == 0);
  // The arrow at the start points downwards.
  const std::string svg = folder.read("p.svg");
  const std::size_t arrow = svg.rfind("<path", svg.find("stroke=\"#222b33\" stroke-width=\"2.4\""));
  const std::string shaft = svg.substr(arrow, svg.find('"', arrow + 9) - arrow);
  const double from = std::stod(shaft.substr(shaft.find(' ', 9)));
  CHECK(std::stod(shaft.substr(shaft.find(' ', shaft.find('L')))) == Approx(from + 26));
}

TEST_CASE(
    "with --compare a vehicle has the algorithms for vehicles alone, and no others have them") {
  const VehicleFolder folder;
  const Outcome vehicle = folder.run("--workspace room.json --compare --reverse --json r.json");
  INFO(vehicle.err);
  REQUIRE(vehicle.code == 0);
  const json results = json::parse(folder.read("r.json"))["results"];
  CHECK(results.size() == 2 + 2 * 3);  // two goals; one search, then three smoothers
  for (const json& result : results) CHECK(result["search"] == "hybrid_astar");
  CHECK(shows(vehicle.out, "\nhybrid_astar "));
  CHECK(shows(vehicle.out, "\nnone "));
  CHECK(shows(vehicle.out, "\nvehicle_shortcut "));
  CHECK(shows(vehicle.out, "\ncontinuous_curvature "));
  CHECK_FALSE(shows(vehicle.out, "nan"));
  CHECK_FALSE(shows(vehicle.out, "\nastar "));
  const Outcome options =
      folder.run("--workspace room.json --compare --search hybrid_astar:headings=16");
  CHECK(options.code == 0);
  CHECK(shows(options.out, "\nhybrid_astar:headings=16 "));

  const Outcome point = folder.run("--workspace room.json --compare");
  CHECK(point.code == 0);
  CHECK_FALSE(shows(point.out, "hybrid_astar"));
  CHECK_FALSE(shows(point.out, "vehicle_shortcut"));
  CHECK_FALSE(shows(point.out, "cusps"));
}

TEST_CASE("a vehicle without a path gives exit code 1, and no advice for points") {
  const VehicleFolder folder;
  const Outcome outcome = folder.run("--workspace room.json --start 2,2,0 --footprint disc:4");
  CHECK(outcome.code == 1);
  CHECK(shows(outcome.out, "start_blocked"));
  folder.write("corner.json", R"({"bounds":[0,0,4,1],"safety_radius":0.1,"obstacles":[],
      "start":[1,0.5],"goals":[[3,0.5]]})");
  const Outcome narrow =
      folder.run("--workspace corner.json --start 1,0.5,0 --goal 3,0.5,180 --turning-radius 3");
  CHECK(narrow.code == 1);
  CHECK(shows(narrow.out, "unreachable"));
  CHECK_FALSE(shows(narrow.out, "--search auto"));
}

TEST_CASE("a picture of a vehicle has its footprint, its headings and its gears in the legend") {
  const VehicleFolder folder;
  const auto picture = [&](const std::string& arguments) {
    const Outcome outcome = folder.run(arguments + " --svg p.svg");
    INFO(arguments << ": " << outcome.err);
    REQUIRE(outcome.code == 0);
    return folder.read("p.svg");
  };
  const std::string car = picture(parking);
  for (const char* part : {">in reverse<", ">footprint<", ">heading<"}) CHECK(shows(car, part));
  CHECK(shows(picture(parking + "--show zones,footprint"), ">footprint<"));
  const std::string bare = picture(parking + "--show zones");
  CHECK_FALSE(shows(bare, ">footprint<"));
  CHECK(shows(bare, ">heading<"));
  CHECK(shows(picture(parking + "--compare --show footprint"), ">footprint<"));
  CHECK_FALSE(shows(picture(parking + "--compare"), ">footprint<"));
  const std::string point = picture("--workspace room.json");
  for (const char* part : {">in reverse<", ">footprint<", ">heading<"}) {
    CHECK_FALSE(shows(point, part));
  }
}

struct BadUsage {
  std::string arguments, expected;
};

void check_refused(const std::vector<BadUsage>& all) {
  const VehicleFolder folder;
  const std::size_t files = folder.files();
  for (const BadUsage& bad : all) {
    INFO("tutavia-plan " << bad.arguments);
    const Outcome outcome = folder.run("--workspace room.json " + bad.arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(shows(outcome.err, bad.expected));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(folder.files() == files);
  }
}

TEST_CASE("a wrong radius or heading gives one line with the option and what it takes") {
  const std::string radius =
      "--turning-radius: expected R in metres, 0 or at least 1e-9, and finite, got ";
  const std::string point = "expected X,Y or X,Y,DEG with finite numbers";
  check_refused({
      {"--turning-radius -1", radius + "\"-1\""},
      {"--turning-radius 1e-300", radius},
      {"--turning-radius nan", radius},
      {"--turning-radius inf", radius},
      {"--turning-radius 5m", radius},
      {"--turning-radius ''", radius},
      {"--turning-radius 0 --footprint car:4,2,3", "--turning-radius 0: expected R above 0"},
      {"--start 2,2,x", "--start: " + point},
      {"--start 2,2,nan", "--start: " + point},
      {"--goal 9,2,1,2", "--goal: " + point},
      {"--goal 9,2,inf", "--goal: " + point},
  });
}

TEST_CASE("a wrong footprint gives one line with the form that it should have") {
  const std::string car =
      "--footprint: expected car:L,W,WB with L and W above 0, neither 100 times the other, and WB "
      "from 0 to L";
  const std::string any = "--footprint: expected disc:R, car:L,W,WB or discs:X,Y,R;X,Y,R;...";
  const std::string disc = "--footprint: expected disc:R with R at least 0, in metres, got ";
  const std::string discs = "--footprint: expected discs:X,Y,R;X,Y,R;... with every R at least 0";
  std::vector<BadUsage> all{{"--footprint disc:-1", disc + "\"disc:-1\""}};
  for (const char* text : {"round", "''", "disc", "Car:4,2,3", "' car:4,2,3'"}) {
    all.push_back({std::string("--footprint ") + text, any});
  }
  for (const char* text : {"nan", "inf", "1,2", "1x", "", " 1", "1;2"}) {
    all.push_back({std::string("--footprint 'disc:") + text + "'", disc});
  }
  for (const char* text : {"4,2", "4,2,3,1", "4,0,3", "4,-2,3", "4,2,5", "4,2,-1", "0,2,0",
                           "1e300,2,3", "4,2,3x", "4,nan,3", "4,2,", ""}) {
    all.push_back({std::string("--footprint car:") + text, car});
  }
  for (const char* text : {"", "0,0,1;", "0,0,1;1,0", "0,0,-1", "0,0,1;0,inf,1", ";0,0,1"}) {
    all.push_back({std::string("--footprint 'discs:") + text + "'", discs});
  }
  check_refused(all);
}

TEST_CASE(
    "algorithms without headings are refused for vehicles, and those of vehicles for others") {
  check_refused({
      {"--reverse --search astar",
       "--search: astar plans no headings; for a vehicle give hybrid_astar"},
      {"--start 2,2,0 --search auto", "--search: auto plans no headings"},
      {"--search hybrid_astar,astar", "--search: astar plans no headings"},
      {"--search hybrid_astar --smoother delta",
       "--smoother: delta keeps no headings; for a vehicle give none, vehicle_shortcut or "
       "continuous_curvature"},
      {"--reverse --smoother none+bezier", "--smoother: bezier keeps no headings"},
      {"--smoother vehicle_shortcut",
       "--smoother: vehicle_shortcut is for vehicles; give --search hybrid_astar"},
      {"--turning-radius 2 --search hybrid_astar:vehicle.min_turning_radius=3",
       "--turning-radius: --search hybrid_astar:vehicle.min_turning_radius=3 says it, too"},
      {"--reverse --search hybrid_astar:vehicle.reverse=false", "--reverse: --search"},
      {"--search hybrid_astar:headings=4",
       "--search hybrid_astar:headings=4: headings must be at least 8"},
      {"--reverse --smoother vehicle_shortcut:places=1",
       "--smoother vehicle_shortcut:places=1: vehicle_shortcut needs"},
      {"--reverse --smoother vehicle_shortcut+continuous_curvature:max_sharpness=-1",
       "max_sharpness must be finite and not negative"},
      {"--search hybrid_astr", "did you mean hybrid_astar?"},
  });
}

}  // namespace
