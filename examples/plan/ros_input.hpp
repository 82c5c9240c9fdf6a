// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tutavia/io/ros_map.hpp"

/// \file
/// load_ros_map_file: the maps of map_server.

namespace plan_program {

/// Reads a ROS map. Throws a UsageError for a file that is refused, and for every file where
/// tutavia-plan was built without tutavia::ros.
tutavia::RosMap load_ros_map_file(const std::string& path);

}  // namespace plan_program
