// SPDX-License-Identifier: MIT
#include "tutavia/io/ros_map_yaml.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
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
  // 1 - 4/5 is less than 0.2 in doubles, and so it is for map_server.
  CHECK(values(yaml, pgm) == Values{100, -1, -1, 0});
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

TEST_CASE("a required key of the YAML that is missing is named, others have nav2's defaults") {
  for (const std::string key : {"image", "resolution", "origin"}) {
    CAPTURE(key);
    CHECK(yaml_complaint(replaced(trinary, key + ":", "other:")) ==
          "the key " + key + " is missing");
  }
  CHECK(yaml_complaint("") == "the key image is missing");
  const auto map = parse_ros_map("image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\n",
                                 replaced(image, "205", "190"));
  if (!map) FAIL(map.error().detail);
  CHECK(map->values == Values{0, -1, 100, 100, -1, 0});
  CHECK(map->warnings ==
        std::vector<std::string>{"the key negate is missing: 0 is assumed",
                                 "the key occupied_thresh is missing: 0.65 is assumed",
                                 "the key free_thresh is missing: 0.25 is assumed"});
}

TEST_CASE("what is wrong with the image is reported by the map, too") {
  CHECK(complaint(parse_ros_map(trinary, "P2 1 1 9")).find("PGM byte 8: expected a pixel") == 0);
  CHECK(parse_ros_map(trinary, "P5 90000 90000 9 ").error().code == PlanError::limit_exceeded);
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
  CHECK(complaint(read_ros_map(yaml)) ==
        pgm.string() + ": expected a PGM, PPM, PNG, BMP or JPEG image, found \"GIF89a\"");
  REQUIRE(detail::write_file(yaml, trinary));
  CHECK(complaint(read_ros_map(yaml)) == (folder / "a.pgm").string() + ": cannot be read");
  REQUIRE(detail::write_file(yaml, "image: a.pgm\nresolution 0.05\n"));
  CHECK(complaint(read_ros_map(yaml)) == yaml.string() + ": the key resolution is missing");
  fs::remove_all(folder);
  CHECK(complaint(read_ros_map(yaml)) == yaml.string() + ": cannot be read");
}

/// The value that nav2_map_server publishes for a pixel of 8 bits: nav2_map_server/src/map_io.cpp,
/// loadMapFromFile, up to Jazzy.
int published(int pixel, const std::string& mode, bool negate, double free, double occupied) {
  const double shade = pixel / 255.0;
  const double occ = negate ? shade : 1.0 - shade;
  if (mode == "raw") {
    const double level = std::round(shade * 255);
    return 0 <= level && level <= 100 ? static_cast<int>(level) : -1;
  }
  if (occupied < occ) return 100;
  if (occ < free) return 0;
  return mode == "trinary" ? -1
                           : static_cast<int>(std::rint((occ - free) / (occupied - free) * 100.0));
}

TEST_CASE("every pixel has the value that map_server publishes, in every mode") {
  std::string pixels = "P2 256 1 255";
  for (int pixel = 0; pixel < 256; ++pixel) pixels += " " + std::to_string(pixel);
  struct Thresholds {
    std::string free, occupied;
  };
  for (const auto& [free, occupied] : {Thresholds{"0.196", "0.65"},
                                       {"0.25", "0.65"},
                                       {"0.2", "0.6"},
                                       {"0", "1"},
                                       {"0.4", "0.8"}}) {
    for (const std::string mode : {"trinary", "scale", "raw"}) {
      for (const bool negate : {false, true}) {
        CAPTURE(free, occupied, mode, negate);
        const auto map = values("image: a\nresolution: 1\norigin: [0, 0, 0]\nfree_thresh: " + free +
                                    "\noccupied_thresh: " + occupied + "\nmode: " + mode +
                                    "\nnegate: " + (negate ? "1" : "0"),
                                pixels);
        for (int pixel = 0; pixel < 256; ++pixel) {
          CAPTURE(pixel);
          REQUIRE(map[static_cast<std::size_t>(pixel)] ==
                  published(pixel, mode, negate, std::stod(free), std::stod(occupied)));
        }
      }
    }
  }
}

TEST_CASE("the grey of unknown cells that counts as free is warned of where map_saver writes it") {
  const auto warnings = [](const std::string& yaml) {
    return parse_ros_map(yaml, image).value().warnings;
  };
  const std::string wide = replaced(trinary, "0.196", "0.25");
  const std::vector<std::string> expected{
      "grey 205, which map_saver writes for unknown cells, counts as free (1 of them): free_thresh "
      "is above 0.196"};
  CHECK(warnings(wide) == expected);
  CHECK(warnings(trinary).empty());
  CHECK(warnings(wide + "mode: scale").empty());
  CHECK(warnings(replaced(wide, "negate: 0", "negate: 1")).empty());
  CHECK(parse_ros_map(wide, "P2 2 1 255 206 204")->warnings.empty());
  CHECK(parse_ros_map(wide, "P2 2 1 65535 52685 0")->warnings == expected);
}

TEST_CASE("an image whose path begins with ~/ is looked for in the home folder") {
  const fs::path folder = fs::temp_directory_path() / "tutavia_ros_map_home";
  fs::create_directories(folder / "maps");
  REQUIRE(detail::write_file(folder / "a.pgm", image));
  REQUIRE(detail::write_file(folder / "maps" / "a.yaml", replaced(trinary, "a.pgm", "~/a.pgm")));
  const char* const home = std::getenv("HOME");
  const std::string before = home == nullptr ? "" : home;
  REQUIRE(::setenv("HOME", folder.c_str(), 1) == 0);
  const auto map = read_ros_map(folder / "maps" / "a.yaml");
  if (home != nullptr) {
    ::setenv("HOME", before.c_str(), 1);
  } else {
    ::unsetenv("HOME");
  }
  if (!map) FAIL(map.error().detail);
  CHECK(map->values == Values{0, -1, 100, 100, -1, 0});
  CHECK(detail::image_path("maps/a.yaml", "~a.pgm") == fs::path("maps/~a.pgm"));
  fs::remove_all(folder);
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

TEST_CASE("floods of YAML are refused or read without harm") {
  for (const int depth : {400, 100000}) {
    for (const char* open : {"[", "{", "{a: ", "- ", "? ", "&a ", "!", "a: [", "\""}) {
      CAPTURE(depth, open);
      CHECK_FALSE(parse_ros_map(repeated(open, depth), image));
    }
    const auto deep = parse_ros_map("a: " + repeated("[", depth) + repeated("]", depth), image);
    REQUIRE_FALSE(deep);
    CHECK(deep.error().detail.find(depth < 500 ? "the key image" : "line 1, column ") == 0);
  }
  std::string bomb = "a0: &a0 [x]\n";  // of 10^29 scalars, were aliases copied
  for (int i = 1; i < 30; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" +
            repeated(alias + ", ", 10) + "]\n";
  }
  const auto map = parse_ros_map(bomb + trinary, image);
  if (!map) FAIL(map.error().detail);
  CHECK(map->warnings.size() == 30);
  CHECK(yaml_complaint(bomb + replaced(trinary, "0.05", "*a29")) ==
        "line 30: expected resolution: a number above 0, found a list of 10");
}

}  // namespace
