// SPDX-License-Identifier: MIT
#include "tutavia/search/sb_rea_star.hpp"

#include "support/random_grids.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("SBREA* keeps the searcher contract") { test::searcher_contract(SbReaStar{}); }

TEST_CASE("SBREA* is defined for one movement rule") {
  const auto space =
      CellSpace::build(test::free_grid(3, 3), {.movement = MovementRule::allow}).value();
  const auto refused = test::search_once(SbReaStar{}, space, {.start = {0.5, 0.5}, .goal = {1, 1}});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_option);
}

}  // namespace
