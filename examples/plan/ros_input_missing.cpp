// SPDX-License-Identifier: MIT
/// \file
/// Takes the place of ros_input.cpp where yaml-cpp or stb_image is missing.

#include "ros_input.hpp"
#include "usage_error.hpp"

namespace plan_program {

tutavia::RosMap load_ros_map_file(const std::string& path) {
  throw UsageError{path +
                   ": tutavia-plan was built without yaml-cpp or stb_image, which ROS maps need "
                   "(install libyaml-cpp-dev and libstb-dev, and build again)"};
}

}  // namespace plan_program
