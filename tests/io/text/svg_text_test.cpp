// SPDX-License-Identifier: MIT
#include "tutavia/io/text/svg_text.hpp"

#include "support/catch.hpp"

namespace {

using namespace tutavia::detail;

TEST_CASE("texts are broken behind separators, else anywhere, and lose nothing") {
  const std::string text = "shortcut+bezier:trim=0.5,fullness=0.6+" + std::string(50, 'x');
  for (const double width : {1.0, 40.0, 100.0, 200.0, 1000.0}) {
    INFO(width);
    std::string joined;
    for (const std::string& line : wrapped(text, width)) {
      CHECK((line.size() == 1 || text_width(line) <= width));
      joined += line;
    }
    CHECK(joined == text);
  }
  CHECK(wrapped("shortcut+bezier", 100) == std::vector<std::string>{"shortcut+", "bezier"});
  CHECK(wrapped("", 100).empty());
}

TEST_CASE("characters of several bytes are not broken") {
  const std::string text = "\u00e4\u00e4\u00e4\u00e4";
  for (const std::string& line : wrapped(text, 1)) CHECK(line == "\u00e4");
  CHECK(wrapped(text, 1).size() == 4);
}

TEST_CASE("numbers are short") {
  CHECK(trimmed(0.3) == "0.3");
  CHECK(with_decimals(12.3456) == "12.346");
  CHECK(with_decimals(1e300) == "1e+300");
}

}  // namespace
