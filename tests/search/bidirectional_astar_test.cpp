// SPDX-License-Identifier: MIT
#include "tutavia/search/bidirectional_astar.hpp"

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("BidirectionalAStar keeps the searcher contract") {
  test::searcher_contract(BidirectionalAStar{});
}

}  // namespace
