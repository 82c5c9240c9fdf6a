// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/core/parts/read_number.hpp"
#include "tutavia/grid/cell.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/io/text/read_file.hpp"
#include "tutavia/io/text/source_text.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// Maps and scenarios of the MovingAI benchmarks (Sturtevant 2012, "Benchmarks for grid-based
/// pathfinding").

namespace tutavia {

/// Options of `parse_moving_ai_map`.
struct MovingAiOptions {
  /// How to read swamp (S) and water (W). In the benchmark they may be entered from some terrain
  /// only, which a grid of free and blocked cells cannot represent.
  enum class DirectionalTerrain { refused, blocked, free };

  DirectionalTerrain directional = DirectionalTerrain::refused;
};

/// One problem of a scenario file. Its lengths are those of paths whose diagonal steps need both
/// cells beside them free (`MovementRule::no_cut`), printed with about six digits.
struct ScenarioRow {
  int bucket = 0;
  std::string map;  ///< as given in the file; often out of date
  int width = 0;    ///< of the map [cells]
  int height = 0;
  Cell start, goal;
  double optimal_length = 0;  ///< [cells]
  std::size_t line = 0;       ///< in the file; the first is 1
};

namespace detail {

/// How errors call the option for swamp and water; programs replace it with the name of their own.
inline constexpr std::string_view directional_option = "MovingAiOptions::directional";

/// Iterates over the lines of a text. Error messages start with the number of the line.
class MovingAiLines {
 public:
  explicit MovingAiLines(std::string_view text) : rest_(without_byte_order_mark(text)) {}

  /// Moves to the next line, without trailing blanks. False at the end of the text.
  bool next() {
    ++number_;
    at_end_ = rest_.empty();
    line_ = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(rest_.size(), line_.size() + 1));
    line_ = line_.substr(0, line_.find_last_not_of(" \t\r") + 1);
    return !at_end_;
  }
  /// The same; skips empty lines.
  bool next_filled() {
    while (next()) {
      if (!line_.empty()) return true;
    }
    return false;
  }

  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }
  std::vector<std::string_view> words() const {
    std::vector<std::string_view> words;
    for (std::size_t begin = 0, end = 0; end < line_.size();) {
      begin = line_.find_first_not_of(" \t", end);  // found, because there are no trailing blanks
      end = std::min(line_.find_first_of(" \t", begin), line_.size());
      words.push_back(line_.substr(begin, end - begin));
    }
    return words;
  }

  Unexpected<Failure> expected(const std::string& what, const std::string& found) const {
    return fail(PlanError::invalid_input,
                "line " + std::to_string(number_) + ": expected " + what + ", found " + found);
  }
  Unexpected<Failure> expected(const std::string& what) const {
    return expected(what, at_end_ ? "the end of the file" : shown_text(line_));
  }

 private:
  std::string_view rest_, line_;
  std::size_t number_ = 0;
  bool at_end_ = false;
};

/// The whole `word` as a number >= 0 without a sign that fits its type, or -1.
template <class Number>
Number moving_ai_number(std::string_view word) {
  if (word.substr(0, 1) == "-") return -1;
  const std::optional<Number> value = read_whole_text<Number>(word);
  return value && std::isfinite(static_cast<double>(*value)) ? *value : -1;
}

/// Reads the lines up to "map". Returns a grid of that size with all cells blocked.
inline Expected<OccupancyGrid, Failure> read_moving_ai_header(MovingAiLines& lines) {
  std::int64_t width = 0, height = 0;  // 0: not read yet
  bool type = false;
  const auto is = [](std::string_view word, std::string_view key) {
    return equal_in_any_case(word, key);
  };
  while (lines.next_filled() && !is(lines.line(), "map")) {
    const auto words = lines.words();
    const bool is_width = is(words[0], "width");
    if (is(words[0], "type") && !type) {
      if (words.size() != 2 || !(is(words[1], "octile") || is(words[1], "tile"))) {
        return lines.expected("type octile or tile");
      }
      type = true;
    } else if ((is_width && width == 0) || (is(words[0], "height") && height == 0)) {
      std::int64_t& size = is_width ? width : height;
      if (words.size() == 2) size = moving_ai_number<std::int64_t>(words[1]);
      if (size <= 0) {
        return lines.expected(std::string(is_width ? "width" : "height") + " from 1 to 2^63 - 1");
      }
    } else {
      return lines.expected("type, width, height (each once) or map");
    }
  }
  if (!is(lines.line(), "map") || !type || width == 0 || height == 0) {
    return lines.expected("type, width and height before map");
  }
  return OccupancyGrid::blocked(width, height);
}

/// Reads row `y` of the map into the grid.
inline Expected<void, Failure> read_moving_ai_row(MovingAiLines& lines, int y,
                                                  const MovingAiOptions& options,
                                                  OccupancyGrid& grid) {
  using DirectionalTerrain = MovingAiOptions::DirectionalTerrain;
  constexpr std::string_view terrains = ".G@OTSW";  // free, blocked from 2, directional from 5
  const std::string row = "row " + std::to_string(y);
  if (!lines.next()) return lines.expected(row + " of " + std::to_string(grid.height()));
  if (lines.line().size() != static_cast<std::size_t>(grid.width())) {
    return lines.expected(std::to_string(grid.width()) + " cells in " + row,
                          std::to_string(lines.line().size()));
  }
  for (int x = 0; x < grid.width(); ++x) {
    const std::string_view found = lines.line().substr(static_cast<std::size_t>(x), 1);
    const std::size_t terrain = terrains.find(found);
    const bool is_known = terrain < terrains.size();
    const bool is_directional = is_known && terrain >= 5;
    if (!is_known || (is_directional && options.directional == DirectionalTerrain::refused)) {
      std::string what = shown_text(found);
      if (is_directional) {
        what.append(", which only some neighbours may enter: ")
            .append(directional_option)
            .append(" says how to read it");
      }
      return lines.expected("one of . G @ O T in " + row + ", column " + std::to_string(x), what);
    }
    grid.set({x, y},
             is_directional ? options.directional == DirectionalTerrain::free : terrain < 2);
  }
  return {};
}

inline Expected<ScenarioRow, Failure> read_scenario_row(const MovingAiLines& lines) {
  const auto words = lines.words();
  if (words.size() != 9) return lines.expected("9 columns", std::to_string(words.size()));
  ScenarioRow row;
  row.map = words[1];
  row.line = lines.number();
  const std::array<int*, 8> columns = {&row.bucket,  nullptr,      &row.width,  &row.height,
                                       &row.start.x, &row.start.y, &row.goal.x, &row.goal.y};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] == nullptr) continue;
    *columns[i] = moving_ai_number<int>(words[i]);
    if (*columns[i] >= 0) continue;
    return lines.expected("a number from 0 to 2^31 - 1 in column " + std::to_string(i + 1),
                          shown_text(words[i]));
  }
  row.optimal_length = moving_ai_number<double>(words[8]);
  if (row.optimal_length < 0) return lines.expected("a length in column 9", shown_text(words[8]));
  for (const Cell& cell : {row.start, row.goal}) {
    if (cell.x < row.width && cell.y < row.height) continue;
    return lines.expected("start and goal in " + std::to_string(row.width) + " x " +
                              std::to_string(row.height) + " cells",
                          std::to_string(cell.x) + ", " + std::to_string(cell.y));
  }
  return row;
}

}  // namespace detail

/// A map as a grid: cell (x, y) is column x of row y, row 0 at the top of the file.
///
/// `.` and `G` are free, `@`, `O` and `T` are blocked. The lines of the header may come in any
/// order and in any case, of type octile or tile; a byte order mark, trailing blanks, CRLF and
/// empty lines at the end are ignored. Errors: `invalid_input` with the line of anything else, rows
/// and columns counted from 0; `limit_exceeded` for more cells than `OccupancyGrid::blocked`
/// allows.
inline Expected<OccupancyGrid, Failure> parse_moving_ai_map(std::string_view text,
                                                            const MovingAiOptions& options = {}) {
  detail::MovingAiLines lines(text);
  auto grid = detail::read_moving_ai_header(lines);
  if (!grid) return grid;
  for (int y = 0; y < grid->height(); ++y) {
    if (const auto row = detail::read_moving_ai_row(lines, y, options, *grid); !row) {
      return Unexpected{row.error()};
    }
  }
  if (lines.next_filled()) return lines.expected("nothing after the last row");
  return grid;
}

/// The rows of a scenario file, with columns separated by tabs or spaces. Errors: `invalid_input`
/// with the line of anything malformed, or of a start or goal outside the size given in its row.
inline Expected<std::vector<ScenarioRow>, Failure> parse_moving_ai_scenario(std::string_view text) {
  detail::MovingAiLines lines(text);
  lines.next();
  const auto is = [&](std::string_view line) {
    return detail::equal_in_any_case(lines.line(), line);
  };
  if (!is("version 1") && !is("version 1.0")) return lines.expected("version 1");
  std::vector<ScenarioRow> rows;
  while (lines.next_filled()) {
    auto row = detail::read_scenario_row(lines);
    if (!row) return Unexpected{row.error()};
    rows.push_back(std::move(*row));
  }
  return rows;
}

/// Errors: `invalid_input` with the line of the first row for a map of another size, or whose start
/// or goal lies outside the map. Start and goal may be blocked.
inline Expected<void, Failure> check_scenario(std::span<const ScenarioRow> rows,
                                              const OccupancyGrid& map) {
  for (const ScenarioRow& row : rows) {
    const auto name = [](int x, int y) { return std::to_string(x) + " x " + std::to_string(y); };
    const auto reject = [&](const std::string& expected) {
      return fail(PlanError::invalid_input,
                  "line " + std::to_string(row.line) + ": expected " + expected);
    };
    if (row.width != map.width() || row.height != map.height()) {
      return reject("a map of " + name(row.width, row.height) + " cells, found one of " +
                    name(map.width(), map.height()));
    }
    if (!map.contains(row.start) || !map.contains(row.goal)) {
      return reject("start and goal in " + name(map.width(), map.height()) + " cells");
    }
  }
  return {};
}

/// `parse_moving_ai_map` of a file.
inline Expected<OccupancyGrid, Failure> read_moving_ai_map(const std::filesystem::path& path,
                                                           const MovingAiOptions& options = {}) {
  return detail::read_file(
      path, [&](std::string_view text) { return parse_moving_ai_map(text, options); });
}

/// `parse_moving_ai_scenario` of a file.
inline Expected<std::vector<ScenarioRow>, Failure> read_moving_ai_scenario(
    const std::filesystem::path& path) {
  return detail::read_file(path, parse_moving_ai_scenario);
}

}  // namespace tutavia
