// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cstdint>

#include "support/registry.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/world/maps.hpp"

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

  const auto count = [](const SearchRecord& record, SearchRecord::Event::Kind kind) {
    return static_cast<std::uint64_t>(
        std::count_if(record.events.begin(), record.events.end(),
                      [&](const SearchRecord::Event& event) { return event.kind == kind; }));
  };
  using Kind = SearchRecord::Event::Kind;
  for (const auto& search : searches) {
    INFO(search.name);
    SearchRecord record;
    AnySearch<LatticeSpace>::Scratch scratch;
    const auto route = search.search(space, query, scratch, record);
    REQUIRE(route);
    const bool is_tree = search.name.find("rrt") != std::string_view::npos;
    // Trees count tries, of which those that fail add no node.
    CHECK(count(record, Kind::expanded) <= route->stats.expanded);
    if (!is_tree) CHECK(count(record, Kind::expanded) == route->stats.expanded);
    if (search.name == "rrt") CHECK(count(record, Kind::edge) == route->stats.generated);
    CHECK((count(record, Kind::edge) > 0) == is_tree);
    const bool is_rectangles = search.name.find("rea_star") != std::string_view::npos;
    CHECK(count(record, Kind::rectangle) == (is_rectangles ? route->stats.expanded : 0));
    CHECK(count(record, Kind::interval) == count(record, Kind::rectangle));
  }
}

TEST_CASE("one scratch serves searches of any kind, one after the other") {
  const Scene scene = maps::array();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  AnySearch<LatticeSpace>::Scratch shared;
  NoObserver no_observer;
  for (const Point& goal : scene.goals) {
    const Query query{.start = scene.start, .goal = goal, .seed = 3};
    for (const auto& search : all_searches<LatticeSpace>()) {
      INFO(search.name);
      AnySearch<LatticeSpace>::Scratch own;
      const auto expected = search.search(space, query, own, no_observer);
      const auto route = search.search(space, query, shared, no_observer);
      REQUIRE(route);
      CHECK(test::same_curve(route->curve, expected->curve));
    }
  }
}

}  // namespace
