// SPDX-License-Identifier: MIT
#include "tutavia/search/jps_plus.hpp"

#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/prepared.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("JpsPlus keeps the searcher contract") {
  test::searcher_contract(test::PreparedEachTime<JpsPlus>{});
}

TEST_CASE("jumps that are looked up lead where jumps that are walked do") {
  const std::uint64_t seed = 443;
  Random random(seed);
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 60)).value();
    const JpsPlus prepared{JpsPlus::prepare(space).value()};
    const Query query = test::random_query(random, space);
    const auto walked = test::search_once(Jps{}, space, query);
    const auto looked_up = test::search_once(prepared, space, query);
    REQUIRE(looked_up.has_value() == walked.has_value());
    if (!walked) continue;
    CHECK(looked_up->cost == Approx(walked->cost).epsilon(1e-12));
    ++found;
  }
  CHECK(found > test::scaled(100) / 3);
}

TEST_CASE("without its table JPS+ refuses to search") {
  const auto space = CellSpace::build(OccupancyGrid::blocked(3, 3).value()).value();
  const Query query{.start = {0.5, 0.5}, .goal = {2.5, 0.5}};
  for (const auto& search : {JpsPlus{}}) {
    const auto route = test::search_once(search, space, query);
    REQUIRE_FALSE(route);
    CHECK(route.error().code == PlanError::invalid_option);
  }
}

}  // namespace
