// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/io/text/source_text.hpp"

/// \file
/// GreyImage: what the readers of images return.

namespace tutavia::detail {

/// A grey image.
struct GreyImage {
  int width = 0;
  int height = 0;
  int max_value = 0;                    ///< value of white; 0 is black
  std::vector<std::uint16_t> pixels{};  ///< row by row, row 0 is the TOP
  std::vector<bool> transparent{};      ///< pixels to treat as unknown; empty if there are none
  std::vector<std::string> warnings{};  ///< what was accepted with a doubt, one line each
};

/// How the transparency of pixels counts.
enum class AlphaRule {
  averaged,  ///< as a channel beside the colours, opaque being white
  masks,     ///< pixels that are not opaque are `transparent`
  ignored,
};

/// The most pixels of an image.
inline constexpr std::int64_t max_pixels = std::int64_t{1} << 30;

/// The mean of channels with values from 0 to `white`, as a whole number. It is exact where its
/// scale fits 16 bits, as it does for channels of 8 bits; otherwise it is rounded.
class ChannelMean {
 public:
  ChannelMean(int channels, int white)
      : divisor_(channels * white > 65535 ? channels : 1), white_(channels * white / divisor_) {}

  /// The value of white.
  int white() const { return white_; }
  std::uint16_t operator()(std::int64_t sum) const {
    return static_cast<std::uint16_t>((sum + divisor_ / 2) / divisor_);
  }

 private:
  int divisor_, white_;
};

/// The beginning of unexpected bytes: printable text in quotes, or "byte 0xC3".
inline std::string shown_bytes(std::string_view bytes) {
  if (bytes.empty()) return "the end of the file";
  if (!is_printable(bytes.front())) return std::string("byte ").append(hex_text(bytes.front()));
  std::size_t end = 0;
  while (end < bytes.size() && end < 20 && is_printable(bytes[end])) ++end;
  return shown_text(bytes.substr(0, end));
}

}  // namespace tutavia::detail
