// SPDX-License-Identifier: MIT
#include "tutavia/io/moving_ai.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "support/skip.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/io/text/write_file.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tutavia;

const std::string header = "type octile\nheight 2\nwidth 3\nmap\n";

std::string drawn(const OccupancyGrid& grid) {
  std::string rows;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) rows += grid.is_free(Cell{x, y}) ? '.' : '@';
    rows += '\n';
  }
  return rows;
}

std::string map_complaint(const std::string& text) {
  const auto grid = parse_moving_ai_map(text);
  REQUIRE_FALSE(grid);
  CHECK(grid.error().code == PlanError::invalid_input);
  return grid.error().detail;
}

std::string scenario_complaint(const std::string& text) {
  const auto rows = parse_moving_ai_scenario(text);
  REQUIRE_FALSE(rows);
  CHECK(rows.error().code == PlanError::invalid_input);
  return rows.error().detail;
}

TEST_CASE("a MovingAI map becomes a grid with row 0 at the top") {
  const auto grid = parse_moving_ai_map(header + ".G@\nOT.\n");
  REQUIRE(grid);
  CHECK(grid->width() == 3);
  CHECK(grid->height() == 2);
  CHECK(drawn(*grid) == "..@\n@@.\n");
  CHECK(grid->is_free(Cell{1, 0}));
  CHECK_FALSE(grid->is_free(Cell{1, 1}));
}

TEST_CASE("a MovingAI map may end without a line end, or in empty lines, and have CRLF") {
  for (const std::string text :
       {"type octile\nheight 1\nwidth 2\nmap\n.@", "type octile\nheight 1\nwidth 2\nmap\n.@\n\n \n",
        "type octile  \r\nheight 1 \r\nwidth\t2\t\r\nmap\r\n.@\r\n\r\n",
        "\xEF\xBB\xBFType Tile\nHEIGHT 1\nWidth 2\nMAP\n.@",
        "width 2\n\n type octile\nheight 1\nmap \n.@  "}) {
    CAPTURE(text);
    const auto grid = parse_moving_ai_map(text);
    REQUIRE(grid);
    CHECK(drawn(*grid) == ".@\n");
  }
}

TEST_CASE("swamp and water of a MovingAI map are refused until they are said to be something") {
  const std::string text = header + "...\n.SW\n";
  CHECK(map_complaint(text) ==
        "line 6: expected one of . G @ O T in row 1, column 1, found \"S\", which only some "
        "neighbours "
        "may enter: MovingAiOptions::directional says how to read it");
  CHECK(map_complaint(header + "..W\n...\n")
            .find("line 5: expected one of . G @ O T in row 0, "
                  "column 2, found \"W\", which") == 0);
  CHECK(drawn(parse_moving_ai_map(text, {MovingAiOptions::DirectionalTerrain::blocked}).value()) ==
        "...\n.@@\n");
  CHECK(drawn(parse_moving_ai_map(text, {MovingAiOptions::DirectionalTerrain::free}).value()) ==
        "...\n...\n");
}

TEST_CASE("a malformed header of a MovingAI map is reported with its line") {
  const std::string end = "found the end of the file";
  CHECK(map_complaint("") == "line 1: expected type, width and height before map, " + end);
  CHECK(map_complaint("\n\n").find("line 3: ") == 0);
  CHECK(map_complaint("type octile\nheight 2\nwidth 3\n") ==
        "line 4: expected type, width and height before map, " + end);
  for (const std::string text :
       {"height 2\nwidth 3\nmap\n...\n...", "type octile\nwidth 3\nmap\n...\n...",
        "type octile\nheight 2\nmap\n...\n..."}) {
    CAPTURE(text);
    CHECK(map_complaint(text).find("expected type, width and height before map, found \"map\"") !=
          std::string::npos);
  }
  CHECK(map_complaint("type quad\n") ==
        "line 1: expected type octile or tile, found \"type quad\"");
  CHECK(map_complaint("type\n") == "line 1: expected type octile or tile, found \"type\"");
  CHECK(map_complaint("type octile\ndepth 2\n") ==
        "line 2: expected type, width, height (each once) or map, found \"depth 2\"");
  CHECK(map_complaint("width 3\nwidth 3\n").find("line 2: expected type, width, height (each") ==
        0);
  CHECK(map_complaint("type octile\ntype octile\n").find("line 2: expected type, width, h") == 0);
  CHECK(map_complaint("...\n...").find("line 1: ") == 0);
}

TEST_CASE("a size that is no positive number is refused, and a huge one before it is allocated") {
  for (const std::string size : {"0", "-2", "2.5", "2x", "x", "", "2 3", "+2", "0x10",
                                 "9223372036854775808", "99999999999999999999999999"}) {
    CAPTURE(size);
    CHECK(map_complaint("type octile\nheight " + size + "\n")
              .find("line 2: expected height from 1 to 2^63 - 1, found \"height") == 0);
    CHECK(map_complaint("width " + size + "\n").find("line 1: expected width from 1") == 0);
  }
  for (const std::string size : {"2000000000", "9223372036854775807"}) {
    const auto grid =
        parse_moving_ai_map("type octile\nheight " + size + "\nwidth " + size + "\nmap\n...");
    REQUIRE_FALSE(grid);
    CHECK(grid.error().code == PlanError::limit_exceeded);
    CHECK(grid.error().detail.find(size) != std::string::npos);
  }
}

TEST_CASE("rows of a MovingAI map that do not fit its size are reported with their line") {
  CHECK(map_complaint(header) == "line 5: expected row 0 of 2, found the end of the file");
  CHECK(map_complaint(header + "...\n") ==
        "line 6: expected row 1 of 2, found the end of the file");
  CHECK(map_complaint(header + "...\n..\n") == "line 6: expected 3 cells in row 1, found 2");
  CHECK(map_complaint(header + "\n...\n...\n") == "line 5: expected 3 cells in row 0, found 0");
  CHECK(map_complaint(header + "....\n...\n") == "line 5: expected 3 cells in row 0, found 4");
  CHECK(map_complaint(header + "...\n...\n\n...\n") ==
        "line 8: expected nothing after the last row, found \"...\"");
}

TEST_CASE("an unknown character of a MovingAI map is named with line, row and column") {
  CHECK(map_complaint(header + "...\n..x\n") ==
        "line 6: expected one of . G @ O T in row 1, column 2, found \"x\"");
  CHECK(map_complaint(header + ". .\n...\n") ==
        "line 5: expected one of . G @ O T in row 0, column 1, found \" \"");
  CHECK(map_complaint(header + "..\x01\n...\n") ==
        "line 5: expected one of . G @ O T in row 0, column 2, found byte 0x01");
  CHECK(map_complaint(header + std::string(".\0.\n...\n", 8)) ==
        "line 5: expected one of . G @ O T in row 0, column 1, found byte 0x00");
}

TEST_CASE("random grids come back from MovingAI text as they were") {
  const std::uint64_t seed = 31;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    const int width = 1 + static_cast<int>(random.below(140));
    const int height = 1 + static_cast<int>(random.below(20));
    OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
    const std::string line_end = random.below(2) == 0 ? "\n" : "\r\n";
    std::string text = "type octile" + line_end + "height " + std::to_string(height) + line_end +
                       "width " + std::to_string(width) + line_end + "map" + line_end;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const bool free = random.below(2) == 0;
        grid.set({x, y}, free);
        text += free ? ".G"[random.below(2)] : "@OT"[random.below(3)];
      }
      text += line_end;
    }
    CAPTURE(round, width, height);
    const auto read = parse_moving_ai_map(text);
    REQUIRE(read);
    REQUIRE(drawn(*read) == drawn(grid));
    REQUIRE_FALSE(parse_moving_ai_map(text.substr(0, text.size() - line_end.size() - 1)));
  }
}

TEST_CASE("a scenario has columns apart by tabs or spaces") {
  for (const std::string text :
       {"version 1\n0\tmaps/a.map\t5\t4\t1\t2\t3\t0\t4.82843\n46\tb.map\t5\t4\t0\t0\t4\t3\t0\n",
        "version 1.0\r\n0 maps/a.map 5 4 1 2 3 0 4.82843\r\n\r\n46 b.map 5 4  0 0 4 3 0 "
        "\r\n\r\n"}) {
    CAPTURE(text);
    const auto rows = parse_moving_ai_scenario(text);
    REQUIRE(rows);
    REQUIRE(rows->size() == 2);
    const ScenarioRow& first = rows->front();
    CHECK(first.bucket == 0);
    CHECK(first.map == "maps/a.map");
    CHECK(first.width == 5);
    CHECK(first.height == 4);
    CHECK(first.start == Cell{1, 2});
    CHECK(first.goal == Cell{3, 0});
    CHECK(first.optimal_length == 4.82843);
    CHECK(first.line == 2);
    CHECK(rows->back().bucket == 46);
    CHECK(rows->back().goal == Cell{4, 3});
    CHECK(rows->back().optimal_length == 0);
  }
  CHECK(parse_moving_ai_scenario("version 1")->empty());
  CHECK(parse_moving_ai_scenario("version 1\r\n1 a 2 2 0 0 1 1 1\r\n\r\n1 a 2 2 0 0 1 1 1")
            ->back()
            .line == 4);
}

TEST_CASE("a malformed scenario is reported with line and column") {
  const std::string end = "found the end of the file";
  CHECK(scenario_complaint("") == "line 1: expected version 1, " + end);
  CHECK(scenario_complaint("version 2\n") == "line 1: expected version 1, found \"version 2\"");
  CHECK(scenario_complaint("0 a 5 4 1 2 3 0 4\n").find("line 1: expected version 1, found \"0 a") ==
        0);
  const std::string version = "version 1\n0 a 5 4 1 2 3 0 4\n";
  CHECK(scenario_complaint(version + "0 a 5 4 1 2 3 0\n") == "line 3: expected 9 columns, found 8");
  CHECK(scenario_complaint(version + "0 a 5 4 1 2 3 0 4 5\n") ==
        "line 3: expected 9 columns, found 10");
  const std::string number = "expected a number from 0 to 2^31 - 1 in column ";
  CHECK(scenario_complaint(version + "x a 5 4 1 2 3 0 4\n") ==
        "line 3: " + number + "1, found \"x\"");
  CHECK(scenario_complaint(version + "0 a -5 4 1 2 3 0 4\n") ==
        "line 3: " + number + "3, found \"-5\"");
  CHECK(scenario_complaint(version + "0 a 5 2147483648 1 2 3 0 4\n") ==
        "line 3: " + number + "4, found \"2147483648\"");
  CHECK(scenario_complaint(version + "0 a 5 4 1.5 2 3 0 4\n") ==
        "line 3: " + number + "5, found \"1.5\"");
  CHECK(scenario_complaint(version + "0 a 5 4 1 -2 3 0 4\n") ==
        "line 3: " + number + "6, found \"-2\"");
  CHECK(scenario_complaint(version + "-00 a 5 4 1 2 3 0 4\n") ==
        "line 3: " + number + "1, found \"-00\"");
  for (const std::string length : {"-1", "-0", "nan", "inf", "1e999", "4,5", "four"}) {
    CAPTURE(length);
    CHECK(scenario_complaint(version + "0 a 5 4 1 2 3 0 " + length) ==
          "line 3: expected a length in column 9, found \"" + length + "\"");
  }
}

TEST_CASE("a scenario row from or to a cell outside its own map is refused") {
  const std::string expected = "line 2: expected start and goal in 5 x 4 cells, found ";
  CHECK(scenario_complaint("version 1\n0 a 5 4 5 2 3 0 4") == expected + "5, 2");
  CHECK(scenario_complaint("version 1\n0 a 5 4 1 4 3 0 4") == expected + "1, 4");
  CHECK(scenario_complaint("version 1\n0 a 5 4 1 2 5 0 4") == expected + "5, 0");
  CHECK(scenario_complaint("version 1\n0 a 5 4 1 2 3 4 4") == expected + "3, 4");
  CHECK(scenario_complaint("version 1\n0 a 0 0 0 0 0 0 4").find("in 0 x 0 cells") !=
        std::string::npos);
}

TEST_CASE("a scenario that was made for another map is refused") {
  const OccupancyGrid map = OccupancyGrid::blocked(5, 4).value();
  auto rows = parse_moving_ai_scenario("version 1\n0 a 5 4 1 2 3 0 4\n0 a 5 4 4 3 0 0 4\n").value();
  CHECK(check_scenario(rows, map));
  CHECK(check_scenario({}, map));
  rows[1].width = 6;
  const auto size = check_scenario(rows, map);
  REQUIRE_FALSE(size);
  CHECK(size.error().code == PlanError::invalid_input);
  CHECK(size.error().detail == "line 3: expected a map of 6 x 4 cells, found one of 5 x 4");
  rows[1].width = 5;
  rows[1].height = 3;
  CHECK_FALSE(check_scenario(rows, map));
  rows[1].height = 4;
  rows[1].goal = {-1, 0};
  const auto outside = check_scenario(rows, map);
  REQUIRE_FALSE(outside);
  CHECK(outside.error().detail == "line 3: expected start and goal in 5 x 4 cells");
  rows[1].goal = {0, 0};
  rows[1].start = {4, 4};
  CHECK_FALSE(check_scenario(rows, map));
}

TEST_CASE("failures to read a MovingAI file begin with its name") {
  const fs::path folder = fs::temp_directory_path() / "tutavia_moving_ai_test";
  fs::create_directories(folder);
  const fs::path map = folder / "a.map", scenario = folder / "a.map.scen";
  REQUIRE(detail::write_file(map, header + ".G@\nSW.\n"));
  REQUIRE(detail::write_file(scenario, "version 1\n0 a 5 4 1 2 3 0\n"));
  CHECK(read_moving_ai_map(map, {MovingAiOptions::DirectionalTerrain::blocked}));
  CHECK(read_moving_ai_map(map).error().detail.find(map.string() + ": line 6: ") == 0);
  CHECK(read_moving_ai_scenario(scenario).error().detail ==
        scenario.string() + ": line 2: expected 9 columns, found 8");
  fs::remove_all(folder);
  CHECK(read_moving_ai_map(map).error().detail == map.string() + ": cannot be read");
  CHECK(read_moving_ai_scenario(scenario).error().code == PlanError::invalid_input);
}

TEST_CASE("maps and scenarios of the benchmark can be read and fit each other") {
  const char* folder = test::moving_ai_folder();
  if (folder == nullptr) return;
  std::size_t maps = 0, problems = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".map") continue;
    CAPTURE(entry.path());
    const auto map = read_moving_ai_map(entry.path());
    if (!map) FAIL(map.error().detail);
    const auto rows = read_moving_ai_scenario(entry.path().string() + ".scen");
    if (!rows) FAIL(rows.error().detail);
    REQUIRE(check_scenario(*rows, *map));
    for (const ScenarioRow& row : *rows) {
      const Cell way = row.goal - row.start;
      const int dx = std::abs(way.x), dy = std::abs(way.y);
      const double octile = std::max(dx, dy) + (std::sqrt(2.0) - 1) * std::min(dx, dy);
      CAPTURE(row.line);
      if (!map->is_free(row.start) || !map->is_free(row.goal)) FAIL("start or goal is blocked");
      if (row.optimal_length < octile * (1 - 1e-5) - 0.02) FAIL("shorter than any path");
    }
    ++maps;
    problems += rows->size();
  }
  CHECK(maps > 0);
  CHECK(problems > 0);
}

}  // namespace
