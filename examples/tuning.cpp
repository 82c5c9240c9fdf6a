// SPDX-License-Identifier: MIT
// The weights of SSA-A*, tuned by a salp swarm on maps like those that it will be used on.

#include <iostream>
#include <span>
#include <tutavia/tutavia.hpp>
#include <vector>

using namespace tutavia;

int main() {
  Random random(19);
  std::vector<CellSpace> spaces;
  std::vector<Query> queries;
  for (int i = 0; i < 8; ++i) {
    auto grid = OccupancyGrid::blocked(20, 20).value();
    for (int y = 0; y < 20; ++y) {
      // Free columns at both ends, and a free top row, keep every query solvable.
      for (int x = 0; x < 20; ++x) {
        grid.set({x, y}, x == 0 || x == 19 || y == 19 || random.uniform() < 0.8);
      }
    }
    spaces.push_back(CellSpace::build(grid).value());
    queries.push_back({.start = {0.5, 0.5}, .goal = {19.5, 0.5 + i}});
  }
  const SsaTraining training{.swarm = {.population = 10, .iterations = 10}};
  const auto tuned =
      tune_ssa(std::span<const CellSpace>(spaces), std::span<const Query>(queries), training);
  if (!tuned) {
    std::cerr << tuned.error() << '\n';
    return 1;
  }
  std::cout << "weights " << tuned->weights.chebyshev << ", " << tuned->weights.euclidean << ", "
            << tuned->weights.density << ": " << tuned->fitness << " of A*'s expansions\n";
}
