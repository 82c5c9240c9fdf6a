// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/source_text.hpp"

/// \file
/// csv_column: the cells of one column of a CSV text.

namespace tutavia::detail {

/// The bytes [begin, end) of a text: a cell without its quotes.
struct CsvCell {
  std::size_t begin = 0, end = 0;
};

/// Reads rows of CSV (RFC 4180). Inside quotes, doubled quotes stay doubled.
class CsvRows {
 public:
  CsvRows(std::string_view text, char separator) : text_(text), separator_(separator) {}

  /// Reads the next row that is not blank. False at the end of the text. Throws ParseError.
  bool next() {
    while (next_ < text_.size() && is_line_blank()) {
      refuse_bare_carriage_return(text_, next_, std::min(text_.find('\n', next_), text_.size()));
      next_ = next_line();
    }
    if (next_ >= text_.size()) return false;
    start_ = next_;
    cells_.clear();
    do {
      cells_.push_back(text_.substr(next_, 1) == "\"" ? quoted_cell() : plain_cell());
    } while (accept_separator());
    next_ = next_line();
    return true;
  }

  const std::vector<CsvCell>& cells() const { return cells_; }
  std::size_t start() const { return start_; }  ///< of the row

 private:
  /// The first byte of the next line.
  std::size_t next_line() const {
    const std::size_t end = text_.find('\n', next_);
    return end == std::string_view::npos ? text_.size() : end + 1;
  }
  bool is_line_blank() const {
    const std::string_view line = text_.substr(next_, text_.find('\n', next_) - next_);
    return line.find_first_not_of(" \r") == std::string_view::npos;
  }
  bool accept_separator() {
    if (text_.substr(next_, 1) != std::string_view(&separator_, 1)) return false;
    ++next_;
    return true;
  }
  CsvCell plain_cell() {
    const std::size_t line_end = std::min(text_.find('\n', next_), text_.size());
    CsvCell cell{next_, std::min(text_.substr(0, line_end).find(separator_, next_), line_end)};
    refuse_bare_carriage_return(text_, cell.begin, cell.end == line_end ? line_end : cell.end + 1);
    next_ = cell.end;
    while (cell.begin < cell.end && is_blank(text_[cell.begin])) ++cell.begin;
    while (cell.begin < cell.end && is_blank(text_[cell.end - 1])) --cell.end;
    return cell;
  }
  CsvCell quoted_cell() {
    const std::size_t quote = next_;
    std::size_t end = text_.find('"', quote + 1);
    while (end != std::string_view::npos && text_.substr(end + 1, 1) == "\"") {
      end = text_.find('"', end + 2);
    }
    if (end == std::string_view::npos) {
      throw ParseError{position_text(text_, quote) + "a quote that is not closed"};
    }
    next_ = end + 1;
    const std::string_view rest = text_.substr(next_);
    if (!rest.empty() && rest[0] != separator_ && rest[0] != '\n' && rest.substr(0, 2) != "\r\n" &&
        rest != "\r") {
      throw ParseError{position_text(text_, next_) + "expected a separator after a quoted cell, " +
                       "found " + shown_word(rest)};
    }
    if (rest.substr(0, 1) == "\r") ++next_;
    return {quote + 1, end};
  }

  std::string_view text_;
  char separator_;
  std::size_t next_ = 0, start_ = 0;
  std::vector<CsvCell> cells_;
};

/// Reads the header. The index of its column called `name`, or npos if it has none or its quotes do
/// not suit the separator. Throws ParseError if it has two.
inline std::size_t csv_column_index(std::string_view text, CsvRows& header, std::string_view name) {
  std::size_t index = std::string_view::npos;
  try {
    if (!header.next()) return index;
  } catch (const ParseError&) {
    return index;
  }
  for (std::size_t i = 0; i < header.cells().size(); ++i) {
    const CsvCell& cell = header.cells()[i];
    if (text.substr(cell.begin, cell.end - cell.begin) != name) continue;
    if (index != std::string_view::npos) {
      throw ParseError{position_text(text, cell.begin) + "a second column " + shown_text(name)};
    }
    index = i;
  }
  return index;
}

/// Calls `visit(cell)` for each cell of the column `name`, without the header. The separator is the
/// first of comma, semicolon and tab with which the header has that column. Throws ParseError for a
/// header without it, for rows of other lengths and for broken quotes.
template <class Visit>
void for_each_in_csv_column(std::string_view text, std::string_view name, Visit visit) {
  for (const char separator : {',', ';', '\t'}) {
    CsvRows rows(text, separator);
    const std::size_t column = csv_column_index(text, rows, name);
    if (column == std::string_view::npos) continue;
    const std::size_t count = rows.cells().size();
    while (rows.next()) {
      if (rows.cells().size() != count) {
        throw ParseError{position_text(text, rows.start()) + "expected " + std::to_string(count) +
                         " cells as in the header, found " + std::to_string(rows.cells().size())};
      }
      visit(rows.cells()[column]);
    }
    return;
  }
  const std::string_view header = text.substr(0, text.find_first_of("\r\n"));
  throw ParseError{"line 1, column 1: expected a header with a column " + shown_text(name) +
                   ", found " + (text.empty() ? "the end of the text" : shown_text(header))};
}

}  // namespace tutavia::detail
