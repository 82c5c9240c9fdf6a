// SPDX-License-Identifier: MIT
/// \file
/// Includes everything, as unit_two.cpp does: what is not inline would be defined twice.

#include "tutavia/io/plan_json.hpp"
#ifdef TUTAVIA_TESTS_ROS
#include "tutavia/io/ros_map_yaml.hpp"
#endif
#include "tutavia/io/workspace_json.hpp"
#include "tutavia/registry.hpp"
#include "tutavia/tutavia.hpp"

namespace tutavia::test {
std::size_t goals_in_unit_one() { return maps::maze().goals.size(); }
}  // namespace tutavia::test
