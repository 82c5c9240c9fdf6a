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
  CHECK(pgm_complaint("") == "PGM byte 0: expected P2 or P5 (of images, only PGM is read), " + end);
  CHECK(pgm_complaint("\x89PNG\r\n") ==
        "PGM byte 0: expected P2 or P5 (of images, only PGM is read), found \"?PNG??\"");
  CHECK(pgm_complaint("P6 1 1 255 abc").find("PGM byte 0: expected P2 or P5") == 0);
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
  CHECK(pgm_complaint("P5 1 1 255#\n").find("PGM byte 10: expected a blank, then pixels") == 0);
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
  CHECK(pgm_complaint("P5 2 1 15\r\n" + as_bytes({7, 8})) ==
        "PGM byte 12: expected nothing after the last pixel, found \"?\"");
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

}  // namespace
