// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/plan/statistics.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// against_astar: the effort of an optimal search beside that of A*.

namespace tutavia::test {

/// Sums of one count of Statistics.
struct Effort {
  std::uint64_t of_astar = 0, own = 0;
};

/// Runs a search and A* on 100 random grids, and checks that both find the same costs.
template <class A>
Effort against_astar(const A& search, std::uint64_t seed, std::uint64_t Statistics::*count) {
  Random random(seed);
  Effort effort;
  for (std::size_t round = 0; round < scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(random_grid(random, 60)).value();
    const Query query = random_query(random, space);
    const auto expected = search_once(AStar{}, space, query);
    const auto route = search_once(search, space, query);
    REQUIRE(route.has_value() == expected.has_value());
    if (!route) continue;
    CHECK(route->cost == Approx(expected->cost).epsilon(1e-9));
    effort.of_astar += expected->stats.*count;
    effort.own += route->stats.*count;
  }
  return effort;
}

}  // namespace tutavia::test
