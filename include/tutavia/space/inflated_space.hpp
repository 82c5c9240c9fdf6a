// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "tutavia/geometry/polygon.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/index/box_tree.hpp"
#include "tutavia/space/index/nearest_feature.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// InflatedSpace: the free space of a workspace, decided by exact distances to its obstacles.

namespace tutavia {

/// The points of a workspace at `safety_radius` or more from every obstacle.
///
/// Obstacles are not offset: the space computes distances to their edges, so safety zones have
/// exactly round corners. A packed R-tree over the edges' boxes (`BoxTree`) makes every query
/// logarithmic in the number of edges. Immutable: one object serves any number of threads.
/// `segment_free` and `is_free` decide ties by exact arithmetic, so a point at exactly the safety
/// radius is free. At radius 0 paths may touch simple polygons and discs, but not obstacles without
/// an interior or polygons that cross themselves. So a point may pass between two polygons that
/// touch, along the side that they share, and along a side that lies on the border of the bounds.
/// On a grid of cells it may not: cells that share a side are one obstacle (CellSpace).
class InflatedSpace {
 public:
  /// Errors: those of `validate(workspace)`.
  static Expected<InflatedSpace, Failure> build(Workspace workspace);

  /// The free space of the same obstacles at another safety radius [m].
  /// Errors: `invalid_input` for a radius that `validate` rejects.
  Expected<InflatedSpace, Failure> with_safety_radius(double radius) const {
    Workspace workspace = workspace_;
    workspace.safety_radius = radius;
    return build(std::move(workspace));
  }

  const Workspace& workspace() const { return workspace_; }
  const Box& bounds() const { return workspace_.bounds; }
  double safety_radius() const { return workspace_.safety_radius; }
  double largest_coordinate() const { return magnitude_; }
  double distance_error_bound() const { return detail::distance_rounding_error(magnitude_); }

  bool is_free(const Point& p) const { return segment_free(p, p); }
  bool segment_free(const Point& p, const Point& q) const;

  /// Signed distance from `p` to the nearest obstacle [m], negative inside; infinity without
  /// obstacles; NaN if a coordinate is.
  double clearance(const Point& p) const;

  /// Distance from a segment or an arc to the nearest obstacle edge or disc; see ClearanceSpace.
  template <class P>
  NearestObstacle nearest(const P& piece, double cap) const {
    return nearest_or_less(piece, cap, -std::numeric_limits<double>::infinity());
  }

  /// Whether `p` is inside a polygon. \pre `p` lies on no edge
  bool is_inside(const Point& p) const;

  /// Calls `visit(core, radius)` for every obstacle edge (radius 0) and disc (a point with a
  /// radius) whose box meets `box`.
  template <class Visit>
  void for_each_feature(const Box& box, Visit visit) const {
    edges_.for_each_in(box,
                       [&](std::uint32_t i) { visit(features_[i].core, features_[i].radius); });
  }

  /// Calls `visit(corner)` for every convex corner in `box` and every disc whose box meets it.
  template <class Visit>
  void for_each_corner(const Box& box, Visit visit) const;

 private:
  /// An obstacle edge (radius 0) or a disc (a single point with a radius).
  struct Feature {
    Segment core;
    double radius;
    std::uint32_t obstacle;
    std::uint32_t edge;
    double exterior_angle;  // at core.a
  };

  /// What an obstacle blocks at safety radius 0. A simple polygon blocks its interior only, so
  /// paths may slide along it. A disc blocks its open interior; any other obstacle blocks its
  /// boundary, too.
  enum class Touch : std::uint8_t { inside_only, blocks };

  explicit InflatedSpace(Workspace workspace);

  void add_ring(const Ring& ring, std::uint32_t obstacle, bool is_hole, std::uint32_t& edge);
  /// Calls `visit(feature)` for all features within `reach` of a piece and perhaps for others, some
  /// of them twice. Once `visit` returns false, the loop ends after at most one part of the piece.
  template <class P, class Visit>
  void for_each_along(const P& piece, double reach, Visit visit) const;
  /// Like `nearest`, but may stop at any distance below `enough`.
  template <class P>
  NearestObstacle nearest_or_less(const P& piece, double cap, double enough) const;
  /// The number of parts into which to cut a box along its diagonal at the least total cost. A
  /// query is taken to cost as much as 20 features, plus the features in its box.
  int parts_along(const Segment& segment, double reach) const;
  static int parts_along(const Arc&, double) { return 1; }
  /// `segment_free` for safety radius 0.
  bool segment_free_at_contact(const Point& p, const Point& q) const;
  double depth(std::uint32_t obstacle, const Point& p) const;

  Workspace workspace_;
  double magnitude_;
  std::vector<Feature> features_;
  std::vector<std::size_t> first_feature_;  // per obstacle, and one past the last
  Box extent_;                              // of all features
  double density_ = 0;                      // features per square metre
  std::vector<Touch> may_touch_;            // per obstacle; filled for safety radius 0
  detail::BoxTree edges_;
  detail::BoxTree areas_;  // boxes of the polygons
};

inline Expected<InflatedSpace, Failure> InflatedSpace::build(Workspace workspace) {
  if (const auto valid = validate(workspace); !valid) return Unexpected{valid.error()};
  return InflatedSpace(std::move(workspace));
}

inline InflatedSpace::InflatedSpace(Workspace workspace)
    : workspace_(std::move(workspace)), magnitude_(workspace_.largest_coordinate()) {
  std::vector<detail::BoxTree::Entry> areas, edges;
  for (std::uint32_t i = 0; i < workspace_.obstacles.size(); ++i) {
    first_feature_.push_back(features_.size());
    if (const Disc* disc = std::get_if<Disc>(&workspace_.obstacles[i])) {
      features_.push_back({{disc->center, disc->center}, disc->radius, i, 0, 2 * std::numbers::pi});
      continue;
    }
    const Polygon& polygon = std::get<Polygon>(workspace_.obstacles[i]);
    std::uint32_t edge = 0;
    add_ring(polygon.outer, i, false, edge);
    for (const Ring& hole : polygon.holes) add_ring(hole, i, true, edge);
    Box box;
    for (const Point& p : polygon.outer) box.include(p);
    areas.emplace_back(box, i);
  }
  first_feature_.push_back(features_.size());
  for (std::uint32_t i = 0; i < features_.size(); ++i) {
    const Box box = features_[i].core.box().inflated(features_[i].radius);
    extent_.include(box.min);
    extent_.include(box.max);
    edges.emplace_back(box, i);
  }
  const double area = extent_.width() * extent_.height();
  if (area > 0) density_ = static_cast<double>(features_.size()) / area;
  if (safety_radius() == 0) {
    for (const Obstacle& obstacle : workspace_.obstacles) {
      const Polygon* polygon = std::get_if<Polygon>(&obstacle);
      const bool simple = polygon != nullptr && is_simple(*polygon);
      may_touch_.push_back(simple ? Touch::inside_only : Touch::blocks);
    }
  }
  edges_ = detail::BoxTree(std::move(edges));
  areas_ = detail::BoxTree(std::move(areas));
}

inline void InflatedSpace::add_ring(const Ring& ring, std::uint32_t obstacle, bool is_hole,
                                    std::uint32_t& edge) {
  const std::size_t first = features_.size();
  detail::for_each_edge(ring, [&](const Point& a, const Point& b) {
    features_.push_back({{a, b}, 0, obstacle, edge++, 0});
  });
  const double area = detail::signed_area_twice(ring);
  for (std::size_t i = first; i < features_.size(); ++i) {
    const Segment& before = features_[i == first ? features_.size() - 1 : i - 1].core;
    const Segment& after = features_[i].core;
    if (after.a == after.b) {
      features_[i].exterior_angle = 2 * std::numbers::pi;
      continue;
    }
    const double turn = turn_angle(before.b - before.a, after.b - after.a);
    features_[i].exterior_angle =
        area == 0 ? std::abs(turn) : ((area > 0) != is_hole ? turn : -turn);
  }
}

inline bool InflatedSpace::segment_free(const Point& p, const Point& q) const {
  if (!bounds().contains(p) || !bounds().contains(q)) return false;
  if (safety_radius() == 0) return segment_free_at_contact(p, q);
  const Segment segment{p, q};
  const double reach = safety_radius() + distance_error_bound();
  const double blocked = safety_radius() - distance_error_bound();
  const double distance = nearest_or_less(segment, reach, blocked).distance;
  if (distance < blocked) return false;
  bool free = true;
  if (distance < reach) {  // a tie, decided exactly
    for_each_along(segment, reach, [&](const Feature& f) {
      return free = free && detail::keeps_distance(segment, f.core, f.radius, safety_radius(),
                                                   distance_error_bound());
    });
  }
  return free && !is_inside(p);
}

inline bool InflatedSpace::segment_free_at_contact(const Point& p, const Point& q) const {
  const Segment segment{p, q};
  bool free = true;
  edges_.for_each_in(segment.box(), [&](std::uint32_t i) {
    const Feature& f = features_[i];
    if (!free || may_touch_[f.obstacle] == Touch::inside_only) return;
    free = f.radius > 0 ? detail::compare_distance(f.core.a, p, q, f.radius, 0) >= 0
                        : !detail::segments_intersect(p, q, f.core.a, f.core.b);
  });
  areas_.for_each_in(segment.box(), [&](std::uint32_t i) {
    const Polygon& polygon = std::get<Polygon>(workspace_.obstacles[i]);
    if (!free) return;
    free = may_touch_[i] == Touch::inside_only ? !detail::interior_meets(polygon, p, q)
                                               : !contains(polygon, p);
  });
  return free;
}

inline int InflatedSpace::parts_along(const Segment& segment, double reach) const {
  const Box box = segment.box();
  const double inside = density_ * box.width() * box.height();
  const double parts = std::sqrt(inside / (20 + 4 * density_ * reach * reach));
  return parts >= 2 ? static_cast<int>(std::fmin(parts, 64)) : 1;  // 1 for NaN, too
}

template <class P, class Visit>
void InflatedSpace::for_each_along(const P& piece, double reach, Visit visit) const {
  bool go_on = true;
  const auto look_in = [&](const Box& part) {
    edges_.for_each_in(part.inflated(reach), [&](std::uint32_t i) { go_on = visit(features_[i]); });
  };
  // The box of a long slanted segment holds many features far from it; the boxes of its parts hold
  // few.
  const int parts = parts_along(piece, reach);
  if (parts == 1) return look_in(piece.box());
  for (int k = 0; k < parts && go_on; ++k) {
    look_in(Box::around({piece.point(double(k) / parts), piece.point((k + 1.0) / parts)}));
  }
}

template <class P>
NearestObstacle InflatedSpace::nearest_or_less(const P& piece, double cap, double enough) const {
  const double first_reach = safety_radius() + (bounds().width() + bounds().height()) / 64;
  return detail::nearest_feature(piece, cap, first_reach, extent_, [&](double reach, auto visit) {
    for_each_along(piece, reach, [&](const Feature& f) {
      return visit(f.core, f.radius, f.obstacle, f.edge) >= enough;
    });
  });
}

inline bool InflatedSpace::is_inside(const Point& p) const {
  bool inside = false;
  areas_.for_each_in({p, p}, [&](std::uint32_t i) {
    inside = inside || contains(std::get<Polygon>(workspace_.obstacles[i]), p);
  });
  return inside;
}

inline double InflatedSpace::depth(std::uint32_t obstacle, const Point& p) const {
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = first_feature_[obstacle]; i < first_feature_[obstacle + 1]; ++i) {
    result = std::min(result, distance(p, features_[i].core));
  }
  return result;
}

inline double InflatedSpace::clearance(const Point& p) const {
  if (p.hasNaN()) return std::numeric_limits<double>::quiet_NaN();
  double result = nearest(Segment{p, p}, std::numeric_limits<double>::infinity()).distance;
  areas_.for_each_in({p, p}, [&](std::uint32_t i) {
    if (contains(std::get<Polygon>(workspace_.obstacles[i]), p)) {
      result = std::min(result, -depth(i, p));
    }
  });
  return result;
}

template <class Visit>
void InflatedSpace::for_each_corner(const Box& box, Visit visit) const {
  edges_.for_each_in(box, [&](std::uint32_t i) {
    const Feature& f = features_[i];
    if (f.exterior_angle > 0 && (f.radius > 0 || box.contains(f.core.a))) {
      visit(Corner{f.core.a, f.radius, f.exterior_angle, i});
    }
  });
}

}  // namespace tutavia
