// SPDX-License-Identifier: MIT
#include "tutavia/search/rrt_connect.hpp"

#include "support/tree_contract.hpp"
#include "tutavia/search/rrt.hpp"

namespace {

using namespace tutavia;

TEST_CASE("RrtConnect keeps the contracts of searchers and of trees", "[soak]") {
  test::tree_contract(RrtConnect{}, 0x97016b59ede0705e);
}

TEST_CASE("two trees need fewer iterations than one") {
  NoObserver no_observer;
  std::uint64_t one = 0, two = 0;
  for (const Scene& scene : test::sampling_scenes()) {
    const auto space = InflatedSpace::build(scene.workspace).value();
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Query query{.start = scene.start, .goal = scene.goals.back(), .seed = seed};
      Rrt::Scratch tree;
      RrtConnect::Scratch trees;
      one += Rrt{}.search(space, query, tree, no_observer)->stats.expanded;
      two += RrtConnect{}.search(space, query, trees, no_observer)->stats.expanded;
    }
  }
  CHECK(2 * two < one);
}

}  // namespace
