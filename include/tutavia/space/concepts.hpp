// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/links.hpp"
#include "tutavia/world/frame.hpp"

/// \file
/// What searchers, smoothers and certificates may ask of a space.

namespace tutavia {

/// The obstacle part nearest to some piece.
struct Proximity {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  double distance = std::numeric_limits<double>::infinity();  ///< [m]; see ClearanceSpace
  double parameter = 0;           ///< where on the piece it is attained, in [0, 1]
  std::uint32_t obstacle = none;  ///< index of the obstacle; none: nothing within reach
  std::uint32_t edge = 0;         ///< which of its edges (outer ring first, then the holes)
};

/// Free space with a yes-or-no answer: `is_free(p)` says whether the point is in it,
/// `segment_free(p, q)` whether the whole closed segment is. Both are proofs, exact on ties.
template <class S>
concept FreeSpace = requires(const S& s, const Point& p) {
  { s.is_free(p) } -> std::same_as<bool>;
  { s.segment_free(p, p) } -> std::same_as<bool>;
  { s.bounds() } -> std::convertible_to<Box>;
};

/// Free space that knows distances.
///
/// `clearance(p)` is the signed distance from p to the nearest obstacle, negative inside.
/// `nearest(piece, cap)` is the distance from a segment or an arc to the nearest obstacle boundary,
/// exact to `slack()` (and the arc's evaluation error) where it is below `cap`; else `cap` with
/// obstacle `none`. Solid discs count negative inside. `is_inside(p)` says whether a point off the
/// boundaries lies inside a polygon. Free space is where the clearance is `safety_radius()` or
/// more.
template <class S>
concept ClearanceSpace = FreeSpace<S> &&
    requires(const S& s, const Point& p, const Segment& segment, const Arc& arc, double cap) {
  { s.clearance(p) } -> std::same_as<double>;
  { s.nearest(segment, cap) } -> std::same_as<Proximity>;
  { s.nearest(arc, cap) } -> std::same_as<Proximity>;
  { s.is_inside(p) } -> std::same_as<bool>;
  { s.safety_radius() } -> std::same_as<double>;
  { s.slack() } -> std::same_as<double>;
  { s.magnitude() } -> std::same_as<double>;
};

/// A space that knows its obstacles' edges: `for_each_feature(box, visit)` calls `visit(core,
/// radius)` for every edge (radius 0) and disc (a point with a radius) whose box meets the box, and
/// perhaps for others. Edges follow one another around closed outlines, so that every vertex is the
/// first end of one.
template <class S>
concept FeatureSpace = ClearanceSpace<S> && requires(const S& s, const Box& box) {
  s.for_each_feature(box, [](const Segment&, double) {});
};

/// Free space with nodes: `links(p)` joins any point to those around it by proved segments.
template <class S>
concept LinkedSpace = FreeSpace<S> && requires(const S& s, const Point& p) {
  { s.frame() } -> std::convertible_to<Frame>;
  { s.links(p) } -> std::same_as<Links>;
};

/// Free space with a grid laid over it, every step of which (by `movement()`) is a proved segment.
template <class S>
concept GridSpace = LinkedSpace<S> && requires(const S& s) {
  { s.grid() } -> std::same_as<const OccupancyGrid&>;
  { s.movement() } -> std::same_as<MovementRule>;
};

}  // namespace tutavia
