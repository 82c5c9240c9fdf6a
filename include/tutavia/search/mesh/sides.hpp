// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "tutavia/geometry/predicates.hpp"
#include "tutavia/grid/bitboard/corner_cells.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// Wall and PolygonSide: the walls of a grid, and sides of polygons between them.

namespace tutavia::detail {

/// A straight part of the border between free and blocked cells, with the free cells on its left.
struct Wall {
  Cell from, to;
  friend bool operator==(const Wall&, const Wall&) = default;
  friend bool operator<(const Wall& a, const Wall& b) {
    return std::tie(a.from.y, a.from.x, a.to.y, a.to.x) <
           std::tie(b.from.y, b.from.x, b.to.y, b.to.x);
  }
};

/// A side of a polygon, counterclockwise from right to left as seen from inside.
struct PolygonSide {
  Cell right, left;
  std::uint32_t beyond;  // the neighbour's number; NavigationMesh::none: blocked
};

/// All walls of a grid, from corner to corner. Cells outside the map count as blocked.
inline std::vector<Wall> walls_of(const OccupancyGrid& grid) {
  std::vector<Wall> walls;
  const Cell nowhere{-1, -1};
  std::vector<Cell> below(static_cast<std::size_t>(grid.width()) + 1, nowhere);
  for (int y = 0; y <= grid.height(); ++y) {
    Cell before = nowhere;
    for (int x = 0; x <= grid.width(); ++x) {
      const Cell corner{x, y};
      const CornerCells around(grid, corner);
      if (!around.is_vertex()) continue;
      Cell& under = below[static_cast<std::size_t>(x)];
      if (around.nw != around.sw) {
        walls.push_back(around.nw ? Wall{before, corner} : Wall{corner, before});
      }
      if (around.sw != around.se) {
        walls.push_back(around.sw ? Wall{under, corner} : Wall{corner, under});
      }
      before = corner;
      under = corner;
    }
  }
  return walls;
}

/// Whether a ring turns left or continues straight at every vertex, and winds around once.
inline bool is_convex(const std::vector<Cell>& ring) {
  const std::size_t n = ring.size();
  const auto side = [&](std::size_t i) { return ring[(i + 1) % n] - ring[i % n]; };
  const auto is_down = [](Cell d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
  int rounds = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Cell a = side(i), b = side(i + 1);
    const std::int64_t bend = turn({0, 0}, a, b);
    const bool ahead = std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y > 0;
    if (bend < 0 || (bend == 0 && !ahead)) return false;
    if (is_down(a) && !is_down(b)) ++rounds;
  }
  return rounds == 1;
}

}  // namespace tutavia::detail
