// SPDX-License-Identifier: MIT
#include "tutavia/core/parts/number_text.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using detail::number_text;

TEST_CASE("numbers are as short as they can be, and tell neighbours apart") {
  CHECK(number_text(0.3) == "0.3");
  CHECK(number_text(14) == "14");
  CHECK(number_text(4845391) == "4845391");
  CHECK(number_text(-1e-13) == "-1e-13");
  CHECK(number_text(std::nextafter(0.3, 1)) == "0.30000000000000004");
  CHECK(number_text(-std::numeric_limits<double>::max()).size() == 24);
}

TEST_CASE("numbers read back") {
  const std::uint64_t seed = 2105;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(1000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double value = random.uniform(-1, 1) * std::pow(10, random.uniform(-300, 300));
    CHECK(std::strtod(number_text(value).c_str(), nullptr) == value);
  }
}

TEST_CASE("streams write the same texts") {
  for (const double value : {0.0,
                             -0.0,
                             1.0,
                             0.3,
                             14.0,
                             1e5,
                             123456.0,
                             1e20,
                             1e21,
                             1e22,
                             1e23,
                             5e-324,
                             0.001,
                             1e-4,
                             1e-5,
                             1234.5,
                             -4845391.0,
                             1.7976931348623157e308,
                             0.1 + 0.2,
                             9007199254740993.0,
                             std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
    CHECK(detail::number_text_from_stream(value) == number_text(value));
  }
}

TEST_CASE("numbers that streams write are no longer, and read back") {
  const std::uint64_t seed = 2106;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(1000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double value = random.uniform(-1, 1) * std::pow(10, random.uniform(-300, 300));
    const std::string text = detail::number_text_from_stream(value);
    CHECK(text.size() == number_text(value).size());
    CHECK(std::strtod(text.c_str(), nullptr) == value);
  }
}

}  // namespace
