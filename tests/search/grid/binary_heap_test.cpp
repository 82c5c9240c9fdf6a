// SPDX-License-Identifier: MIT
#include "tutavia/search/grid/binary_heap.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

TEST_CASE("the least key comes first, among equal ones the entry pushed last") {
  detail::BinaryHeap heap;
  heap.reset(0);
  heap.push(5, 1, 10);
  heap.push(3, 2, 20);
  heap.push(3, 3, 30);
  heap.push(4, 4, 40);
  CHECK(heap.seek_first() == 3);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
  while (!heap.empty()) {
    const auto entry = heap.pop();
    order.emplace_back(entry.node, entry.tag);
  }
  CHECK(order ==
        std::vector<std::pair<std::uint32_t, std::uint32_t>>{{3, 30}, {2, 20}, {4, 40}, {1, 10}});
}

TEST_CASE("keys may fall below those taken, and a new query begins with nothing") {
  const std::uint64_t seed = 52;
  Random random(seed);
  detail::BinaryHeap heap;
  for (int round = 0; round < 20; ++round) {
    INFO("seed " << seed << ", round " << round);
    heap.reset(0);
    CHECK(heap.empty());
    std::vector<Cost> keys;
    for (int i = 0; i < 200; ++i) {
      if (!keys.empty() && random.below(3) == 0) {
        const auto least = std::min_element(keys.begin(), keys.end());
        REQUIRE(heap.pop().key == *least);
        keys.erase(least);
      } else {
        keys.push_back(static_cast<Cost>(random.below(1000)));
        heap.push(keys.back(), 0, 0);
      }
    }
  }
}

}  // namespace
