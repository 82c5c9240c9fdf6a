// SPDX-License-Identifier: MIT
/// \file
/// Includes everything, as unit_one.cpp does: what is not inline would be defined twice. The
/// library does without Boost.

#include "tutavia/io/plan_json.hpp"
#ifdef TUTAVIA_TESTS_ROS
#include "tutavia/io/ros_map_yaml.hpp"
#endif
#include "tutavia/io/workspace_json.hpp"
#include "tutavia/registry.hpp"
#include "tutavia/tutavia.hpp"

#if defined(BOOST_CONFIG_HPP) || defined(BOOST_VERSION) || defined(BOOST_VERSION_HPP)
#error "a header of the library includes Boost"
#endif

namespace tutavia::test {
std::size_t goals_in_unit_two() { return maps::maze().goals.size(); }
}  // namespace tutavia::test
