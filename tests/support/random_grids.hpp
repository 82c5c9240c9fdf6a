// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

#include "tutavia/core/random.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// Random grids with all difficulties for searches.

namespace tutavia::test {

inline constexpr MovementRule all_rules[] = {MovementRule::no_cut, MovementRule::no_squeeze,
                                             MovementRule::allow, MovementRule::four_connected};

/// A grid whose cells are blocked with probability `density`.
inline OccupancyGrid noise_grid(Random& random, int width, int height, double density) {
  OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) grid.set({x, y}, random.uniform() >= density);
  }
  return grid;
}

/// Calls `visit(grid)` for grids of all densities with sides around multiples of 64, wide and high.
template <class Visit>
void for_each_grid_around_words(Random& random, std::size_t rounds, const Visit& visit) {
  constexpr int sizes[] = {1, 2, 3, 61, 62, 63, 64, 65, 66, 126, 127, 128, 129, 130, 200};
  constexpr double densities[] = {0, 0.001, 0.02, 0.1, 0.35, 0.7, 1};
  for (std::size_t round = 0; round < rounds; ++round) {
    for (const int width : sizes) {
      const int height = sizes[random.below(std::size(sizes))];
      const double density = densities[random.below(std::size(densities))];
      visit(noise_grid(random, width, height, density));
      visit(noise_grid(random, height, width, density));
    }
  }
}

/// A grid without blocked cells.
inline OccupancyGrid free_grid(int width, int height) {
  OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
  for (int y = 0; y < height; ++y) grid.set_run(y, 0, width - 1, true);
  return grid;
}

/// Grids of 1 to `largest` cells a side: noise of 0 to 50 %, blocks, or rooms with doors.
inline OccupancyGrid random_grid(Random& random, int largest) {
  const auto upto = [&](int n) { return static_cast<int>(random.below(static_cast<unsigned>(n))); };
  const int width = 1 + upto(largest), height = 1 + upto(largest);
  OccupancyGrid grid = free_grid(width, height);
  switch (random.below(3)) {
    case 0:
      return noise_grid(random, width, height, random.uniform(0, 0.5));
    case 1:
      for (int i = upto(12); i >= 0; --i) {
        const int x = upto(width), y = upto(height), w = 1 + upto(6), h = 1 + upto(6);
        for (int k = 0; k < h; ++k) grid.set_run(y + k, x, x + w - 1, false);
      }
      break;
    default: {
      const int size = 2 + upto(6);
      for (int y = size; y < height; y += size + 1) grid.set_run(y, 0, width - 1, false);
      for (int x = size; x < width; x += size + 1) {
        for (int y = 0; y < height; ++y) grid.set({x, y}, false);
      }
      for (int i = width * height / 8; i > 0; --i) grid.set({upto(width), upto(height)}, true);
    }
  }
  return grid;
}

/// A free cell (sometimes in a corner), or any cell if none is found soon.
inline Cell random_cell(Random& random, const OccupancyGrid& grid) {
  Cell cell{};
  for (int attempt = 0; attempt < 20; ++attempt) {
    cell = {static_cast<int>(random.below(static_cast<unsigned>(grid.width()))),
            static_cast<int>(random.below(static_cast<unsigned>(grid.height())))};
    if (random.below(8) == 0) cell = {0, 0};
    if (random.below(8) == 0) cell = {grid.width() - 1, grid.height() - 1};
    if (grid.is_free(cell)) break;
  }
  return cell;
}

}  // namespace tutavia::test
