// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/core/expected.hpp"
#include "tutavia/core/parts/bytes.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/grid/corner_cells.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/search/mesh/constrained_delaunay.hpp"

/// \file
/// NavigationMesh: the free cells of a grid as few convex polygons, prepared.

namespace tutavia {

/// A decomposition of a grid's free cells into convex polygons with the sides they share: what
/// RowRuns finds anew for every query, in far fewer pieces.
///
/// The polygons' vertices are the corners of the blocked regions, so no side ends in open space. A
/// constrained Delaunay triangulation of them, its triangles merged while they stay convex.
/// Source: Cui, Harabor and Grastien 2017, "Compromise-free pathfinding on a navigation mesh".
class NavigationMesh {
 public:
  /// A polygon by its number.
  using Piece = std::uint32_t;
  static constexpr Piece none = std::numeric_limits<Piece>::max();
  static constexpr int max_side = detail::ConstrainedDelaunay::max_side - 2;

  /// Takes O(n log n) for n corners in practice. `limit_exceeded` for grids of more than `max_side`
  /// cells a side or 2^28 walls.
  static Expected<NavigationMesh, Failure> build(const OccupancyGrid& grid);

  /// The polygons as bytes, to be kept in a file.
  std::string to_bytes() const;
  /// What `to_bytes` gave. `invalid_input` for anything else, and for polygons that are not a
  /// decomposition of this grid's free cells.
  static Expected<NavigationMesh, Failure> from_bytes(std::string_view bytes,
                                                      const OccupancyGrid& grid);

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return way_out_.size(); }
  std::size_t memory() const {
    return first_side_.size() * sizeof(std::uint32_t) + sides_.size() * sizeof(Side) +
           way_out_.size() * sizeof(Piece) + first_in_bin_.size() * sizeof(std::uint32_t) +
           in_bin_.size() * sizeof(Piece);
  }

  /// A piece as RowRuns has it; here there is nothing to look up.
  Piece open(Piece piece) const { return piece; }

  /// Calls `visit(piece)` for every polygon that may touch a cell.
  template <class Visit>
  void for_each_near(Cell cell, const Visit& visit) const {
    const std::size_t bin = bin_of(std::clamp(cell.x, 0, width_), std::clamp(cell.y, 0, height_));
    for (std::uint32_t i = first_in_bin_[bin]; i < first_in_bin_[bin + 1]; ++i) visit(in_bin_[i]);
  }

  /// Whether a point lies in a polygon or on its border; `place(corner)` says where corners lie.
  template <class Place>
  bool holds(Piece piece, const Point& p, const Place& place) const {
    for (std::uint32_t i = first_side_[piece]; i < first_side_[piece + 1]; ++i) {
      if (orientation(place(sides_[i].right), place(sides_[i].left), p) < 0) return false;
    }
    return true;
  }

  /// Calls `visit(right, left, piece)` for every side that a polygon shares with another: its ends
  /// as seen from within.
  template <class Visit>
  void for_each_exit(Piece piece, const Visit& visit) const {
    for (std::uint32_t i = first_side_[piece]; i < first_side_[piece + 1]; ++i) {
      if (sides_[i].beyond != none) visit(sides_[i].right, sides_[i].left, sides_[i].beyond);
    }
  }

  /// Whether all ways from a polygon, other than back by the one it was entered through, end
  /// nowhere: only paths that begin or end there need it.
  bool is_dead_end(Piece piece) const { return way_out_[piece] != none; }
  /// The neighbour that leads out of a dead end; the last of a tree of them names itself.
  Piece way_out(Piece piece) const { return way_out_[piece]; }
  /// All dead ends have lesser numbers.
  std::size_t dead_end_limit() const { return size(); }

 private:
  /// A straight part of the border between free and blocked cells, free ones on its left.
  struct Wall {
    Cell from, to;
    friend bool operator==(const Wall&, const Wall&) = default;
    friend bool operator<(const Wall& a, const Wall& b) {
      return std::tie(a.from.y, a.from.x, a.to.y, a.to.x) <
             std::tie(b.from.y, b.from.x, b.to.y, b.to.x);
    }
  };
  /// A side of a polygon, counterclockwise from right to left as seen from within.
  struct Side {
    Cell right, left;
    Piece beyond;  // none: blocked
  };
  static constexpr int bin_side = 8;  // cells

  NavigationMesh(int width, int height)
      : width_(width), height_(height), bin_columns_(width / bin_side + 1) {}

  /// All walls of a grid, whose map is surrounded by blocked cells, from corner to corner.
  static std::vector<Wall> walls(const OccupancyGrid& grid);
  static bool is_convex(const std::vector<Cell>& ring);
  /// Adds a polygon by its vertices, counterclockwise.
  void add(const std::vector<Cell>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      sides_.push_back({ring[i], ring[(i + 1) % ring.size()], none});
    }
    first_side_.push_back(static_cast<std::uint32_t>(sides_.size()));
    way_out_.push_back(none);
  }
  /// Finds what lies beyond the sides; false unless those without a neighbour are the grid's walls,
  /// every one once.
  bool join(std::vector<Wall> walls);
  void find_dead_ends();
  void fill_bins();
  /// Calls `visit(bin)` for every bin that a polygon touches, and perhaps for some others.
  template <class Visit>
  void for_each_bin(Piece piece, const Visit& visit) const;
  std::size_t bin_of(int x, int y) const {
    return static_cast<std::size_t>(y / bin_side) * static_cast<std::size_t>(bin_columns_) +
           static_cast<std::size_t>(x / bin_side);
  }

  int width_, height_, bin_columns_;
  std::vector<std::uint32_t> first_side_{0};  // by polygon, and the end
  std::vector<Side> sides_;
  std::vector<Piece> way_out_;  // by polygon; none: no dead end
  std::vector<std::uint32_t> first_in_bin_;
  std::vector<Piece> in_bin_;
};

inline std::vector<NavigationMesh::Wall> NavigationMesh::walls(const OccupancyGrid& grid) {
  std::vector<Wall> result;
  const Cell nowhere{-1, -1};
  std::vector<Cell> below(static_cast<std::size_t>(grid.width()) + 1, nowhere);
  for (int y = 0; y <= grid.height(); ++y) {
    Cell before = nowhere;
    for (int x = 0; x <= grid.width(); ++x) {
      const Cell corner{x, y};
      const CornerCells around(grid, corner);
      if (!around.is_vertex()) continue;
      Cell& under = below[static_cast<std::size_t>(x)];
      if (around.nw != around.sw)
        result.push_back(around.nw ? Wall{before, corner} : Wall{corner, before});
      if (around.sw != around.se)
        result.push_back(around.sw ? Wall{under, corner} : Wall{corner, under});
      before = corner;
      under = corner;
    }
  }
  return result;
}

inline Expected<NavigationMesh, Failure> NavigationMesh::build(const OccupancyGrid& grid) {
  if (grid.width() > max_side || grid.height() > max_side) {
    return fail(PlanError::limit_exceeded, "navigation mesh of " + std::to_string(grid.width()) +
                                               " x " + std::to_string(grid.height()) +
                                               " cells needed, " + std::to_string(max_side) +
                                               " a side allowed");
  }
  using Index = detail::ConstrainedDelaunay::Index;
  // Corners along Morton's curve, so that each is near the one before.
  struct Vertex {
    std::uint64_t key;
    Cell corner;
    Index index;
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
  std::vector<Wall> walls = NavigationMesh::walls(grid);
  constexpr std::size_t max_walls = std::size_t{1} << 28;  // six half-edges each, at most
  if (walls.size() > max_walls) {
    return fail(PlanError::limit_exceeded, "navigation mesh of " + std::to_string(walls.size()) +
                                               " walls needed, " + std::to_string(max_walls) +
                                               " allowed");
  }
  std::vector<Vertex> vertices;
  vertices.reserve(walls.size());
  for (const Wall& wall : walls) vertices.push_back({morton(wall.from), wall.from, 0});
  const auto by_key = [](const Vertex& a, const Vertex& b) { return a.key < b.key; };
  std::sort(vertices.begin(), vertices.end(), by_key);
  detail::ConstrainedDelaunay triangles({-1, -1}, {grid.width() + 1, grid.height() + 1});
  for (Vertex& vertex : vertices) vertex.index = triangles.insert(vertex.corner);
  const auto index = [&](Cell corner) {
    const Vertex wanted{morton(corner), corner, 0};
    return std::lower_bound(vertices.begin(), vertices.end(), wanted, by_key)->index;
  };
  for (const Wall& wall : walls) triangles.fix(index(wall.from), index(wall.to));
  triangles.restore();

  // Polygons as rings of half-edges; the longest sides that may go, go first.
  const Index count = triangles.half_edge_count();
  std::vector<Index> next(count), previous(count);
  std::vector<char> inside(count);
  std::vector<std::pair<std::int64_t, Index>> shared;
  for (Index e = 0; e < count; ++e) {
    next[e] = detail::ConstrainedDelaunay::next(e);
    previous[e] = detail::ConstrainedDelaunay::previous(e);
    const Cell sum = triangles.from(e) + triangles.from(next[e]) + triangles.from(previous[e]);
    const Cell cell{(sum.x + 3) / 3 - 1, (sum.y + 3) / 3 - 1};
    inside[e] = grid.contains(cell) && grid.is_free(cell) ? 1 : 0;
  }
  for (Index e = 0; e < count; ++e) {
    const Index t = triangles.twin(e);
    if (!inside[e] || t == detail::ConstrainedDelaunay::none || t < e || !inside[t]) continue;
    const Cell d = triangles.to(e) - triangles.from(e);
    shared.emplace_back(-(std::int64_t{d.x} * d.x + std::int64_t{d.y} * d.y), e);
  }
  std::sort(shared.begin(), shared.end());
  for (const auto& [length, e] : shared) {
    const Index t = triangles.twin(e);
    const auto turns_left = [&](Index in, Index out) {
      return turn(triangles.from(in), triangles.from(out), triangles.from(next[out])) >= 0;
    };
    if (!turns_left(previous[e], next[t]) || !turns_left(previous[t], next[e])) continue;
    next[previous[e]] = next[t], previous[next[t]] = previous[e];
    next[previous[t]] = next[e], previous[next[e]] = previous[t];
    inside[e] = inside[t] = 0;
  }

  NavigationMesh mesh(grid.width(), grid.height());
  std::vector<Cell> ring;
  for (Index first = 0; first < count; ++first) {
    if (!inside[first]) continue;
    ring.clear();
    for (Index e = first; inside[e]; e = next[e]) {
      ring.push_back(triangles.from(e));
      inside[e] = 0;
    }
    mesh.add(ring);
  }
  const bool whole = mesh.join(std::move(walls));
  TUTAVIA_ASSERT(whole);
  static_cast<void>(whole);
  mesh.find_dead_ends();
  mesh.fill_bins();
  return mesh;
}

inline bool NavigationMesh::join(std::vector<Wall> walls) {
  // Sides by their ends, so that the two of a shared one stand together.
  struct End {
    Wall side;  // from the lesser to the greater end
    bool turned;
    std::uint32_t id;
    Piece piece;
  };
  std::vector<End> ends;
  ends.reserve(sides_.size());
  for (Piece piece = 0; piece < size(); ++piece) {
    for (std::uint32_t i = first_side_[piece]; i < first_side_[piece + 1]; ++i) {
      const Wall there{sides_[i].right, sides_[i].left}, back{there.to, there.from};
      ends.push_back({std::min(there, back), back < there, i, piece});
    }
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    return std::tie(a.side, a.turned) < std::tie(b.side, b.turned);
  });
  std::vector<Wall> bare;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Side& side = sides_[ends[i].id];
    if (i + 1 < ends.size() && ends[i].side == ends[i + 1].side &&
        ends[i].turned != ends[i + 1].turned) {
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
  std::vector<std::uint32_t> ways(size(), 0);  // exits that are not known to be dead ends
  std::vector<Piece> found;
  for (Piece piece = 0; piece < size(); ++piece) {
    for_each_exit(piece, [&](Cell, Cell, Piece) { ++ways[piece]; });
    if (ways[piece] <= 1) found.push_back(piece);
  }
  while (!found.empty()) {
    const Piece piece = found.back();
    found.pop_back();
    way_out_[piece] = piece;
    for_each_exit(piece, [&](Cell, Cell, Piece beyond) {
      if (is_dead_end(beyond)) return;
      way_out_[piece] = beyond;
      if (--ways[beyond] == 1) found.push_back(beyond);
    });
  }
}

template <class Visit>
void NavigationMesh::for_each_bin(Piece piece, const Visit& visit) const {
  int bottom = height_, top = 0;
  for (std::uint32_t i = first_side_[piece]; i < first_side_[piece + 1]; ++i) {
    bottom = std::min(bottom, sides_[i].right.y);
    top = std::max(top, sides_[i].right.y);
  }
  for (int row = bottom / bin_side; row <= top / bin_side; ++row) {
    int low = width_, high = 0;
    for (std::uint32_t i = first_side_[piece]; i < first_side_[piece + 1]; ++i) {
      const Cell a = sides_[i].right, b = sides_[i].left;
      const auto offer = [&](int y) {  // where the side crosses a level
        if (y < std::min(a.y, b.y) || y > std::max(a.y, b.y)) return;
        const int rise = a.y == b.y ? 1 : b.y - a.y;
        const std::int64_t run = a.y == b.y ? 0 : (std::int64_t{b.x} - a.x) * (y - a.y);
        const auto x = static_cast<int>(a.x + run / rise);
        low = std::min(low, x - 1);
        high = std::max(high, x + 1);
      };
      offer(row * bin_side);
      offer((row + 1) * bin_side);
      if (a.y / bin_side == row) low = std::min(low, a.x), high = std::max(high, a.x);
    }
    low = std::max(low, 0) / bin_side;
    high = std::min(high, width_) / bin_side;
    for (int column = low; column <= high; ++column) {
      visit(bin_of(column * bin_side, row * bin_side));
    }
  }
}

inline void NavigationMesh::fill_bins() {
  first_in_bin_.assign(bin_of(width_, height_) + 2, 0);
  for (Piece piece = 0; piece < size(); ++piece) {
    for_each_bin(piece, [&](std::size_t bin) { ++first_in_bin_[bin + 1]; });
  }
  for (std::size_t bin = 1; bin < first_in_bin_.size(); ++bin) {
    first_in_bin_[bin] += first_in_bin_[bin - 1];
  }
  in_bin_.resize(first_in_bin_.back());
  std::vector<std::uint32_t> at(first_in_bin_.begin(), first_in_bin_.end() - 1);
  for (Piece piece = 0; piece < size(); ++piece) {
    for_each_bin(piece, [&](std::size_t bin) { in_bin_[at[bin]++] = piece; });
  }
}

/// Whether a ring turns left or goes straight on at every vertex, once around.
inline bool NavigationMesh::is_convex(const std::vector<Cell>& ring) {
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
  const auto broken = [](const char* what) { return fail(PlanError::invalid_input, what); };
  const std::string_view magic = detail::navigation_mesh_magic;
  if (bytes.substr(0, magic.size()) != magic || grid.width() > max_side ||
      grid.height() > max_side) {
    return broken("not a navigation mesh of this version");
  }
  NavigationMesh mesh(grid.width(), grid.height());
  std::vector<Cell> ring;
  for (std::size_t at = magic.size(); at < bytes.size();) {
    if (bytes.size() - at < 4) return broken("the navigation mesh is damaged");
    const std::uint64_t count = detail::read_bytes(bytes, at, 4);
    at += 4;
    if (count > (bytes.size() - at) / 8) return broken("the navigation mesh is damaged");
    ring.clear();
    for (std::uint64_t i = 0; i < count; ++i, at += 8) {
      const std::uint64_t x = detail::read_bytes(bytes, at, 4),
                          y = detail::read_bytes(bytes, at + 4, 4);
      if (x > static_cast<std::uint64_t>(grid.width()) ||
          y > static_cast<std::uint64_t>(grid.height())) {
        return broken("the navigation mesh was made for another grid");
      }
      ring.push_back({static_cast<int>(x), static_cast<int>(y)});
    }
    if (!is_convex(ring)) return broken("the navigation mesh is damaged");
    mesh.add(ring);
  }
  // Convex polygons whose borders cancel out but for the grid's walls cover what these surround,
  // every point once.
  if (!mesh.join(walls(grid))) return broken("the navigation mesh was made for another grid");
  mesh.find_dead_ends();
  mesh.fill_bins();
  return mesh;
}

}  // namespace tutavia
