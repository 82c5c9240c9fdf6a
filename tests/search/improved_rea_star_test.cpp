// SPDX-License-Identifier: MIT
#include "tutavia/search/improved_rea_star.hpp"

#include "support/random_grids.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("improved REA* keeps the searcher contract") {
  test::searcher_contract(ImprovedReaStar{});
  test::searcher_contract(ImprovedReaStar{.exit_cost = ExitCost::last_leg, .funnel = false});
  test::searcher_contract(ImprovedReaStar{.continue_after_contact = true});
  test::searcher_contract(ImprovedReaStar{.target = ExitTarget::newest_exit});
}

TEST_CASE(
    "the estimate towards the newest exit finds a path where there is one, another at times") {
  const std::uint64_t seed = 31;
  Random random(seed);
  int found = 0, differ = 0;
  for (int round = 0; round < 300; ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::noise_grid(random, 24, 24, 0.2)).value();
    const Query query{.start = space.frame().point({0, 0}), .goal = space.frame().point({23, 23})};
    const auto fixed = test::search_once(ImprovedReaStar{}, space, query);
    const auto aimed =
        test::search_once(ImprovedReaStar{.target = ExitTarget::newest_exit}, space, query);
    REQUIRE(aimed.has_value() == fixed.has_value());
    if (!fixed) continue;
    ++found;
    differ += aimed->stats.expanded != fixed->stats.expanded;
  }
  CHECK(found > 20);
  CHECK(differ > 10);
}

TEST_CASE("improved REA* is defined for one movement rule") {
  const auto space =
      CellSpace::build(test::free_grid(3, 3), {.movement = MovementRule::allow}).value();
  const auto refused =
      test::search_once(ImprovedReaStar{}, space, {.start = {0.5, 0.5}, .goal = {1, 1}});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_option);
}

}  // namespace
