// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "tutavia/io/text/parse_error.hpp"

/// \file
/// Helpers of the text readers: positions in a text, and parts of it in messages.

namespace tutavia::detail {

/// The text after its byte order mark (UTF-8), if it has one.
inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.substr(0, mark.size()) == mark) text.remove_prefix(mark.size());
  return text;
}

/// White space of ASCII, whatever the locale.
constexpr bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Whether `word` is `other` apart from the case of ASCII letters.
inline bool equal_in_any_case(std::string_view word, std::string_view other) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(word.begin(), word.end(), other.begin(), other.end(),
                    [&](char a, char b) { return lower(a) == lower(b); });
}

/// The line of a byte, counted from 1.
inline std::size_t line_number(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

/// The place of a byte as "line 3, column 7: "; columns count bytes from 1.
inline std::string position_text(std::string_view text, std::size_t at) {
  const std::size_t line_end = text.substr(0, at).rfind('\n');  // npos + 1 is 0
  return "line " + std::to_string(line_number(text, at)) + ", column " +
         std::to_string(at - line_end) + ": ";
}

/// Throws ParseError for a carriage return within a line: in a file of such line ends, all that
/// follows a comment or a header would be taken for a part of it, walls as well.
inline void refuse_bare_carriage_return(std::string_view text, std::size_t begin,
                                        std::size_t line_end) {
  const std::size_t at = text.find('\r', begin);
  if (at >= line_end || at + 1 == line_end) return;
  throw ParseError{position_text(text, at) +
                   "a line end without a line feed; lines end with LF or with CR LF"};
}

constexpr bool is_printable(char c) { return c >= ' ' && c <= '~'; }

/// A byte as "0xC3".
inline std::string hex_text(char c) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  const auto byte = static_cast<unsigned char>(c);
  return {'0', 'x', digits[byte / 16], digits[byte % 16]};
}

/// Text for a message: in quotes up to 60 bytes, and a byte that is not printable ASCII in hex:
/// "ab" and byte 0xC3.
inline std::string shown_text(std::string_view found) {
  found = found.substr(0, 60);
  std::size_t size = 0;
  while (size < found.size() && is_printable(found[size])) ++size;
  std::string text;
  if (size > 0 || found.empty()) text.append(1, '"').append(found.substr(0, size)).append(1, '"');
  if (size == found.size()) return text;
  if (size > 0) text += " and ";
  return text.append("byte ").append(hex_text(found[size]));
}

/// The word at the start of `rest` for a message, up to a blank and 20 bytes.
inline std::string shown_word(std::string_view rest) {
  rest = rest.substr(0, 20);
  std::size_t size = 0;
  while (size < rest.size() && !is_blank(rest[size])) ++size;
  return shown_text(rest.substr(0, std::max<std::size_t>(size, 1)));
}

/// A line for people: every byte that is not printable ASCII becomes <0xC3>.
inline std::string printable_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (is_printable(c)) {
      line += c;
    } else {
      line.append("<").append(hex_text(c)).append(">");
    }
  }
  return line;
}

}  // namespace tutavia::detail
