// SPDX-License-Identifier: MIT
/// \file
/// Files of ROS maps as tools and people write them, with what is read from each of them.

#include <array>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/io/ros_map_yaml.hpp"

namespace {

using namespace tutavia;

const std::filesystem::path inputs_folder = std::filesystem::path(TUTAVIA_TEST_DATA) / "inputs";

std::string number_text(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// Size, resolution, origin and yaw; the number of free, occupied and unknown cells; the values of
/// the middle row from the left, or of all rows from the bottom if they are few; the warnings.
std::string description(const RosMap& map) {
  std::string text = std::to_string(map.width) + "x" + std::to_string(map.height);
  for (const double value : {map.resolution, map.origin.x(), map.origin.y(), map.yaw}) {
    text += " " + number_text(value);
  }
  std::array<std::size_t, 3> counts{};
  for (const int value : map.values) ++counts[value < 0 ? 2U : value < 100 ? 0U : 1U];
  text += ", " + std::to_string(counts[0]) + " free " + std::to_string(counts[1]) + " occupied " +
          std::to_string(counts[2]) + " unknown:";
  std::vector<std::int8_t> shown = map.values;
  if (shown.size() > 20) {
    const auto row = map.values.begin() + std::ptrdiff_t{map.height / 2} * map.width;
    shown.assign(row, row + map.width);
  }
  for (std::size_t i = 0, end = 0; i < shown.size(); i = end) {
    while (end < shown.size() && shown[end] == shown[i]) ++end;
    text += " " + std::to_string(shown[i]);
    if (end - i > 1) text += "*" + std::to_string(end - i);
  }
  for (const std::string& warning : map.warnings) text += "\n" + warning;
  return text;
}

/// A description, or "refused: " and the reason, without the folder of the inputs.
std::string outcome_of(const Expected<RosMap, Failure>& map) {
  if (map) return description(*map);
  std::string reason = map.error().detail;
  const std::string folder = inputs_folder.string() + "/";
  if (reason.rfind(folder, 0) == 0) reason.erase(0, folder.size());
  return "refused: " + reason;
}

/// The maps of one folder.
struct FolderCases {
  const char* folder;
  struct Case {
    const char* file;
    const char* outcome;
  };
  std::vector<Case> cases;
};

void check_folder(const FolderCases& expected) {
  std::set<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(inputs_folder / expected.folder)) {
    if (entry.path().extension() == ".yaml") left.insert(entry.path().filename().string());
  }
  for (const auto& [file, outcome] : expected.cases) {
    CAPTURE(file);
    CHECK(left.erase(file) == 1);
    CHECK(outcome_of(read_ros_map(inputs_folder / expected.folder / file)) == outcome);
  }
  CAPTURE(left.empty() ? "" : *left.begin());
  CHECK(left.empty());
}

const std::vector<FolderCases> folders{
    {"01-yaw-nan",  // a yaw that is not a number
     {
         {"map.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100\n"
          "line 3: the yaw of origin is not a number: 0 is assumed"},
     }},
    {"02-yaw",  // turned maps
     {
         {"flat.yaml",
          "20x16 0.05 -21.2 -14.9 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"map.yaml",
          "20x16 0.05 -21.2 -14.9 1.56, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"minus0.yaml",
          "20x16 0.05 -21.2 -14.9 -0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
     }},
    {"03-png",  // images of other formats
     {
         {"bits1_png.yaml", "3x2 0.05 1 2 0, 3 free 3 occupied 0 unknown: 0 100 0 100 0 100"},
         {"blocks_jpg.yaml",
          "16x16 0.05 1 2 0, 128 free 128 occupied 0 unknown: 0*8 100*8\n"
          "image: JPEG blurs edges: a PNG or PGM image keeps walls as they are"},
         {"colour_bmp.yaml", "3x2 0.05 1 2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
         {"cut_bmp.yaml", "refused: 03-png/cut.bmp: BMP image: cut short"},
         {"cut_jpg.yaml", "refused: 03-png/cut.jpg: JPEG image: cut short"},
         {"cut_png.yaml", "refused: 03-png/cut.png: PNG image: cut short"},
         {"flipped_png.yaml",
          "refused: 03-png/flipped.png: PNG image: damaged (a checksum is wrong)"},
         {"grey16_png.yaml", "3x2 0.05 1 2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
         {"grey_alpha_raw.yaml", "3x2 0.05 1 2 0, 2 free 1 occupied 3 unknown: -1 100 89 0 -1*2"},
         {"grey_alpha_scale.yaml", "3x2 0.05 1 2 0, 2 free 2 occupied 2 unknown: -1*2 100*2 0*2"},
         {"grey_alpha_trinary.yaml",
          "3x2 0.05 1 2 0, 2 free 1 occupied 3 unknown: -1*3 100 0*2\n"
          "image: alpha counts as a colour, as in map_server: opaque cells look freer than "
          "their grey"},
         {"grey_bmp.yaml", "3x2 0.05 1 2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
         {"huge_png.yaml",
          "refused: 03-png/huge.png: PNG image: 30000 x 30000 pixels do not fit into its data"},
         {"map.yaml", "20x16 0.0333 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"named_jpg.yaml", "3x2 0.05 1 2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
         {"no_end_png.yaml", "refused: 03-png/no_end.png: PNG image: cut short"},
         {"palette_png.yaml", "3x2 0.05 1 2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
         {"picture_gif.yaml",
          "refused: 03-png/picture.gif: expected a PGM, PPM, PNG, BMP or JPEG image, found "
          "\"GIF89a\""},
         {"rgb16_png.yaml", "2x1 0.05 1 2 0, 1 free 1 occupied 0 unknown: 100 0"},
         {"rgb_png.yaml", "3x2 0.05 1 2 0, 2 free 3 occupied 1 unknown: 0 100*3 -1 0"},
         {"rgba_raw.yaml", "3x2 0.05 1 2 0, 2 free 0 occupied 4 unknown: -1*2 0*2 -1*2"},
         {"rgba_scale.yaml", "3x2 0.05 1 2 0, 2 free 2 occupied 2 unknown: -1*2 100*2 0*2"},
         {"rgba_trinary.yaml",
          "3x2 0.05 1 2 0, 3 free 2 occupied 1 unknown: -1 0 100*2 0*2\n"
          "image: alpha counts as a colour, as in map_server: opaque cells look freer than "
          "their grey"},
         {"top_down_bmp.yaml", "3x2 0.05 1 2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
     }},
    {"04-quoted",  // quoted values
     {
         {"bad.yaml",
          "refused: 04-quoted/bad.yaml: line 2: expected resolution: a number above 0, found 5 "
          "cm"},
         {"map.yaml", "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
     }},
    {"06-free-thresh",  // thresholds of map_server and nav2
     {
         {"map_0.196.yaml", "20x16 0.05 0 0 0, 144 free 68 occupied 108 unknown: 100 -1*18 100"},
         {"map_0.25.yaml",
          "20x16 0.05 0 0 0, 252 free 68 occupied 0 unknown: 100 0*18 100\n"
          "grey 205, which map_saver writes for unknown cells, counts as free (108 of them): "
          "free_thresh is above 0.196"},
     }},
    {"07-maxval",  // variants of PGM
     {
         {"black.yaml",
          "refused: 07-maxval/black.pgm: PGM byte 7: expected a greatest value from 1 to "
          "65535, found \"0 \""},
         {"blankline.pgm.yaml",
          "3x2 1 0 0 0, 6 free 0 occupied 0 unknown: 0*6\n"
          "image: blank lines or comments before the pixels were skipped"},
         {"comments.pgm.yaml", "3x2 1 0 0 0, 6 free 0 occupied 0 unknown: 0*6"},
         {"crlf.pgm.yaml",
          "3x2 1 0 0 0, 6 free 0 occupied 0 unknown: 0*6\n"
          "image: the line ends of the header are CR LF"},
         {"oneline.pgm.yaml", "3x2 1 0 0 0, 6 free 0 occupied 0 unknown: 0*6"},
         {"p2.pgm.yaml", "3x2 1 0 0 0, 6 free 0 occupied 0 unknown: 0*6"},
         {"p6.pgm.yaml",
          "1x1 1 0 0 0, 1 free 0 occupied 0 unknown: 0\n"
          "image: the image has colours: the mean of red, green and blue counts"},
         {"pil.yaml", "15x7 1 0 0 0, 8 free 88 occupied 9 unknown: 100*7 -1 100*2 0 100*4"},
         {"pil_neg.yaml", "15x7 1 0 0 0, 76 free 8 occupied 21 unknown: 0 -1*4 0*2 -1 0*2 100 0*4"},
         {"short.pgm.yaml",
          "refused: 07-maxval/short.pgm: PGM byte 16: expected a pixel from 0 to 255, found "
          "the end of the file"},
         {"trailnl.pgm.yaml",
          "3x2 1 0 0 0, 6 free 0 occupied 0 unknown: 0*6\n"
          "image: a line end or blanks after the last pixel were skipped"},
     }},
    {"29-yaml",  // YAML as tools and people write it
     {
         {"anchors.yaml", "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"backslash.yaml", "refused: 29-yaml/maps\\map.pgm: cannot be read"},
         {"blank_first.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"block_list.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"block_list_indented.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"bom.yaml", "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"colon_in_name.yaml", "refused: 29-yaml/C:/maps/map.pgm: cannot be read"},
         {"colon_nospace.yaml",
          "refused: 29-yaml/colon_nospace.yaml: line 2, column 11: illegal map value"},
         {"comma_decimal.yaml",
          "refused: 29-yaml/comma_decimal.yaml: line 2: expected resolution: a number above 0, "
          "found 0,05"},
         {"comment_no_space.yaml",
          "refused: 29-yaml/comment_no_space.yaml: line 4: expected negate: 0 or 1, found 0# "
          "normal"},
         {"crlf.yaml", "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"dot_end.yaml", "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"dotslash.yaml", "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"dup.yaml",
          "refused: 29-yaml/dup.yaml: line 7: expected every key once, found negate again, "
          "first in line 4"},
         {"exp.yaml", "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"free_eq_occ.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"free_gt_occ.yaml",
          "refused: 29-yaml/free_gt_occ.yaml: line 6: expected free_thresh: a number from 0 to "
          "occupied_thresh, found 0.7"},
         {"free_missing.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100\n"
          "the key free_thresh is missing: 0.25 is assumed"},
         {"hash_in_name.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"indented.yaml", "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"lambda_extra.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100\n"
          "line 7: unknown key cost"},
         {"mode_TRINARY.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"mode_Trinary.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"mode_scale.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"multiline_flow.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"negate_0.0.yaml",
          "refused: 29-yaml/negate_0.0.yaml: line 4: expected negate: 0 or 1, found 0.0"},
         {"negate_False.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"negate_missing.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100\n"
          "the key negate is missing: 0 is assumed"},
         {"nested_extra.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100\n"
          "line 7: unknown key size"},
         {"ok.yaml", "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"origin2.yaml",
          "refused: 29-yaml/origin2.yaml: line 3: expected origin with 3 values, found a list "
          "of 2"},
         {"origin_xyz_yaw4.yaml",
          "refused: 29-yaml/origin_xyz_yaw4.yaml: line 3: expected origin with 3 values, found "
          "a list of 4"},
         {"percent.yaml",
          "refused: 29-yaml/percent.yaml: line 5: expected occupied_thresh: a number from 0 to "
          "1, found 65"},
         {"plus.yaml", "20x16 0.05 0 -0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"space_in_name.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"tab_after_colon.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"trailing_comma.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"utf8_comment.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
         {"yaml_directive.yaml",
          "20x16 0.05 0 0 0, 246 free 74 occupied 0 unknown: 100 0*8 100 0*9 100"},
     }},
};

/// A text and what is read from it.
struct TextCase {
  std::string text;
  const char* outcome;
};

const std::string plain_settings =
    "image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
const std::string plain_pixels = "P2\n3 2\n255\n0 205 254\n255 100 89\n";

/// Texts that map_server reads.
const std::vector<TextCase> yaml_texts{
    {"{image: a.pgm, resolution: 0.05, origin: [1.5, -2, 0], negate: 0, occupied_thresh: "
     "0.65, free_thresh: 0.196}",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
    {"{\"image\": \"a.pgm\", \"resolution\": 0.05,\n"
     " \"origin\": [1.5, -2, 0], \"negate\": 0,\n"
     " \"occupied_thresh\": 0.65, \"free_thresh\": 0.196,}\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
    {"# a map\n---\nimage: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n...\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
    {"\"image\" : 'a.pgm'\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
    {"image: a.pgm\nresolution: 0.05\norigin:\n  [\n    1.5, # x\n    -2,\n    0,\n  ]\n"
     "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
    {"image: a.pgm\nresolution: 0.05\norigin: !!seq [!!float 1.5, \"-2\", +0e0]\n"
     "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
    {"defaults: {size: &size 0.05, at: &at [1.5, -2, 0]}\nimage: a.pgm\n"
     "resolution: *size\norigin: *at\nnegate: 0\noccupied_thresh: 0.65\n"
     "free_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0\n"
     "line 1: unknown key defaults"},
    {"image: >-\n  a\n  b.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, .NaN]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0\n"
     "line 3: the yaw of origin is not a number: 0 is assumed"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, nan]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0\n"
     "line 3: the yaw of origin is not a number: 0 is assumed"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, +6.5]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 6.5, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 1\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 1 free 3 occupied 2 unknown: 100 -1*2 0 100*2"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: yes\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 1 free 3 occupied 2 unknown: 100 -1*2 0 100*2"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: OFF\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: \"True\"\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 1 free 3 occupied 2 unknown: 100 -1*2 0 100*2"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: -3\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 1 free 3 occupied 2 unknown: 100 -1*2 0 100*2\n"
     "line 4: negate: -3 counts as 1"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\n",
     "3x2 0.05 1.5 -2 0, 3 free 2 occupied 1 unknown: 0 -1 100*2 0*2\n"
     "the key negate is missing: 0 is assumed\n"
     "the key occupied_thresh is missing: 0.65 is assumed\n"
     "the key free_thresh is missing: 0.25 is assumed\n"
     "grey 205, which map_saver writes for unknown cells, counts as free (1 of them): "
     "free_thresh is above 0.196"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\nmode: SCALE\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 4 free 2 occupied 0 unknown: 0 91 100*2 0*2"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 1\nmode: raw\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 2 free 1 occupied 3 unknown: -1 100 89 0 -1*2\n"
     "negate changes nothing in raw mode"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\nmode: Raw\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "3x2 0.05 1.5 -2 0, 2 free 1 occupied 3 unknown: -1 100 89 0 -1*2"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.25\n",
     "3x2 0.05 1.5 -2 0, 3 free 2 occupied 1 unknown: 0 -1 100*2 0*2\n"
     "grey 205, which map_saver writes for unknown cells, counts as free (1 of them): "
     "free_thresh is above 0.196"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 1\nfree_thresh: 0\n",
     "3x2 0.05 1.5 -2 0, 0 free 0 occupied 6 unknown: -1*6"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\nmap_type: [a, {b: c}]\n? [x, y]\n: odd\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0\n"
     "line 7: unknown key map_type\nline 8: unknown key a list of 2"},
    {"image: a.pgm\r\nresolution: 5.0e-2 # five centimetres\r\norigin: [1.5, -2, 0]\r\n"
     "negate: 0\r\noccupied_thresh: 0.65\r\nfree_thresh: 0.196\r\n",
     "3x2 0.05 1.5 -2 0, 2 free 2 occupied 2 unknown: 0 -1 100*2 -1 0"},
};

const std::vector<TextCase> bad_yaml_texts{
    {"", "refused: the key image is missing"},
    {"# nothing\n", "refused: the key image is missing"},
    {"image\n", "refused: line 1: expected a map of keys, found image"},
    {"- image: a.pgm\n", "refused: line 1: expected a map of keys, found a list of 1"},
    {"[image, a.pgm]", "refused: line 1: expected a map of keys, found a list of 2"},
    {"\"image: a.pgm\"\n", "refused: line 1: expected a map of keys, found image: a.pgm"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\nresolution: 0.1\n",
     "refused: line 7: expected every key once, found resolution again, first in line 2"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n\"image\": b.pgm\n",
     "refused: line 7: expected every key once, found image again, first in line 1"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\nextra: 1\nextra: 2\n",
     "refused: line 8: expected every key once, found extra again, first in line 7"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n---\nnegate: 1\n",
     "refused: line 7: expected the end of the file after the first document"},
    {"{image: a.pgm}\nnegate: 1\n", "refused: line 2..."},
    {"image: \nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
     "free_thresh: 0.196\n",
     "refused: line 1: expected image: the name of a file, found nothing"},
    {"image: \"\"\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 1: expected image: the name of a file, found \"\""},
    {"image: [a.pgm]\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 1: expected image: the name of a file, found a list of 1"},
    {"resolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
     "free_thresh: 0.196\n",
     "refused: the key image is missing"},
    {"image: a.pgm\nresolution: 0\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2: expected resolution: a number above 0, found 0"},
    {"image: a.pgm\nresolution: -0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2: expected resolution: a number above 0, found -0.05"},
    {"image: a.pgm\nresolution: .inf\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2: expected resolution: a number above 0, found .inf"},
    {"image: a.pgm\nresolution: 1e999\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2: expected resolution: a number above 0, found 1e999"},
    {"image: a.pgm\nresolution: 1e-400\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2: expected resolution: a number above 0, found 1e-400"},
    {"image: a.pgm\nresolution: 0x1p-4\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2: expected resolution: a number above 0, found 0x1p-4"},
    {"image: a.pgm\nresolution: +-1\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2: expected resolution: a number above 0, found +-1"},
    {"image: a.pgm\nresolution: 5e-2m\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2: expected resolution: a number above 0, found 5e-2m"},
    {"image: a.pgm\nresolution: {a: 1}\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2: expected resolution: a number above 0, found a map"},
    {"image: a.pgm\nresolution: 1_000\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2: expected resolution: a number above 0, found 1_000"},
    {"image: a.pgm\nresolution: 0.05\norigin: 1.5 -2 0\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 3: expected origin with 3 values, found 1.5 -2 0"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1,5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 3: expected origin with 3 values, found a list of 4"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, [-2], 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 3: expected origin: x, y and yaw, found a list of 1"},
    {"image: a.pgm\nresolution: 0.05\norigin: [.nan, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 3: expected origin: x, y and yaw, found .nan"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, inf]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 3: expected origin: x, y and yaw, found inf"},
    {"image: a.pgm\nresolution: 0.05\norigin: {x: 1.5, y: -2, yaw: 0}\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 3: expected origin with 3 values, found a map"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 4, column 7: end of sequence flow not found"},
    {"image: a.pgm\nresolution: 0.05\norigin: *at\nnegate: 0\noccupied_thresh: 0.65\n"
     "free_thresh: 0.196\n",
     "refused: line 3, column 9: the referenced anchor is not defined..."},
    {"image: a.pgm\nresolution: 0.05\norigin: &o [*o, *o, *o]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 3: expected origin: x, y and yaw, found a list of 3"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: maybe\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 4: expected negate: 0 or 1, found maybe"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: yEs\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 4: expected negate: 0 or 1, found yEs"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0.5\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 4: expected negate: 0 or 1, found 0.5"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate:\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 4: expected negate: 0 or 1, found nothing"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n mode: raw\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 5, column 6: illegal map value"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\nmode: binary\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 5: expected mode: trinary, scale or raw, found binary"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\n\tnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 4, column 2: end of map not found"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 1.01\nfree_thresh: 0.196\n",
     "refused: line 5: expected occupied_thresh: a number from 0 to 1, found 1.01"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: nan\nfree_thresh: 0.196\n",
     "refused: line 5: expected occupied_thresh: a number from 0 to 1, found nan"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: -0.1\n",
     "refused: line 6: expected free_thresh: a number from 0 to occupied_thresh, found "
     "-0.1"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.66\n",
     "refused: line 6: expected free_thresh: a number from 0 to occupied_thresh, found "
     "0.66"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.2\n",
     "refused: the key free_thresh is missing, and its default, 0.25, is above "
     "occupied_thresh"},
    {std::string("image: a.pgm\nresolution\000: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
                 "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
                 103),
     "refused: line 2: expected text, found byte 0x00"},
    {"image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\nnegate: 0\004\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 4: expected text, found byte 0x04"},
    {"%YAML 1.2\n%YAML 1.2\n---\nimage: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\n"
     "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2, column 1: repeated YAML directive"},
    {"image: a.pgm\nresolution: \"0.05\norigin: [1.5, -2, 0]\nnegate: 0\n"
     "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
     "refused: line 2: expected resolution: a number above 0, found 0.05 origin: [1.5, "
     "-2, 0] negate: 0 occupied_thresh: 0.65 fr..."},
};

const std::vector<TextCase> image_texts{
    {"P2 3 1 255 0 205 254", "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0"},
    {std::string("P5 3 1 255\n\000\315\376", 14),
     "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0"},
    {std::string("P5\r\n3 1\r\n255\r\n\000\315\376\r\n", 19),
     "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0\n"
     "image: the line ends of the header are CR LF\n"
     "image: a line end or blanks after the last pixel were skipped"},
    {std::string("P5 3 1 255\n\n\000\315\376", 15),
     "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0\n"
     "image: blank lines or comments before the pixels were skipped"},
    {std::string("P5 3 1 255\n# late\n\000\315\376", 21),
     "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0\n"
     "image: blank lines or comments before the pixels were skipped"},
    {std::string("P5 3 1 255 # late\n\000\315\376", 21),
     "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0\n"
     "image: blank lines or comments before the pixels were skipped"},
    {std::string("P5 3 1 255#late\n\000\315\376", 19),
     "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0\n"
     "image: a comment after the greatest value was skipped"},
    {std::string("P5 3 1 255\n\000\315\376\n", 15),
     "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0\n"
     "image: a line end or blanks after the last pixel were skipped"},
    {std::string("P5 3 1 255\n\000\315\376P5 1 1 255\n\000", 26),
     "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0\n"
     "image: only the first of several images is read"},
    {"P2 3 1 255 0 205 254\nP2 1 1 1 0",
     "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0\n"
     "image: only the first of several images is read"},
    {std::string("P5 3 1 65535\n\000\000\315\315\376\376", 19),
     "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0"},
    {std::string("P6 1 1 255\n\377\000\000", 14),
     "1x1 0.05 1.5 -2 0, 0 free 1 occupied 0 unknown: 100\n"
     "image: the image has colours: the mean of red, green and blue counts"},
    {"P3 2 1 9 9 9 9 0 0 0",
     "2x1 0.05 1.5 -2 0, 1 free 1 occupied 0 unknown: 0 100\n"
     "image: the image has colours: the mean of red, green and blue counts"},
    {"P2 3 1 9 0 7 9 # end", "3x1 0.05 1.5 -2 0, 1 free 1 occupied 1 unknown: 100 -1 0"},
    {"", "refused: expected a PGM, PPM, PNG, BMP or JPEG image, found the end of the file"},
    {"P", "refused: PGM byte 0: expected a PGM or PPM image (P2, P3, P5 or P6), found \"P\""},
    {std::string("P4 8 1\n\000", 8),
     "refused: PGM byte 0: expected a PGM or PPM image (P2, P3, P5 or P6), found \"P4 8 "
     "1\""},
    {"P5", "refused: PGM byte 2: expected a width above 0, found the end of the file"},
    {std::string("P5 3 1 0\n\000\000\000", 12),
     "refused: PGM byte 7: expected a greatest value from 1 to 65535, found \"0\""},
    {"P5 3 1 65536\n",
     "refused: PGM byte 7: expected a greatest value from 1 to 65535, found \"65536\""},
    {"P2 3 1 255 0 205",
     "refused: PGM byte 16: expected a pixel from 0 to 255, found the end of the file"},
    {"P2 3 1 255 0 205 256", "refused: PGM byte 17: expected a pixel from 0 to 255, found \"256\""},
    {"P2 3 1 255 0 205 -1", "refused: PGM byte 17: expected a pixel from 0 to 255, found \"-1\""},
    {"P2 3 1 255 0 205 254 7",
     "refused: PGM byte 21: expected nothing after the last pixel, found \"7\""},
    {std::string("P5 3 1 255\n\000\315", 13),
     "refused: PGM byte 13: expected a pixel from 0 to 255, found the end of the file"},
    {std::string("P5 3 1 200\n\000\315\376", 14),
     "refused: PGM byte 12: expected a pixel from 0 to 200, found 205"},
    {std::string("P5 3 1 255\n\000\315\376\376", 15),
     "refused: PGM byte 14: expected nothing after the last pixel, found byte 0xFE"},
    {"P5 3 1 255\n\n\315\376\n",
     "refused: PGM byte 11: expected pixels at a certain place, found blanks that may be "
     "pixels before and after them"},
    {std::string("P5 3 1 255\000\315\376\376", 14),
     "refused: PGM byte 10: expected a blank, then pixels, found byte 0x00"},
    {"P5 3 -1 255\n", "refused: PGM byte 5: expected a height above 0, found \"-1 255\""},
    {"P5 40000 40000 255\n",
     "refused: PGM image of 40000 x 40000 pixels needed, 1073741824 pixels allowed"},
    {"\211PNG\r\n\032\n", "refused: PNG image: cut short"},
    {"BM", "refused: BMP image: unknown image type"},
    {"\377\330\377\340", "refused: JPEG image: cut short"},
    {"RIFF", "refused: expected a PGM, PPM, PNG, BMP or JPEG image, found \"RIFF\""},
    {std::string("\000", 1),
     "refused: expected a PGM, PPM, PNG, BMP or JPEG image, found byte 0x00"},
    {"P5 3.5 1 255 ", "refused: PGM byte 4: expected a height above 0, found \".5 1 255 \""},
};

TEST_CASE("inputs of ROS maps: files of tools and users") {
  for (const FolderCases& folder : folders) check_folder(folder);
}

TEST_CASE("inputs of ROS maps: texts that yaml-cpp and map_server read") {
  for (const auto& [text, outcome] : yaml_texts) {
    CAPTURE(text);
    CHECK(outcome_of(parse_ros_map(text, plain_pixels)) == outcome);
  }
}

TEST_CASE("inputs of ROS maps: texts that mean nothing") {
  for (const auto& [text, outcome] : bad_yaml_texts) {
    CAPTURE(text);
    const std::string_view expected = outcome;
    const std::string found = outcome_of(parse_ros_map(text, plain_pixels));
    // Versions of yaml-cpp differ in what they say; the line is the same.
    if (expected.substr(expected.size() - 3) == "...") {
      CHECK(found.substr(0, expected.size() - 3) == expected.substr(0, expected.size() - 3));
    } else {
      CHECK(found == expected);
    }
  }
}

TEST_CASE("inputs of ROS maps: images, whole and broken") {
  for (const auto& [text, outcome] : image_texts) {
    CAPTURE(text);
    CHECK(outcome_of(parse_ros_map(plain_settings, text)) == outcome);
  }
}

}  // namespace
