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
#include <utility>

#include "tutavia/io/text/grey_image.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// parse_pgm: grey images in PGM format, and the grey of PPM images.

namespace tutavia::detail {

/// Reads both variants of PGM and of PPM (netpbm, pgm(5) and ppm(5)). Throws ParseError with the
/// byte.
class PgmReader {
 public:
  explicit PgmReader(std::string_view bytes) : bytes_(bytes) {}

  GreyImage read() {
    if (!begins_image(0)) reject("a PGM or PPM image (P2, P3, P5 or P6)");
    const char kind = bytes_[1];
    is_plain_ = kind == '2' || kind == '3';
    channels_ = kind == '3' || kind == '6' ? 3 : 1;
    at_ = 2;
    read_header();
    if (!is_plain_) find_pixels();
    read_pixels();
    if (channels_ == 3) warn("the image has colours: the mean of red, green and blue counts");
    check_rest();
    return std::move(image_);
  }

 private:
  static constexpr std::int64_t too_large = std::numeric_limits<std::int64_t>::max();

  void read_header() {
    const std::int64_t width = number(1, too_large, "a width above 0");
    const std::int64_t height = number(1, too_large, "a height above 0");
    if (width > max_pixels / height) {
      throw ParseError{"PGM image of " + std::to_string(width) + " x " + std::to_string(height) +
                           " pixels needed, " + std::to_string(max_pixels) + " pixels allowed",
                       PlanError::limit_exceeded};
    }
    white_ = number(1, 65535, "a greatest value from 1 to 65535");
    image_.width = static_cast<int>(width);
    image_.height = static_cast<int>(height);
    count_ = static_cast<std::size_t>(width * height);
    raster_ = count_ * static_cast<std::size_t>(channels_) * (white_ > 255 ? 2 : 1);
  }

  /// Steps over the one blank before the pixels of P5 and P6. Where bytes are left over, the first
  /// ones may be a line feed after a carriage return, blank lines or comments.
  void find_pixels() {
    if (at_ < bytes_.size() && bytes_[at_] == '#') {
      skip_comment();
      warn("a comment after the greatest value was skipped");
    }
    if (at_ == bytes_.size() || !is_blank(bytes_[at_])) reject("a blank, then pixels");
    const bool is_return = bytes_[at_++] == '\r';
    if (bytes_.size() - at_ <= raster_) return;
    if (is_return && bytes_[at_] == '\n') {
      ++at_;
      warn("the line ends of the header are CR LF");
    }
    const std::size_t standard = at_, padded = first_unpadded();
    const bool is_standard = is_rest(standard + raster_);
    const bool is_padded = padded > standard && is_rest(padded + raster_);
    if (is_standard && (is_padded || (is_blank(bytes_[at_]) && is_rest(standard + 1 + raster_)))) {
      reject("pixels at a certain place", "blanks that may be pixels before and after them");
    }
    if (is_standard || !is_padded) return;
    at_ = padded;
    warn("blank lines or comments before the pixels were skipped");
  }
  /// The first byte from the current one on that is no blank and in no comment.
  std::size_t first_unpadded() const {
    PgmReader ahead(bytes_);
    ahead.at_ = at_;
    ahead.skip_blanks();
    return ahead.at_;
  }

  void read_pixels() {
    const ChannelMean mean(channels_, static_cast<int>(white_));
    image_.max_value = mean.white();
    image_.pixels.reserve(std::min(count_, bytes_.size()));
    const std::string what = "a pixel from 0 to " + std::to_string(white_);
    while (image_.pixels.size() < count_) {
      std::int64_t sum = 0;
      for (int channel = 0; channel < channels_; ++channel) {
        sum += is_plain_ ? number(0, white_, what) : raw_pixel(what);
      }
      image_.pixels.push_back(mean(sum));
    }
  }

  /// Blanks and further images may follow.
  void check_rest() {
    const std::size_t end = at_;
    if (is_plain_) {
      skip_blanks();
    } else {
      while (at_ < bytes_.size() && is_blank(bytes_[at_])) ++at_;
      if (at_ > end) warn("a line end or blanks after the last pixel were skipped");
    }
    if (at_ == bytes_.size()) return;
    if (!begins_image(at_)) reject("nothing after the last pixel");
    warn("only the first of several images is read");
  }
  /// Whether the bytes from `at` on may follow the last pixel.
  bool is_rest(std::size_t at) const {
    if (at > bytes_.size()) return false;
    while (at < bytes_.size() && is_blank(bytes_[at])) ++at;
    return at == bytes_.size() || begins_image(at);
  }
  bool begins_image(std::size_t at) const {
    const std::string_view kind = bytes_.substr(at, 2);
    return kind == "P2" || kind == "P3" || kind == "P5" || kind == "P6";
  }

  static bool is_blank(char c) { return c == ' ' || ('\t' <= c && c <= '\r'); }
  void skip_comment() {
    while (at_ < bytes_.size() && bytes_[at_] != '\n' && bytes_[at_] != '\r') ++at_;
  }
  /// Skips white space and comments, which start with #.
  void skip_blanks() {
    for (; at_ < bytes_.size(); ++at_) {
      if (bytes_[at_] == '#') skip_comment();
      if (at_ == bytes_.size() || !is_blank(bytes_[at_])) return;
    }
  }
  /// Reads at least one blank and a number; one that exceeds 64 bits becomes `too_large`.
  std::int64_t number(std::int64_t low, std::int64_t high, const std::string& what) {
    const std::size_t before = at_;
    skip_blanks();
    if (at_ < bytes_.size() && bytes_[at_] == '-') reject(what);
    std::int64_t value = too_large;
    const char *const begin = bytes_.data() + at_, *const end = bytes_.data() + bytes_.size();
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (at_ == before || error == std::errc::invalid_argument || value < low || value > high) {
      reject(what);
    }
    at_ += static_cast<std::size_t>(stop - begin);
    return value;
  }
  std::int64_t raw_pixel(const std::string& what) {
    std::int64_t value = 0;
    for (std::int64_t span = white_; span > 0; span /= 256) {
      if (at_ == bytes_.size()) reject(what);
      value = 256 * value + static_cast<unsigned char>(bytes_[at_++]);
    }
    if (value > white_) {
      at_ -= white_ > 255 ? 2 : 1;
      reject(what, std::to_string(value));
    }
    return value;
  }

  void warn(std::string what) { image_.warnings.push_back(std::move(what)); }
  [[noreturn]] void reject(const std::string& expected) const {
    reject(expected, shown_bytes(bytes_.substr(at_)));
  }
  [[noreturn]] void reject(const std::string& expected, const std::string& found) const {
    throw ParseError{"PGM byte " + std::to_string(at_) + ": expected " + expected + ", found " +
                     found};
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  bool is_plain_ = false;
  int channels_ = 1;
  std::int64_t white_ = 0;  // of a channel
  std::size_t count_ = 0;   // of pixels
  std::size_t raster_ = 0;  // size of the pixels of P5 and P6 [bytes]
  GreyImage image_{};
};

/// A PGM image, P2 or P5, of up to 2^30 pixels (`limit_exceeded`); P5 with a maximum value above
/// 255 has two bytes per pixel, the high one first. Of a PPM image, P3 or P6, the mean of the
/// channels counts. What map_server reads beyond the format is accepted with a warning: blanks
/// after the last pixel, further images, CR LF, blank lines and comments before the pixels, as far
/// as the size of the file leaves no doubt where the pixels are. Errors: `invalid_input` with the
/// byte of the first unexpected content, including other data after the last pixel.
inline Expected<GreyImage, Failure> parse_pgm(std::string_view pgm) {
  return parse_or_fail([&] { return PgmReader(pgm).read(); });
}

}  // namespace tutavia::detail
