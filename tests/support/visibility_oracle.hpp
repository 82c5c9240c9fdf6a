// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/segment.hpp"

/// \file
/// VisibilityOracle: shortest paths of a point among convex pieces and walls, in whole numbers.

namespace tutavia::test {

/// The classic visibility graph of a point robot, written independently of the library: every pair
/// of vertices is tested against every obstacle in exact arithmetic, and Dijkstra's algorithm runs
/// over all free pairs. Coordinates are multiples of 1/8 below 2^16.
///
/// Convex pieces block their interiors only. Walls block all their points: paths go around their
/// ends at 2^-40. An obstacle that is not convex is given as convex pieces that overlap, so that no
/// point of its interior lies on the boundaries of all.
class VisibilityOracle {
 public:
  /// Paths stay within the bounds.
  explicit VisibilityOracle(const Box& bounds)
      : low_(exact(bounds.min)), high_(exact(bounds.max)) {}

  /// A convex ring, counterclockwise.
  void add_piece(const std::vector<Point>& ring) {
    std::vector<Vertex> piece;
    for (const Point& p : ring) {
      piece.push_back(exact(p));
      add_node(piece.back());
    }
    pieces_.push_back(std::move(piece));
  }
  void add_wall(const Segment& wall) {
    const Vertex a = exact(wall.a), b = exact(wall.b);
    for (const Vertex& end : {a, b}) {
      for (const int x : {-1, 0, 1}) {
        for (const int y : {-1, 0, 1}) {
          if (x != 0 || y != 0) add_node({end.x + x, end.y + y});
        }
      }
    }
    walls_.emplace_back(a, b);
  }

  bool is_free(const Point& p) const { return is_free(exact(p), exact(p)); }

  /// Infinity if there is no path.
  double shortest_length(const Point& start, const Point& goal) const {
    constexpr double unreached = std::numeric_limits<double>::infinity();
    std::vector<Vertex> nodes = nodes_;
    nodes.push_back(exact(start));
    nodes.push_back(exact(goal));
    std::vector<double> cost(nodes.size(), unreached);
    std::vector<bool> is_closed(nodes.size(), false);
    cost[nodes.size() - 2] = 0;
    while (true) {
      std::size_t best = nodes.size();
      double least = unreached;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (is_closed[i] || !(cost[i] < least)) continue;
        best = i;
        least = cost[i];
      }
      if (best == nodes.size() || best == nodes.size() - 1) return least;
      is_closed[best] = true;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double next = least + distance(nodes[best], nodes[i]);
        if (!is_closed[i] && next < cost[i] && is_free(nodes[best], nodes[i])) cost[i] = next;
      }
    }
  }

 private:
  using Whole = boost::multiprecision::int128_t;
  static constexpr double unit = 0x1p-40;

  struct Vertex {
    std::int64_t x, y;
  };

  void add_node(const Vertex& v) {
    if (low_.x <= v.x && v.x <= high_.x && low_.y <= v.y && v.y <= high_.y) nodes_.push_back(v);
  }

  static Vertex exact(const Point& p) {
    return {static_cast<std::int64_t>(p.x() / unit), static_cast<std::int64_t>(p.y() / unit)};
  }
  static double distance(const Vertex& a, const Vertex& b) {
    return unit * std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
  }
  /// Positive where c lies to the left of the way from a to b.
  static int side(const Vertex& a, const Vertex& b, const Vertex& c) {
    const Whole left = Whole(b.x - a.x) * Whole(c.y - a.y);
    const Whole right = Whole(b.y - a.y) * Whole(c.x - a.x);
    return left > right ? 1 : left < right ? -1 : 0;
  }

  static bool is_between(const Vertex& a, const Vertex& b, const Vertex& c) {
    return side(a, b, c) == 0 && std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= c.y && c.y <= std::max(a.y, b.y);
  }
  static bool meet(const Vertex& p, const Vertex& q, const Vertex& a, const Vertex& b) {
    return (side(p, q, a) * side(p, q, b) < 0 && side(a, b, p) * side(a, b, q) < 0) ||
           is_between(p, q, a) || is_between(p, q, b) || is_between(a, b, p) || is_between(a, b, q);
  }
  /// By separating axes: an edge of the piece, or the segment itself.
  static bool meets_inside(const std::vector<Vertex>& piece, const Vertex& p, const Vertex& q) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Vertex &a = piece[i], &b = piece[(i + 1) % piece.size()];
      if (side(a, b, p) <= 0 && side(a, b, q) <= 0) return false;
      left = left || side(p, q, a) > 0;
      right = right || side(p, q, a) < 0;
    }
    const bool is_point = p.x == q.x && p.y == q.y;
    return is_point || (left && right);
  }

  bool is_free(const Vertex& p, const Vertex& q) const {
    for (const auto& [a, b] : walls_) {
      if (meet(p, q, a, b)) return false;
    }
    for (const std::vector<Vertex>& piece : pieces_) {
      if (meets_inside(piece, p, q)) return false;
    }
    return true;
  }

  Vertex low_, high_;
  std::vector<std::vector<Vertex>> pieces_;
  std::vector<std::pair<Vertex, Vertex>> walls_;
  std::vector<Vertex> nodes_;
};

}  // namespace tutavia::test
