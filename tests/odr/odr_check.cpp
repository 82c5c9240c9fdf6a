// SPDX-License-Identifier: MIT
#include <cstddef>

#include "support/catch.hpp"

namespace tutavia::test {

std::size_t goals_in_unit_one();
std::size_t goals_in_unit_two();

TEST_CASE("two translation units that include everything link into one program") {
  CHECK(goals_in_unit_one() == goals_in_unit_two());
}

}  // namespace tutavia::test
