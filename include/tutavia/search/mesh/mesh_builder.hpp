// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "tutavia/geometry/predicates.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/search/mesh/constrained_delaunay.hpp"
#include "tutavia/search/mesh/sides.hpp"

/// \file
/// MeshBuilder: builds convex polygons from the walls of a grid.

namespace tutavia::detail {

/// The constrained Delaunay triangulation of the corners of a grid's walls, with all walls as
/// edges.
inline ConstrainedDelaunay triangulate(const OccupancyGrid& grid, const std::vector<Wall>& walls) {
  // Corners in Morton order, so that successive corners are near each other.
  struct Vertex {
    std::uint64_t key;
    Cell corner;
    ConstrainedDelaunay::Index index;
  };
  const auto morton = [](Cell corner) {
    const auto spread = [](int value) {
      auto bits = static_cast<std::uint64_t>(value);
      bits = (bits | bits << 8) & 0x00FF00FF;
      bits = (bits | bits << 4) & 0x0F0F0F0F;
      bits = (bits | bits << 2) & 0x33333333;
      return (bits | bits << 1) & 0x55555555;
    };
    return spread(corner.x) | spread(corner.y) << 1;
  };
  std::vector<Vertex> vertices;
  vertices.reserve(walls.size());
  for (const Wall& wall : walls) vertices.push_back({morton(wall.from), wall.from, 0});
  const auto by_key = [](const Vertex& a, const Vertex& b) { return a.key < b.key; };
  std::sort(vertices.begin(), vertices.end(), by_key);
  ConstrainedDelaunay triangles({-1, -1}, {grid.width() + 1, grid.height() + 1});
  for (Vertex& vertex : vertices) vertex.index = triangles.insert(vertex.corner);
  const auto index = [&](Cell corner) {
    const Vertex wanted{morton(corner), corner, 0};
    return std::lower_bound(vertices.begin(), vertices.end(), wanted, by_key)->index;
  };
  for (const Wall& wall : walls) triangles.fix(index(wall.from), index(wall.to));
  triangles.restore();
  return triangles;
}

/// Merges the triangles of a grid's free cells while the result stays convex, the longest removable
/// sides first. Polygons are rings of half-edges.
class MeshBuilder {
 public:
  MeshBuilder(const OccupancyGrid& grid, const std::vector<Wall>& walls)
      : triangles_(triangulate(grid, walls)),
        count_(triangles_.half_edge_count()),
        next_(count_),
        previous_(count_),
        inside_(count_) {
    mark_inside(grid);
    merge_convex();
  }

  /// Calls `visit(ring)` with the vertices of every polygon, counterclockwise. Call once only.
  template <class Visit>
  void collect_polygons(const Visit& visit) {
    std::vector<Cell> ring;
    for (Index first = 0; first < count_; ++first) {
      if (!inside_[first]) continue;
      ring.clear();
      for (Index e = first; inside_[e]; e = next_[e]) {
        ring.push_back(triangles_.from(e));
        inside_[e] = 0;
      }
      visit(ring);
    }
  }

 private:
  using Index = ConstrainedDelaunay::Index;

  /// Initialises rings from the triangles and marks those in free cells.
  void mark_inside(const OccupancyGrid& grid) {
    for (Index e = 0; e < count_; ++e) {
      next_[e] = ConstrainedDelaunay::next(e);
      previous_[e] = ConstrainedDelaunay::previous(e);
      const Cell sum =
          triangles_.from(e) + triangles_.from(next_[e]) + triangles_.from(previous_[e]);
      const Cell cell{(sum.x + 3) / 3 - 1, (sum.y + 3) / 3 - 1};
      inside_[e] = grid.contains(cell) && grid.is_free(cell) ? 1 : 0;
    }
  }

  void merge_convex() {
    std::vector<std::pair<std::int64_t, Index>> shared;  // minus squared length, half-edge
    for (Index e = 0; e < count_; ++e) {
      const Index t = triangles_.twin(e);
      if (!inside_[e] || t == ConstrainedDelaunay::none || t < e || !inside_[t]) continue;
      const Cell d = triangles_.to(e) - triangles_.from(e);
      shared.emplace_back(-(std::int64_t{d.x} * d.x + std::int64_t{d.y} * d.y), e);
    }
    std::sort(shared.begin(), shared.end());
    for (const auto& [length, e] : shared) {
      const Index t = triangles_.twin(e);
      if (!turns_left(previous_[e], next_[t]) || !turns_left(previous_[t], next_[e])) continue;
      link(previous_[e], next_[t]);
      link(previous_[t], next_[e]);
      inside_[e] = 0;
      inside_[t] = 0;
    }
  }
  bool turns_left(Index in, Index out) const {
    return turn(triangles_.from(in), triangles_.from(out), triangles_.from(next_[out])) >= 0;
  }
  void link(Index in, Index out) {
    next_[in] = out;
    previous_[out] = in;
  }

  ConstrainedDelaunay triangles_;
  Index count_;                         // number of half-edges
  std::vector<Index> next_, previous_;  // along the ring
  std::vector<char> inside_;            // whether a half-edge is a side of a free polygon
};

}  // namespace tutavia::detail
