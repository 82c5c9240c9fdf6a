// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <ios>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

#include "tutavia/core/parts/read_number.hpp"

/// \file
/// number_text: a number for people that tells it from every other.

namespace tutavia::detail {

/// `number_text` by means of streams, for standard libraries without std::to_chars for doubles. Its
/// last digit may differ where two texts of the same length read back to the number.
inline std::string number_text_from_stream(double value) {
  if (std::isnan(value)) return std::signbit(value) ? "-nan" : "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  const auto written = [value](std::ios_base& (*format)(std::ios_base&), int precision) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream << format << std::setprecision(precision) << value;
    return stream.str();
  };
  const auto reads_back = [value](const std::string& text) {
    double read = 0;
    read_number(text.data(), text.data() + text.size(), read);
    return read == value;
  };
  int digits = 1;
  std::string scientific = written(std::scientific, 0);
  for (; digits < std::numeric_limits<double>::max_digits10 && !reads_back(scientific); ++digits) {
    scientific = written(std::scientific, digits);
  }
  const int exponent = std::atoi(scientific.c_str() + scientific.find('e') + 1);
  if (std::abs(exponent) > 30) return scientific;
  const int decimals = digits - 1 - exponent;
  std::string fixed = written(std::fixed, decimals > 0 ? decimals : 0);
  return fixed.size() <= scientific.size() ? fixed : scientific;
}

/// The shortest text that reads back to the same double: "0.3", "4845391", "-1e-13".
inline std::string number_text(double value) {
#ifdef __cpp_lib_to_chars
  std::array<char, 32> text{};  // 24 characters at most
  const char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), static_cast<std::size_t>(end - text.data())};
#else
  return number_text_from_stream(value);
#endif
}

}  // namespace tutavia::detail
