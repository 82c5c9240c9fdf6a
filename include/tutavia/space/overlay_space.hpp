// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// OverlaySpace: a window of a space with more obstacles, at a safety radius of its own.

namespace tutavia {

/// A window of a space, with obstacles that the space does not hold, at any safety radius. Makes no
/// copy of the space, which must outlive it: for queries near a robot that meets something new.
///
/// Obstacles of the space keep their indices; the i-th of the others has the index 2^31 + i. A
/// point or segment within rounding of the safety radius is not free: unlike the spaces that it
/// covers, this one does not decide ties.
template <FeatureSpace S>
class OverlaySpace {
 public:
  /// The index of the first added obstacle.
  static constexpr std::uint32_t first_added = 1u << 31;

  /// Errors: those of `validate` for the window, the radius and the obstacles.
  static Expected<OverlaySpace, Failure> build(const S& space, const Box& window,
                                               double safety_radius,
                                               std::vector<Obstacle> obstacles) {
    const Box& whole = space.bounds();
    const Box bounds{whole.clamp(window.min), whole.clamp(window.max)};
    auto added = InflatedSpace::build({bounds, safety_radius, std::move(obstacles)});
    if (!added) return Unexpected{added.error()};
    return OverlaySpace(space, std::move(*added));
  }

  const Box& bounds() const { return added_.bounds(); }
  double safety_radius() const { return added_.safety_radius(); }
  double largest_coordinate() const {
    return std::max(space_->largest_coordinate(), added_.largest_coordinate());
  }
  double distance_error_bound() const {
    return std::max(space_->distance_error_bound(), added_.distance_error_bound());
  }

  bool is_free(const Point& p) const { return segment_free(p, p); }
  bool segment_free(const Point& p, const Point& q) const {
    if (!bounds().contains(p) || !bounds().contains(q)) return false;
    const double reach = safety_radius() + distance_error_bound();
    return nearest(Segment{p, q}, reach).distance >= reach && !is_inside(p);
  }
  double clearance(const Point& p) const {
    return std::min(space_->clearance(p), added_.clearance(p));
  }
  bool is_inside(const Point& p) const { return space_->is_inside(p) || added_.is_inside(p); }

  template <class P>
  NearestObstacle nearest(const P& piece, double cap) const {
    const NearestObstacle old = space_->nearest(piece, cap);
    NearestObstacle other = added_.nearest(piece, old.distance);
    if (other.obstacle == NearestObstacle::none) return old;
    other.obstacle += first_added;
    return other;
  }

  template <class Visit>
  void for_each_feature(const Box& box, Visit visit) const {
    space_->for_each_feature(box, visit);
    added_.for_each_feature(box, visit);
  }

 private:
  OverlaySpace(const S& space, InflatedSpace added) : space_(&space), added_(std::move(added)) {}

  const S* space_;
  InflatedSpace added_;  // the obstacles that the space does not hold
};

}  // namespace tutavia
