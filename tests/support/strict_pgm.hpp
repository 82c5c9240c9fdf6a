// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace tutavia::test {

/// A grey image as its format defines it.
struct StrictPgm {
  unsigned long long width = 0, height = 0, max_value = 0;
  std::vector<unsigned> pixels{};
};

/// Exactly what pgm(5) defines, a single image, and nothing else; written without the library.
inline std::optional<StrictPgm> strict_pgm(std::string_view text) {
  if (text.substr(0, 2) != "P2" && text.substr(0, 2) != "P5") return std::nullopt;
  const bool is_plain = text[1] == '2';
  std::size_t i = 2;
  const auto is_space = [&] {
    return i < text.size() && std::string_view(" \t\n\v\f\r").find(text[i]) != text.npos;
  };
  const auto gap = [&] {
    const std::size_t begin = i;
    while (is_space() || (i < text.size() && text[i] == '#')) {
      if (text[i] == '#') {
        while (i < text.size() && text[i] != '\n' && text[i] != '\r') ++i;
      } else {
        ++i;
      }
    }
    return i > begin;
  };
  const auto number = [&](unsigned long long& value) {
    if (!gap() || i == text.size() || text[i] < '0' || text[i] > '9') return false;
    for (; i < text.size() && text[i] >= '0' && text[i] <= '9'; ++i) {
      value = 10 * value + static_cast<unsigned>(text[i] - '0');
      if (value > 1000000) return false;  // larger images are not compared
    }
    return true;
  };
  StrictPgm image;
  if (!number(image.width) || !number(image.height) || !number(image.max_value))
    return std::nullopt;
  const auto count = image.width * image.height;
  if (count == 0 || image.max_value == 0 || image.max_value > 65535) return std::nullopt;
  if (!is_plain) {
    const std::size_t bytes = image.max_value > 255 ? 2 : 1;
    if (!is_space() || text.size() - ++i != bytes * count) return std::nullopt;
    for (; i < text.size(); i += bytes) {
      unsigned value = 0;
      for (std::size_t k = 0; k < bytes; ++k) {
        value = 256 * value + static_cast<unsigned char>(text[i + k]);
      }
      image.pixels.push_back(value);
    }
  }
  while (is_plain && image.pixels.size() < count) {
    unsigned long long value = 0;
    if (!number(value)) return std::nullopt;
    image.pixels.push_back(static_cast<unsigned>(value));
  }
  for (const unsigned pixel : image.pixels) {
    if (pixel > image.max_value) return std::nullopt;
  }
  gap();
  return is_plain && i < text.size() ? std::nullopt : std::optional(image);
}

}  // namespace tutavia::test
