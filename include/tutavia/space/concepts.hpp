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
#include "tutavia/grid/bitboard/turn_planes.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/links.hpp"
#include "tutavia/world/frame.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// The concepts of spaces: the operations that searchers, smoothers and certificates require.

namespace tutavia {

/// The obstacle edge or disc nearest to a piece of a curve.
struct NearestObstacle {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  double distance = std::numeric_limits<double>::infinity();  ///< [m]; see ClearanceSpace
  double parameter = 0;           ///< of the nearest point of the piece, in [0, 1]
  std::uint32_t obstacle = none;  ///< index of the obstacle; none: nothing within reach
  std::uint32_t edge = 0;         ///< which of its edges (outer ring first, then the holes)
};

/// A convex corner of an obstacle, or a disc.
struct Corner {
  Point position = Point::Zero();  ///< the vertex, or the disc's centre
  double radius = 0;               ///< 0 for a vertex, else the disc's radius [m]
  double exterior_angle = 0;       ///< turn of the boundary there [rad]; 2 pi for a disc
  std::uint32_t id = 0;            ///< the same corner has the same id in every answer
};

/// Free space with yes-or-no tests: `is_free(p)` tests a point, `segment_free(p, q)` a whole closed
/// segment. Both are proofs, exact on ties. Free space lies within the box `bounds()`.
///
/// Example: examples/own_space.cpp.
template <class S>
concept FreeSpace = requires(const S& s, const Point& p) {
  { s.is_free(p) } -> std::same_as<bool>;
  { s.segment_free(p, p) } -> std::same_as<bool>;
  { s.bounds() } -> std::same_as<const Box&>;
};

/// Free space with distances to obstacles.
///
/// `clearance(p)` is the signed distance from p to the nearest obstacle, negative inside.
/// `nearest(piece, cap)` is the distance from a segment or an arc to the nearest obstacle boundary,
/// with an error of at most `distance_error_bound()` plus the arc's evaluation error. If that
/// distance is not below `cap`, the result is `cap` with obstacle `none`. Distances inside a disc
/// are negative. `is_inside(p)` tests whether a point that lies on no boundary is inside a polygon.
/// A point is free if its clearance is at least `safety_radius()`.
///
/// A minimal model: tests/support/archetypes.hpp.
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

/// A space that enumerates its obstacles' edges: `for_each_feature(box, visit)` calls
/// `visit(core, radius)` for every edge (radius 0) and disc (a point with a radius) whose bounding
/// box meets `box`, and perhaps for others. Edges form closed outlines, so every vertex is the
/// start of one edge.
///
/// A minimal model: tests/support/archetypes.hpp.
template <class S>
concept FeatureSpace = ClearanceSpace<S> && requires(const S& s, const Box& box) {
  s.for_each_feature(box, [](const Segment&, double) {});
};

/// A space that enumerates its obstacles' corners: `for_each_corner(box, visit)` calls
/// `visit(corner)` for every convex corner in `box` and every disc whose bounding box meets it.
///
/// A minimal model: tests/support/archetypes.hpp.
template <class S>
concept CornerSpace = ClearanceSpace<S> && requires(const S& s, const Box& box) {
  s.for_each_corner(box, [](const Corner&) {});
};

/// The free space of a workspace: `workspace()` holds its obstacles, polygons and discs.
///
/// A minimal model: tests/support/archetypes.hpp.
template <class S>
concept WorkspaceSpace = FeatureSpace<S> && requires(const S& s) {
  { s.workspace() } -> std::same_as<const Workspace&>;
};

/// Free space with nodes on a lattice. `frame()` maps nodes to the plane; `links(p)` joins any
/// point to nearby nodes by proved segments.
///
/// Example: examples/own_space.cpp.
template <class S>
concept LinkedSpace = FreeSpace<S> && requires(const S& s, const Point& p) {
  { s.frame() } -> std::same_as<const Frame&>;
  { s.links(p) } -> std::same_as<EndpointLinks>;
};

/// Free space with a grid on which every step that `movement()` allows is a proved segment.
///
/// Example: examples/own_space.cpp.
template <class S>
concept GridSpace = LinkedSpace<S> && requires(const S& s) {
  { s.grid() } -> std::same_as<const OccupancyGrid&>;
  { s.movement() } -> std::same_as<MovementRule>;
};

/// A grid space that stores its grid a second time, column by column: `columns()` is the grid with
/// rows and columns exchanged.
///
/// A minimal model: tests/support/archetypes.hpp.
template <class S>
concept ColumnSpace = GridSpace<S> && requires(const S& s) {
  { s.columns() } -> std::same_as<const OccupancyGrid&>;
};

/// A grid space that stores the planes of its grid in which searches find jump points.
///
/// A minimal model: tests/support/archetypes.hpp.
template <class S>
concept JumpSpace = GridSpace<S> && requires(const S& s) {
  { s.stop_planes() } -> std::same_as<const detail::StopPlanes&>;
  { s.turn_planes() } -> std::same_as<const detail::TurnPlanes&>;
};

/// Free space with a grid of nodes and its own rule for steps: `successors(index)` is the set of
/// steps from the free node with this index in `grid()`. Each step is a proved segment to a free
/// node.
///
/// A minimal model: tests/support/archetypes.hpp.
template <class S>
concept StepSpace = LinkedSpace<S> && requires(const S& s, std::size_t index) {
  { s.grid() } -> std::same_as<const OccupancyGrid&>;
  { s.successors(index) } -> std::same_as<StepSet>;
};

/// A grid with steps, defined by a movement rule or by the space itself.
///
/// A minimal model: tests/support/archetypes.hpp.
template <class S>
concept SteppedSpace = GridSpace<S> || StepSpace<S>;

/// A grid with lines of sight: if `line_of_sight(a, b)` holds for two free nodes, the segment
/// between their reference points is free, and a path may use it.
///
/// A minimal model: tests/support/archetypes.hpp.
template <class S>
concept LineOfSightSpace = SteppedSpace<S> && requires(const S& s, Cell node) {
  { s.line_of_sight(node, node) } -> std::same_as<bool>;
};

/// A grid space with distances to obstacles.
///
/// A minimal model: tests/support/archetypes.hpp.
template <class S>
concept ClearanceGridSpace = GridSpace<S> && ClearanceSpace<S>;

namespace detail {

/// A grid space with columns and lines of sight.
template <class S>
concept ColumnLineOfSightSpace = ColumnSpace<S> && LineOfSightSpace<S>;

/// A grid space with stop planes and lines of sight.
template <class S>
concept JumpLineOfSightSpace = JumpSpace<S> && LineOfSightSpace<S>;

}  // namespace detail

}  // namespace tutavia
