// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "runs.hpp"
#include "support/paper_maps.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/search/astar.hpp"

/// \file
/// Grids to tune SSA-A* on, of the kinds of the test grids and disjoint from them.

namespace reproduce {

/// Blocks every cell with probability 0.2.
inline OccupancyGrid scattered_cells(Random& random, int size) {
  OccupancyGrid grid = OccupancyGrid::blocked(size, size).value();
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) grid.set({x, y}, random.uniform() >= 0.2);
  }
  return grid;
}

/// Blocks the cells of random walks until 40 % are blocked.
inline OccupancyGrid clustered_cells(Random& random, int size) {
  OccupancyGrid grid = OccupancyGrid::blocked(size, size).value();
  for (int y = 0; y < size; ++y) grid.set_run(y, 0, size - 1, true);
  const auto upto = [&](int n) { return static_cast<int>(random.below(static_cast<unsigned>(n))); };
  int blocked = 0;
  while (5 * blocked < 2 * size * size) {
    Cell at{upto(size), upto(size)};
    for (int steps_left = size / 3 + upto(size - size / 3 + 1); steps_left > 0; --steps_left) {
      blocked += grid.is_free(at);
      grid.set(at, false);
      const Cell next = at + steps[2 * random.below(4)];
      if (grid.contains(next)) at = next;
    }
  }
  return grid;
}

/// Grids from corner to corner: the 3 x 3 cells at both corners are free, and the shortest path is
/// at most 1.16 times as long as on an empty grid.
inline std::vector<test::PaperTask> training_tasks(bool clustered, int size, std::size_t count,
                                                   std::uint64_t seed) {
  Random random(seed);
  std::vector<test::PaperTask> tasks;
  AStar::Scratch scratch;
  NoObserver no_observer;
  while (tasks.size() < count) {
    OccupancyGrid grid = clustered ? clustered_cells(random, size) : scattered_cells(random, size);
    for (int i = 0; i < 3; ++i) {
      grid.set_run(i, 0, 2, true);
      grid.set_run(size - 1 - i, size - 3, size - 1, true);
    }
    auto space = CellSpace::build(std::move(grid), {.movement = MovementRule::allow}).value();
    const Query query{.start = space.frame().point({0, 0}),
                      .goal = space.frame().point({size - 1, size - 1})};
    const auto route =
        AStar{.successors = AStar::Successors::all}.search(space, query, scratch, no_observer);
    if (route && route->cost <= 1.16 * std::sqrt(2.0) * (size - 1)) {
      tasks.push_back({std::move(space), query});
    }
  }
  return tasks;
}

}  // namespace reproduce
