// SPDX-License-Identifier: MIT
#include "tutavia/io/ros_map.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/io/text/write_file.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tutavia;

using Values = std::vector<std::int8_t>;

const std::string image = "P2\n3 2\n255\n0 205 254\n255 100 89\n";
const std::string settings =
    "image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
const std::string trinary = settings + "negate: 0\n";

std::string bytes(const std::vector<int>& values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), by);
}

Values values(const std::string& yaml, const std::string& pgm) {
  const auto map = parse_ros_map(yaml, pgm);
  if (!map) FAIL(map.error().detail);
  return map->values;
}

template <class T>
std::string complaint(const Expected<T, Failure>& result) {
  REQUIRE_FALSE(result);
  CHECK(result.error().code == PlanError::invalid_input);
  return result.error().detail;
}
std::string yaml_complaint(const std::string& yaml) {
  return complaint(parse_ros_map(yaml, image));
}

TEST_CASE("a trinary map is occupied, free or unknown, its bottom row first") {
  const auto map = parse_ros_map(trinary, image);
  if (!map) FAIL(map.error().detail);
  CHECK(map->width == 3);
  CHECK(map->height == 2);
  CHECK(map->values == Values{0, -1, 100, 100, -1, 0});
  CHECK(map->resolution == 0.05);
  CHECK(map->origin == Point(1.5, -2));
  CHECK(map->yaw == 0);
  CHECK(map->warnings.empty());
  CHECK(values(trinary + "mode: trinary\n", image) == map->values);
  CHECK(values(settings + "negate: 1\n", image) == Values{100, -1, -1, 0, 100, 100});
}

TEST_CASE("a scale map is linear between the thresholds") {
  const std::string scale = settings + "mode: scale\nnegate: ";
  CHECK(values(scale + "0", image) == Values{0, 91, 100, 100, 0, 0});
  CHECK(values(scale + "1", image) == Values{100, 43, 34, 0, 100, 100});
}

TEST_CASE("a raw map has its pixels as values up to 100, negated or not") {
  const std::string raw = settings + "mode: raw\nnegate: ";
  CHECK(values(raw + "0", image) == Values{-1, 100, 89, 0, -1, -1});
  CHECK(values(raw + "0", "P2 3 1 255 100 101 128") == Values{100, -1, -1});
  const auto negated = parse_ros_map(raw + "1", image);
  REQUIRE(negated);
  CHECK(negated->values == Values{-1, 100, 89, 0, -1, -1});
  CHECK(negated->warnings == std::vector<std::string>{"negate changes nothing in raw mode"});
}

TEST_CASE("pixels count relative to white, at 4 bits as at 16") {
  const std::string coarse = "P2 5 1 10 0 4 5 8 10";
  CHECK(values(trinary, coarse) == Values{100, -1, -1, -1, 0});
  CHECK(values(settings + "negate: 0\nmode: scale", coarse) == Values{100, 89, 67, 1, 0});
  CHECK(values(settings + "negate: 0\nmode: raw", coarse) == Values{0, -1, -1, -1, -1});
  const std::string fine = "P5 4 1 65535 " + bytes({0, 0, 0x80, 0, 0xFF, 0xFF, 0x19, 0});
  CHECK(values(trinary, fine) == Values{100, -1, 0, 100});
  CHECK(values(settings + "negate: 1", fine) == Values{0, -1, 100, 0});
  CHECK(values(settings + "negate: 0\nmode: scale", fine) == Values{100, 67, 0, 100});
  CHECK(values(settings + "negate: 1\nmode: scale", fine) == Values{0, 67, 100, 0});
  CHECK(values(settings + "negate: 0\nmode: raw", fine) == Values{0, -1, -1, 25});
}

TEST_CASE("a pixel exactly at a threshold is between them") {
  const std::string yaml = replaced(replaced(trinary, "0.65", "0.6"), "0.196", "0.2");
  const std::string pgm = "P2 4 1 5 1 2 3 4";  // occupied by 0.8, 0.6, 0.4, 0.2
  CHECK(values(yaml, pgm) == Values{100, -1, -1, -1});
  CHECK(values(yaml + "mode: scale", pgm) == Values{100, 100, 50, 0});
  const std::string same = replaced(yaml, "0.2", "0.6");
  CHECK(values(same, pgm) == Values{100, -1, 0, 0});
  CHECK(values(same + "mode: scale", pgm) == Values{100, 100, 0, 0});
}

TEST_CASE("YAML may have comments, quotes, a marker, CRLF and its list in a block") {
  for (const std::string text :
       {"---\nimage: 'a.pgm'\nresolution: \"0.05\"\norigin: ['1.5',-2 , 0.0]\n"
        "occupied_thresh: .65\nfree_thresh: 196e-3\nnegate: false\nmode: \"trinary\"\n",
        "# a map\r\n\r\n--- # begins\r\nmode :  trinary # default\r\nnegate:\t0\r\n"
        "image: a.pgm#1  # the picture\r\nresolution: 0.05\r\norigin: [1.5, -2, 0] #x\r\n"
        "occupied_thresh: 0.65\r\nfree_thresh: 0.196\r\n  \t\r\n",
        "image: a b.pgm\nresolution: 5e-2\norigin:\n- 1.5\n- -2\n\n# yaw\n- 0\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196",
        "image: it's \"a\".pgm\nresolution: 0.05\norigin: # x, y, yaw\n  - 1.5\n  - '-2'\n"
        "  -  0 # yaw\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196"}) {
    CAPTURE(text);
    const auto map = parse_ros_map(text, image);
    if (!map) FAIL(map.error().detail);
    CHECK(map->resolution == 0.05);
    CHECK(map->origin == Point(1.5, -2));
    CHECK(map->values == Values{0, -1, 100, 100, -1, 0});
    CHECK(map->warnings.empty());
  }
}

TEST_CASE("unknown keys become warnings") {
  const auto map =
      parse_ros_map("map_type: occupancy\n" + trinary + "tags: [a, b]\nnothing:\n", image);
  if (!map) FAIL(map.error().detail);
  CHECK(map->warnings == std::vector<std::string>{"line 1: unknown key map_type",
                                                  "line 8: unknown key tags",
                                                  "line 9: unknown key nothing"});
}

TEST_CASE("a missing key of the YAML is named") {
  for (const std::string key :
       {"image", "resolution", "origin", "occupied_thresh", "free_thresh", "negate"}) {
    CAPTURE(key);
    CHECK(yaml_complaint(replaced(trinary, key + ":", "other:")) ==
          "the key " + key + " is missing");
  }
  CHECK(yaml_complaint("") == "the key image is missing");
}

TEST_CASE("a value of the YAML that means nothing is reported with its line") {
  const auto with = [](const std::string& old, const std::string& by) {
    return yaml_complaint(replaced(trinary, old, by));
  };
  for (const std::string number :
       {"0", "-0.05", "nan", "inf", ".inf", "1e999", "0x1", "5 cm", "fine", "5#"}) {
    CAPTURE(number);
    CHECK(with("0.05", number) == "line 2: expected resolution: a number above 0, found " + number);
  }
  CHECK(with("0.05", "") == "line 2: expected resolution with 1 value, found 0");
  CHECK(with("0.05", "[1, 2]") == "line 2: expected resolution with 1 value, found 2");
  CHECK(with(", 0]", "]") == "line 3: expected origin with 3 values, found 2");
  CHECK(with(", 0]", ", 0, 0]") == "line 3: expected origin with 3 values, found 4");
  CHECK(with("[1.5, -2, 0]", "1.5") == "line 3: expected origin with 3 values, found 1");
  CHECK(with("[1.5, -2, 0]", "") == "line 3: expected origin with 3 values, found 0");
  CHECK(with("[1.5, -2, 0]", "[1.5, y, 0]") == "line 3: expected origin: x, y and yaw, found y");
  CHECK(with("[1.5, -2, 0]", "[1.5, -2, inf]").find("line 3: expected origin: x, y and y") == 0);
  CHECK(with("0.65", "1.01") ==
        "line 4: expected occupied_thresh: a number from 0 to 1, found 1.01");
  CHECK(with("0.65", "-0.1").find("line 4: expected occupied_thresh: ") == 0);
  CHECK(with("0.196", "-0.1").find("line 5: expected free_thresh: a number from 0 to occ") == 0);
  CHECK(with("0.196", "0.66") ==
        "line 5: expected free_thresh: a number from 0 to occupied_thresh, found 0.66");
  for (const std::string text : {"2", "-1", "0.5", "yes", "no", "on"}) {
    CAPTURE(text);
    CHECK(with("negate: 0", "negate: " + text) == "line 6: expected negate: 0 or 1, found " + text);
  }
  CHECK(with("negate: 0", "negate: 0\nmode: binary") ==
        "line 7: expected mode: trinary, scale or raw, found binary");
}

TEST_CASE("what is wrong with the image is reported by the map, too") {
  CHECK(complaint(parse_ros_map(trinary, "P2 1 1 9")).find("PGM byte 8: expected a pixel") == 0);
  CHECK(parse_ros_map(trinary, "P5 90000 90000 9 ").error().code == PlanError::limit_exceeded);
}

TEST_CASE("the grid of a map has its row 0 at the bottom and unknown cells as asked") {
  RosMap map = parse_ros_map(trinary, image).value();
  const auto blocked = to_grid(map, RosMap::UnknownCells::blocked);
  REQUIRE(blocked);
  CHECK(blocked->width() == 3);
  CHECK(blocked->height() == 2);
  CHECK(blocked->count_free() == 2);
  CHECK(blocked->is_free(Cell{0, 0}));
  CHECK(blocked->is_free(Cell{2, 1}));
  const auto free = to_grid(map, RosMap::UnknownCells::free);
  REQUIRE(free);
  CHECK(free->count_free() == 4);
  CHECK(free->is_free(Cell{1, 0}));
  CHECK(free->is_free(Cell{1, 1}));
}

TEST_CASE("cells of a map are blocked from the asked value on") {
  RosMap map;
  map.width = 5;
  map.height = 1;
  map.values = {0, 49, 50, 99, 100};
  const auto count = [&](int occupied_at) {
    return to_grid(map, RosMap::UnknownCells::blocked, occupied_at)->count_free();
  };
  CHECK(to_grid(map, RosMap::UnknownCells::blocked)->count_free() == 4);
  CHECK(count(100) == 4);
  CHECK(count(99) == 3);
  CHECK(count(50) == 2);
  CHECK(count(1) == 1);
  for (const int occupied_at : {0, -1, 101}) {
    const auto grid = to_grid(map, RosMap::UnknownCells::blocked, occupied_at);
    REQUIRE_FALSE(grid);
    CHECK(grid.error().code == PlanError::invalid_option);
    CHECK(grid.error().detail ==
          "occupied_at: expected 1 to 100, found " + std::to_string(occupied_at));
  }
}

TEST_CASE("a map whose values do not fit becomes no grid") {
  RosMap map;
  map.width = 2;
  map.height = 2;
  map.values = {0, 0, 0};
  CHECK(complaint(to_grid(map, RosMap::UnknownCells::free)) == "expected 2 x 2 values, found 3");
  map.values = {0, 0, 0, 101};
  CHECK(complaint(to_grid(map, RosMap::UnknownCells::free)) ==
        "values[3]: expected -1 to 100, found 101");
  map.values = {0, -2, 0, 0};
  CHECK(complaint(to_grid(map, RosMap::UnknownCells::free)) ==
        "values[1]: expected -1 to 100, found -2");
  map.values = {};
  map.width = -2;
  CHECK(complaint(to_grid(map, RosMap::UnknownCells::free)) == "grid size is negative");
  map.width = map.height = std::numeric_limits<int>::max();
  CHECK(complaint(to_grid(map, RosMap::UnknownCells::free)).find("values, found 0") !=
        std::string::npos);
}

TEST_CASE("points go from the map frame to the grid frame and back") {
  RosMap map;
  map.origin = {-10, 4};
  CHECK(to_grid_frame(map, {-10, 4}) == Point(0, 0));
  CHECK(to_grid_frame(map, {-8, 5}) == Point(2, 1));
  CHECK(to_map_frame(map, {2, 1}) == Point(-8, 5));
  map.origin = {1, 2};
  map.yaw = std::numbers::pi / 2;  // the image's rows run along the map's y axis
  CHECK(distance(to_map_frame(map, {3, 0}), {1, 5}) < 1e-15);
  CHECK(distance(to_map_frame(map, {0, 1}), {0, 2}) < 1e-15);
  CHECK(distance(to_grid_frame(map, {1, 5}), {3, 0}) < 1e-15);
  CHECK(distance(to_grid_frame(map, {0, 2}), {0, 1}) < 1e-15);
  const std::uint64_t seed = 5;
  CAPTURE(seed);
  Random random(seed);
  const auto point = [&] { return Point(random.uniform(-50, 50), random.uniform(-50, 50)); };
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    map.origin = point();
    map.yaw = random.uniform(-7, 7);
    const Point p = point(), q = point();
    CAPTURE(round);
    REQUIRE(distance(to_map_frame(map, to_grid_frame(map, p)), p) < 1e-12);
    REQUIRE(distance(to_grid_frame(map, to_map_frame(map, p)), p) < 1e-12);
    REQUIRE(distance(to_grid_frame(map, p), to_grid_frame(map, q)) ==
            Approx(distance(p, q)).epsilon(1e-12));
  }
}

TEST_CASE("a costmap is blocked from the asked cost on and where it knows nothing as asked") {
  const std::vector<std::uint8_t> costs = {0, 252, 253, 254, 255, 1};
  const auto grid = grid_from_costmap(costs, 3, 2, 253, RosMap::UnknownCells::blocked);
  REQUIRE(grid);
  CHECK(grid->count_free() == 3);
  CHECK(grid->is_free(Cell{1, 0}));
  CHECK_FALSE(grid->is_free(Cell{2, 0}));
  CHECK(grid->is_free(Cell{2, 1}));
  CHECK(grid_from_costmap(costs, 3, 2, 254, RosMap::UnknownCells::blocked)->count_free() == 4);
  CHECK(grid_from_costmap(costs, 3, 2, 254, RosMap::UnknownCells::free)->count_free() == 5);
  CHECK(grid_from_costmap(costs, 3, 2, 1, RosMap::UnknownCells::free)->count_free() == 2);
  CHECK(complaint(grid_from_costmap(costs, 3, 3, 254, RosMap::UnknownCells::free)) ==
        "expected 3 x 3 values, found 6");
  CHECK(complaint(grid_from_costmap(costs, -3, -2, 254, RosMap::UnknownCells::free)) ==
        "grid size is negative");
  for (const int blocked_at : {0, 255}) {
    const auto refused = grid_from_costmap(costs, 3, 2, blocked_at, RosMap::UnknownCells::free);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == PlanError::invalid_option);
  }
}

TEST_CASE("random maps come back from both kinds of PGM as they were") {
  const std::uint64_t seed = 77;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    const auto width = 1 + random.below(30), height = 1 + random.below(30);
    const std::string size = std::to_string(width) + ' ' + std::to_string(height);
    std::string plain = "P2\n" + size + "\n255\n", raw = "P5\n" + size + "\n255\n";
    Values expected(width * height);
    for (std::size_t row = height; row-- > 0;) {
      for (std::size_t column = 0; column < width; ++column) {
        const std::size_t kind = random.below(3);
        plain +=
            std::to_string(std::vector{0, 205, 254}[kind]) + (random.below(2) == 0 ? '\n' : ' ');
        raw += bytes({std::vector{0, 205, 254}[kind]});
        expected[row * width + column] = Values{100, -1, 0}[kind];
      }
    }
    CAPTURE(round);
    REQUIRE(values(trinary, plain) == expected);
    REQUIRE(values(trinary, raw) == expected);
  }
}

TEST_CASE("a map of damaged files is refused or has all its values") {
  const std::uint64_t seed = 78;
  CAPTURE(seed);
  Random random(seed);
  const auto damage = [&](std::string text) {
    for (auto i = random.below(4); i-- > 0;) {
      const std::size_t at = random.below(text.size());
      const char by = "\n #:-[]'\"0x19\0\r"[random.below(16)];
      if (random.below(3) == 0) {
        text.erase(at, 1);
      } else {
        text[at] = by;
      }
    }
    return text;
  };
  std::size_t read = 0, refused = 0;
  for (std::size_t round = 0; round < test::scaled(2000); ++round) {
    const auto map = parse_ros_map(damage(trinary), damage(image));
    CAPTURE(round);
    if (map) {
      REQUIRE(map->values.size() == static_cast<std::size_t>(map->width * map->height));
      REQUIRE(to_grid(*map, RosMap::UnknownCells::blocked));
      ++read;
    } else {
      REQUIRE_FALSE(map.error().detail.empty());
      ++refused;
    }
  }
  CHECK(read > 0);
  CHECK(refused > 0);
}

TEST_CASE("a map's image is looked for beside its YAML file") {
  const fs::path folder = fs::temp_directory_path() / "tutavia_ros_map_test";
  fs::create_directories(folder / "pictures");
  const fs::path yaml = folder / "a.yaml", pgm = folder / "pictures" / "a.pgm";
  REQUIRE(detail::write_file(pgm, image));
  REQUIRE(detail::write_file(yaml, replaced(trinary, "a.pgm", "pictures/a.pgm")));
  const auto relative = read_ros_map(yaml);
  if (!relative) FAIL(relative.error().detail);
  CHECK(relative->values == Values{0, -1, 100, 100, -1, 0});
  REQUIRE(detail::write_file(yaml, replaced(trinary, "a.pgm", '"' + pgm.string() + '"')));
  CHECK(read_ros_map(yaml));

  REQUIRE(detail::write_file(pgm, "GIF89a"));
  CHECK(complaint(read_ros_map(yaml)).find(pgm.string() + ": PGM byte 0: expected P2 or P5") == 0);
  REQUIRE(detail::write_file(yaml, trinary));
  CHECK(complaint(read_ros_map(yaml)) == (folder / "a.pgm").string() + ": cannot be read");
  REQUIRE(detail::write_file(yaml, "image: a.pgm\nresolution 0.05\n"));
  CHECK(complaint(read_ros_map(yaml)).find(yaml.string() + ": line 2: expected key: value") == 0);
  fs::remove_all(folder);
  CHECK(complaint(read_ros_map(yaml)) == yaml.string() + ": cannot be read");
}

}  // namespace
