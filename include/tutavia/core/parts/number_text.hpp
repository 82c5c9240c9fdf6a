// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string>

/// \file
/// number_text: a number for people that tells it from every other.

namespace tutavia::detail {

/// The shortest text that reads back to the same double: "0.3", "4845391", "-1e-13".
inline std::string number_text(double value) {
  std::array<char, 32> text{};  // 24 characters at most
  const char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), static_cast<std::size_t>(end - text.data())};
}

}  // namespace tutavia::detail
