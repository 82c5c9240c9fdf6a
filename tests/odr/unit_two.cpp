// SPDX-License-Identifier: MIT
/// \file
/// Includes everything, as unit_one.cpp does: what is not inline would be defined twice.

#include "tutavia/io/plan_json.hpp"
#include "tutavia/io/workspace_json.hpp"
#include "tutavia/registry.hpp"
#include "tutavia/tutavia.hpp"

namespace tutavia::test {
std::size_t searches_in_unit_two() { return all_searches<LatticeSpace>().size(); }
}  // namespace tutavia::test
