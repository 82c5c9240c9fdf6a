// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>

#include "tutavia/plan/failure.hpp"

/// \file
/// read_file: reads and parses a file.

namespace tutavia::detail {

/// The text of a file. Errors: `invalid_input` with its name.
inline Expected<std::string, Failure> read_text(const std::filesystem::path& path) {
  std::error_code error;
  std::ifstream file(path, std::ios::binary);
  if (!file.is_open() || std::filesystem::is_directory(path, error)) {
    return fail(PlanError::invalid_input, path.string() + ": cannot be read");
  }
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) return fail(PlanError::invalid_input, path.string() + ": cannot be read");
  return text;
}

/// The result of `parse` for the text of a file; details of failures start with the file's name.
template <class Parse>
auto read_file(const std::filesystem::path& path, Parse parse)
    -> decltype(parse(std::string_view{})) {
  const auto text = read_text(path);
  if (!text) return Unexpected{text.error()};
  auto result = parse(std::string_view(*text));
  if (!result) result.error().detail = path.string() + ": " + result.error().detail;
  return result;
}

}  // namespace tutavia::detail
