// SPDX-License-Identifier: MIT
#include "queries.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "tutavia/core/parts/read_number.hpp"
#include "tutavia/io/text/source_text.hpp"
#include "tutavia/registry/nearest_name.hpp"

namespace batch_program {

namespace {

constexpr std::array<std::string_view, 7> names{"start_x",       "start_y",      "goal_x", "goal_y",
                                                "start_heading", "goal_heading", "seed"};
constexpr std::size_t required = 4, seed_column = 6;

/// The cells of a line, without blanks around them; a cell may stand in double quotes.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (bool more = true; more;) {
    const std::size_t comma = line.find(',');
    std::string_view cell = line.substr(0, comma);
    more = comma != std::string_view::npos;
    if (more) line.remove_prefix(comma + 1);
    cell.remove_prefix(std::min(cell.find_first_not_of(" \t\r"), cell.size()));
    cell = cell.substr(0, cell.find_last_not_of(" \t\r") + 1);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
      cell = cell.substr(1, cell.size() - 2);
    }
    cells.push_back(cell);
  }
  return cells;
}

template <class Number>
bool read(std::string_view cell, Number& value) {
  const auto number = tutavia::detail::read_whole_text<Number>(cell);
  if (!number || !std::isfinite(static_cast<double>(*number))) return false;
  value = *number;
  return true;
}

/// The columns of the header, and queries from the lines below it.
class QueryReader {
 public:
  Expected<void, Failure> read_header(std::string_view line) {
    const auto header = cells_of(line);
    width_ = header.size();
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto found = std::find(header.begin(), header.end(), names[i]);
      if (found != header.end()) {
        columns_[i] = static_cast<std::size_t>(found - header.begin());
      } else if (i < required) {
        return missing(names[i], header);
      }
    }
    return {};
  }

  Expected<Query, Failure> read_line(std::string_view line, std::size_t number) const {
    const auto cells = cells_of(line);
    const auto invalid = [&](std::string detail) {
      return fail(PlanError::invalid_input,
                  "line " + std::to_string(number) + ": " + std::move(detail));
    };
    if (cells.size() != width_) {
      return invalid("expected " + std::to_string(width_) + " columns, found " +
                     std::to_string(cells.size()));
    }
    Query query;
    std::array<std::optional<double>, seed_column> numbers;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!columns_[i]) continue;
      const std::string_view cell = cells[*columns_[i]];
      if (cell.empty() && i >= required) continue;
      const bool is_read =
          i == seed_column ? read(cell, query.seed) : read(cell, numbers[i].emplace());
      if (is_read) continue;
      return invalid(std::string(names[i]) + ": expected a finite number, found " +
                     tutavia::detail::shown_text(cell));
    }
    query.start = {*numbers[0], *numbers[1]};
    query.goal = {*numbers[2], *numbers[3]};
    query.start_heading = numbers[4];
    query.goal_heading = numbers[5];
    return query;
  }

 private:
  static Unexpected<Failure> missing(std::string_view name,
                                     const std::vector<std::string_view>& header) {
    std::vector<std::string> unknown;
    for (const std::string_view column : header) {
      if (std::find(names.begin(), names.end(), column) == names.end())
        unknown.emplace_back(column);
    }
    std::string detail = "line 1: no column is named ";
    detail.append(name);
    if (const auto near = nearest_name(name, unknown)) {
      detail.append("; is it \"").append(*near).append("\"?");
    }
    return fail(PlanError::invalid_input, detail);
  }

  std::size_t width_ = 0;
  std::array<std::optional<std::size_t>, names.size()> columns_{};
};

}  // namespace

Expected<std::vector<Query>, Failure> parse_queries(std::string_view text) {
  text = tutavia::detail::without_byte_order_mark(text);
  QueryReader reader;
  std::vector<Query> queries;
  for (std::size_t number = 1; number == 1 || !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (number == 1) {
      if (auto header = reader.read_header(line); !header) return std::move(header).unexpected();
      continue;
    }
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    auto query = reader.read_line(line, number);
    if (!query) return std::move(query).unexpected();
    queries.push_back(std::move(*query));
  }
  return queries;
}

}  // namespace batch_program
