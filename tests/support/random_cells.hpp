// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/cell_oracle.hpp"
#include "support/random_grids.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// Cell maps from text, and random ones with all kinds of radii and resolutions.

namespace tutavia::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double quiet_nan = std::numeric_limits<double>::quiet_NaN();

/// A map from rows of text, the topmost first: '#' is blocked.
inline OccupancyGrid draw(const std::vector<std::string>& rows) {
  const int height = static_cast<int>(rows.size()), width = static_cast<int>(rows[0].size());
  OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::string& row = rows[static_cast<std::size_t>(height - 1 - y)];
      grid.set({x, y}, row[static_cast<std::size_t>(x)] != '#');
    }
  }
  return grid;
}

/// Scattered blocked cells and blocks; sometimes none or all. Large maps are wider than a word,
/// with few blocked or few free cells.
inline OccupancyGrid random_map(Random& random, bool large = false) {
  const int width = 1 + static_cast<int>(random.below(9)) + (large ? 55 : 0);
  const int height = 1 + static_cast<int>(random.below(large ? 40 : 9));
  OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
  const double density = large                   ? 0.02 * random.uniform()
                         : random.below(12) == 0 ? 1
                                                 : random.uniform() * random.uniform();
  const auto count = static_cast<std::size_t>(random.below(large ? 7 : 4));
  const bool inverse = large && random.below(4) == 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) grid.set({x, y}, (random.uniform() < density) == inverse);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const int x = static_cast<int>(random.below(static_cast<std::uint64_t>(width)));
    const int y = static_cast<int>(random.below(static_cast<std::uint64_t>(height)));
    for (int dy = 0; dy < 1 + static_cast<int>(i); ++dy) {
      for (int dx = 0; dx < 3; ++dx) {
        if (grid.contains({x + dx, y + dy})) grid.set({x + dx, y + dy}, inverse);
      }
    }
  }
  return grid;
}

/// Random sizes and origins, binary fractions and others.
inline CellOptions random_options(Random& random) {
  constexpr double sizes[] = {1, 0.5, 0.25, 0.05, 0.1, 3, 1e-3};
  const Point origins[] = {{0, 0}, {-12.3, 4.7}, {1000.5, -2000}, {-3, 1e4 / 3}};
  return {.resolution = sizes[random.below(std::size(sizes))],
          .origin = origins[random.below(std::size(origins))],
          .movement = all_rules[random.below(4)]};
}

/// A radius for cells of this size: 0, a multiple of a quarter or a neighbouring double, a distance
/// between corners, or any other.
inline double random_radius(Random& random, double side) {
  const auto n = static_cast<double>(1 + random.below(8));
  switch (random.below(6)) {
    case 0:
      return 0;
    case 1:
      return side * n / 4;
    case 2:
      return std::nextafter(side * n / 4, random.below(2) == 0 ? 0 : infinity);
    case 3:
      return side * std::sqrt(n / 8);
    case 4:
      return std::nextafter(side * std::sqrt(n / 2), random.below(2) == 0 ? 0 : infinity);
    default:
      return side * random.uniform(0.01, 2);
  }
}

inline CellSpace random_space(Random& random, const OccupancyGrid& map, bool at_contact = false) {
  CellOptions options = random_options(random);
  const double side = CellSpace::build(map, options).value().frame().resolution;
  options.safety_radius = at_contact ? 0 : random_radius(random, side);
  return CellSpace::build(map, options).value();
}

/// A box with its corners on quarters, sometimes beyond the grid.
inline std::pair<Place, Place> random_box(Random& random, const Squares& squares) {
  const Place a = squares.random_place(random), b = squares.random_place(random);
  const std::int64_t more = random.below(5) == 0 ? 6 : 0;
  return {{std::min(a.x, b.x) - more, std::min(a.y, b.y) - more},
          {std::max(a.x, b.x) + more, std::max(a.y, b.y) + more}};
}

/// The number and kinds of random maps.
struct CellTrials {
  std::uint64_t seed;
  std::size_t rounds;
  std::size_t large_every = 0;       ///< the map is large once in so many rounds; 0: never
  std::size_t at_contact_every = 0;  ///< the safety radius is 0 once in so many rounds
};

struct CellTrial {
  Random& random;
  OccupancyGrid map;
  CellSpace space;
  Squares squares;
};

/// Calls check(trial) for random maps and their spaces, the same ones for the same seed.
template <class Check>
void on_random_cells(const CellTrials& trials, const Check& check) {
  const auto is_due = [](std::size_t round, std::size_t every) {
    return every != 0 && round % every == 0;
  };
  Random random(trials.seed);
  for (std::size_t round = 0; round < trials.rounds; ++round) {
    INFO("seed " << trials.seed << ", round " << round);
    OccupancyGrid map = random_map(random, is_due(round, trials.large_every));
    CellSpace space = random_space(random, map, is_due(round, trials.at_contact_every));
    Squares squares(map);
    check(CellTrial{random, std::move(map), std::move(space), std::move(squares)});
  }
}

}  // namespace tutavia::test
