// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "tutavia/geometry/numeric/exact_number.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/grid/dilate.hpp"
#include "tutavia/grid/line_of_sight.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/index/grid_layer.hpp"
#include "tutavia/space/index/nearest_feature.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// CellSpace: the free space among the blocked cells of a grid.

namespace tutavia {

/// Where the cells lie, and how far to keep from the blocked ones.
struct CellOptions {
  double resolution = 1;         ///< side of a cell [m]
  Point origin = Point::Zero();  ///< lower left corner of cell (0, 0) [m]
  double safety_radius = 0;      ///< distance to keep from blocked cells [m]
  MovementRule movement = MovementRule::no_cut;
};

/// The points of a grid's rectangle at `safety_radius` or more from every blocked cell, a cell
/// being a closed square; and the grid of those cells whose centres a robot may pass.
///
/// At radius 0 the robot is a point, which may touch blocked cells and slide along them, but not
/// pass where two of them share an edge, nor along the border of the map where a blocked cell is.
/// Every step between free cells lies in free space: under `no_cut` and `four_connected` the
/// centres' clearances are enough for that, under the other rules a positive radius asks for
/// sqrt(r^2 + resolution^2 / 2) at the centres.
///
/// Origin and resolution are rounded (the latter up) to a binary fraction such that the coordinates
/// of all corners and centres are exact: the origin moves by less than 2^-50 of the largest
/// coordinate, and a cell grows by less than 2^-49 of it.
/// Questions are decided exactly: a corridor just as wide as the robot is free. Immutable: one
/// object serves any number of threads.
class CellSpace {
 public:
  /// `invalid_option` for a resolution that is not positive, an origin that is not finite or too
  /// far away for exact coordinates, or a negative radius.
  static Expected<CellSpace, Failure> build(OccupancyGrid cells, const CellOptions& options = {});

  /// The cells that a path may step on.
  const OccupancyGrid& grid() const { return layer_.grid(); }
  /// The cells that are not blocked themselves.
  const OccupancyGrid& cells() const { return cells_ ? *cells_ : layer_.grid(); }
  /// The lower left corner of a cell, exactly; of cells as far beyond the map as it is large, too.
  Point corner(Cell cell) const {
    return {corner_.x() + layer_.frame().resolution * cell.x,
            corner_.y() + layer_.frame().resolution * cell.y};
  }
  const Frame& frame() const { return layer_.frame(); }
  MovementRule movement() const { return layer_.movement(); }
  const detail::StopPlanes& stop_planes() const { return layer_.stop_planes(); }
  const OccupancyGrid& columns() const { return layer_.columns(); }
  const OccupancyGrid& corners() const { return layer_.corners(); }
  Links links(const Point& p) const {
    if (!bounds_.contains(p)) return {};
    return layer_.links(p, 0,
                        [this](const Point& a, const Point& b) { return segment_free(a, b); });
  }

  /// Whether the segment between the reference points of two cells is free. At safety radius 0 it
  /// keeps to cells that a path may step on and, like steps under `no_cut`, touches no other;
  /// otherwise it is free as any segment.
  bool sees(Cell a, Cell b) const {
    if (safety_radius_ == 0) return line_of_sight(grid().view(), layer_.columns().view(), a, b);
    return segment_free(frame().point(a), frame().point(b));
  }

  const Box& bounds() const { return bounds_; }
  double safety_radius() const { return safety_radius_; }
  double magnitude() const { return magnitude_; }
  double slack() const { return rounding_slack(magnitude_); }

  bool is_free(const Point& p) const { return segment_free(p, p); }
  bool segment_free(const Point& p, const Point& q) const;
  /// Signed distance from `p` to the nearest blocked cell [m], negative inside; infinity where no
  /// cell is blocked.
  double clearance(const Point& p) const;
  /// See ClearanceSpace. Proximity::obstacle is the index of the blocked cell in `cells()`, its
  /// edges count from the right one counterclockwise.
  template <class P>
  Proximity nearest(const P& piece, double cap) const;
  /// Whether `p` lies inside the union of the blocked cells, or on the map's border where a blocked
  /// cell is.
  bool is_inside(const Point& p) const { return meets_inside({p, p}); }

  /// Calls `visit(edge, 0.0)` for every edge of the blocked cells' union in `box`.
  template <class Visit>
  void for_each_feature(const Box& box, Visit visit) const {
    for_each_edge_near(Strip{box}, box.min.y(), box.max.y(), 0,
                       [&](const Segment& edge, std::uint32_t, std::uint32_t) {
                         visit(edge, 0.0);
                         return 0.0;
                       });
  }
  /// Calls `visit(corner)` for every convex corner of the blocked cells in `box`.
  template <class Visit>
  void for_each_corner(const Box& box, Visit visit) const;

 private:
  /// The x-range of a piece within a range of y; a box has the same everywhere.
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

  CellSpace(OccupancyGrid grid, std::shared_ptr<const OccupancyGrid> cells, const Point& origin,
            const Frame& frame, const CellOptions& options)
      : layer_(std::move(grid), frame, options.movement),
        cells_(std::move(cells)),
        corner_(origin),
        bounds_{origin, corner({layer_.grid().width(), layer_.grid().height()})},
        safety_radius_(options.safety_radius),
        magnitude_(std::fmax(bounds_.magnitude(), safety_radius_)) {}

  bool blocked(Cell cell) const { return cells().contains(cell) && !cells().is_free(cell); }
  int column(double x) const { return place(x, corner_.x(), cells().width()); }
  int row(double y) const { return place(y, corner_.y(), cells().height()); }
  int place(double x, double from, int count) const {
    return static_cast<int>(
        std::clamp(std::floor((x - from) / frame().resolution), -1.0, static_cast<double>(count)));
  }

  /// Calls `visit(cell)` for the blocked cells of a row from column `first` to `last`, as far as
  /// they exist; with `Boundary` only for those beside a cell that is not blocked.
  template <bool Boundary, class Visit>
  void for_each_blocked(int y, int first, int last, Visit visit) const;
  /// Calls `visit(edge, cell index, side)` for every edge of the blocked cells' union that comes
  /// within `reach` of the piece along x and along y, and for some others. It goes outwards from
  /// the piece's own rows, y from `low` to `high`; `visit` returns how far it still makes sense to
  /// look, at most `reach`.
  template <class P, class Visit>
  void for_each_edge_near(const P& piece, double low, double high, double reach, Visit visit) const;
  bool meets_inside(const Segment& s) const;
  /// Whether what has this box runs along a line of the grid (or is a point on one) with blocked
  /// cells, or what lies beyond the map, on both sides.
  bool runs_inside(const Box& box) const;

  detail::GridLayer layer_;
  std::shared_ptr<const OccupancyGrid> cells_;  // where the grid is not these; shared by copies
  Point corner_;
  Box bounds_;
  double safety_radius_;
  double magnitude_;
};

inline Expected<CellSpace, Failure> CellSpace::build(OccupancyGrid cells,
                                                     const CellOptions& options) {
  const double size = options.resolution, r = options.safety_radius;
  if (!(size > 0) || !std::isfinite(size)) {
    return fail(PlanError::invalid_option, "resolution must be positive and finite");
  }
  if (!(r >= 0) || !std::isfinite(r)) {
    return fail(PlanError::invalid_option, "safety_radius must be finite and not negative");
  }
  if (!is_finite(options.origin)) {
    return fail(PlanError::invalid_option, "origin must be finite");
  }
  const Point far{options.origin.x() + size * (cells.width() + 1),
                  options.origin.y() + size * (cells.height() + 1)};
  const double magnitude = std::fmax(max_magnitude(options.origin), max_magnitude(far));
  if (!(magnitude < 0x1p300) || !(size > 0x1p-300)) {
    return fail(PlanError::invalid_option, "origin and resolution must lie below 2^300 m");
  }
  // Coordinates become multiples of the quantum, fewer than 2^52 of them.
  const double quantum = std::ldexp(1.0, std::ilogb(magnitude) - 50);
  if (!(size > 0x1p20 * quantum)) {
    return fail(PlanError::invalid_option,
                "origin and resolution must leave room for exact coordinates: the largest is " +
                    std::to_string(magnitude) + " m");
  }
  const auto snap = [&](double x) { return std::nearbyint(x / quantum) * quantum; };
  const Point origin{snap(options.origin.x()), snap(options.origin.y())};
  // Rounded up, so that a corridor of so many cells is never narrower than it was meant to be.
  const double side = std::ceil(size / (2 * quantum)) * 2 * quantum;
  const Frame frame{{origin.x() + side / 2, origin.y() + side / 2}, side};
  if (r == 0) return CellSpace(std::move(cells), nullptr, origin, frame, options);

  // Squared distances between centres and squares are integers in units of half a cell.
  const auto squared = [](const detail::ExactNumber& x) { return x * x; };
  const detail::ExactNumber unit = squared(detail::ExactNumber(side / 2)),
                            limit = squared(detail::ExactNumber(r));
  const double ratio = 2 * r / side;
  if (!(ratio < 0x1p25)) {
    return fail(PlanError::invalid_option, "safety_radius is more than 2^24 cells");
  }
  auto least = static_cast<std::int64_t>(ratio * ratio);
  const auto keeps = [&](std::int64_t n) {
    return (detail::ExactNumber(static_cast<double>(n)) * unit - limit).sign() >= 0;
  };
  while (least > 0 && keeps(least - 1)) --least;
  while (!keeps(least)) ++least;
  const bool cuts_corners =
      options.movement == MovementRule::no_squeeze || options.movement == MovementRule::allow;
  OccupancyGrid grid = dilated(cells, least + (cuts_corners ? 2 : 0));
  return CellSpace(std::move(grid), std::make_shared<const OccupancyGrid>(std::move(cells)), origin,
                   frame, options);
}

template <bool Boundary, class Visit>
void CellSpace::for_each_blocked(int y, int first, int last, Visit visit) const {
  const OccupancyGrid& map = cells();
  if (y < 0 || y >= map.height()) return;
  first = std::max(first, 0);
  last = std::min(last, map.width() - 1);
  const auto free_from = [&](int x, int row) {
    return detail::load_bits(map.words().data(), map.index({x, row}));
  };
  const bool border_row = y == 0 || y == map.height() - 1;
  for (int x = first; x <= last; x += static_cast<int>(detail::loaded_bits)) {
    const int count = std::min(last - x + 1, static_cast<int>(detail::loaded_bits));
    std::uint64_t blocked = ~free_from(x, y) & ((std::uint64_t{1} << count) - 1);
    if (blocked == 0) continue;
    if (Boundary && !border_row) {
      std::uint64_t beside =
          free_from(x, y - 1) | free_from(x, y + 1) | free_from(x - 1, y) | free_from(x + 1, y);
      // What lies beyond the map is not blocked.
      if (x == 0) beside |= 1;
      if (x + count == map.width()) beside |= std::uint64_t{1} << (count - 1);
      blocked &= beside;
    }
    for (; blocked != 0; blocked &= blocked - 1) visit(Cell{x + std::countr_zero(blocked), y});
  }
}

template <class P, class Visit>
void CellSpace::for_each_edge_near(const P& piece, double low, double high, double reach,
                                   Visit visit) const {
  const OccupancyGrid& map = cells();
  const double size = frame().resolution;
  const auto scan = [&](int y) {
    const double bottom = corner({0, y}).y(), margin = reach + 2 * slack();
    const auto [x0, x1] = piece.range(bottom - margin, bottom + size + margin);
    for_each_blocked<true>(y, column(x0 - margin) - 1, column(x1 + margin) + 1, [&](Cell cell) {
      const auto index = static_cast<std::uint32_t>(map.index(cell));
      for (std::uint32_t side = 0; side < 4; ++side) {
        if (blocked(cell + steps[std::size_t{2} * side])) continue;
        const auto corner_of = [&](std::uint32_t k) {  // counterclockwise from the lower right one
          return corner(cell + std::array<Cell, 4>{{{1, 0}, {1, 1}, {0, 1}, {0, 0}}}[k % 4]);
        };
        reach = std::min(reach, visit(Segment{corner_of(side), corner_of(side + 1)}, index, side));
      }
    });
  };
  // A row farther up or down than the reach has nothing left to give.
  const auto beyond = [&](double gap) { return gap > reach + 2 * slack(); };
  const int first = std::max(row(low) - 1, 0), last = std::min(row(high) + 1, map.height() - 1);
  for (int y = first; y <= last; ++y) scan(y);
  for (int y = first - 1; y >= 0 && !beyond(low - corner({0, y + 1}).y()); --y) scan(y);
  for (int y = last + 1; y < map.height() && !beyond(corner({0, y}).y() - high); ++y) scan(y);
}

template <class P>
Proximity CellSpace::nearest(const P& piece, double cap) const {
  const Box box = piece.box();
  return detail::nearest_feature(
      piece, cap, safety_radius_ + 2 * frame().resolution, bounds_, [&](double reach, auto visit) {
        for_each_edge_near(strip(piece), box.min.y(), box.max.y(), reach,
                           [&](const Segment& edge, std::uint32_t cell, std::uint32_t side) {
                             return visit(edge, 0.0, cell, side);
                           });
      });
}

inline bool CellSpace::meets_inside(const Segment& s) const {
  const Box box = s.box();
  // The open square of a cell against the segment, by separating lines.
  const auto meets_open = [&](Cell cell) {
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
  };
  // Row by row, in cells: most have no blocked one anywhere near the segment.
  const OccupancyGrid& map = cells();
  const double size = frame().resolution, margin = 4 * slack() / size;
  const Point low = (box.min - corner_) / size, high = (box.max - corner_) / size;
  const double rise = std::abs(s.b.y() - s.a.y()) / size;
  const bool rising = (s.b.x() >= s.a.x()) == (s.b.y() >= s.a.y());
  const bool flat = !(rise > margin);
  const double slope = (rising ? 1 : -1) * (high.x() - low.x()) / rise,
               from = rising ? low.x() : high.x();
  const auto at = [&](double y) {  // where it crosses a level
    return std::clamp(from + (y - low.y()) * slope, low.x(), high.x());
  };
  const auto first_of = [](double x) { return static_cast<int>(std::clamp(x, 0.0, 0x1p30)); };
  const auto last_of = [](double x, int count) {
    return static_cast<int>(std::floor(std::clamp(x, -1.0, count - 1.0)));
  };
  const int last_row = last_of(high.y() + margin, map.height());
  for (int y = first_of(low.y() - margin); y <= last_row; ++y) {
    const double in = flat ? low.x() : at(y - margin), out = flat ? high.x() : at(y + 1 + margin);
    const int first = first_of(std::fmin(in, out) - margin);
    const int last = last_of(std::fmax(in, out) + margin, map.width());
    if (first > last) continue;
    if (detail::run_is_free(map.words().data(), map.index({first, y}),
                            static_cast<std::uint32_t>(last - first + 1))) {
      continue;
    }
    bool meets = false;
    for_each_blocked<false>(y, first, last, [&](Cell cell) { meets = meets || meets_open(cell); });
    if (meets) return true;
  }
  return runs_inside(box);
}

inline bool CellSpace::runs_inside(const Box& box) const {
  const int x0 = column(box.min.x()), x1 = column(box.max.x());
  const int y0 = row(box.min.y()), y1 = row(box.max.y());
  // Blocked on both sides; what lies beyond the map counts as blocked, but not by itself.
  const auto between = [&](std::initializer_list<Cell> sides) {
    bool any_blocked = false, all_solid = true;
    for (const Cell cell : sides) {
      any_blocked = any_blocked || blocked(cell);
      all_solid = all_solid && (blocked(cell) || !cells().contains(cell));
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

inline bool CellSpace::segment_free(const Point& p, const Point& q) const {
  if (!bounds_.contains(p) || !bounds_.contains(q)) return false;
  const Segment segment{p, q};
  if (safety_radius_ == 0) return !meets_inside(segment);
  const double reach = safety_radius_ + slack();
  const double distance = nearest(segment, reach).distance;
  if (distance < safety_radius_ - slack()) return false;
  bool free = true;
  if (distance < reach) {  // a tie: to be settled exactly
    const Box box = segment.box();
    for_each_edge_near(strip(segment), box.min.y(), box.max.y(), reach,
                       [&](const Segment& edge, std::uint32_t, std::uint32_t) {
                         free = free && keeps_distance(segment, edge, 0, safety_radius_, slack());
                         return reach;
                       });
  }
  return free && !is_inside(p);
}

inline double CellSpace::clearance(const Point& p) const {
  const double distance = nearest(Segment{p, p}, std::numeric_limits<double>::infinity()).distance;
  return is_inside(p) ? -distance : distance;
}

template <class Visit>
void CellSpace::for_each_corner(const Box& box, Visit visit) const {
  const double margin = 2 * slack();
  for (int y = row(box.min.y() - margin); y <= row(box.max.y() + margin) + 1; ++y) {
    for (int x = column(box.min.x() - margin); x <= column(box.max.x() + margin) + 1; ++x) {
      const bool ne = blocked({x, y}), nw = blocked({x - 1, y}), sw = blocked({x - 1, y - 1}),
                 se = blocked({x, y - 1});
      const int count = ne + nw + sw + se;
      const bool convex = count == 1 || (count == 2 && ne == sw);
      const Point position = corner({x, y});
      if (convex && box.contains(position)) {
        visit(Corner{position, 0, std::numbers::pi / 2,
                     static_cast<std::uint32_t>(cells().index({x, y}))});
      }
    }
  }
}

}  // namespace tutavia
