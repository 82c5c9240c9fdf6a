// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// The rules of the Grid-Based Path Planning Competition for paths of a point robot among blocked
/// cells, in integers, and the shortest such path by a visibility graph. Shares no code with the
/// searches.

namespace tutavia::test {

/// Coordinates in half cells: corners are even, centres odd.
struct Half {
  std::int64_t x = 0, y = 0;
  friend bool operator==(const Half&, const Half&) = default;
};

inline Half corner_of(Cell cell) { return {2 * std::int64_t{cell.x}, 2 * std::int64_t{cell.y}}; }
inline Half centre_of(Cell cell) {
  return {2 * std::int64_t{cell.x} + 1, 2 * std::int64_t{cell.y} + 1};
}
/// The waypoints of a curve, on cells of side 1 with the origin at 0.
inline std::vector<Half> joints_in_halves(const Curve& curve) {
  const auto half = [](const Point& p) {
    return Half{std::llround(2 * p.x()), std::llround(2 * p.y())};
  };
  std::vector<Half> joints{half(curve.start())};
  for (const Piece& piece : curve.pieces()) joints.push_back(half(end_of(piece)));
  return joints;
}

inline double length(Half a, Half b) {
  const auto dx = static_cast<double>(a.x - b.x), dy = static_cast<double>(a.y - b.y);
  return std::sqrt(dx * dx + dy * dy) / 2;
}

class CornerRules {
 public:
  explicit CornerRules(const OccupancyGrid& grid) : grid_(grid) {}

  bool blocked(std::int64_t x, std::int64_t y) const {
    const Cell cell{static_cast<int>(x), static_cast<int>(y)};
    return !grid_.contains(cell) || !grid_.is_free(cell);
  }

  /// Whether two blocked cells touch at this lattice point only.
  bool is_double_corner(Half p) const {
    if (p.x % 2 != 0 || p.y % 2 != 0) return false;
    const bool ne = blocked(p.x / 2, p.y / 2), nw = blocked(p.x / 2 - 1, p.y / 2);
    const bool sw = blocked(p.x / 2 - 1, p.y / 2 - 1), se = blocked(p.x / 2, p.y / 2 - 1);
    return (ne && sw && !nw && !se) || (nw && se && !ne && !sw);
  }

  /// Whether a segment avoids the interiors of blocked cells, does not run between two blocked
  /// cells, and passes no double corner between its ends.
  bool allows(Half a, Half b) const {
    const std::int64_t x0 = std::min(a.x, b.x), x1 = std::max(a.x, b.x);
    const std::int64_t y0 = std::min(a.y, b.y), y1 = std::max(a.y, b.y);
    if (x0 < 0 || y0 < 0 || x1 > 2 * grid_.width() || y1 > 2 * grid_.height()) return false;
    // A generous range of columns near the segment in a row of cells.
    const auto columns = [&](std::int64_t y) {
      if (a.y == b.y) return std::pair{x0 / 2 - 1, x1 / 2 + 1};
      const auto at = [&](std::int64_t level) {
        return a.x + (std::clamp(level, y0, y1) - a.y) * (b.x - a.x) / (b.y - a.y);
      };
      const auto [low, high] = std::minmax({at(2 * y - 2), at(2 * y + 4)});
      return std::pair{low / 2 - 2, high / 2 + 2};
    };
    for (std::int64_t y = y0 / 2 - 1; y <= y1 / 2; ++y) {
      const auto [first, last] = columns(y);
      for (std::int64_t x = first; x <= last; ++x) {
        if (crosses_inside(a, b, x, y) && blocked(x, y)) return false;
        const Half p{2 * x, 2 * y};
        const bool between = x0 <= p.x && p.x <= x1 && y0 <= p.y && p.y <= y1 &&
                             side(a, b, p) == 0 && p != a && p != b;
        if (between && is_double_corner(p)) return false;
      }
    }
    if (y0 == y1 && y0 % 2 == 0) {
      for (std::int64_t x = x0 / 2; 2 * x < x1; ++x) {
        if (blocked(x, y0 / 2) && blocked(x, y0 / 2 - 1)) return false;
      }
    }
    if (x0 == x1 && x0 % 2 == 0) {
      for (std::int64_t y = y0 / 2; 2 * y < y1; ++y) {
        if (blocked(x0 / 2, y) && blocked(x0 / 2 - 1, y)) return false;
      }
    }
    return true;
  }

  /// A whole path: its segments, and no bend at a double corner.
  bool allows(const std::vector<Half>& path) const {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      if (!allows(path[i], path[i + 1])) return false;
      if (i > 0 && is_double_corner(path[i])) return false;
    }
    return true;
  }

  /// Length of a shortest path: Dijkstra on the start, the goal and all corners that a taut string
  /// can bend at.
  std::optional<double> shortest(Half start, Half goal) const {
    std::vector<Half> nodes{start, goal};
    for (int y = 1; y < grid_.height(); ++y) {
      for (int x = 1; x < grid_.width(); ++x) {
        const int count =
            blocked(x, y) + blocked(x - 1, y) + blocked(x - 1, y - 1) + blocked(x, y - 1);
        if (count == 1) nodes.push_back(corner_of({x, y}));
      }
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> g(nodes.size(), infinity);
    std::vector<bool> done(nodes.size(), false);
    g[0] = 0;
    while (true) {
      std::size_t best = nodes.size();
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!done[i] && g[i] < infinity && (best == nodes.size() || g[i] < g[best])) best = i;
      }
      if (best == nodes.size()) return std::nullopt;
      if (best == 1) return g[1];
      done[best] = true;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double through = g[best] + length(nodes[best], nodes[i]);
        if (!done[i] && through < g[i] && allows(nodes[best], nodes[i])) g[i] = through;
      }
    }
  }

 private:
  static std::int64_t side(Half a, Half b, Half p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }
  static bool crosses_inside(Half a, Half b, std::int64_t x, std::int64_t y) {
    if (std::max(a.x, b.x) <= 2 * x || std::min(a.x, b.x) >= 2 * x + 2 ||
        std::max(a.y, b.y) <= 2 * y || std::min(a.y, b.y) >= 2 * y + 2) {
      return false;
    }
    if (a == b) return true;
    bool left = false, right = false;
    for (const Half corner : {Half{2 * x, 2 * y}, Half{2 * x + 2, 2 * y}, Half{2 * x, 2 * y + 2},
                              Half{2 * x + 2, 2 * y + 2}}) {
      left = left || side(a, b, corner) > 0;
      right = right || side(a, b, corner) < 0;
    }
    return left && right;
  }

  const OccupancyGrid& grid_;
};

}  // namespace tutavia::test
