// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// \file
/// append_bytes and read_bytes: numbers as bytes of a file, the low byte first on every machine.

namespace tutavia::detail {

/// Appends the `count` lowest bytes of a number.
inline void append_bytes(std::string& bytes, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
}

/// The number that `count` bytes from a position on represent. \pre the bytes exist
inline std::uint64_t read_bytes(std::string_view bytes, std::size_t from, int count) {
  std::uint64_t value = 0;
  for (int i = count; i-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[from + static_cast<std::size_t>(i)]);
  }
  return value;
}

}  // namespace tutavia::detail
