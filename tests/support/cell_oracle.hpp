// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/core/random.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// Expected results of CellSpace, by brute force in integers: quarters of a cell.

namespace tutavia::test {

using Rational = boost::multiprecision::cpp_rational;

inline bool is_blocked(const OccupancyGrid& grid, int x, int y) {
  return grid.contains({x, y}) && !grid.is_free(Cell{x, y});
}

/// A point of the grid in quarters of a cell, counted from the grid's lower left corner.
struct Place {
  std::int64_t x, y;
};
/// A rectangle in the same units; an edge if its width or height is 0.
struct Rectangle {
  std::int64_t x0, y0, x1, y1;
  friend bool operator==(const Rectangle&, const Rectangle&) = default;
};
/// n / d, not negative.
struct Fraction {
  std::int64_t n, d;
  double value() const { return static_cast<double>(n) / static_cast<double>(d); }
  friend bool operator<(Fraction a, Fraction b) { return a.n * b.d < b.n * a.d; }
};

inline std::int64_t turn(Place a, Place b, Place c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether the closed segment a-b meets a rectangle, or its interior (`inside`), by separating
/// axes.
inline bool meets(const Rectangle& r, Place a, Place b, bool inside) {
  const auto apart = [&](std::int64_t p, std::int64_t q, std::int64_t low, std::int64_t high) {
    return inside ? std::max(p, q) <= low || std::min(p, q) >= high
                  : std::max(p, q) < low || std::min(p, q) > high;
  };
  if (apart(a.x, b.x, r.x0, r.x1) || apart(a.y, b.y, r.y0, r.y1)) return false;
  if (a.x == b.x && a.y == b.y) return true;
  const std::int64_t turns[] = {turn(a, b, {r.x0, r.y0}), turn(a, b, {r.x1, r.y0}),
                                turn(a, b, {r.x0, r.y1}), turn(a, b, {r.x1, r.y1})};
  const auto [least, most] = std::minmax_element(std::begin(turns), std::end(turns));
  return inside ? *least < 0 && *most > 0 : *least <= 0 && *most >= 0;
}

/// The squared distance between a point and a closed segment.
inline Fraction to_segment(Place p, Place a, Place b) {
  const std::int64_t ux = b.x - a.x, uy = b.y - a.y, vx = p.x - a.x, vy = p.y - a.y;
  const std::int64_t along = ux * vx + uy * vy, square = ux * ux + uy * uy;
  if (along <= 0) return {vx * vx + vy * vy, 1};
  if (along >= square) {
    return {(p.x - b.x) * (p.x - b.x) + (p.y - b.y) * (p.y - b.y), 1};
  }
  const std::int64_t area = ux * vy - uy * vx;
  return {area * area, square};
}

/// The squared distance between a closed segment and a closed rectangle.
inline Fraction to_rectangle(const Rectangle& r, Place a, Place b) {
  if (meets(r, a, b, false)) return {0, 1};
  const auto from_end = [&](Place p) {
    const std::int64_t dx = std::max({r.x0 - p.x, p.x - r.x1, std::int64_t{0}});
    const std::int64_t dy = std::max({r.y0 - p.y, p.y - r.y1, std::int64_t{0}});
    return Fraction{dx * dx + dy * dy, 1};
  };
  return std::min({from_end(a), from_end(b), to_segment({r.x0, r.y0}, a, b),
                   to_segment({r.x1, r.y0}, a, b), to_segment({r.x0, r.y1}, a, b),
                   to_segment({r.x1, r.y1}, a, b)});
}

/// An edge of a blocked cell that no other blocked cell shares, with its numbers.
struct CellEdge {
  Rectangle line;
  std::uint32_t cell;
  std::uint32_t side;
};

/// The blocked cells of a map as rectangles, in integers.
class Squares {
 public:
  explicit Squares(const OccupancyGrid& map) : width_(4 * map.width()), height_(4 * map.height()) {
    const auto solid = [&](int x, int y) { return !map.contains({x, y}) || !map.is_free({x, y}); };
    for (int y = -1; y < map.height(); ++y) {
      for (int x = -1; x < map.width(); ++x) {
        if (!solid(x, y)) continue;
        const auto add = [&](int columns, int rows) {
          const Cell far{x + columns - 1, y + rows - 1};
          if (is_blocked(map, x, y) || is_blocked(map, far.x, y) || is_blocked(map, x, far.y) ||
              is_blocked(map, far.x, far.y)) {
            insides.push_back({4 * x, 4 * y, 4 * (far.x + 1), 4 * (far.y + 1)});
          }
        };
        const bool right = solid(x + 1, y), above = solid(x, y + 1);
        add(1, 1);
        if (right) add(2, 1);
        if (above) add(1, 2);
        if (right && above && solid(x + 1, y + 1)) add(2, 2);
        if (!is_blocked(map, x, y)) continue;
        cells.push_back({4 * x, 4 * y, 4 * x + 4, 4 * y + 4});
        const auto edge = [&](int dx, int dy, const Rectangle& line) {
          if (is_blocked(map, x + dx, y + dy)) return;
          const std::uint32_t side = dx == 1 ? 0 : dy == 1 ? 1 : dx == -1 ? 2 : 3;
          edges.push_back({line, static_cast<std::uint32_t>(map.index({x, y})), side});
        };
        edge(1, 0, {4 * x + 4, 4 * y, 4 * x + 4, 4 * y + 4});
        edge(0, 1, {4 * x, 4 * y + 4, 4 * x + 4, 4 * y + 4});
        edge(-1, 0, {4 * x, 4 * y, 4 * x, 4 * y + 4});
        edge(0, -1, {4 * x, 4 * y, 4 * x + 4, 4 * y});
      }
    }
  }

  std::vector<Rectangle> cells;
  /// Rectangles whose open interiors together are the interior of the blocked region, with the
  /// outside of the grid counted as blocked: cells, pairs that share an edge, and groups of four
  /// that share a corner.
  std::vector<Rectangle> insides;
  std::vector<CellEdge> edges;

  bool contains(Place p) const {
    return std::any_of(cells.begin(), cells.end(),
                       [&](const Rectangle& r) { return meets(r, p, p, false); });
  }
  bool inside_meets(Place a, Place b) const {
    return std::any_of(insides.begin(), insides.end(),
                       [&](const Rectangle& r) { return meets(r, a, b, true); });
  }
  /// From the segment to the nearest blocked cell; huge if there is none.
  Fraction squared_clearance(Place a, Place b) const {
    Fraction least{std::int64_t{1} << 40, 1};
    for (const Rectangle& r : cells) least = std::min(least, to_rectangle(r, a, b));
    return least;
  }
  Fraction squared_distance_to_edges(Place a, Place b) const {
    Fraction least{std::int64_t{1} << 40, 1};
    for (const CellEdge& e : edges) least = std::min(least, to_rectangle(e.line, a, b));
    return least;
  }
  /// Free space by its definition.
  bool is_free(Place a, Place b, const Rational& squared_radius) const {
    if (squared_radius == 0) return !inside_meets(a, b);
    const Fraction clearance = squared_clearance(a, b);
    return Rational(clearance.n) >= squared_radius * clearance.d;
  }

  /// A point on grid lines, on centres, or on any quarters.
  Place random_place(Random& random) const {
    const auto coordinate = [&](std::int64_t size) {
      const auto any =
          static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(size) + 1));
      const std::uint64_t kind = random.below(4);
      return kind == 0 ? any / 4 * 4 : kind == 1 ? std::min(any / 4 * 4 + 2, size) : any;
    };
    const std::int64_t x = coordinate(width_);
    return {x, coordinate(height_)};
  }
  /// A single point, or a segment that is axis-parallel, at 45 degrees, or of any slope.
  std::pair<Place, Place> random_segment(Random& random) const {
    const Place a = random_place(random);
    Place b = random_place(random);
    switch (random.below(6)) {
      case 0:
        return {a, a};
      case 1:
        return {a, {b.x, a.y}};
      case 2:
        return {a, {a.x, b.y}};
      case 3: {
        const std::int64_t length = std::min({b.x, b.y, width_ - a.x, height_ - a.y});
        b = {a.x + length, a.y + length};
        return {a, b};
      }
      default:
        return {a, b};
    }
  }

 private:
  std::int64_t width_;
  std::int64_t height_;
};

/// The exact point of a place.
inline Point point_at(const CellSpace& space, Place place) {
  const double unit = space.frame().resolution / 4;
  const Point corner = space.bounds().min;
  return {corner.x() + unit * static_cast<double>(place.x),
          corner.y() + unit * static_cast<double>(place.y)};
}

/// The square of the safety radius in quarters of a cell.
inline Rational squared_radius(const CellSpace& space) {
  const Rational ratio = Rational(space.safety_radius()) * 4 / Rational(space.frame().resolution);
  return ratio * ratio;
}

/// The place of a point on quarters.
inline std::pair<std::int64_t, std::int64_t> place_of(const CellSpace& space, const Point& p) {
  const double unit = space.frame().resolution / 4;
  const Point corner = space.bounds().min;
  return {std::llround((p.x() - corner.x()) / unit), std::llround((p.y() - corner.y()) / unit)};
}

}  // namespace tutavia::test
