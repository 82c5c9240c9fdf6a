// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

/// \file
/// read_number: std::from_chars, also where the standard library has it for integers alone.
/// read_whole_text: a text that is a number and nothing else.

namespace tutavia::detail {

/// The length of the number that a text starts with, in the grammar of std::from_chars: a minus,
/// digits with a point, an exponent. 0 if there is none.
inline std::size_t length_of_number(std::string_view text) {
  const auto is_digit = [&](std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
  };
  std::size_t i = 0, digits = 0;
  if (i < text.size() && text[i] == '-') ++i;
  for (; is_digit(i); ++i) ++digits;
  if (i < text.size() && text[i] == '.') {
    for (++i; is_digit(i); ++i) ++digits;
  }
  if (digits == 0) return 0;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t j = i + 1;
    if (j < text.size() && (text[j] == '-' || text[j] == '+')) ++j;
    if (is_digit(j)) {
      for (i = j; is_digit(i);) ++i;
    }
  }
  return i;
}

/// Reads "inf", "infinity" and "nan", in any case and with or without a minus.
inline std::from_chars_result read_special(std::string_view text, double& value) {
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  const auto is_letter = [](char a, char b) { return a == b || a == b - 'a' + 'A'; };
  for (const std::string_view name : {"infinity", "inf", "nan"}) {
    const std::string_view word = text.substr(sign, name.size());
    if (!std::equal(word.begin(), word.end(), name.begin(), name.end(), is_letter)) continue;
    const double special = name == "nan" ? std::numeric_limits<double>::quiet_NaN()
                                         : std::numeric_limits<double>::infinity();
    value = sign == 1 ? -special : special;
    return {word.data() + word.size(), std::errc{}};
  }
  return {text.data(), std::errc::invalid_argument};
}

/// std::from_chars by means of a stream, whatever the locale of the program.
inline std::from_chars_result read_double_from_stream(std::string_view text, double& value) {
  const std::string_view number = text.substr(0, length_of_number(text));
  if (number.empty()) return read_special(text, value);
  std::istringstream stream{std::string(number)};
  stream.imbue(std::locale::classic());
  double read = 0;
  const bool is_read = static_cast<bool>(stream >> read);
  const char* const end = number.data() + number.size();
  // A stream may read a number below the least normal one and fail nevertheless.
  const bool is_too_large = !is_read && std::abs(read) >= std::numeric_limits<double>::max();
  const bool is_zero = number.substr(0, number.find_first_of("eE")).find_first_of("123456789") ==
                       std::string_view::npos;
  if (is_too_large || (read == 0 && !is_zero)) return {end, std::errc::result_out_of_range};
  value = read;
  return {end, std::errc{}};
}

/// As std::from_chars.
template <class Number>
std::from_chars_result read_number(const char* first, const char* last, Number& value) {
#ifdef __cpp_lib_to_chars
  constexpr bool has_doubles = true;
#else
  constexpr bool has_doubles = false;
#endif
  if constexpr (has_doubles || std::integral<Number>) {
    return std::from_chars(first, last, value);
  } else {
    return read_double_from_stream({first, static_cast<std::size_t>(last - first)}, value);
  }
}

/// The number that the whole text is. Empty if it is none, or none that the type can hold.
template <class Number>
std::optional<Number> read_whole_text(std::string_view text) {
  Number value{};
  const char* const last = text.data() + text.size();
  const auto [end, error] = read_number(text.data(), last, value);
  return error == std::errc{} && end == last ? std::optional(value) : std::nullopt;
}

}  // namespace tutavia::detail
