// SPDX-License-Identifier: MIT
#include "tutavia/registry/options/option_kind.hpp"

#include <limits>
#include <string>

#include "support/catch.hpp"
#include "tutavia/registry/options/movement_options.hpp"

namespace tutavia::detail {

namespace {

template <class T>
bool reads(const char* text, T expected) {
  T value{};
  return option_kind<T>.parse(text, &value) && value == expected;
}

/// Whether a text is refused and leaves the member alone.
template <class T>
bool refuses(const char* text, T before) {
  T value = before;
  return !option_kind<T>.parse(text, &value) && value == before;
}

TEST_CASE("numbers are read whole, to the last bit, and never as NaN") {
  CHECK(reads("0.1", 0.1));
  CHECK(reads("-2.5e-3", -2.5e-3));
  CHECK(reads("1e+5", 1e5));
  CHECK(reads("5", 5.0));
  CHECK(reads("inf", std::numeric_limits<double>::infinity()));
  CHECK(reads("0.3490658503988659", 0.3490658503988659));
  for (const char* bad : {"", " ", "x", "1x", " 1", "1 ", "nan", "NaN", "-nan", "nan(1)", "1e999",
                          "-1e999", "0x10", "1,5", "--1", "none", "true"}) {
    INFO(bad);
    CHECK(refuses(bad, 7.0));
  }
}

TEST_CASE("whole numbers are read within the range of their type") {
  CHECK(reads("4294967295", std::uint32_t{4294967295u}));
  CHECK(reads("0", std::uint32_t{0}));
  CHECK(reads("18446744073709551615", std::numeric_limits<std::uint64_t>::max()));
  CHECK(reads("-2147483648", std::numeric_limits<int>::min()));
  for (const char* bad : {"", "-1", "1.5", "1e3", "4294967296", "99999999999999999999999999", "nan",
                          "inf", "none", "+1", "true"}) {
    INFO(bad);
    CHECK(refuses(bad, std::uint32_t{7}));
  }
  CHECK(refuses("18446744073709551616", std::uint64_t{7}));
  CHECK(refuses("2147483648", 7));
}

TEST_CASE("switches and enums are read by their names alone") {
  CHECK(reads("true", true));
  CHECK(reads("false", false));
  for (const char* bad : {"", "1", "0", "yes", "True", "tru", "none"}) {
    INFO(bad);
    CHECK(refuses(bad, true));
  }
  CHECK(reads("four_connected", MovementRule::four_connected));
  for (const char* bad : {"", "0", "No_cut", "no_cu", "no_cut ", "none"}) {
    INFO(bad);
    CHECK(refuses(bad, MovementRule::allow));
  }
}

TEST_CASE("optional numbers can also be taken away") {
  using Optional = std::optional<double>;
  CHECK(reads("2", Optional(2)));
  Optional value = 3;
  CHECK(option_kind<Optional>.parse("none", &value));
  CHECK_FALSE(value);
  CHECK(refuses("", Optional(4)));
  CHECK(refuses("nan", Optional(4)));
  CHECK(std::holds_alternative<std::monostate>(to_value(Optional{})));
  CHECK(std::get<double>(to_value(Optional(0.1))) == 0.1);
}

TEST_CASE("types and what they take have words") {
  CHECK(type_text(option_kind<double>) == "number");
  CHECK(type_text(option_kind<std::optional<double>>) == "number|none");
  CHECK(type_text(option_kind<int>) == "whole number");
  CHECK(type_text(option_kind<bool>) == "false|true");
  CHECK(type_text(option_kind<MovementRule>) == "no_cut|no_squeeze|allow|four_connected");
  CHECK(expected_text(option_kind<double>) == "a number");
  CHECK(expected_text(option_kind<std::optional<double>>) == "a number or none");
  CHECK(expected_text(option_kind<int>) == "a whole number from -2147483648 to 2147483647");
  CHECK(expected_text(option_kind<bool>) == "false or true");
  CHECK(expected_text(option_kind<MovementRule>) == "no_cut, no_squeeze, allow or four_connected");
}

TEST_CASE("the text of a value reads back to it") {
  for (const double number : {0.0, -0.0, 0.1, 1.0 / 3, 1e300, -5e-324, 2.0 / 3}) {
    double back = 7;
    REQUIRE(option_kind<double>.parse(to_text(number), &back));
    CHECK(back == number);
  }
  CHECK(to_text(std::numeric_limits<double>::infinity()) == "inf");
  CHECK(to_text(OptionValue{}) == "none");
  CHECK(to_text(true) == "true");
  CHECK(to_text(std::string("allow")) == "allow");
  CHECK(to_text(std::int64_t{-3}) == "-3");
  CHECK(to_text(std::numeric_limits<std::uint64_t>::max()) == "18446744073709551615");
}

}  // namespace

}  // namespace tutavia::detail
