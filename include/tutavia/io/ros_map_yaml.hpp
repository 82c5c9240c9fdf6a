// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "tutavia/core/expected.hpp"
#include "tutavia/io/ros_map.hpp"
#include "tutavia/io/text/image_stb.hpp"
#include "tutavia/io/text/read_file.hpp"
#include "tutavia/io/text/ros_map_values.hpp"
#include "tutavia/io/text/ros_settings_yaml.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// Reads the maps of map_server and nav2_map_server. Needs the target tutavia::ros (yaml-cpp, stb).

namespace tutavia {

namespace detail {

/// The path of an image that a YAML file names: ~/ is the home folder, and a relative path starts
/// at the folder of the YAML file.
inline std::filesystem::path image_path(const std::filesystem::path& yaml_path,
                                        const std::string& image) {
  const char* const home = std::getenv("HOME");
  if (home != nullptr && (image == "~" || image.starts_with("~/"))) {
    return std::string(home).append(image, 1);
  }
  return yaml_path.parent_path() / image;
}

}  // namespace detail

/// Parses a map from its YAML text and its image, as map_server and nav2_map_server (up to Jazzy)
/// read them. `image`, `resolution` and `origin` are required. Others have defaults: `mode`
/// trinary, and with a warning `negate` 0, `occupied_thresh` 0.65 and `free_thresh` 0.25, which
/// are those of nav2's map_saver.
///
/// With shade = pixel / white, and occupancy = 1 - shade, or shade with `negate`:
/// - trinary: 100 above `occupied_thresh`, 0 below `free_thresh`, unknown otherwise
/// - scale: the same, but linear in between, rounded to whole numbers
/// - raw: the shade on a scale with white = 255, up to 100; unknown above. `negate` changes
///   nothing.
///
/// The image may be PGM, PPM, PNG, BMP or JPEG; its content says which. Shades of colours are their
/// mean. Alpha is averaged with the colours in trinary mode, marks all that is not opaque as
/// unknown in scale mode, and is ignored in raw mode. Later versions of nav2 treat a pixel exactly
/// at a threshold as occupied or free, and whatever is not opaque as unknown.
///
/// Warnings say what was assumed or skipped: defaults, unknown keys, a yaw that is not a number (it
/// counts as 0), irregularities of the image, and cells of the grey that map_saver writes for
/// unknown (205) where `free_thresh` makes them free. Errors: `invalid_input` with the line of the
/// YAML, or the byte of a PGM; a key given twice is one. `limit_exceeded` for images of more than
/// 2^30 pixels.
inline Expected<RosMap, Failure> parse_ros_map(std::string_view yaml, std::string_view image) {
  const auto settings = detail::parse_ros_settings(yaml);
  if (!settings) return Unexpected{settings.error()};
  const auto pixels = detail::parse_image(image, detail::alpha_rule(settings->mode));
  if (!pixels) return Unexpected{pixels.error()};
  return detail::make_ros_map(*settings, *pixels);
}

/// Reads a YAML file and its image with `parse_ros_map`. A relative image path starts at the folder
/// of the YAML file, ~/ at the home folder. Details of failures start with the file's name.
///
/// Example: examples/02_ros_map.cpp.
inline Expected<RosMap, Failure> read_ros_map(const std::filesystem::path& yaml_path) {
  const auto settings = detail::read_file(yaml_path, detail::parse_ros_settings);
  if (!settings) return Unexpected{settings.error()};
  const auto image = detail::read_file(
      detail::image_path(yaml_path, settings->image), [&](std::string_view bytes) {
        return detail::parse_image(bytes, detail::alpha_rule(settings->mode));
      });
  if (!image) return Unexpected{image.error()};
  return detail::make_ros_map(*settings, *image);
}

}  // namespace tutavia
