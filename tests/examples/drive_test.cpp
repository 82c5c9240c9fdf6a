// SPDX-License-Identifier: MIT
/// \file
/// The command line of tutavia-drive, run as a user runs it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/program_folder.hpp"

namespace {

namespace fs = std::filesystem;

bool text_has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

struct DriveFolder : tutavia::test::ProgramFolder {
  DriveFolder() : ProgramFolder("tutavia_drive", TUTAVIA_DRIVE) {}
};

/// The lines of a CSV file, split into fields.
std::vector<std::vector<std::string>> csv_rows(const fs::path& path) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream text(tutavia::test::file_text(path));
  for (std::string line; std::getline(text, line);) {
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
    rows.push_back(fields);
  }
  return rows;
}

/// Whether every element of a text of XML is closed by its own end, and quotes are closed.
bool is_well_formed(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = text.substr(at + 1, end - at - 1);
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0 || text_has(tag, "<")) return false;
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (name[0] == '/') {
      if (open.empty() || "/" + open.back() != name) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
    at = end;
  }
  return open.empty();
}

/// Whether the keyTimes of every animation ascend from 0, one for each value.
bool has_valid_times(const std::string& svg) {
  const auto list_after = [&](const std::string& name, std::size_t at) {
    const std::size_t begin = svg.find(name + "=\"", at) + name.size() + 2;
    std::vector<std::string> parts;
    std::istringstream stream(svg.substr(begin, svg.find('"', begin) - begin));
    for (std::string part; std::getline(stream, part, ';');) parts.push_back(part);
    return parts;
  };
  std::size_t animations = 0;
  for (std::size_t at = svg.find("<animate"); at != std::string::npos;
       at = svg.find("<animate", at + 1)) {
    ++animations;
    std::vector<double> times;
    for (const std::string& time : list_after("keyTimes", at)) times.push_back(std::stod(time));
    if (times.empty() || times.front() != 0 || times.back() > 1) return false;
    if (!std::is_sorted(times.begin(), times.end())) return false;
    if (times.size() != list_after("values", at).size()) return false;
  }
  return animations > 10;
}

TEST_CASE("tutavia-drive drives both controllers to the goal, without a contact of their own") {
  const DriveFolder folder;
  for (const std::string controller : {"band", "pursuit"}) {
    CAPTURE(controller);
    const tutavia::test::Outcome outcome =
        folder.run("--map complex --obstacles 3 --seed 2 --controller " + controller);
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    CHECK(text_has(outcome.out, "controller     " + controller));
    CHECK(text_has(outcome.out, "result         reached"));
    CHECK(text_has(outcome.out, "obstacles      3 appeared"));
    CHECK(text_has(outcome.out, "contacts       0 of its own"));
    CHECK(text_has(outcome.out, "limits         0 violations"));
    CHECK(text_has(outcome.out, "beyond the safety radius"));
  }
}

TEST_CASE("the CSV of a drive has a line per period, from the start to the goal") {
  const DriveFolder folder;
  REQUIRE(folder.run("--map complex --start 2,1,90 --obstacles 2 --csv a.csv").code == 0);
  const auto rows = csv_rows(folder / "a.csv");
  REQUIRE(rows.size() > 100);
  CHECK(tutavia::test::file_text(folder / "a.csv")
            .rfind("time,x,y,heading,v,omega,clearance,status\n", 0) == 0);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    REQUIRE(rows[i].size() == 8);
    CHECK(std::stod(rows[i][0]) == Approx(0.1 * static_cast<double>(i - 1)));
    for (std::size_t k = 1; k < 7; ++k) CHECK(std::isfinite(std::stod(rows[i][k])));
  }
  CHECK(std::stod(rows[1][1]) == 2);
  CHECK(std::stod(rows[1][2]) == 1);
  CHECK(std::stod(rows[1][3]) == Approx(1.5707963));
  CHECK(rows.back()[7] == "arrived");
  CHECK(std::hypot(std::stod(rows.back()[1]) - 11, std::stod(rows.back()[2]) - 6) < 0.15);
  REQUIRE(folder.run("--map complex --start 2,1,90 --obstacles 2 --csv b.csv").code == 0);
  CHECK(tutavia::test::file_text(folder / "a.csv") == tutavia::test::file_text(folder / "b.csv"));
}

TEST_CASE("the picture of a drive is well-formed, and its animations are") {
  const DriveFolder folder;
  REQUIRE(folder.run("--map complex --obstacles 4 --noise 0.01 --svg a.svg").code == 0);
  const std::string svg = tutavia::test::file_text(folder / "a.svg");
  CHECK(is_well_formed(svg));
  CHECK(has_valid_times(svg));
  CHECK(text_has(svg, "repeatCount=\"indefinite\""));
  CHECK(text_has(svg, "obstacle that appears"));
  CHECK(text_has(svg, "arrived"));
}

TEST_CASE("tutavia-drive drives on workspace files and on grid maps") {
  const DriveFolder folder;
  std::ofstream(folder / "room.json")
      << R"({"bounds":[0,0,8,4],"safety_radius":0.3,"obstacles":[{"center":[4,2],"radius":0.5}]})";
  CHECK(folder.run("--workspace room.json --start 1,2 --goal 7,2").code == 0);
  std::ofstream(folder / "room.map") << "type octile\nheight 4\nwidth 8\nmap\n"
                                     << "........\n....@...\n....@...\n........\n";
  const tutavia::test::Outcome cells = folder.run(
      "--grid room.map --radius 0.3 --start 1.5,1.5 --goal 6.5,1.5 --controller pursuit --svg "
      "a.svg");
  CHECK(cells.code == 0);
  CHECK(is_well_formed(tutavia::test::file_text(folder / "a.svg")));
}

TEST_CASE("tutavia-drive says with code 1 that there is no path, or that the robot had to stop") {
  const DriveFolder folder;
  const tutavia::test::Outcome blocked = folder.run("--map maze --goal 0.5,2");
  CHECK(blocked.code == 1);
  CHECK(text_has(blocked.out, "no path: goal_blocked"));
  CHECK(text_has(folder.run("--map maze --start 0.5,2").out, "no path: start_blocked"));
  CHECK(text_has(folder.run("--map maze --start -1,1").out, "no path: start_out_of_bounds"));
  const tutavia::test::Outcome late = folder.run("--map maze --time-limit 3");
  CHECK(late.code == 1);
  CHECK(text_has(late.out, "result         timed out"));
  CHECK(text_has(late.out, "way to goal    left open"));
}

TEST_CASE("tutavia-drive answers bad usage with code 2 and one line") {
  const DriveFolder folder;
  const auto refuses = [&](const std::string& arguments, const std::string& message) {
    CAPTURE(arguments);
    const tutavia::test::Outcome outcome = folder.run(arguments);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(text_has(outcome.err, "tutavia-drive: "));
    CHECK(text_has(outcome.err, message));
  };
  refuses("--map attic", "unknown map");
  refuses("--controler band", "did you mean --controller?");
  refuses("--controller pid", "--controller: unknown name \"pid\" (band or pursuit)");
  refuses("--start 1,2,3,4", "expected X,Y");
  refuses("--start 1,2,north", "expected X,Y or X,Y,DEG");
  refuses("--goal 1", "--goal: expected X,Y");
  refuses("--map rrt_scene_1", "give --radius R");
  refuses("--noise -1", "--noise");
  refuses("--obstacles many", "--obstacles");
  refuses("--unknown cost:2", "--unknown");
}

TEST_CASE("tutavia-drive --help names its options") {
  const DriveFolder folder;
  const tutavia::test::Outcome outcome = folder.run("--help");
  CHECK(outcome.code == 0);
  for (const char* option :
       {"--map", "--grid", "--controller", "--obstacles", "--noise", "--csv"}) {
    CHECK(text_has(outcome.out, option));
  }
}

}  // namespace
