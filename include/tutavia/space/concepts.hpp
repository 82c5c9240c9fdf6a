// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/grid/bitboard/stop_planes.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/links.hpp"
#include "tutavia/world/frame.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// What searchers, smoothers and certificates may ask of a space.

namespace tutavia {

/// The obstacle part nearest to some piece.
struct NearestObstacle {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  double distance = std::numeric_limits<double>::infinity();  ///< [m]; see ClearanceSpace
  double parameter = 0;           ///< where on the piece it is attained, in [0, 1]
  std::uint32_t obstacle = none;  ///< index of the obstacle; none: nothing within reach
  std::uint32_t edge = 0;         ///< which of its edges (outer ring first, then the holes)
};

/// A convex corner of an obstacle, or a disc.
struct Corner {
  Point position = Point::Zero();  ///< the vertex, or the disc's centre
  double radius = 0;               ///< 0 for a vertex, else the disc's radius [m]
  double exterior_angle = 0;       ///< by how much the boundary turns there [rad]; 2 pi for a disc
  std::uint32_t id = 0;            ///< the same corner has the same id in every answer
};

/// Free space with a yes-or-no answer: `is_free(p)` says whether the point is in it,
/// `segment_free(p, q)` whether the whole closed segment is. Both are proofs, exact on ties. All of
/// it lies in the box `bounds()`.
template <class S>
concept FreeSpace = requires(const S& s, const Point& p) {
  { s.is_free(p) } -> std::same_as<bool>;
  { s.segment_free(p, p) } -> std::same_as<bool>;
  { s.bounds() } -> std::same_as<const Box&>;
};

/// Free space that knows distances.
///
/// `clearance(p)` is the signed distance from p to the nearest obstacle, negative inside.
/// `nearest(piece, cap)` is the distance from a segment or an arc to the nearest obstacle boundary,
/// exact to `distance_error_bound()` (and the arc's evaluation error) where it is below `cap`; else
/// `cap` with obstacle `none`. Solid discs count negative inside. `is_inside(p)` says whether a
/// point off the boundaries lies inside a polygon. Free space is where the clearance is
/// `safety_radius()` or more.
template <class S>
concept ClearanceSpace = FreeSpace<S> &&
    requires(const S& s, const Point& p, const Segment& segment, const Arc& arc, double cap) {
  { s.clearance(p) } -> std::same_as<double>;
  { s.nearest(segment, cap) } -> std::same_as<NearestObstacle>;
  { s.nearest(arc, cap) } -> std::same_as<NearestObstacle>;
  { s.is_inside(p) } -> std::same_as<bool>;
  { s.safety_radius() } -> std::same_as<double>;
  { s.distance_error_bound() } -> std::same_as<double>;
  { s.largest_coordinate() } -> std::same_as<double>;
};

/// A space that knows its obstacles' edges: `for_each_feature(box, visit)` calls `visit(core,
/// radius)` for every edge (radius 0) and disc (a point with a radius) whose box meets the box, and
/// perhaps for others. Edges follow one another around closed outlines, so that every vertex is the
/// first end of one.
template <class S>
concept FeatureSpace = ClearanceSpace<S> && requires(const S& s, const Box& box) {
  s.for_each_feature(box, [](const Segment&, double) {});
};

/// A space that knows its obstacles' corners: `for_each_corner(box, visit)` calls `visit(corner)`
/// for every convex corner in the box and every disc whose box meets it.
template <class S>
concept CornerSpace = ClearanceSpace<S> && requires(const S& s, const Box& box) {
  s.for_each_corner(box, [](const Corner&) {});
};

/// The free space of a workspace: `workspace()` has its obstacles, polygons and discs.
template <class S>
concept WorkspaceSpace = FeatureSpace<S> && requires(const S& s) {
  { s.workspace() } -> std::same_as<const Workspace&>;
};

/// Free space with nodes on a lattice, whose place in the plane is `frame()`: `links(p)` joins any
/// point to those around it by proved segments.
template <class S>
concept LinkedSpace = FreeSpace<S> && requires(const S& s, const Point& p) {
  { s.frame() } -> std::same_as<const Frame&>;
  { s.links(p) } -> std::same_as<EndpointLinks>;
};

/// Free space with a grid laid over it, every step of which (by `movement()`) is a proved segment.
template <class S>
concept GridSpace = LinkedSpace<S> && requires(const S& s) {
  { s.grid() } -> std::same_as<const OccupancyGrid&>;
  { s.movement() } -> std::same_as<MovementRule>;
};

/// A grid space that is as well known along its columns as along its rows: `columns()` is its grid
/// with rows and columns exchanged.
template <class S>
concept ColumnSpace = GridSpace<S> && requires(const S& s) {
  { s.columns() } -> std::same_as<const OccupancyGrid&>;
};

/// A grid space that keeps the stop planes of its grid, in which jump points are found.
template <class S>
concept JumpSpace = GridSpace<S> && requires(const S& s) {
  { s.stop_planes() } -> std::same_as<const detail::StopPlanes&>;
};

/// Free space with a grid of nodes and steps of its own: `successors(index)` holds the steps, each
/// a proved segment to a free node, that lead from the free node with this index in `grid()`.
template <class S>
concept StepSpace = LinkedSpace<S> && requires(const S& s, std::size_t index) {
  { s.grid() } -> std::same_as<const OccupancyGrid&>;
  { s.successors(index) } -> std::same_as<StepSet>;
};

/// A grid with steps, by the rule of its movement or its own.
template <class S>
concept SteppedSpace = GridSpace<S> || StepSpace<S>;

/// A grid whose nodes know each other: where `line_of_sight(a, b)` holds for two free nodes, the
/// segment between their reference points is free and may be taken.
template <class S>
concept LineOfSightSpace = SteppedSpace<S> && requires(const S& s, Cell node) {
  { s.line_of_sight(node, node) } -> std::same_as<bool>;
};

/// A grid with distances.
template <class S>
concept ClearanceGridSpace = GridSpace<S> && ClearanceSpace<S>;

namespace detail {

/// Rows, columns and lines of sight.
template <class S>
concept ColumnLineOfSightSpace = ColumnSpace<S> && LineOfSightSpace<S>;

/// Jump points and lines of sight.
template <class S>
concept JumpLineOfSightSpace = JumpSpace<S> && LineOfSightSpace<S>;

}  // namespace detail

}  // namespace tutavia
