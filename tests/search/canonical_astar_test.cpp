// SPDX-License-Identifier: MIT
#include "tutavia/search/canonical_astar.hpp"

#include "support/against_astar.hpp"
#include "support/catch.hpp"
#include "support/searcher_contract.hpp"

namespace {

using namespace tutavia;

TEST_CASE("CanonicalAStar keeps the searcher contract") {
  test::searcher_contract(CanonicalAStar{});
}

TEST_CASE("canonical A* is A* with its default options") {
  const test::Effort effort = test::against_astar(CanonicalAStar{}, 441, &Statistics::generated);
  CHECK(effort.own == effort.of_astar);
}

}  // namespace
