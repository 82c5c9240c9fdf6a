// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>

#include "tutavia/core/parts/read_number.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/source_text.hpp"

/// \file
/// WktCursor: the words, numbers and errors of WKT.

namespace tutavia::detail {

/// A place in a WKT text, and what can be read there.
class WktCursor {
 public:
  explicit WktCursor(std::string_view text) : text_(text), end_(text.size()) {}

  /// Reads a decimal number, which must be followed by a blank, a comma, a parenthesis or the end.
  double number(const char* what) {
    skip_space();
    if (!is_number_next()) expected(next_, what);
    const std::size_t at = next_;
    double value = 0;
    const char* const first = text_.data() + at + (text_[at] == '+' ? 1 : 0);
    const auto [last, status] = read_number(first, text_.data() + end_, value);
    next_ = static_cast<std::size_t>(last - text_.data());
    if (status == std::errc::result_out_of_range) error(at, "a number beyond the range of double");
    const bool is_whole = is_end() || is_blank(text_[next_]) ||
                          std::string_view(",()").find(text_[next_]) != std::string_view::npos;
    if (status != std::errc{} || !is_whole) expected(at, what);
    return value;
  }

  /// Whether a number starts here; "nan" and "inf" are not numbers.
  bool is_number_next() const {
    std::size_t i = next_;
    if (i < end_ && (text_[i] == '-' || text_[i] == '+')) ++i;
    if (i < end_ && text_[i] == '.') ++i;
    return i < end_ && text_[i] >= '0' && text_[i] <= '9';
  }

  std::string_view word() {
    const std::size_t from = next_;
    const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    while (!is_end() && is_letter(text_[next_])) ++next_;
    return text_.substr(from, next_ - from);
  }

  /// Skips white space, and `c` if it comes next.
  bool accept(char c) {
    skip_space();
    if (is_end() || text_[next_] != c) return false;
    ++next_;
    return true;
  }
  bool is_end() const { return next_ == end_; }
  void skip_space() {
    while (!is_end() && is_blank(text_[next_])) ++next_;
  }
  /// Skips white space and, if `has_comments_`, lines that start with #.
  void skip_comments() {
    skip_space();
    for (; has_comments_ && !is_end() && text_[next_] == '#' && is_line_start(); skip_space()) {
      const std::size_t line_end = std::min(text_.find('\n', next_), end_);
      refuse_bare_carriage_return(text_, next_, line_end);
      next_ = line_end;
    }
  }

  [[noreturn]] void error(std::size_t at, const std::string& what) const {
    std::string message = position_text(text_, at) + what;
    const std::size_t line = line_number(text_, first_);
    if (line != line_number(text_, at)) {
      message += " (the geometry begins at line " + std::to_string(line) + ")";
    }
    throw ParseError{message};
  }
  [[noreturn]] void expected(std::size_t at, const std::string& what) const {
    const char* const end = end_ == text_.size() ? "the end of the text" : "the end of the cell";
    error(at, "expected " + what + ", found " +
                  (at == end_ ? end : shown_word(text_.substr(at, end_ - at))));
  }

 protected:
  std::string_view text_;
  std::size_t next_ = 0, end_;
  std::size_t first_ = 0;  // start of the current geometry
  bool has_comments_ = true;

 private:
  bool is_line_start() const { return next_ == 0 || text_[next_ - 1] == '\n'; }
};

}  // namespace tutavia::detail
