// SPDX-License-Identifier: MIT
#include "tutavia/registry.hpp"

#include "support/searcher_contract.hpp"
#include "tutavia/planner.hpp"

namespace {

using namespace tutavia;

static_assert(Searcher<AnySearch<LatticeSpace>, LatticeSpace>);
static_assert(Smoother<AnySmoother<LatticeSpace>, LatticeSpace>);

TEST_CASE("algorithms chosen by name give what the algorithms themselves give") {
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  const Query query{.start = scene.start, .goal = scene.goals[0]};
  const auto searches = all_searches<LatticeSpace>();
  const auto smoothers = all_smoothers<LatticeSpace>();
  const auto named = [](const auto& all, std::string_view name) {
    for (const auto& any : all) {
      if (any.name == name) return any;
    }
    FAIL("no algorithm is called " << name);
    return all.front();
  };
  Planner by_name{named(searches, "astar"), named(smoothers, "delta")};
  Planner by_type{AStar{}, DeltaSmoother{}};
  CHECK(test::same_curve(by_name.plan(space, query).value().curve,
                         by_type.plan(space, query).value().curve));
  CHECK(named(searches, "dijkstra").name == "dijkstra");
  CHECK(named(smoothers, "none").name == "none");
  CHECK(named(smoothers, "shortcut").name == "shortcut");

  CHECK_FALSE(named(searches, "astar").tree);
  const auto sampling = named(searches, "rrt");
  REQUIRE(sampling.tree);
  const auto route = sampling.run(space, query);
  REQUIRE(route);
  CHECK(sampling.tree().size() == route->stats.generated);
}

}  // namespace
