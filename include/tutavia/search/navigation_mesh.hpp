// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/core/expected.hpp"
#include "tutavia/core/parts/bytes.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/search/mesh/constrained_delaunay.hpp"
#include "tutavia/search/mesh/mesh_builder.hpp"
#include "tutavia/search/mesh/polygon_bins.hpp"
#include "tutavia/search/mesh/sides.hpp"

/// \file
/// NavigationMesh: a grid's free cells decomposed into convex polygons.

namespace tutavia {

/// A decomposition of a grid's free cells into convex polygons and the sides they share. It has far
/// fewer pieces than the free runs of rows, which AnyAngle uses without a mesh.
///
/// The polygons' vertices are corners of the blocked regions, so no side ends in open space. They
/// come from a constrained Delaunay triangulation, whose triangles are merged while the result
/// stays convex.
///
/// Source: Cui, Harabor and Grastien 2017, "Compromise-free pathfinding on a navigation mesh".
///
/// Example: examples/searches_on_cells.cpp.
class NavigationMesh {
 public:
  /// The number of a polygon.
  using Piece = std::uint32_t;
  static constexpr Piece none = std::numeric_limits<Piece>::max();
  static constexpr int max_side = detail::ConstrainedDelaunay::max_side - 2;

  /// O(n log n) for n corners in practice. `limit_exceeded` for grids of more than `max_side` cells
  /// per side or 2^28 walls.
  static Expected<NavigationMesh, Failure> build(const OccupancyGrid& grid);

  /// Serialises the polygons.
  std::string to_bytes() const;
  /// Restores the output of `to_bytes`. `invalid_input` for anything else, and for polygons that
  /// are not a decomposition of this grid's free cells.
  static Expected<NavigationMesh, Failure> from_bytes(std::string_view bytes,
                                                      const OccupancyGrid& grid);

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return exit_of_dead_end_.size(); }
  std::size_t memory() const {
    return first_side_.size() * sizeof(std::uint32_t) +
           sides_.size() * sizeof(detail::PolygonSide) + exit_of_dead_end_.size() * sizeof(Piece) +
           bins_.memory();
  }

  // From here on: what the search of AnyAngle asks (the concept ConvexPieces).

  /// The polygon itself; other decompositions look pieces up here.
  Piece open(Piece piece) const { return piece; }

  /// Calls `visit(piece)` for every polygon that may touch a cell.
  template <class Visit>
  void for_each_near(Cell cell, const Visit& visit) const {
    bins_.for_each_near(cell, visit);
  }

  /// Whether a point lies in a polygon or on its border. `position(corner)` gives a corner's
  /// coordinates.
  template <class Coords>
  bool holds(Piece piece, const Point& p, const Coords& position) const {
    const auto ring = sides(piece);
    return std::all_of(ring.begin(), ring.end(), [&](const detail::PolygonSide& side) {
      return orientation(position(side.right), position(side.left), p) >= 0;
    });
  }

  /// Calls `visit(right, left, piece)` for every side shared with another polygon. The ends are
  /// ordered as seen from inside the polygon.
  template <class Visit>
  void for_each_exit(Piece piece, const Visit& visit) const {
    for (const detail::PolygonSide& side : sides(piece)) {
      if (side.beyond != none) visit(side.right, side.left, side.beyond);
    }
  }

  /// Whether every exit of a polygon but one leads only to dead ends. Only paths that start or end
  /// there need such a polygon.
  bool is_dead_end(Piece piece) const { return exit_of_dead_end_[piece] != none; }
  /// The neighbour through which a dead end is left; the polygon itself if it has none.
  Piece exit_of_dead_end(Piece piece) const { return exit_of_dead_end_[piece]; }
  /// All dead ends have smaller numbers.
  std::size_t dead_end_limit() const { return size(); }

 private:
  NavigationMesh(int width, int height) : width_(width), height_(height), bins_(width, height) {}

  /// A polygon's sides.
  std::span<const detail::PolygonSide> sides(Piece piece) const {
    return {sides_.data() + first_side_[piece], sides_.data() + first_side_[piece + 1]};
  }
  /// Adds a polygon by its vertices, counterclockwise.
  void add(const std::vector<Cell>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      sides_.push_back({ring[i], ring[(i + 1) % ring.size()], none});
    }
    first_side_.push_back(static_cast<std::uint32_t>(sides_.size()));
    exit_of_dead_end_.push_back(none);
  }
  /// Links the sides that two polygons share. Returns false unless the other sides are exactly the
  /// grid's walls, each one once.
  bool link_sides(std::vector<detail::Wall> walls);
  void find_dead_ends();
  void fill_bins() {
    bins_.fill(static_cast<Piece>(size()), [&](Piece piece) { return sides(piece); });
  }

  int width_, height_;
  std::vector<std::uint32_t> first_side_{0};  // per polygon, and one past the last
  std::vector<detail::PolygonSide> sides_;
  std::vector<Piece> exit_of_dead_end_;  // per polygon; none: not a dead end
  detail::PolygonBins bins_;
};

inline Expected<NavigationMesh, Failure> NavigationMesh::build(const OccupancyGrid& grid) {
  if (grid.width() > max_side || grid.height() > max_side) {
    return fail(PlanError::limit_exceeded, "navigation mesh of " + std::to_string(grid.width()) +
                                               " x " + std::to_string(grid.height()) +
                                               " cells needed, " + std::to_string(max_side) +
                                               " a side allowed");
  }
  std::vector<detail::Wall> walls = detail::walls_of(grid);
  constexpr std::size_t max_walls = std::size_t{1} << 28;  // six half-edges each, at most
  if (walls.size() > max_walls) {
    return fail(PlanError::limit_exceeded, "navigation mesh of " + std::to_string(walls.size()) +
                                               " walls needed, " + std::to_string(max_walls) +
                                               " allowed");
  }
  NavigationMesh mesh(grid.width(), grid.height());
  detail::MeshBuilder(grid, walls).collect_polygons([&](const std::vector<Cell>& ring) {
    mesh.add(ring);
  });
  const bool whole = mesh.link_sides(std::move(walls));
  TUTAVIA_ASSERT(whole);
  static_cast<void>(whole);
  mesh.find_dead_ends();
  mesh.fill_bins();
  return mesh;
}

inline bool NavigationMesh::link_sides(std::vector<detail::Wall> walls) {
  using detail::Wall;
  // Sorted by their ends, the two copies of a shared side are adjacent.
  struct End {
    detail::Wall side;  // from the smaller to the larger end
    bool is_reversed;
    std::uint32_t id;
    Piece piece;
  };
  std::vector<End> ends;
  ends.reserve(sides_.size());
  for (Piece piece = 0; piece < size(); ++piece) {
    for (std::uint32_t i = first_side_[piece]; i < first_side_[piece + 1]; ++i) {
      const detail::Wall there{sides_[i].right, sides_[i].left}, back{there.to, there.from};
      ends.push_back({std::min(there, back), back < there, i, piece});
    }
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    return std::tie(a.side, a.is_reversed) < std::tie(b.side, b.is_reversed);
  });
  std::vector<detail::Wall> bare;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const detail::PolygonSide& side = sides_[ends[i].id];
    if (i + 1 < ends.size() && ends[i].side == ends[i + 1].side &&
        ends[i].is_reversed != ends[i + 1].is_reversed) {
      sides_[ends[i].id].beyond = ends[i + 1].piece;
      sides_[ends[i + 1].id].beyond = ends[i].piece;
      ++i;
    } else {
      bare.push_back({side.right, side.left});
    }
  }
  std::sort(walls.begin(), walls.end());
  std::sort(bare.begin(), bare.end());
  return bare == walls;
}

inline void NavigationMesh::find_dead_ends() {
  std::vector<std::uint32_t> exit_counts(size(), 0);  // exits not known to lead to a dead end
  std::vector<Piece> found;
  for (Piece piece = 0; piece < size(); ++piece) {
    for_each_exit(piece, [&](Cell, Cell, Piece) { ++exit_counts[piece]; });
    if (exit_counts[piece] <= 1) found.push_back(piece);
  }
  while (!found.empty()) {
    const Piece piece = found.back();
    found.pop_back();
    exit_of_dead_end_[piece] = piece;
    for_each_exit(piece, [&](Cell, Cell, Piece beyond) {
      if (is_dead_end(beyond)) return;
      exit_of_dead_end_[piece] = beyond;
      if (--exit_counts[beyond] == 1) found.push_back(beyond);
    });
  }
}

namespace detail {

inline constexpr std::string_view navigation_mesh_magic = "tutavia navigation mesh 1\n";

}  // namespace detail

inline std::string NavigationMesh::to_bytes() const {
  std::string bytes(detail::navigation_mesh_magic);
  bytes.reserve(bytes.size() + 4 * size() + 8 * sides_.size());
  for (Piece piece = 0; piece < size(); ++piece) {
    detail::append_bytes(bytes, first_side_[piece + 1] - first_side_[piece], 4);
    for (std::uint32_t i = first_side_[piece]; i < first_side_[piece + 1]; ++i) {
      detail::append_bytes(bytes, static_cast<std::uint32_t>(sides_[i].right.x), 4);
      detail::append_bytes(bytes, static_cast<std::uint32_t>(sides_[i].right.y), 4);
    }
  }
  return bytes;
}

inline Expected<NavigationMesh, Failure> NavigationMesh::from_bytes(std::string_view bytes,
                                                                    const OccupancyGrid& grid) {
  const auto invalid = [](const char* what) { return fail(PlanError::invalid_input, what); };
  const std::string_view magic = detail::navigation_mesh_magic;
  if (bytes.substr(0, magic.size()) != magic || grid.width() > max_side ||
      grid.height() > max_side) {
    return invalid("not a navigation mesh of this version");
  }
  NavigationMesh mesh(grid.width(), grid.height());
  std::vector<Cell> ring;
  for (std::size_t at = magic.size(); at < bytes.size();) {
    if (bytes.size() - at < 4) return invalid("the navigation mesh is damaged");
    const std::uint64_t count = detail::read_bytes(bytes, at, 4);
    at += 4;
    if (count > (bytes.size() - at) / 8) return invalid("the navigation mesh is damaged");
    ring.clear();
    for (std::uint64_t i = 0; i < count; ++i, at += 8) {
      const std::uint64_t x = detail::read_bytes(bytes, at, 4),
                          y = detail::read_bytes(bytes, at + 4, 4);
      if (x > static_cast<std::uint64_t>(grid.width()) ||
          y > static_cast<std::uint64_t>(grid.height())) {
        return invalid("the navigation mesh was made for another grid");
      }
      ring.push_back({static_cast<int>(x), static_cast<int>(y)});
    }
    if (!detail::is_convex(ring)) return invalid("the navigation mesh is damaged");
    mesh.add(ring);
  }
  // If the borders of convex polygons cancel out except for the grid's walls, the polygons cover
  // the area inside the walls, every point once.
  if (!mesh.link_sides(detail::walls_of(grid))) {
    return invalid("the navigation mesh was made for another grid");
  }
  mesh.find_dead_ends();
  mesh.fill_bins();
  return mesh;
}

}  // namespace tutavia
