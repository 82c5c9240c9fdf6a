// SPDX-License-Identifier: MIT
#include "tutavia/search/rrt.hpp"

#include "support/searcher_contract.hpp"
#include "support/tree_contract.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

TEST_CASE("Rrt keeps the contracts of searchers and of trees", "[soak]") {
  test::tree_contract(Rrt{}, 0x3adf3abbe4bdfcdb);
}

TEST_CASE("no edge of a tree is longer than the step, and the path bends at its nodes only") {
  const Scene scene = maps::array();
  const auto space = InflatedSpace::build(scene.workspace).value();
  const Query query{.start = scene.start, .goal = scene.goals[3]};
  Rrt::Scratch scratch;
  NoObserver no_observer;
  for (const double step : {0.3, 1.0, 22.0}) {
    const auto route =
        Rrt{.step = step, .max_iterations = 20000}.search(space, query, scratch, no_observer);
    REQUIRE(route);
    std::size_t edges = 0;
    scratch.for_each_edge([&](const Point& from, const Point& to) {
      ++edges;
      CHECK(distance(from, to) <= step * (1 + 1e-12));
    });
    CHECK(edges == route->stats.generated);
    CHECK(route->cost == Approx(route->curve.length()).epsilon(1e-12));
  }
}

TEST_CASE("a tree that only grows towards the goal gets stuck behind an obstacle") {
  const Scene& scene = test::open_scene();
  const auto space = InflatedSpace::build(scene.workspace).value();
  const Query query{.start = scene.start, .goal = scene.goals[0]};
  Rrt::Scratch scratch;
  NoObserver no_observer;
  const auto stuck = Rrt{.goal_bias = 1}.search(space, query, scratch, no_observer);
  REQUIRE_FALSE(stuck);
  CHECK(stuck.error().code == PlanError::budget_exhausted);
  CHECK(Rrt{.goal_bias = 0}.search(space, query, scratch, no_observer));
}

TEST_CASE("the distance that a tree kept from the goal is told") {
  const auto space = InflatedSpace::build({.bounds = {{0, 0}, {10, 10}},
                                           .safety_radius = 1,
                                           .obstacles = {Polygon{{{5, -1}, {5, 11}}}}})
                         .value();
  Rrt::Scratch scratch;
  NoObserver no_observer;
  const auto none = Rrt{.step = 4, .goal_bias = 0.5}.search(
      space, {.start = {1, 5}, .goal = {9, 5}}, scratch, no_observer);
  REQUIRE_FALSE(none);
  const std::string& detail = none.error().detail;
  CHECK(detail.find("no path after 3000 iterations; the tree comes within 5.") == 0);
}

}  // namespace
