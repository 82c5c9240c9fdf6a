// SPDX-License-Identifier: MIT
#include "tutavia/search/canonical_astar.hpp"

#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("CanonicalAStar keeps the searcher contract") {
  test::searcher_contract(CanonicalAStar{});
}

TEST_CASE("canonical steps generate fewer nodes than all steps do") {
  const std::uint64_t seed = 441;
  Random random(seed);
  std::uint64_t of_astar = 0, own = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 60)).value();
    const Query query = test::random_query(random, space);
    const auto expected = test::search_once(AStar{}, space, query);
    const auto route = test::search_once(CanonicalAStar{}, space, query);
    REQUIRE(route.has_value() == expected.has_value());
    if (!route) continue;
    CHECK(route->cost == Approx(expected->cost).epsilon(1e-9));
    of_astar += expected->stats.generated;
    own += route->stats.generated;
  }
  CHECK(own < of_astar);
}

}  // namespace
