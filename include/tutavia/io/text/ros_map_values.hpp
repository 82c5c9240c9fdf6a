// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "tutavia/io/ros_map.hpp"
#include "tutavia/io/text/grey_image.hpp"

/// \file
/// RosMapValues: the occupancy of a map from the pixels of its image.

namespace tutavia::detail {

/// What the YAML file of a map says. Size and values of `map` come from the image.
struct RosMapSettings {
  enum class Mode { trinary, scale, raw };

  RosMap map{};
  std::string image{};
  Mode mode = Mode::trinary;
  bool negate = false;
  double occupied_thresh = 0, free_thresh = 0;
};

/// What transparency means in the mode of a map.
inline AlphaRule alpha_rule(RosMapSettings::Mode mode) {
  switch (mode) {
    case RosMapSettings::Mode::trinary:
      return AlphaRule::averaged;
    case RosMapSettings::Mode::scale:
      return AlphaRule::masks;
    case RosMapSettings::Mode::raw:
      break;
  }
  return AlphaRule::ignored;
}

/// The occupancy of a pixel, in the arithmetic of nav2_map_server up to Jazzy (map_io.cpp,
/// loadMapFromFile), which decides ties with a threshold.
class RosMapValues {
 public:
  /// The image has the scale from 0 to `white`.
  RosMapValues(const RosMapSettings& settings, double white)
      : mode_(settings.mode),
        negate_(settings.negate),
        white_(white),
        free_(settings.free_thresh),
        occupied_(settings.occupied_thresh) {}

  std::int8_t operator()(int pixel) const {
    using Mode = RosMapSettings::Mode;
    const double shade = pixel / white_;
    if (mode_ == Mode::raw) {
      const long level = std::lround(shade * 255);
      return static_cast<std::int8_t>(level <= 100 ? level : -1);
    }
    const double occupancy = negate_ ? shade : 1.0 - shade;
    if (occupancy > occupied_) return 100;
    if (occupancy < free_) return 0;
    if (mode_ == Mode::trinary) return -1;
    if (free_ == occupied_) return 100;
    return static_cast<std::int8_t>(std::lrint((occupancy - free_) / (occupied_ - free_) * 100.0));
  }

 private:
  RosMapSettings::Mode mode_;
  bool negate_;
  double white_, free_, occupied_;
};

/// Warns where the grey that map_saver writes for unknown cells counts as free.
inline void warn_of_free_unknown(const RosMapSettings& settings, const GreyImage& image,
                                 RosMap& map) {
  constexpr int unknown = 205, white = 255;
  if (settings.mode != RosMapSettings::Mode::trinary || settings.negate) return;
  if (RosMapValues(settings, white)(unknown) != 0) return;
  std::size_t count = 0;
  for (const int pixel : image.pixels)
    count += pixel * white == unknown * image.max_value ? 1U : 0U;
  if (count == 0) return;
  map.warnings.push_back("grey 205, which map_saver writes for unknown cells, counts as free (" +
                         std::to_string(count) + " of them): free_thresh is above 0.196");
}

inline RosMap make_ros_map(const RosMapSettings& settings, const GreyImage& image) {
  RosMap map = settings.map;
  map.width = image.width;
  map.height = image.height;
  for (const std::string& warning : image.warnings) map.warnings.push_back("image: " + warning);
  warn_of_free_unknown(settings, image, map);
  const RosMapValues value(settings, image.max_value);
  map.values.reserve(image.pixels.size());
  for (std::ptrdiff_t row = image.height; row-- > 0;) {
    for (std::ptrdiff_t column = 0; column < image.width; ++column) {
      const auto i = static_cast<std::size_t>(row * image.width + column);
      const bool is_transparent = !image.transparent.empty() && image.transparent[i];
      map.values.push_back(is_transparent ? std::int8_t{-1} : value(image.pixels[i]));
    }
  }
  return map;
}

}  // namespace tutavia::detail
