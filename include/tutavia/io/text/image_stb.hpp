// SPDX-License-Identifier: MIT
#pragma once

#include <stb/stb_image.h>

#include <array>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "tutavia/io/text/grey_image.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/pgm.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// parse_image: grey images of several formats.

namespace tutavia::detail {

/// Reads PNG, BMP and JPEG images by stb_image. What it reads without noticing damage is checked
/// here. Throws ParseError.
class ImageReader {
 public:
  ImageReader(std::string_view bytes, AlphaRule alpha) : bytes_(bytes), alpha_(alpha) {}

  GreyImage read() {
    if (bytes_.size() > INT_MAX) {
      throw ParseError{"image of " + std::to_string(bytes_.size()) + " bytes needed, " +
                           std::to_string(INT_MAX) + " bytes allowed",
                       PlanError::limit_exceeded};
    }
    if (is_png(bytes_)) {
      format_ = "PNG";
      check_png();
    } else if (is_bmp(bytes_)) {
      format_ = "BMP";
    } else {
      format_ = "JPEG";
      check_jpeg();
    }
    check_size();
    return stbi_is_16_bit_from_memory(data(), size()) != 0 ? load(stbi_load_16_from_memory, 65535)
                                                           : load(stbi_load_from_memory, 255);
  }

  static bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1A\n"); }
  static bool is_bmp(std::string_view bytes) { return bytes.starts_with("BM"); }
  static bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xFF\xD8\xFF"); }

 private:
  const stbi_uc* data() const { return reinterpret_cast<const stbi_uc*>(bytes_.data()); }
  int size() const { return static_cast<int>(bytes_.size()); }

  template <class Sample>
  GreyImage load(Sample* (*decode)(const stbi_uc*, int, int*, int*, int*, int), int white) const {
    GreyImage image;
    int channels = 0;
    const std::unique_ptr<Sample, void (*)(void*)> samples(
        decode(data(), size(), &image.width, &image.height, &channels, 0), stbi_image_free);
    if (samples == nullptr) reject(stbi_failure_reason());
    const bool has_alpha = channels == 2 || channels == 4;
    const int colours = has_alpha ? channels - 1 : channels;
    const bool averages_alpha = has_alpha && alpha_ == AlphaRule::averaged;
    // Alpha weighs as much as one of three colours, where the image is grey, too.
    const int repeats = averages_alpha && colours == 1 ? 3 : 1;
    const ChannelMean mean(colours * repeats + (averages_alpha ? 1 : 0), white);
    image.max_value = mean.white();
    const std::size_t count =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.pixels.reserve(count);
    if (has_alpha && alpha_ == AlphaRule::masks) image.transparent.resize(count);
    const Sample* sample = samples.get();
    for (std::size_t i = 0; i < count; ++i) {
      std::int64_t sum = 0;
      for (int channel = 0; channel < colours; ++channel) sum += repeats * std::int64_t{*sample++};
      const std::int64_t alpha = has_alpha ? *sample++ : white;
      image.pixels.push_back(mean(averages_alpha ? sum + alpha : sum));
      if (!image.transparent.empty()) image.transparent[i] = alpha < white;
    }
    if (averages_alpha) {
      image.warnings.emplace_back(
          "alpha counts as a colour, as in map_server: opaque cells look freer than their grey");
    }
    if (format_ == "JPEG") {
      image.warnings.emplace_back("JPEG blurs edges: a PNG or PGM image keeps walls as they are");
    }
    return image;
  }

  void check_size() const {
    int width = 0, signed_height = 0, channels = 0;
    if (stbi_info_from_memory(data(), size(), &width, &signed_height, &channels) == 0) {
      reject(stbi_failure_reason());
    }
    const std::int64_t height = std::abs(std::int64_t{signed_height});  // of a BMP from the top
    if (width <= 0 || height == 0) reject("its width or height is not above 0");
    const std::int64_t pixels = std::int64_t{width} * height;
    const std::string extent = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    if (pixels > max_pixels) {
      throw ParseError{std::string(format_).append(" image of ").append(extent) + " needed, " +
                           std::to_string(max_pixels) + " pixels allowed",
                       PlanError::limit_exceeded};
    }
    // A byte of DEFLATE, the tightest of these formats, unpacks to at most 1032 bytes.
    if (pixels / 8 > 1032 * std::int64_t{size()}) reject(extent + " do not fit into its data");
    if (is_bmp(bytes_)) check_bmp(width, height);
  }

  /// stb_image checks no checksum.
  void check_png() const {
    std::string_view rest = bytes_.substr(8), type;
    while (type != "IEND") {
      if (rest.size() < 12) reject("cut short");
      const std::size_t length = big_endian(rest);
      if (length > rest.size() - 12) reject("cut short");
      type = rest.substr(4, 4);
      if (crc(rest.substr(4, length + 4)) != big_endian(rest.substr(length + 8))) {
        reject("damaged (a checksum is wrong)");
      }
      rest.remove_prefix(length + 12);
    }
  }
  static std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
  }
  /// The checksum of PNG (ISO/IEC 15948, annex D).
  static std::uint32_t crc(std::string_view bytes) {
    static const auto table = [] {
      std::array<std::uint32_t, 256> all{};
      for (std::uint32_t i = 0; i < 256; ++i) {
        all[i] = i;
        for (int bit = 0; bit < 8; ++bit) {
          all[i] = (all[i] & 1) != 0 ? 0xEDB88320 ^ all[i] >> 1 : all[i] >> 1;
        }
      }
      return all;
    }();
    std::uint32_t value = 0xFFFFFFFF;
    for (const char c : bytes) {
      value = table[(value ^ static_cast<unsigned char>(c)) & 0xFF] ^ value >> 8;
    }
    return ~value;
  }

  /// Within the pixels of JPEG there is no marker of an end; stb_image reads missing ones as grey.
  void check_jpeg() const {
    const std::size_t scan = bytes_.rfind("\xFF\xDA"), end = bytes_.rfind("\xFF\xD9");
    if (end == std::string_view::npos || (scan != std::string_view::npos && end < scan)) {
      reject("cut short");
    }
  }

  /// stb_image reads missing pixels as black. \pre stb_image knows the header
  void check_bmp(std::int64_t width, std::int64_t height) const {
    if (bytes_.size() < 30) reject("cut short");
    const auto little_endian = [&](std::size_t at, std::size_t count) {
      std::int64_t value = 0;
      while (count-- > 0) value = value << 8 | static_cast<unsigned char>(bytes_[at + count]);
      return value;
    };
    const bool is_old = little_endian(14, 4) == 12;  // its header has 12 bytes, width and height 2
    const std::int64_t pixels_at = little_endian(10, 4), bits = little_endian(is_old ? 24 : 28, 2);
    const std::int64_t row = (width * bits + 31) / 32 * 4;
    if (bits > 32 || pixels_at + row * height > std::int64_t{size()}) reject("cut short");
  }

  [[noreturn]] void reject(const std::string& reason) const {
    throw ParseError{std::string(format_).append(" image: ").append(reason)};
  }

  std::string_view bytes_;
  AlphaRule alpha_;
  std::string_view format_{};
};

/// An image in PNG, BMP, JPEG, PGM or PPM format of up to 2^30 pixels (`limit_exceeded`). The
/// content decides on the format. Colours count with their mean. PNG and PGM keep 16 bits of grey.
/// Errors: `invalid_input` for anything else and for damaged files.
inline Expected<GreyImage, Failure> parse_image(std::string_view bytes, AlphaRule alpha) {
  if (ImageReader::is_png(bytes) || ImageReader::is_bmp(bytes) || ImageReader::is_jpeg(bytes)) {
    return parse_or_fail([&] { return ImageReader(bytes, alpha).read(); });
  }
  if (bytes.starts_with("P")) return parse_pgm(bytes);
  return fail(PlanError::invalid_input,
              "expected a PGM, PPM, PNG, BMP or JPEG image, found " + shown_bytes(bytes));
}

}  // namespace tutavia::detail
