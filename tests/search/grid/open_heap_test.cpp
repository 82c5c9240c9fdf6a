// SPDX-License-Identifier: MIT
#include "tutavia/search/grid/open_heap.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

TEST_CASE("an open list gives the best entry first, whatever the order of pushing") {
  const std::uint64_t seed = 51;
  Random random(seed);
  detail::OpenHeap<std::uint64_t> open;  // a < b: a is worse
  for (int round = 0; round < 50; ++round) {
    INFO("seed " << seed << ", round " << round);
    std::vector<std::uint64_t> entries;
    // Pushes and pops by turns, as in a search.
    for (int i = 0; i < 100; ++i) {
      if (!entries.empty() && random.below(3) == 0) {
        const auto best = std::max_element(entries.begin(), entries.end());
        REQUIRE(open.top() == *best);
        REQUIRE(open.pop() == *best);
        entries.erase(best);
      } else {
        entries.push_back(random.below(20));
        open.push(entries.back());
      }
      REQUIRE(open.empty() == entries.empty());
    }
    open.clear();
    CHECK(open.empty());
  }
}

}  // namespace
