// SPDX-License-Identifier: MIT
#include "tutavia/search/dijkstra.hpp"

#include <queue>
#include <vector>

#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"

namespace {

using namespace tutavia;

TEST_CASE("Dijkstra keeps the searcher contract") { test::searcher_contract(Dijkstra{}); }

/// Bellman-Ford over all pairs of nodes at most sqrt(2) delta apart, in doubles: slow and obvious.
double shortest_by_relaxation(const LatticeSpace& space, const Point& start, const Point& goal) {
  std::vector<Point> nodes{start, goal};
  for (int y = 0; y < space.grid().height(); ++y) {
    for (int x = 0; x < space.grid().width(); ++x) {
      if (space.grid().is_free({x, y})) nodes.push_back(space.frame().point({x, y}));
    }
  }
  const double longest = std::sqrt(2.0) * space.frame().resolution * (1 + 1e-9);
  std::vector<double> cost(nodes.size(), std::numeric_limits<double>::infinity());
  cost[0] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        const double length = (nodes[i] - nodes[j]).norm();
        if (length > longest || cost[i] + length >= cost[j] - 1e-12) continue;
        if ((i < 2 || j < 2) && !space.segment_free(nodes[i], nodes[j])) continue;
        cost[j] = cost[i] + length;
        changed = true;
      }
    }
  }
  return cost[1];
}

TEST_CASE("Dijkstra's path is the shortest on the lattice") {
  const std::uint64_t seed = 50;
  test::WorldGenerator worlds(seed);
  std::size_t compared = 0;
  for (std::size_t round = 0; round < test::scaled(40); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto space = LatticeSpace::build(world, {.resolution = world.bounds.width() / 14,
                                                   .movement = MovementRule::allow})
                           .value();
    const Query query{.start = worlds.point(world), .goal = worlds.point(world)};
    const auto route = test::search_once(Dijkstra{}, space, query);
    if (!route || route->stats.expanded == 0) continue;  // the straight segment was free
    const double expected = shortest_by_relaxation(space, query.start, query.goal);
    CHECK(route->cost ==
          Approx(expected).epsilon(1e-8).margin(2 * space.frame().resolution / 13860));
    ++compared;
  }
  CHECK(compared > test::scaled(40) / 8);
}

}  // namespace
