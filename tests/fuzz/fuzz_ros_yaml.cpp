// SPDX-License-Identifier: MIT
/// \file
/// Any text as the YAML file of a ROS map: it is refused, or all its values are in range and, as
/// map_server would convert them, the same.

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/io/ros_map_yaml.hpp"

namespace {

using namespace tutavia;

void require(bool condition) {
  if (!condition) std::abort();
}

void check_values(const detail::RosMapSettings& settings) {
  const RosMap& map = settings.map;
  require(!settings.image.empty());
  require(map.resolution > 0 && std::isfinite(map.resolution));
  require(detail::is_finite(map.origin) && std::isfinite(map.yaw));
  require(0 <= settings.free_thresh && settings.free_thresh <= settings.occupied_thresh);
  require(settings.occupied_thresh <= 1);
  for (const std::string& warning : map.warnings) {
    require(warning.find('\n') == std::string::npos && warning.size() < 200);
  }
}

/// Compares with the conversions of yaml-cpp. What it refuses is not compared.
void check_against_yaml_cpp(const std::string& text, const detail::RosMapSettings& settings) {
  try {
    const YAML::Node node = YAML::Load(text);
    require(node["image"].as<std::string>() == settings.image);
    require(node["resolution"].as<double>() == settings.map.resolution);
    if (node["free_thresh"]) require(node["free_thresh"].as<double>() == settings.free_thresh);
    if (node["occupied_thresh"]) {
      require(node["occupied_thresh"].as<double>() == settings.occupied_thresh);
    }
    if (node["negate"]) {
      bool negate = false;
      try {
        negate = node["negate"].as<int>() != 0;
      } catch (const YAML::Exception&) {
        negate = node["negate"].as<bool>();
      }
      require(negate == settings.negate);
    }
    const auto origin = node["origin"].as<std::vector<double>>();
    require(origin.size() == 3);
    require(origin[0] == settings.map.origin.x() && origin[1] == settings.map.origin.y());
    require(std::isnan(origin[2]) ? settings.map.yaw == 0 : origin[2] == settings.map.yaw);
  } catch (const YAML::Exception&) {
    return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto settings = detail::parse_ros_settings(text);
  if (!settings) {
    require(settings.error().detail.find('\n') == std::string::npos);
    return 0;
  }
  check_values(*settings);
  check_against_yaml_cpp(text, *settings);
  for (const char* image : {"P2 3 1 255 0 205 254", "P5 1 1 255 \n"}) {
    const auto map = parse_ros_map(text, image);
    if (map) require(map->values.size() == static_cast<std::size_t>(map->width));
  }
  return 0;
}
