// SPDX-License-Identifier: MIT
// Every search on the cells of a map: its name, the length of its path and its expansions.

#include <iostream>
#include <tutavia/tutavia.hpp>

using namespace tutavia;

template <class Search>
void show(const CellSpace& space, const Query& query, Search search) {
  Planner planner{std::move(search)};
  const auto plan = planner.plan(space, query);
  std::cout << Search::name << ": ";
  if (plan) {
    std::cout << plan->metrics.length << " m, " << plan->stats.expanded << " expansions\n";
  } else {
    std::cout << plan.error() << '\n';
  }
}

int main() {
  auto grid = OccupancyGrid::blocked(60, 40).value();
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 60; ++x) {
      const bool is_wall = (x == 20 && y < 30) || (x == 40 && y >= 10);
      grid.set({x, y}, !is_wall);
    }
  }
  const CellSpace space = CellSpace::build(grid).value();
  const Query query{.start = {2.5, 3.5}, .goal = {57.5, 35.5}, .seed = 1};

  show(space, query, Dijkstra{});
  show(space, query, AStar{});
  show(space, query, AStar{.heuristic = HeuristicKind::euclidean});
  show(space, query, WeightedAStar{.weight = 1.5});
  show(space, query, CanonicalAStar{});
  show(space, query, BidirectionalAStar{});
  show(space, query, PenaltyAStar{});
  show(space, query, SsaAStar{});
  show(space, query, AntColony{.ants = 10, .iterations = 20});
  show(space, query, Jps{});
  show(space, query, JpsPlus{JpsPlus::prepare(space).value()});

  show(space, query, ThetaStar{.nodes = NodePlacement::cell_corner});
  show(space, query, LazyThetaStar{});
  show(space, query, JpsThetaStar{});
  show(space, query, AnyAngle{});
  show(space, query, AnyAngle{AnyAngle::prepare(space).value()});

  show(space, query, ReaStar{});
  show(space, query, SbReaStar{});
  show(space, query, ImprovedReaStar{});
}
