// SPDX-License-Identifier: MIT
#include "tutavia/io/text/pgm.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

const std::string plain_image = "P2\n3 2\n255\n0 205 254\n255 100 89\n";

std::string as_bytes(const std::vector<int>& values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}

std::string pgm_complaint(const std::string& pgm) {
  const auto read = detail::parse_pgm(pgm);
  REQUIRE_FALSE(read);
  CHECK(read.error().code == PlanError::invalid_input);
  return read.error().detail;
}

TEST_CASE("a plain PGM is read row by row from the top") {
  const auto pgm = detail::parse_pgm(plain_image);
  REQUIRE(pgm);
  CHECK(pgm->width == 3);
  CHECK(pgm->height == 2);
  CHECK(pgm->max_value == 255);
  CHECK(pgm->pixels == std::vector<std::uint16_t>{0, 205, 254, 255, 100, 89});
}

TEST_CASE("comments and blanks of any kind may stand between the numbers of a plain PGM") {
  const std::string text =
      "P2# made by hand\r\n# width:\n\t3 #height\n\n2#\n#\n# maximum\n255 0 205\v254\f\r\n"
      "# bottom 1 2 3\n255 100#\n89#end";
  const auto pgm = detail::parse_pgm(text);
  if (!pgm) FAIL(pgm.error().detail);
  CHECK(pgm->pixels == detail::parse_pgm(plain_image)->pixels);
  CHECK(detail::parse_pgm("P2 # of an old Mac\r1 1 9 5")->pixels == std::vector<std::uint16_t>{5});
}

TEST_CASE("a raw PGM has its pixels right behind one blank, whatever their bytes mean") {
  const auto pgm =
      detail::parse_pgm("P5\n# two rows\n2 2\n255\n" + as_bytes({'#', '\n', ' ', 255}));
  REQUIRE(pgm);
  CHECK(pgm->pixels == std::vector<std::uint16_t>{35, 10, 32, 255});
  CHECK(detail::parse_pgm("P5 1 1 9 " + as_bytes({9}))->pixels == std::vector<std::uint16_t>{9});
}

TEST_CASE("a raw PGM of more than 8 bits has two bytes per pixel, the high one first") {
  const auto pgm = detail::parse_pgm("P5 3 1 65535\n" + as_bytes({1, 2, 0, 255, 255, 0}));
  REQUIRE(pgm);
  CHECK(pgm->pixels == std::vector<std::uint16_t>{258, 255, 65280});
  CHECK(detail::parse_pgm("P5 1 1 256 " + as_bytes({1, 0}))->pixels ==
        std::vector<std::uint16_t>{256});
  CHECK(detail::parse_pgm("P2 1 1 65535 65535")->pixels == std::vector<std::uint16_t>{65535});
}

TEST_CASE("a malformed PGM is reported with the byte") {
  const std::string end = "found the end of the file";
  const std::string kinds = "PGM byte 0: expected a PGM or PPM image (P2, P3, P5 or P6), ";
  CHECK(pgm_complaint("") == kinds + end);
  CHECK(pgm_complaint("\x89PNG\r\n") == kinds + "found byte 0x89");
  CHECK(pgm_complaint("P4 1 1 abc") == kinds + "found \"P4 1 1 abc\"");
  CHECK(pgm_complaint("P5\x01") == "PGM byte 2: expected a width above 0, found byte 0x01");
  CHECK(pgm_complaint("P5") == "PGM byte 2: expected a width above 0, " + end);
  CHECK(pgm_complaint("P25 5 255") == "PGM byte 2: expected a width above 0, found \"5 5 255\"");
  CHECK(pgm_complaint("P2 x") == "PGM byte 3: expected a width above 0, found \"x\"");
  CHECK(pgm_complaint("P2 0 4 255") == "PGM byte 3: expected a width above 0, found \"0 4 255\"");
  CHECK(pgm_complaint("P2 4 -4 9") == "PGM byte 5: expected a height above 0, found \"-4 9\"");
  CHECK(pgm_complaint("P2 4.5 4").find("PGM byte 4: expected a height above 0") == 0);
  for (const std::string white : {"0", "65536", "99999999999999999999", "-1", "white"}) {
    CAPTURE(white);
    CHECK(pgm_complaint("P2 1 1 " + white) ==
          "PGM byte 7: expected a greatest value from 1 to 65535, found \"" + white + '"');
  }
  CHECK(pgm_complaint("P5 1 1 255") == "PGM byte 10: expected a blank, then pixels, " + end);
  CHECK(pgm_complaint("P5 1 1 255#\n") == "PGM byte 12: expected a pixel from 0 to 255, " + end);
}

TEST_CASE("pixels that are missing, too many or too large are reported with the byte") {
  const std::string end = "found the end of the file";
  CHECK(pgm_complaint("P2 2 1 15 7 ") == "PGM byte 12: expected a pixel from 0 to 15, " + end);
  CHECK(pgm_complaint("P2 2 1 15 7 16") ==
        "PGM byte 12: expected a pixel from 0 to 15, found \"16\"");
  CHECK(pgm_complaint("P2 2 1 15 7 -1").find("PGM byte 12: ") == 0);
  CHECK(pgm_complaint("P2 2 1 15 7 1 0") ==
        "PGM byte 14: expected nothing after the last pixel, found \"0\"");
  CHECK(pgm_complaint("P5 2 1 15 " + as_bytes({7})) ==
        "PGM byte 11: expected a pixel from 0 to 15, " + end);
  CHECK(pgm_complaint("P5 2 1 15 " + as_bytes({7, 16})) ==
        "PGM byte 11: expected a pixel from 0 to 15, found 16");
  CHECK(pgm_complaint("P5 2 1 15\n" + as_bytes({7, 8, 9, 1})) ==
        "PGM byte 13: expected nothing after the last pixel, found byte 0x01");
  CHECK(pgm_complaint("P5 1 1 300 " + as_bytes({1})) ==
        "PGM byte 12: expected a pixel from 0 to 300, " + end);
  CHECK(pgm_complaint("P5 1 1 300 " + as_bytes({1, 45})) ==
        "PGM byte 11: expected a pixel from 0 to 300, found 301");
}

TEST_CASE("a huge PGM is refused before anything is allocated") {
  for (const std::string size : {"40000 40000", "4611686018427387904 4", "1 1073741825",
                                 "99999999999999999999 99999999999999999999"}) {
    CAPTURE(size);
    for (const std::string kind : {"P2 ", "P5 "}) {
      const auto pgm = detail::parse_pgm(kind + size + " 255 ");
      REQUIRE_FALSE(pgm);
      CHECK(pgm.error().code == PlanError::limit_exceeded);
      CHECK(pgm.error().detail.find("1073741824 pixels allowed") != std::string::npos);
    }
  }
  CHECK(pgm_complaint("P2 32768 32768 255 1").find("found the end of the file") !=
        std::string::npos);
}

/// What is read with a warning: the pixels, and the warnings.
void check_doubtful(const std::string& text, const std::vector<std::uint16_t>& pixels,
                    const std::vector<std::string>& warnings) {
  CAPTURE(text);
  const auto pgm = detail::parse_pgm(text);
  if (!pgm) FAIL(pgm.error().detail);
  CHECK(pgm->pixels == pixels);
  CHECK(pgm->warnings == warnings);
}

TEST_CASE("blanks and images after the last pixel of a raw PGM are skipped with a warning") {
  const std::string after = "a line end or blanks after the last pixel were skipped";
  check_doubtful("P5 2 1 15 " + as_bytes({7, 8}) + "\n", {7, 8}, {after});
  check_doubtful("P5 2 1 15 " + as_bytes({7, 8}) + " \r\n\n", {7, 8}, {after});
  const std::string several = "only the first of several images is read";
  const std::string raw = "P5 2 1 15 " + as_bytes({7, 8});
  check_doubtful(raw + raw, {7, 8}, {several});
  check_doubtful(raw + "\n" + raw, {7, 8}, {after, several});
  check_doubtful("P2 1 1 9 5 P2 1 1 9 6", {5}, {several});
  check_doubtful("P5 1 1 300 " + as_bytes({1, 44, 10}), {300}, {after});
}

TEST_CASE("a header that ends in another way is skipped where the size leaves no doubt") {
  const std::string lines = "the line ends of the header are CR LF";
  const std::string lead = "blank lines or comments before the pixels were skipped";
  check_doubtful("P5\r\n2 1\r\n15\r\n" + as_bytes({7, 8}), {7, 8}, {lines});
  check_doubtful("P5\r\n2 1\r\n15\r\n" + as_bytes({10, 13}), {10, 13}, {lines});
  check_doubtful("P5 2 1 15\n\n \n" + as_bytes({7, 8}), {7, 8}, {lead});
  check_doubtful("P5 2 1 15\n# made by hand\n" + as_bytes({7, 8}), {7, 8}, {lead});
  check_doubtful("P5 2 1 15# made by hand\n" + as_bytes({7, 8}), {7, 8},
                 {"a comment after the greatest value was skipped"});
  // Of the right size, all of it is pixels: a carriage return may end the header of an old Mac.
  check_doubtful("P5\r2 1\r15\r" + as_bytes({10, 8}), {10, 8}, {});
  check_doubtful("P5 2 1 255\n" + as_bytes({'#', '\n'}), {35, 10}, {});
}

TEST_CASE("a raw PGM whose pixels may begin at two places is refused") {
  const std::string doubt =
      ": expected pixels at a certain place, found blanks that may be pixels before and after them";
  CHECK(pgm_complaint("P5 2 1 255\n" + as_bytes({10, 8}) + "\n") == "PGM byte 11" + doubt);
  CHECK(pgm_complaint("P5 3 1 255\n" + as_bytes({'#', '\n', 8}) + "\n\n") == "PGM byte 11" + doubt);
  CHECK(pgm_complaint("P5\r\n2 1\r\n255\r\n" + as_bytes({32, 8}) + "\n") == "PGM byte 14" + doubt);
}

TEST_CASE("the colours of a PPM count with their mean") {
  const std::string colours = "the image has colours: the mean of red, green and blue counts";
  check_doubtful("P3 2 1 9 9 0 3 1 2 2", {12, 5}, {colours});
  CHECK(detail::parse_pgm("P3 2 1 9 9 0 3 1 2 2")->max_value == 27);
  check_doubtful("P6 1 1 255 " + as_bytes({255, 205, 155}), {615}, {colours});
  check_doubtful("P3 1 1 65535 65535 65535 65534", {65535}, {colours});  // rounded
  CHECK(detail::parse_pgm("P3 1 1 65535 0 0 0")->max_value == 65535);
  CHECK(pgm_complaint("P6 1 1 255 ab") ==
        "PGM byte 13: expected a pixel from 0 to 255, found the end of the file");
}

}  // namespace
