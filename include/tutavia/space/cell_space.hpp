// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "tutavia/geometry/numeric/exact_number.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/grid/bitboard/transposed.hpp"
#include "tutavia/grid/dilate.hpp"
#include "tutavia/grid/line_of_sight.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/index/blocked_edges.hpp"
#include "tutavia/space/index/grid_layer.hpp"
#include "tutavia/space/index/nearest_feature.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// CellSpace: the free space between the blocked cells of a grid.

namespace tutavia {

/// Position and size of the cells, safety radius and movement rule.
struct CellOptions {
  double resolution = 1;         ///< side of a cell [m]
  Point origin = Point::Zero();  ///< lower left corner of cell (0, 0) [m]
  double safety_radius = 0;      ///< distance to keep from blocked cells [m]
  MovementRule movement = MovementRule::no_cut;
};

/// The points of a grid's rectangle at `safety_radius` or more from every blocked cell, a closed
/// square; and the grid of the cells that a path may step on.
///
/// At radius 0 the robot is a point. It may touch blocked cells and slide along them, but may not
/// move along an edge that two blocked cells share, or that a blocked cell shares with the border
/// of the map. Every step between free cells lies in free space: under `no_cut` and
/// `four_connected` a clearance of r at the centres suffices; under the other rules a positive
/// radius requires sqrt(r^2 + resolution^2 / 2).
///
/// Origin and resolution are rounded (the latter up) to binary fractions, so that the coordinates
/// of all corners and centres are exact: the origin moves by less than 2^-50 of the largest
/// coordinate, and a cell grows by less than 2^-49 of it. Tests are exact: a corridor just as wide
/// as the robot is free. Immutable: one object serves any number of threads.
class CellSpace {
 public:
  /// Errors: `invalid_option` for a resolution that is not positive, an origin that is not finite
  /// or too far away for exact coordinates, a negative radius, or the movement rule `by_edge`;
  /// `limit_exceeded` for some 67 million columns or more (see `detail::check_transpose`).
  static Expected<CellSpace, Failure> build(OccupancyGrid cells, const CellOptions& options = {});

  /// The space of the same cells at another safety radius [m]. Errors: those of `build`.
  Expected<CellSpace, Failure> with_safety_radius(double radius) const {
    return build(cells(), {.resolution = frame().resolution,
                           .origin = corner({0, 0}),
                           .safety_radius = radius,
                           .movement = movement()});
  }

  /// The grid of the cells that a path may step on.
  const OccupancyGrid& grid() const { return layer_.grid(); }
  /// The map as given to `build`.
  const OccupancyGrid& cells() const { return cells_ ? *cells_ : layer_.grid(); }
  /// The exact lower left corner of a cell. Cells outside the map, up to its own size away, are
  /// allowed.
  Point corner(Cell cell) const {
    return {corner_.x() + layer_.frame().resolution * cell.x,
            corner_.y() + layer_.frame().resolution * cell.y};
  }
  const Frame& frame() const { return layer_.frame(); }
  MovementRule movement() const { return layer_.movement(); }
  /// Copies of a space share an identity, other spaces do not. It stays unique while it is held.
  std::shared_ptr<const void> identity() const { return layer_.identity(); }
  const detail::StopPlanes& stop_planes() const { return layer_.stop_planes(); }
  const detail::TurnPlanes& turn_planes() const { return layer_.turn_planes(); }
  const OccupancyGrid& columns() const { return layer_.columns(); }
  const OccupancyGrid& corners() const { return layer_.corners(); }
  EndpointLinks links(const Point& p) const {
    if (!bounds_.contains(p)) return {};
    return layer_.links(p, 0,
                        [this](const Point& a, const Point& b) { return segment_free(a, b); });
  }

  /// Whether the segment between the reference points of two cells is free. At safety radius 0 the
  /// segment may touch free cells only, as steps under `no_cut` do; otherwise this is
  /// `segment_free`.
  bool line_of_sight(Cell a, Cell b) const {
    if (safety_radius_ == 0)
      return tutavia::line_of_sight(grid().view(), layer_.columns().view(), a, b);
    return segment_free(frame().point(a), frame().point(b));
  }

  const Box& bounds() const { return bounds_; }
  double safety_radius() const { return safety_radius_; }
  double largest_coordinate() const { return magnitude_; }
  double distance_error_bound() const { return detail::distance_rounding_error(magnitude_); }

  bool is_free(const Point& p) const { return segment_free(p, p); }
  bool segment_free(const Point& p, const Point& q) const;
  /// Signed distance from `p` to the nearest blocked cell [m], negative inside; infinity if no cell
  /// is blocked; NaN if a coordinate is.
  double clearance(const Point& p) const;
  /// See ClearanceSpace. `obstacle` is the index of the blocked cell in `cells()`; its edges are
  /// numbered counterclockwise, from the right one.
  template <class P>
  NearestObstacle nearest(const P& piece, double cap) const;
  /// Whether `p` lies inside the union of the blocked cells, or on an edge that a blocked cell
  /// shares with the border of the map.
  bool is_inside(const Point& p) const { return edges().meets_inside({p, p}); }

  /// Calls `visit(edge, 0.0)` for every edge of the blocked cells' union in `box`.
  template <class Visit>
  void for_each_feature(const Box& box, Visit visit) const {
    edges().for_each_in(box, [&](const Segment& edge, std::uint32_t, std::uint32_t) {
      visit(edge, 0.0);
      return 0.0;
    });
  }
  /// Calls `visit(corner)` for every convex corner of the blocked cells in `box`.
  template <class Visit>
  void for_each_corner(const Box& box, Visit visit) const {
    edges().for_each_corner(box, visit);
  }

 private:
  CellSpace(OccupancyGrid grid, std::shared_ptr<const OccupancyGrid> cells, const Point& origin,
            const Frame& frame, const CellOptions& options)
      : layer_(std::move(grid), frame, options.movement),
        cells_(std::move(cells)),
        corner_(origin),
        bounds_{origin, corner({layer_.grid().width(), layer_.grid().height()})},
        safety_radius_(options.safety_radius),
        magnitude_(std::fmax(bounds_.largest_coordinate(), safety_radius_)) {}

  /// The blocked cells and their edges.
  detail::BlockedEdges edges() const {
    return {cells(), corner_, layer_.frame().resolution, distance_error_bound()};
  }

  detail::GridLayer layer_;
  std::shared_ptr<const OccupancyGrid> cells_;  // null if the same as the grid; shared by copies
  Point corner_;
  Box bounds_;
  double safety_radius_;
  double magnitude_;
};

namespace detail {

/// The power of two of which all coordinates become multiples, by factors below 2^52.
inline Expected<double, Failure> coordinate_quantum(const OccupancyGrid& cells,
                                                    const CellOptions& options) {
  const double size = options.resolution;
  if (!(size > 0) || !std::isfinite(size)) {
    return fail(PlanError::invalid_option, "resolution must be positive and finite");
  }
  if (!(options.safety_radius >= 0) || !std::isfinite(options.safety_radius)) {
    return fail(PlanError::invalid_option, "safety_radius must be finite and not negative");
  }
  if (options.movement == MovementRule::by_edge) {
    return fail(PlanError::invalid_option, "movement by_edge is not defined for cells");
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
  const double quantum = std::ldexp(1.0, std::ilogb(magnitude) - 50);
  if (!(size > 0x1p20 * quantum)) {
    return fail(PlanError::invalid_option,
                "origin and resolution must leave room for exact coordinates: the largest is " +
                    std::to_string(magnitude) + " m");
  }
  return quantum;
}

/// The least squared distance from a blocked cell, in units of half a cell, at which the centre of
/// a cell keeps the safety radius; decided exactly. \pre the radius is less than 2^24 sides
inline std::int64_t least_squared_distance(double radius, double side) {
  const auto squared = [](const ExactNumber& x) { return x * x; };
  const ExactNumber unit = squared(ExactNumber(side / 2)), limit = squared(ExactNumber(radius));
  const auto keeps = [&](std::int64_t n) {
    return (ExactNumber(static_cast<double>(n)) * unit - limit).sign() >= 0;
  };
  const double ratio = 2 * radius / side;
  auto least = static_cast<std::int64_t>(ratio * ratio);
  while (least > 0 && keeps(least - 1)) --least;
  while (!keeps(least)) ++least;
  return least;
}

}  // namespace detail

inline Expected<CellSpace, Failure> CellSpace::build(OccupancyGrid cells,
                                                     const CellOptions& options) {
  if (auto valid = detail::check_transpose(cells); !valid) return std::move(valid).unexpected();
  const auto quantum = detail::coordinate_quantum(cells, options);
  if (!quantum) return Unexpected{quantum.error()};
  const auto snap = [&](double x) { return std::nearbyint(x / *quantum) * *quantum; };
  const Point origin{snap(options.origin.x()), snap(options.origin.y())};
  // Rounded up, so that a corridor is never narrower than specified.
  const double side = std::ceil(options.resolution / (2 * *quantum)) * 2 * *quantum;
  const Frame frame{{origin.x() + side / 2, origin.y() + side / 2}, side};
  const double r = options.safety_radius;
  if (r == 0) return CellSpace(std::move(cells), nullptr, origin, frame, options);
  if (!(2 * r / side < 0x1p25)) {
    return fail(PlanError::invalid_option, "safety_radius is more than 2^24 cells");
  }
  const bool cuts_corners =
      options.movement == MovementRule::no_squeeze || options.movement == MovementRule::allow;
  OccupancyGrid grid =
      dilated(cells, detail::least_squared_distance(r, side) + (cuts_corners ? 2 : 0));
  return CellSpace(std::move(grid), std::make_shared<const OccupancyGrid>(std::move(cells)), origin,
                   frame, options);
}

template <class P>
NearestObstacle CellSpace::nearest(const P& piece, double cap) const {
  return detail::nearest_feature(
      piece, cap, safety_radius_ + 2 * frame().resolution, bounds_, [&](double reach, auto visit) {
        edges().for_each_near(piece, reach,
                              [&](const Segment& edge, std::uint32_t cell, std::uint32_t side) {
                                return visit(edge, 0.0, cell, side);
                              });
      });
}

inline bool CellSpace::segment_free(const Point& p, const Point& q) const {
  if (!bounds_.contains(p) || !bounds_.contains(q)) return false;
  const Segment segment{p, q};
  // Quicker than distances, and enough for most segments that are not free.
  if (edges().meets_inside(segment)) return false;
  if (safety_radius_ == 0) return true;
  const double reach = safety_radius_ + distance_error_bound();
  const double distance = nearest(segment, reach).distance;
  if (distance < safety_radius_ - distance_error_bound()) return false;
  bool free = true;
  if (distance < reach) {  // a tie, decided exactly
    edges().for_each_near(segment, reach, [&](const Segment& edge, std::uint32_t, std::uint32_t) {
      free =
          free && detail::keeps_distance(segment, edge, 0, safety_radius_, distance_error_bound());
      return reach;
    });
  }
  return free;
}

inline double CellSpace::clearance(const Point& p) const {
  if (p.hasNaN()) return std::numeric_limits<double>::quiet_NaN();
  const double distance = nearest(Segment{p, p}, std::numeric_limits<double>::infinity()).distance;
  return is_inside(p) ? -distance : distance;
}

}  // namespace tutavia
