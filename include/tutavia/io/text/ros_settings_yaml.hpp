// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/core/expected.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/ros_map_values.hpp"
#include "tutavia/io/text/ros_settings.hpp"
#include "tutavia/io/text/tree_yaml.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// parse_ros_settings: the YAML file of a ROS map.

namespace tutavia::detail {

inline Expected<RosMapSettings, Failure> parse_ros_settings(std::string_view text) {
  return parse_or_fail([&] { return RosSettingsReader(parse_yaml(text)).read(); });
}

}  // namespace tutavia::detail
