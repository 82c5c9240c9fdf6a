// SPDX-License-Identifier: MIT
#include <tutavia/io/ros_map_yaml.hpp>

int main() {
  const char* const yaml = "{image: a.pgm, resolution: 1, origin: [0, 0, 0]}";
  return tutavia::parse_ros_map(yaml, "P2 1 1 1 1") ? 0 : 1;
}
