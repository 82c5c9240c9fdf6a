// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// Numbers and lines of text in pictures.

namespace tutavia::detail {

/// A number with as many digits as it needs, at most six.
inline std::string trimmed(double x) {
  std::array<char, 64> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%g", x);
  return buffer.data();
}

/// A number with three decimals, or like `trimmed` if it is large.
inline std::string with_decimals(double x) {
  std::array<char, 64> buffer;
  std::snprintf(buffer.data(), buffer.size(), x < 1e6 ? "%.3f" : "%g", x);
  return buffer.data();
}

/// The width of a character in a font of 14 pixels, with room for fonts wider than Helvetica.
inline double text_width(char c) {
  constexpr std::string_view narrow = "ijlft.,:;'|!()[]{}/ r", wide = "mwMW%@&";
  if ((static_cast<unsigned char>(c) & 0xc0) == 0x80) return 0;  // the rest of a UTF-8 character
  if (narrow.find(c) != std::string_view::npos) return 5.6;
  if (wide.find(c) != std::string_view::npos) return 13.6;
  return c >= 'A' && c <= 'Z' ? 10.6 : 8.9;
}

inline double text_width(std::string_view text) {
  double width = 0;
  for (const char c : text) width += text_width(c);
  return width;
}

/// Breaks a text into lines of at most `width` pixels (or one character): behind a separator in
/// the second half of the line if there is one.
inline std::vector<std::string> wrapped(std::string_view text, double width) {
  constexpr std::string_view separators = " ,;:+";
  std::vector<std::string> lines;
  while (!text.empty()) {
    std::size_t end = 0, cut = 0;
    for (double used = 0; end < text.size(); ++end) {
      used += text_width(text[end]);
      if (used > width && end > 0 && text_width(text[end]) > 0) break;
      if (used > width / 2 && separators.find(text[end]) != std::string_view::npos) cut = end + 1;
    }
    if (end < text.size() && cut > 0) end = cut;
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

}  // namespace tutavia::detail
