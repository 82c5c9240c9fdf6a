// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

/// \file
/// reference_csv: a second reader of a CSV column, byte by byte.

namespace tutavia::test {

using CsvTable = std::vector<std::vector<std::string>>;

/// The first `most` rows of a CSV text that are not blank, or nothing for broken quotes. Doubled
/// quotes stay doubled.
inline std::optional<CsvTable> reference_csv(const std::string& text, char separator,
                                             std::size_t most = std::string::npos) {
  enum class In { start, plain, quotes, after } state = In::start;
  CsvTable rows(1);
  std::string cell;
  bool blank_row = true;
  const auto end_cell = [&](bool plain) {
    if (plain) {
      const std::size_t from = cell.find_first_not_of(" \t\r\f\v");
      cell = from == std::string::npos
                 ? ""
                 : cell.substr(from, cell.find_last_not_of(" \t\r\f\v") + 1 - from);
    }
    rows.back().push_back(cell);
    cell.clear();
  };
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const bool end = i == text.size();
    const char c = end ? '\n' : text[i];
    if (state == In::quotes) {
      if (end) return std::nullopt;
      if (c != '"') {
        cell += c;
      } else if (i + 1 < text.size() && text[i + 1] == '"') {
        cell += "\"\"";
        ++i;
      } else {
        state = In::after;
      }
      continue;
    }
    if (state == In::after && c == '\r' && c != separator &&
        (i + 1 == text.size() || text[i + 1] == '\n')) {
      continue;
    }
    if (c == '\n' || c == separator) {
      end_cell(state != In::after);
      state = In::start;
      if (c == separator) blank_row = false;
      if (c == '\n') {
        if (blank_row) rows.pop_back();
        if (rows.size() == most) return rows;
        if (!end) rows.emplace_back();
        blank_row = true;
      }
    } else if (state == In::after) {
      return std::nullopt;
    } else if (state == In::start && c == '"') {
      state = In::quotes;
      blank_row = false;
    } else {
      if (c == '\r' && i + 1 < text.size() && text[i + 1] != '\n') return std::nullopt;
      if (c != ' ' && c != '\r') blank_row = false;
      state = In::plain;
      cell += c;
    }
  }
  return rows;
}

/// The cells of a column, or nothing for a text that must be refused.
inline std::optional<std::vector<std::string>> reference_csv_column(const std::string& text,
                                                                    const std::string& name) {
  for (const char separator : {',', ';', '\t'}) {
    // The header alone decides on the separator.
    const auto top = reference_csv(text, separator, 1);
    if (!top || top->empty()) continue;
    const std::vector<std::string> header = top->front();
    const auto count = std::count(header.begin(), header.end(), name);
    if (count > 1) return std::nullopt;
    if (count == 0) continue;
    const auto table = reference_csv(text, separator);
    if (!table) return std::nullopt;
    const auto column =
        static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
    std::vector<std::string> cells;
    for (std::size_t i = 1; i < table->size(); ++i) {
      if ((*table)[i].size() != header.size()) return std::nullopt;
      cells.push_back((*table)[i][column]);
    }
    return cells;
  }
  return std::nullopt;
}

}  // namespace tutavia::test
