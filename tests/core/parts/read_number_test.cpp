// SPDX-License-Identifier: MIT
#include "tutavia/core/parts/read_number.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

#include "support/catch.hpp"
#include "tutavia/core/parts/number_text.hpp"

using namespace tutavia;

namespace {

struct Reading {
  std::ptrdiff_t length;
  std::errc error;
  double value;
};

Reading by_library(const std::string& text) {
  double value = 7;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return {end - text.data(), error, value};
}

Reading by_stream(const std::string& text) {
  double value = 7;
  const auto [end, error] = detail::read_double_from_stream(text, value);
  return {end - text.data(), error, value};
}

void check_equal(const std::string& text) {
  CAPTURE(text);
  const Reading library = by_library(text), stream = by_stream(text);
  CHECK(stream.error == library.error);
  CHECK(stream.length == library.length);
  const bool both_nan = std::isnan(stream.value) && std::isnan(library.value);
  CHECK((both_nan || std::bit_cast<std::uint64_t>(stream.value) ==
                         std::bit_cast<std::uint64_t>(library.value)));
}

/// A locale that writes numbers as 1.234,5.
struct CommaNumbers : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST_CASE("a stream reads doubles as std::from_chars does", "[core]") {
  for (const char* const text : {"0",
                                 "-0",
                                 "1",
                                 "-1.5",
                                 ".5",
                                 "5.",
                                 "1e3",
                                 "1E-3",
                                 "1e+3",
                                 "1e",
                                 "1e+",
                                 "1ex",
                                 "",
                                 "-",
                                 ".",
                                 "+1",
                                 " 1",
                                 "1 ",
                                 "0x10",
                                 "1,5",
                                 "1.5.2",
                                 "abc",
                                 "inf",
                                 "-INF",
                                 "Infinity",
                                 "infinite",
                                 "nan",
                                 "-nan",
                                 "NaNs",
                                 "in",
                                 "1e308",
                                 "1e309",
                                 "-1e309",
                                 "1e-308",
                                 "1e-310",
                                 "4.9e-324",
                                 "1e-400",
                                 "-1e-400",
                                 "0e-400",
                                 "0e999",
                                 "00012",
                                 "1.7976931348623157e308",
                                 "2.2250738585072014e-308",
                                 "123456789012345678901234"}) {
    check_equal(text);
  }
}

TEST_CASE("a stream reads every double back from its shortest text", "[core]") {
  const std::uint64_t seed = 26;
  std::mt19937_64 random(seed);
  for (int round = 0; round < 2000; ++round) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    INFO("seed " << seed << ", round " << round);
    check_equal(detail::number_text(value));
  }
}

TEST_CASE("numbers are read alike in every locale", "[core]") {
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaNumbers));
  const Reading stream = by_stream("1234.5");
  std::locale::global(before);
  CHECK(stream.value == 1234.5);
  CHECK(stream.length == 6);
}

TEST_CASE("whole numbers are read by the standard library", "[core]") {
  const std::string_view text = "42;";
  int value = 0;
  const auto [end, error] = detail::read_number(text.data(), text.data() + text.size(), value);
  CHECK(error == std::errc{});
  CHECK(value == 42);
  CHECK(*end == ';');
}

TEST_CASE("a text is a number if nothing of it is left over", "[core]") {
  CHECK(detail::read_whole_text<double>("-2.5e3") == -2500);
  CHECK(detail::read_whole_text<double>("inf") == std::numeric_limits<double>::infinity());
  CHECK(detail::read_whole_text<int>("-42") == -42);
  for (const char* const text : {"", " 1", "1 ", "1,", "+1", "1e999", "one"}) {
    CAPTURE(text);
    CHECK_FALSE(detail::read_whole_text<double>(text));
  }
  for (const char* const text : {"", "1.5", "1e3", "99999999999", "0x1"}) {
    CAPTURE(text);
    CHECK_FALSE(detail::read_whole_text<int>(text));
  }
}
