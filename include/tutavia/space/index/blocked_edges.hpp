// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/grid/bitboard/bits.hpp"
#include "tutavia/grid/line_of_sight.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// BlockedEdges: the edges of the union of a grid's blocked cells.

namespace tutavia::detail {

/// Queries on the union of a grid's blocked cells, closed squares. A view: the grid must outlive
/// it.
class BlockedEdges {
 public:
  /// `origin`: lower left corner of cell (0, 0); `size`: side of a cell; coordinates of corners are
  /// exact multiples. `error_bound`: exceeds every rounding error of a coordinate [m].
  BlockedEdges(const OccupancyGrid& map, const Point& origin, double size, double error_bound)
      : map_(map), origin_(origin), size_(size), error_bound_(error_bound) {}

  /// Calls `visit(edge, cell index, side)` for every edge of the union that lies within `reach` of
  /// a segment or an arc along x and along y, and for some others. Rows are visited outwards from
  /// those of the piece; `visit` returns the reach for the remaining rows, at most `reach`.
  template <class P, class Visit>
  void for_each_near(const P& piece, double reach, Visit visit) const {
    const Box box = piece.box();
    for_each_in_strip(strip(piece), box.min.y(), box.max.y(), reach, visit);
  }
  /// The same for the edges in a box.
  template <class Visit>
  void for_each_in(const Box& box, Visit visit) const {
    for_each_in_strip(Strip{box}, box.min.y(), box.max.y(), 0, visit);
  }

  /// Calls `visit(corner)` for every convex corner of the union in `box`.
  template <class Visit>
  void for_each_corner(const Box& box, Visit visit) const;

  /// Whether a segment meets the interior of the union, or an edge that a blocked cell shares with
  /// the border of the map.
  bool meets_inside(const Segment& s) const;

 private:
  /// The x-range of a piece within a range of y; for a box it is constant.
  struct Strip {
    Box box;
    std::pair<double, double> range(double, double) const { return {box.min.x(), box.max.x()}; }
  };
  struct SlantedStrip {
    Segment s;
    std::pair<double, double> range(double low, double high) const {
      const double rise = s.b.y() - s.a.y();
      const Box box = s.box();
      if (rise == 0) return {box.min.x(), box.max.x()};
      const auto at = [&](double y) {
        const double t = std::clamp((y - s.a.y()) / rise, 0.0, 1.0);
        return s.a.x() + t * (s.b.x() - s.a.x());
      };
      const auto [x0, x1] = std::minmax({at(low), at(high)});
      return {x0, x1};
    }
  };
  static SlantedStrip strip(const Segment& s) { return {s}; }
  static Strip strip(const Arc& arc) { return {arc.box()}; }

  /// The columns near a segment, row by row.
  class NearColumns;

  Point corner(Cell cell) const {
    return {origin_.x() + size_ * cell.x, origin_.y() + size_ * cell.y};
  }
  bool blocked(Cell cell) const { return map_.contains(cell) && !map_.is_free(cell); }
  /// Bits of the blocked cells of a row, from column x >= -1 on; none outside the map.
  std::uint64_t blocked_from(int x, int y) const {
    if (y < 0 || y >= map_.height()) return 0;
    std::uint64_t bits = ~load_bits(map_.words().data(), map_.index({x, y}));
    if (x < 0) bits &= ~std::uint64_t{1};
    const int inside = map_.width() - x;
    return inside < 64 ? bits & ((std::uint64_t{1} << inside) - 1) : bits;
  }
  int column(double x) const { return cell_index(x, origin_.x(), map_.width()); }
  int row(double y) const { return cell_index(y, origin_.y(), map_.height()); }
  int cell_index(double x, double from, int count) const {
    return static_cast<int>(
        std::clamp(std::floor((x - from) / size_), -1.0, static_cast<double>(count)));
  }

  enum class Cells { all, boundary };
  /// Calls `visit(cell)` for the blocked cells of a row from column `first` to `last`: for all, or
  /// for those with an edge neighbour that is not blocked. Columns outside the map are skipped.
  template <Cells which, class Visit>
  void for_each_blocked(int y, int first, int last, Visit visit) const;
  template <class P, class Visit>
  void for_each_in_strip(const P& piece, double low, double high, double reach, Visit visit) const;
  bool meets_open_square(Cell cell, const Segment& s, const Box& box) const;
  /// Whether a segment with this box lies on a grid line (or is a point on one) that has, on both
  /// sides, blocked cells or the outside of the map, with at least one blocked cell.
  bool runs_inside(const Box& box) const;

  const OccupancyGrid& map_;
  Point origin_;
  double size_;
  double error_bound_;
};

template <BlockedEdges::Cells which, class Visit>
void BlockedEdges::for_each_blocked(int y, int first, int last, Visit visit) const {
  if (y < 0 || y >= map_.height()) return;
  first = std::max(first, 0);
  last = std::min(last, map_.width() - 1);
  const auto free_from = [&](int x, int row) {
    return load_bits(map_.words().data(), map_.index({x, row}));
  };
  const bool border_row = y == 0 || y == map_.height() - 1;
  for (int x = first; x <= last; x += static_cast<int>(loaded_bits)) {
    const int count = std::min(last - x + 1, static_cast<int>(loaded_bits));
    std::uint64_t blocked = ~free_from(x, y) & ((std::uint64_t{1} << count) - 1);
    if (blocked == 0) continue;
    if (which == Cells::boundary && !border_row) {
      std::uint64_t beside =
          free_from(x, y - 1) | free_from(x, y + 1) | free_from(x - 1, y) | free_from(x + 1, y);
      // The outside of the map is not blocked.
      if (x == 0) beside |= 1;
      if (x + count == map_.width()) beside |= std::uint64_t{1} << (count - 1);
      blocked &= beside;
    }
    for (; blocked != 0; blocked &= blocked - 1) visit(Cell{x + std::countr_zero(blocked), y});
  }
}

template <class P, class Visit>
void BlockedEdges::for_each_in_strip(const P& piece, double low, double high, double reach,
                                     Visit visit) const {
  const auto scan = [&](int y) {
    const double bottom = corner({0, y}).y(), margin = reach + 2 * error_bound_;
    const auto [x0, x1] = piece.range(bottom - margin, bottom + size_ + margin);
    for_each_blocked<
        Cells::boundary>(y, column(x0 - margin) - 1, column(x1 + margin) + 1, [&](Cell cell) {
      const auto index = static_cast<std::uint32_t>(map_.index(cell));
      for (std::uint32_t side = 0; side < 4; ++side) {
        if (blocked(cell + steps[std::size_t{2} * side])) continue;
        const auto corner_of = [&](std::uint32_t k) {  // counterclockwise from the lower right one
          return corner(cell + std::array<Cell, 4>{{{1, 0}, {1, 1}, {0, 1}, {0, 0}}}[k % 4]);
        };
        reach = std::min(reach, visit(Segment{corner_of(side), corner_of(side + 1)}, index, side));
      }
    });
  };
  // Rows beyond the reach hold no more edges.
  const auto beyond = [&](double gap) { return gap > reach + 2 * error_bound_; };
  const int first = std::max(row(low) - 1, 0), last = std::min(row(high) + 1, map_.height() - 1);
  for (int y = first; y <= last; ++y) scan(y);
  for (int y = first - 1; y >= 0 && !beyond(low - corner({0, y + 1}).y()); --y) scan(y);
  for (int y = last + 1; y < map_.height() && !beyond(corner({0, y}).y() - high); ++y) scan(y);
}

/// Whether the open square of a cell meets a segment, by separating axes.
inline bool BlockedEdges::meets_open_square(Cell cell, const Segment& s, const Box& box) const {
  const Point low = corner(cell), high = corner(cell + Cell{1, 1});
  if (!(box.max.x() > low.x() && box.min.x() < high.x() && box.max.y() > low.y() &&
        box.min.y() < high.y())) {
    return false;
  }
  if (s.a == s.b) return true;
  bool left = false, right = false;
  for (const Point& p : {low, high, Point(low.x(), high.y()), Point(high.x(), low.y())}) {
    const int side = orientation(s.a, s.b, p);
    left = left || side > 0;
    right = right || side < 0;
  }
  return left && right;
}

class BlockedEdges::NearColumns {
 public:
  /// `low`, `high`: the corners of the segment's box in cells.
  NearColumns(const Segment& s, const Point& low, const Point& high, double size, double margin)
      : left_(low.x()), right_(high.x()), bottom_(low.y()), margin_(margin) {
    const double rise = std::abs(s.b.y() - s.a.y()) / size;
    const bool rising = (s.b.x() >= s.a.x()) == (s.b.y() >= s.a.y());
    flat_ = !(rise > margin);
    slope_ = (rising ? 1 : -1) * (right_ - left_) / rise;
    start_ = rising ? left_ : right_;
  }

  /// The first and the last column near the segment in row y of a map with `columns` columns; none
  /// if the first is greater.
  std::pair<int, int> in_row(int y, int columns) const {
    const double in = flat_ ? left_ : at(y - margin_);
    const double out = flat_ ? right_ : at(y + 1 + margin_);
    return {first_of(std::fmin(in, out) - margin_), last_of(std::fmax(in, out) + margin_, columns)};
  }

  static int first_of(double x) { return static_cast<int>(std::clamp(x, 0.0, 0x1p30)); }
  static int last_of(double x, int count) {
    return static_cast<int>(std::floor(std::clamp(x, -1.0, count - 1.0)));
  }

 private:
  /// The column where the segment crosses a level of y.
  double at(double y) const { return std::clamp(start_ + (y - bottom_) * slope_, left_, right_); }

  double left_, right_, bottom_, margin_;
  bool flat_;
  double slope_, start_;
};

inline bool BlockedEdges::meets_inside(const Segment& s) const {
  const Box box = s.box();
  const Point low = (box.min - origin_) / size_, high = (box.max - origin_) / size_;
  const double margin = 4 * error_bound_ / size_;
  const NearColumns near(s, low, high, size_, margin);
  // Most rows have no blocked cell near the segment.
  const int last_row = NearColumns::last_of(high.y() + margin, map_.height());
  for (int y = NearColumns::first_of(low.y() - margin); y <= last_row; ++y) {
    const auto [first, last] = near.in_row(y, map_.width());
    if (first > last) continue;
    if (run_is_free(map_.words().data(), map_.index({first, y}),
                    static_cast<std::uint32_t>(last - first + 1))) {
      continue;
    }
    bool meets = false;
    for_each_blocked<Cells::all>(
        y, first, last, [&](Cell cell) { meets = meets || meets_open_square(cell, s, box); });
    if (meets) return true;
  }
  return runs_inside(box);
}

inline bool BlockedEdges::runs_inside(const Box& box) const {
  const int x0 = column(box.min.x()), x1 = column(box.max.x());
  const int y0 = row(box.min.y()), y1 = row(box.max.y());
  // Every side is blocked or outside the map, and at least one is blocked.
  const auto between = [&](std::initializer_list<Cell> sides) {
    bool any_blocked = false, all_solid = true;
    for (const Cell cell : sides) {
      any_blocked = any_blocked || blocked(cell);
      all_solid = all_solid && (blocked(cell) || !map_.contains(cell));
    }
    return any_blocked && all_solid;
  };
  const bool on_row = corner({0, y0}).y() == box.max.y() && box.min.y() == box.max.y();
  const bool on_column = corner({x0, 0}).x() == box.max.x() && box.min.x() == box.max.x();
  if (on_row && on_column) {
    return between({{x0, y0}, {x0 - 1, y0}, {x0, y0 - 1}, {x0 - 1, y0 - 1}});
  }
  for (int x = x0 - 1; on_row && x <= x1; ++x) {
    const bool over = corner({x, 0}).x() < box.max.x() && corner({x + 1, 0}).x() > box.min.x();
    if (over && between({{x, y0}, {x, y0 - 1}})) return true;
  }
  for (int y = y0 - 1; on_column && y <= y1; ++y) {
    const bool over = corner({0, y}).y() < box.max.y() && corner({0, y + 1}).y() > box.min.y();
    if (over && between({{x0, y}, {x0 - 1, y}})) return true;
  }
  return false;
}

template <class Visit>
void BlockedEdges::for_each_corner(const Box& box, Visit visit) const {
  const double margin = 2 * error_bound_;
  const int first = std::max(column(box.min.x() - margin), 0);
  const int last = std::min(column(box.max.x() + margin) + 1, map_.width());
  constexpr int step = static_cast<int>(loaded_bits) - 1;
  const int bottom = std::max(row(box.min.y() - margin), 0);
  const int top = std::min(row(box.max.y() + margin) + 1, map_.height());
  for (int x = first; x <= last; x += step) {
    const int count = std::min(last - x + 1, step);
    const std::uint64_t looked_at = (std::uint64_t{2} << count) - 1;  // columns x - 1 to last
    std::uint64_t below = blocked_from(x - 1, bottom - 1) & looked_at;
    for (int y = bottom; y <= top; ++y) {
      const std::uint64_t above = blocked_from(x - 1, y) & looked_at;
      // Bit i: the cells to the left (w) and right (e) of corner (x + i, y), above and below it.
      const std::uint64_t nw = above, ne = above >> 1, sw = std::exchange(below, above),
                          se = sw >> 1;
      if ((nw | sw) == 0) continue;
      const std::uint64_t one = (ne ^ nw ^ sw ^ se) & ~((ne & nw) | (sw & se));
      const std::uint64_t opposite = ~(ne ^ sw) & ~(nw ^ se) & (ne ^ nw);
      std::uint64_t corners = (one | opposite) & (looked_at >> 1);
      for (; corners != 0; corners &= corners - 1) {
        const Cell at{x + std::countr_zero(corners), y};
        const Point position = corner(at);
        if (!box.contains(position)) continue;
        visit(
            Corner{position, 0, std::numbers::pi / 2, static_cast<std::uint32_t>(map_.index(at))});
      }
    }
  }
}

}  // namespace tutavia::detail
