// SPDX-License-Identifier: MIT
#include "tutavia/core/version.hpp"

#include <string>

#include "support/catch.hpp"

using namespace tutavia;

TEST_CASE("the version as a text has the three numbers of the macros", "[core]") {
  const std::string text = version_text();
  const std::size_t first = text.find('.'), second = text.find('.', first + 1);
  REQUIRE(second != std::string::npos);
  CHECK(std::stoi(text) == TUTAVIA_VERSION_MAJOR);
  CHECK(std::stoi(text.substr(first + 1)) == TUTAVIA_VERSION_MINOR);
  CHECK(text.substr(second + 1) == std::to_string(TUTAVIA_VERSION_PATCH));
}
