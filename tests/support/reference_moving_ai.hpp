// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

/// \file
/// reference_moving_ai: second readers of MovingAI maps and scenarios.

namespace tutavia::test {

/// The lines of a text without trailing blanks, and without its byte order mark.
inline std::vector<std::string> reference_lines(std::string text) {
  if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    while (!line.empty() && std::string(" \t\r").find(line.back()) != std::string::npos) {
      line.pop_back();
    }
    lines.push_back(line);
  }
  return lines;
}

inline std::vector<std::string> reference_words(const std::string& line) {
  std::vector<std::string> words(1);
  for (const char c : line) {
    if (c == ' ' || c == '\t') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  words.erase(std::remove(words.begin(), words.end(), ""), words.end());
  return words;
}
inline std::string reference_lower(std::string word) {
  for (char& c : word) c = c > 0 ? static_cast<char>(std::tolower(c)) : c;
  return word;
}
/// A whole number from `least` to `most`, or -1.
inline long long reference_integer(const std::string& word, long long least, long long most) {
  if (word.empty() || word.find_first_not_of("0123456789") != std::string::npos) return -1;
  errno = 0;
  const long long value = std::strtoll(word.c_str(), nullptr, 10);
  return errno == 0 && value >= least && value <= most ? value : -1;
}

/// The rows of a map, '.' for free and '@' for blocked, or nothing. `directional` is what S and W
/// become, or '?' where they are refused.
inline std::optional<std::vector<std::string>> reference_moving_ai_map(const std::string& text,
                                                                       char directional) {
  const std::vector<std::string> lines = reference_lines(text);
  std::size_t i = 0;
  long long width = 0, height = 0;
  bool type = false;
  for (; i < lines.size() && reference_lower(lines[i]) != "map"; ++i) {
    const auto words = reference_words(reference_lower(lines[i]));
    if (words.empty()) continue;
    if (words.size() != 2) return std::nullopt;
    if (words[0] == "type") {
      if (type || (words[1] != "octile" && words[1] != "tile")) return std::nullopt;
      type = true;
    } else if (words[0] == "width" || words[0] == "height") {
      long long& size = words[0] == "width" ? width : height;
      if (size != 0) return std::nullopt;
      size = reference_integer(words[1], 1, 9223372036854775807LL);
      if (size < 0) return std::nullopt;
    } else {
      return std::nullopt;
    }
  }
  if (i++ == lines.size() || !type || width == 0 || height == 0) return std::nullopt;
  if (width > 1000000 || height > 1000000) return std::nullopt;  // longer than any text here
  std::vector<std::string> rows;
  for (; i < lines.size() && rows.size() < static_cast<std::size_t>(height); ++i) {
    if (lines[i].size() != static_cast<std::size_t>(width)) return std::nullopt;
    rows.emplace_back();
    for (const char c : lines[i]) {
      const std::string known = ".G@OTSW",
                        meaning = {'.', '.', '@', '@', '@', directional, directional};
      const std::size_t terrain = known.find(c);
      if (terrain == std::string::npos || meaning[terrain] == '?') return std::nullopt;
      rows.back() += meaning[terrain];
    }
  }
  if (rows.size() < static_cast<std::size_t>(height)) return std::nullopt;
  for (; i < lines.size(); ++i) {
    if (!lines[i].empty()) return std::nullopt;
  }
  return rows;
}

/// A row of a scenario: bucket, width, height, start and goal, the map's name and the length.
struct ReferenceScenarioRow {
  std::vector<long long> numbers;
  std::string map;
  double length;
};

/// The rows of a scenario, or nothing.
inline std::optional<std::vector<ReferenceScenarioRow>> reference_moving_ai_scenario(
    const std::string& text) {
  const std::vector<std::string> lines = reference_lines(text);
  if (lines.empty()) return std::nullopt;
  const std::string version = reference_lower(lines[0]);
  if (version != "version 1" && version != "version 1.0") return std::nullopt;
  std::vector<ReferenceScenarioRow> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto words = reference_words(lines[i]);
    if (words.empty()) continue;
    if (words.size() != 9) return std::nullopt;
    ReferenceScenarioRow row{{}, words[1], 0};
    for (const std::size_t column : {0U, 2U, 3U, 4U, 5U, 6U, 7U}) {
      row.numbers.push_back(reference_integer(words[column], 0, 2147483647));
      if (row.numbers.back() < 0) return std::nullopt;
    }
    const auto& n = row.numbers;
    if (n[3] >= n[1] || n[5] >= n[1] || n[4] >= n[2] || n[6] >= n[2]) return std::nullopt;
    if (words[8].find_first_not_of("0123456789.eE+-") != std::string::npos) return std::nullopt;
    if (words[8][0] == '-' || words[8][0] == '+') return std::nullopt;
    char* end = nullptr;
    row.length = std::strtod(words[8].c_str(), &end);
    const std::string mantissa = words[8].substr(0, words[8].find_first_of("eE"));
    const bool vanishes =
        row.length == 0 && mantissa.find_first_of("123456789") != std::string::npos;
    if (*end != 0 || !std::isfinite(row.length) || vanishes) return std::nullopt;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace tutavia::test
