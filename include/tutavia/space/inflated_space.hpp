// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "tutavia/geometry/polygon.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/space/boost_rtree.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/corner.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// InflatedSpace: the free space of a workspace, by exact distances to its obstacles.

namespace tutavia {

/// The points of a workspace at `safety_radius` or more from every obstacle.
///
/// Obstacles are never offset: distances to their edges are measured, so zones have exactly round
/// corners. An R-tree over the edges' boxes (Boost.Geometry, bulk-loaded) makes every question
/// logarithmic in the number of edges. Immutable: one object serves any number of threads.
/// `segment_free` and `is_free` settle ties by exact arithmetic, so a point at a distance of
/// exactly the safety radius is free. At radius 0 paths may touch simple polygons and discs;
/// obstacles without an inside, and polygons that cross themselves, block already where they are
/// touched.
class InflatedSpace {
 public:
  /// Fails with what `validate(workspace)` finds.
  static Expected<InflatedSpace, Failure> build(Workspace workspace);

  const Workspace& workspace() const { return workspace_; }
  const Box& bounds() const { return workspace_.bounds; }
  double safety_radius() const { return workspace_.safety_radius; }
  double magnitude() const { return magnitude_; }
  double slack() const { return rounding_slack(magnitude_); }

  bool is_free(const Point& p) const { return segment_free(p, p); }
  bool segment_free(const Point& p, const Point& q) const;

  /// Signed distance from `p` to the nearest obstacle [m], negative inside; infinity where there
  /// are no obstacles.
  double clearance(const Point& p) const;

  /// Distance from a segment or an arc to the nearest obstacle edge or disc; see ClearanceSpace.
  template <class P>
  Proximity nearest(const P& piece, double cap) const;

  /// Whether `p`, which lies on no edge, is inside a polygon.
  bool is_inside(const Point& p) const;

  /// Calls `visit(core, radius)` for every obstacle edge (radius 0) and disc (a point with a
  /// radius) whose box meets `box`.
  template <class Visit>
  void for_each_feature(const Box& box, Visit visit) const {
    for_each_in(edges_, box,
                [&](std::uint32_t i) { visit(features_[i].core, features_[i].radius); });
  }

  /// Calls `visit(corner)` for every convex corner in `box` and every disc whose box meets it.
  template <class Visit>
  void for_each_corner(const Box& box, Visit visit) const;

 private:
  using TreePoint = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
  using TreeBox = boost::geometry::model::box<TreePoint>;
  using Entry = std::pair<TreeBox, std::uint32_t>;
  using Tree = boost::geometry::index::rtree<Entry, boost::geometry::index::linear<16>>;

  /// An obstacle edge (radius 0) or a disc (a single point with a radius).
  struct Feature {
    Segment core;
    double radius;
    std::uint32_t obstacle;
    std::uint32_t edge;
    double exterior_angle;  // at core.a
  };

  /// What blocks at safety radius 0: a simple polygon only by its inside, so that paths may slide
  /// along it; anything else already by contact (discs: where they are overlapped).
  enum class Touch : std::uint8_t { inside_only, blocks };

  explicit InflatedSpace(Workspace workspace);

  static TreeBox tree_box(const Box& box) {
    return {{box.min.x(), box.min.y()}, {box.max.x(), box.max.y()}};
  }
  /// Calls `visit(index)` for every entry that meets the box. The tree's query is instantiated
  /// once, for a plain function, because every further one costs the user's compiler a tenth of a
  /// second.
  template <class Visit>
  static void for_each_in(const Tree& tree, const Box& box, Visit visit) {
    query(tree, box, &visit,
          [](void* context, std::uint32_t index) { (*static_cast<Visit*>(context))(index); });
  }
  static void query(const Tree& tree, const Box& box, void* context,
                    void (*visit)(void*, std::uint32_t)) {
    tree.query(boost::geometry::index::intersects(tree_box(box)),
               boost::make_function_output_iterator(
                   [context, visit](const Entry& entry) { visit(context, entry.second); }));
  }
  static Tree make_tree(const std::vector<Entry>& entries) {
    return {entries.begin(), entries.end()};
  }

  /// Tells cheaply that a feature lies farther than some distance to one side of a segment's line:
  /// most of the features in a slanted segment's box do.
  class SideTest {
   public:
    explicit SideTest(const Segment& s) {
      const double length = s.length();
      if (!(length > 0)) return;
      normal_ = {(s.a.y() - s.b.y()) / length, (s.b.x() - s.a.x()) / length};
      offset_ = normal_.x() * s.a.x() + normal_.y() * s.a.y();
    }
    explicit SideTest(const Arc&) {}

    bool operator()(const Feature& feature, double distance) const {
      const double a = side(feature.core.a), b = side(feature.core.b);
      const double limit = distance + feature.radius;
      return (a > limit && b > limit) || (a < -limit && b < -limit);
    }

   private:
    double side(const Point& p) const {
      return normal_.x() * p.x() + normal_.y() * p.y() - offset_;
    }

    Point normal_{0, 0};  // null: nothing is ever to one side
    double offset_ = 0;
  };

  void add_ring(const Ring& ring, std::uint32_t obstacle, bool is_hole, std::uint32_t& edge);
  bool keeps_radius(const Segment& segment, const Feature& feature) const;
  /// segment_free for safety radius 0.
  bool segment_free_at_contact(const Point& p, const Point& q) const;
  double depth(std::uint32_t obstacle, const Point& p) const;

  Workspace workspace_;
  double magnitude_;
  std::vector<Feature> features_;
  std::vector<std::size_t> first_feature_;  // per obstacle, and one past the last
  Box extent_;                              // of all features
  std::vector<Touch> may_touch_;            // per obstacle; filled for safety radius 0
  Tree edges_;
  Tree areas_;  // boxes of the polygons
};

inline Expected<InflatedSpace, Failure> InflatedSpace::build(Workspace workspace) {
  if (const auto valid = validate(workspace); !valid) return Unexpected{valid.error()};
  return InflatedSpace(std::move(workspace));
}

inline InflatedSpace::InflatedSpace(Workspace workspace)
    : workspace_(std::move(workspace)), magnitude_(workspace_.magnitude()) {
  std::vector<Entry> areas, edges;
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
    areas.emplace_back(tree_box(box), i);
  }
  first_feature_.push_back(features_.size());
  for (std::uint32_t i = 0; i < features_.size(); ++i) {
    const Box box = features_[i].core.box().inflated(features_[i].radius);
    extent_.include(box.min);
    extent_.include(box.max);
    edges.emplace_back(tree_box(box), i);
  }
  if (safety_radius() == 0) {
    for (const Obstacle& obstacle : workspace_.obstacles) {
      const Polygon* polygon = std::get_if<Polygon>(&obstacle);
      const bool simple = polygon != nullptr && is_simple(*polygon);
      may_touch_.push_back(simple ? Touch::inside_only : Touch::blocks);
    }
  }
  edges_ = make_tree(edges);
  areas_ = make_tree(areas);
}

inline void InflatedSpace::add_ring(const Ring& ring, std::uint32_t obstacle, bool is_hole,
                                    std::uint32_t& edge) {
  const std::size_t first = features_.size();
  for_each_edge(ring, [&](const Point& a, const Point& b) {
    features_.push_back({{a, b}, 0, obstacle, edge++, 0});
  });
  const double area = signed_area_twice(ring);
  for (std::size_t i = first; i < features_.size(); ++i) {
    const Segment& before = features_[i == first ? features_.size() - 1 : i - 1].core;
    const Segment& after = features_[i].core;
    if (after.a == after.b) {
      features_[i].exterior_angle = 2 * std::numbers::pi;
      continue;
    }
    const double turn = deflection(before.b - before.a, after.b - after.a);
    features_[i].exterior_angle =
        area == 0 ? std::abs(turn) : ((area > 0) != is_hole ? turn : -turn);
  }
}

inline bool InflatedSpace::keeps_radius(const Segment& s, const Feature& feature) const {
  const double r = safety_radius();
  const double gap = approach(s, feature.core).distance - feature.radius - r;
  if (gap > slack()) return true;
  if (gap < -slack()) return false;
  const Segment& core = feature.core;
  const auto keeps = [&](const Point& p, const Segment& q) {
    return compare_distance(p, q.a, q.b, feature.radius, r) >= 0;
  };
  return !segments_intersect(s.a, s.b, core.a, core.b) && keeps(s.a, core) && keeps(s.b, core) &&
         keeps(core.a, s) && keeps(core.b, s);
}

inline bool InflatedSpace::segment_free(const Point& p, const Point& q) const {
  if (!bounds().contains(p) || !bounds().contains(q)) return false;
  if (safety_radius() == 0) return segment_free_at_contact(p, q);
  const Segment segment{p, q};
  const double reach = safety_radius() + slack();
  const double distance = nearest(segment, reach).distance;
  if (distance < safety_radius() - slack()) return false;
  bool free = true;
  if (distance < reach) {  // a tie: to be settled exactly
    for_each_in(edges_, segment.box().inflated(reach),
                [&](std::uint32_t i) { free = free && keeps_radius(segment, features_[i]); });
  }
  return free && !is_inside(p);
}

inline bool InflatedSpace::segment_free_at_contact(const Point& p, const Point& q) const {
  const Segment segment{p, q};
  bool free = true;
  for_each_in(edges_, segment.box(), [&](std::uint32_t i) {
    const Feature& f = features_[i];
    if (!free || may_touch_[f.obstacle] == Touch::inside_only) return;
    free = f.radius > 0 ? compare_distance(f.core.a, p, q, f.radius, 0) >= 0
                        : !segments_intersect(p, q, f.core.a, f.core.b);
  });
  for_each_in(areas_, segment.box(), [&](std::uint32_t i) {
    const Polygon& polygon = std::get<Polygon>(workspace_.obstacles[i]);
    if (!free) return;
    free = may_touch_[i] == Touch::inside_only ? !interior_meets(polygon, p, q)
                                               : !contains(polygon, p);
  });
  return free;
}

template <class P>
Proximity InflatedSpace::nearest(const P& piece, double cap) const {
  const Box box = piece.box();
  const SideTest beside(piece);
  double reach = std::min(cap, safety_radius() + (bounds().width() + bounds().height()) / 64);
  while (true) {
    const Box window = box.inflated(reach);
    // A feature found within reach is the nearest one; once the window holds all, any found is.
    const bool complete = reach >= cap || window.contains(extent_) || features_.empty();
    if (complete) reach = cap;
    std::uint32_t best_feature = Proximity::none;
    Approach best{reach, 0};
    for_each_in(edges_, window, [&](std::uint32_t i) {
      if (beside(features_[i], best.distance)) return;
      Approach found = approach(piece, features_[i].core);
      found.distance -= features_[i].radius;
      const bool tie = found.distance == best.distance && i < best_feature;
      if (found.distance < best.distance || tie) best_feature = i, best = found;
    });
    if (best_feature != Proximity::none) {
      const Feature& feature = features_[best_feature];
      return {best.distance, best.parameter, feature.obstacle, feature.edge};
    }
    if (complete) return {cap, 0, Proximity::none, 0};
    reach = std::min(cap, 4 * reach);
  }
}

inline bool InflatedSpace::is_inside(const Point& p) const {
  bool inside = false;
  for_each_in(areas_, {p, p}, [&](std::uint32_t i) {
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
  double result = nearest(Segment{p, p}, std::numeric_limits<double>::infinity()).distance;
  for_each_in(areas_, {p, p}, [&](std::uint32_t i) {
    if (contains(std::get<Polygon>(workspace_.obstacles[i]), p)) {
      result = std::min(result, -depth(i, p));
    }
  });
  return result;
}

template <class Visit>
void InflatedSpace::for_each_corner(const Box& box, Visit visit) const {
  for_each_in(edges_, box, [&](std::uint32_t i) {
    const Feature& f = features_[i];
    if (f.exterior_angle > 0 && (f.radius > 0 || box.contains(f.core.a))) {
      visit(Corner{f.core.a, f.radius, f.exterior_angle, i});
    }
  });
}

}  // namespace tutavia
