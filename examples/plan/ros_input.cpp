// SPDX-License-Identifier: MIT
#include "ros_input.hpp"

#include "tutavia/io/ros_map_yaml.hpp"
#include "usage_error.hpp"

namespace plan_program {

tutavia::RosMap load_ros_map_file(const std::string& path) {
  return value_or_throw(tutavia::read_ros_map(path));
}

}  // namespace plan_program
