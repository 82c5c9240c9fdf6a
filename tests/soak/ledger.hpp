// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/plan/failure.hpp"

/// \file
/// The tables of docs/evidence.md, and how rows add up.

namespace tutavia::test {

/// How two rows of one table combine. Rows with the same keys are one row: its numbers are sums,
/// and its worlds the union of both. No world counts twice.
enum class Column { key, worlds, count, minutes };

using Row = std::vector<std::string>;

inline constexpr std::string_view world_heading = "## Worlds", fuzz_heading = "## Fuzz targets";
inline constexpr Column world_columns[] = {
    Column::key,   Column::key,   Column::worlds, Column::count, Column::count,
    Column::count, Column::count, Column::count,  Column::count, Column::minutes};
inline constexpr Column fuzz_columns[] = {Column::key, Column::key, Column::count, Column::minutes,
                                          Column::count};

inline std::string minutes(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", seconds / 60);
  return text;
}

/// The union of two lists of worlds, "0-99, 200-249"; nothing if they have a world in common.
inline std::optional<std::string> join_worlds(const std::string& a, const std::string& b) {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges;
  std::istringstream in(a + ',' + b);
  for (std::string range; std::getline(in, range, ',');) {
    const std::size_t dash = range.find('-');
    ranges.emplace_back(std::stoull(range), std::stoull(range.substr(dash + 1)));
  }
  std::sort(ranges.begin(), ranges.end());
  std::string text = std::to_string(ranges[0].first);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const bool is_last = i + 1 == ranges.size();
    if (!is_last && ranges[i + 1].first <= ranges[i].second) return std::nullopt;
    if (!is_last && ranges[i + 1].first == ranges[i].second + 1) continue;
    text.append("-").append(std::to_string(ranges[i].second));
    if (!is_last) text.append(", ").append(std::to_string(ranges[i + 1].first));
  }
  return text;
}

/// Adds a row to the row with its keys, or as the last one. Errors: `invalid_input` if the rows
/// have a world in common.
inline Expected<void, Failure> add_row(std::vector<Row>& rows, std::span<const Column> columns,
                                       const Row& row) {
  const auto has_same_keys = [&](const Row& other) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i] == Column::key && row[i] != other[i]) return false;
    }
    return true;
  };
  const auto same = std::find_if(rows.begin(), rows.end(), has_same_keys);
  if (same == rows.end()) {
    rows.push_back(row);
    return {};
  }
  Row sum = *same;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] == Column::worlds) {
      auto joined = join_worlds(sum[i], row[i]);
      if (!joined) {
        return fail(PlanError::invalid_input, std::string("worlds ")
                                                  .append(row[i])
                                                  .append(" were counted before, in ")
                                                  .append(sum[i]));
      }
      sum[i] = *joined;
    } else if (columns[i] == Column::count) {
      sum[i] = std::to_string(std::stoull(sum[i]) + std::stoull(row[i]));
    } else if (columns[i] == Column::minutes) {
      sum[i] = minutes(60 * (std::stod(sum[i]) + std::stod(row[i])));
    }
  }
  *same = std::move(sum);
  return {};
}

/// The cells of a line "| a | b |".
inline Row cells_of(const std::string& line) {
  Row cells;
  std::istringstream in(line.substr(1));
  for (std::string cell; std::getline(in, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
    if (first != std::string::npos) cells.push_back(cell.substr(first, last - first + 1));
  }
  return cells;
}

/// A ledger, taken apart at one of its tables.
struct Ledger {
  std::string before;  ///< up to the table's head
  std::vector<Row> rows;
  std::string after;
};

/// Reads the table below `heading`. Errors: `invalid_input` if there is none with these columns.
inline Expected<Ledger, Failure> read_ledger(const std::string& text, std::string_view heading,
                                             std::span<const Column> columns) {
  std::istringstream in(text);
  Ledger ledger;
  std::string line;
  bool is_below = false;
  while (std::getline(in, line) && !(is_below && line.starts_with("|--"))) {
    is_below = is_below || line == heading;
    ledger.before.append(line).append("\n");
  }
  std::vector<Row> rows{in ? cells_of(line) : Row{}};
  ledger.before.append(line).append("\n");
  while (std::getline(in, line) && line.starts_with("|")) rows.push_back(cells_of(line));
  if (in) ledger.after.append(line).append("\n");
  while (std::getline(in, line)) ledger.after.append(line).append("\n");
  for (const Row& row : rows) {
    if (row.size() == columns.size()) continue;
    return fail(PlanError::invalid_input, std::string("no table of ")
                                              .append(std::to_string(columns.size()))
                                              .append(" columns below ")
                                              .append(heading));
  }
  ledger.rows.assign(rows.begin() + 1, rows.end());
  return ledger;
}

/// The text of a ledger with the rows added to the table below `heading`; all else stays. Errors:
/// those of `read_ledger` and `add_row`.
inline Expected<std::string, Failure> add_to_ledger(const std::string& text,
                                                    std::string_view heading,
                                                    std::span<const Column> columns,
                                                    const std::vector<Row>& added) {
  auto ledger = read_ledger(text, heading, columns);
  if (!ledger) return std::move(ledger).unexpected();
  for (const Row& row : added) {
    if (auto done = add_row(ledger->rows, columns, row); !done) return std::move(done).unexpected();
  }
  std::string result = std::move(ledger->before);
  for (const Row& row : ledger->rows) {
    result.append("|");
    for (const std::string& cell : row) result.append(" ").append(cell).append(" |");
    result.append("\n");
  }
  return result + ledger->after;
}

/// The first world after all worlds of these rows.
inline std::uint64_t world_after(const std::vector<Row>& rows) {
  std::uint64_t next = 0;
  for (const Row& row : rows) {
    const std::string& worlds = row[2];
    next = std::max<std::uint64_t>(next, std::stoull(worlds.substr(worlds.rfind('-') + 1)) + 1);
  }
  return next;
}

/// The row of a fuzz target from what libFuzzer prints with -print_final_stats=1; nothing if the
/// run has not ended.
inline std::optional<Row> fuzz_row(const std::string& target, const std::string& revision,
                                   const std::string& log) {
  std::istringstream in(log);
  std::optional<std::uint64_t> runs;
  double rate = 0, seconds = -1;
  std::uint64_t findings = 0;
  for (std::string line; std::getline(in, line);) {
    unsigned long long whole = 0, time = 0;
    if (std::sscanf(line.c_str(), "stat::number_of_executed_units: %llu", &whole) == 1)
      runs = whole;
    if (std::sscanf(line.c_str(), "stat::average_exec_per_sec: %llu", &whole) == 1) {
      rate = static_cast<double>(whole);
    }
    if (std::sscanf(line.c_str(), "Done %llu runs in %llu second", &whole, &time) == 2) {
      seconds = static_cast<double>(time);
    }
    if (line.find("Test unit written to ") != std::string::npos) ++findings;
  }
  if (!runs) return std::nullopt;
  // A run that ended with a finding does not print its time.
  if (seconds < 0) seconds = rate > 0 ? static_cast<double>(*runs) / rate : 0;
  return Row{target, revision, std::to_string(*runs), minutes(seconds), std::to_string(findings)};
}

}  // namespace tutavia::test
