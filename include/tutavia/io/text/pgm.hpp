// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// parse_pgm: grey images in PGM format.

namespace tutavia::detail {

/// A grey image.
struct PgmImage {
  int width = 0;
  int height = 0;
  int max_value = 0;                    ///< value of white; 0 is black
  std::vector<std::uint16_t> pixels{};  ///< row by row, row 0 is the TOP
};

/// Reads both variants of PGM (netpbm, pgm(5)). Throws ParseError with the byte.
class PgmReader {
 public:
  explicit PgmReader(std::string_view bytes) : bytes_(bytes) {}

  PgmImage read() {
    const bool plain = bytes_.starts_with("P2");
    if (!plain && !bytes_.starts_with("P5")) reject("P2 or P5 (of images, only PGM is read)");
    at_ = 2;
    PgmImage image = header();
    if (!plain) {
      if (at_ == bytes_.size() || !is_blank(bytes_[at_])) reject("a blank, then pixels");
      ++at_;
    }
    read_pixels(image, plain);
    if (plain) skip_blanks();
    if (at_ < bytes_.size()) reject("nothing after the last pixel");
    return image;
  }

 private:
  static constexpr std::int64_t too_large = std::numeric_limits<std::int64_t>::max();

  PgmImage header() {
    const std::int64_t width = number(1, too_large, "a width above 0");
    const std::int64_t height = number(1, too_large, "a height above 0");
    constexpr std::int64_t max_pixels = std::int64_t{1} << 30;
    if (width > max_pixels / height) {
      throw ParseError{"PGM image of " + std::to_string(width) + " x " + std::to_string(height) +
                           " pixels needed, " + std::to_string(max_pixels) + " pixels allowed",
                       PlanError::limit_exceeded};
    }
    const std::int64_t white = number(1, 65535, "a greatest value from 1 to 65535");
    return {static_cast<int>(width), static_cast<int>(height), static_cast<int>(white), {}};
  }

  void read_pixels(PgmImage& image, bool plain) {
    const std::size_t count =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.pixels.reserve(std::min(count, bytes_.size()));
    const std::string what = "a pixel from 0 to " + std::to_string(image.max_value);
    while (image.pixels.size() < count) {
      const std::int64_t pixel =
          plain ? number(0, image.max_value, what) : raw_pixel(image.max_value, what);
      image.pixels.push_back(static_cast<std::uint16_t>(pixel));
    }
  }

  static bool is_blank(char c) { return c == ' ' || ('\t' <= c && c <= '\r'); }
  /// Skips white space and comments, which start with #.
  void skip_blanks() {
    for (bool comment = false; at_ < bytes_.size(); ++at_) {
      const char c = bytes_[at_];
      comment = (comment || c == '#') && c != '\n' && c != '\r';
      if (!comment && !is_blank(c)) return;
    }
  }
  /// Reads at least one blank and a number; one that exceeds 64 bits becomes `too_large`.
  std::int64_t number(std::int64_t low, std::int64_t high, const std::string& what) {
    const std::size_t before = at_;
    skip_blanks();
    std::int64_t value = too_large;
    const char *const begin = bytes_.data() + at_, *const end = bytes_.data() + bytes_.size();
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (at_ == before || error == std::errc::invalid_argument || value < low || value > high) {
      reject(what);
    }
    at_ += static_cast<std::size_t>(stop - begin);
    return value;
  }
  std::int64_t raw_pixel(std::int64_t high, const std::string& what) {
    std::int64_t value = 0;
    for (std::int64_t span = high; span > 0; span /= 256) {
      if (at_ == bytes_.size()) reject(what);
      value = 256 * value + static_cast<unsigned char>(bytes_[at_++]);
    }
    if (value > high) {
      at_ -= high > 255 ? 2 : 1;
      reject(what, std::to_string(value));
    }
    return value;
  }

  [[noreturn]] void reject(const std::string& expected) const {
    std::string found(bytes_.substr(at_, 20));
    for (char& c : found) c = c < ' ' || c > '~' ? '?' : c;
    reject(expected, at_ < bytes_.size() ? '"' + found + '"' : "the end of the file");
  }
  [[noreturn]] void reject(const std::string& expected, const std::string& found) const {
    throw ParseError{"PGM byte " + std::to_string(at_) + ": expected " + expected + ", found " +
                     found};
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// A PGM image, P2 or P5, of up to 2^30 pixels (`limit_exceeded`); P5 with a maximum value above
/// 255 has two bytes per pixel, the high one first. Errors: `invalid_input` with the byte of the
/// first unexpected content, including data after the last pixel.
inline Expected<PgmImage, Failure> parse_pgm(std::string_view pgm) {
  return parse_or_fail([&] { return PgmReader(pgm).read(); });
}

}  // namespace tutavia::detail
