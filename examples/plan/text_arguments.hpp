// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/geometry/point.hpp"

/// \file
/// Numbers and points in the texts of command lines.

namespace plan_program {

using tutavia::Point;

/// Reads a number; nothing if the text is not one.
std::optional<double> parse_number(std::string_view text);

/// The parts of a text between separators, including empty ones.
std::vector<std::string> split(const std::string& text, char separator);

/// Reads `count` finite numbers from a comma list. Throws a UsageError that names the option and
/// the expected form, such as "X,Y".
std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  std::size_t count, const char* form);

/// Reads a point from "X,Y". Throws UsageError.
Point parse_point(const std::string& option, const std::string& text);

}  // namespace plan_program
