// SPDX-License-Identifier: MIT
#include "text_arguments.hpp"

#include <algorithm>
#include <cmath>

#include "tutavia/core/parts/read_number.hpp"
#include "usage_error.hpp"

namespace plan_program {

std::optional<double> parse_number(std::string_view text) {
  return tutavia::detail::read_whole_text<double>(text);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  std::size_t count, const char* form) {
  const std::vector<std::string> parts = split(text, ',');
  std::vector<double> numbers;
  for (const std::string& part : parts) {
    const auto number = parse_number(part);
    if (number && std::isfinite(*number)) numbers.push_back(*number);
  }
  if (parts.size() == count && numbers.size() == count) return numbers;
  throw UsageError{option + ": expected " + form + " with finite numbers, got \"" + text + "\""};
}

Point parse_point(const std::string& option, const std::string& text) {
  const std::vector<double> numbers = parse_numbers(option, text, 2, "X,Y");
  return {numbers[0], numbers[1]};
}

}  // namespace plan_program
