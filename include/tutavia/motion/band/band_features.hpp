// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <variant>
#include <vector>

#include "tutavia/geometry/polygon.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/motion/band.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// BandFeatures: the obstacle edges and discs near each pose of a band.

namespace tutavia::detail {

/// The distance from a pose to the nearest obstacle on one side, and its gradient.
struct SideDistance {
  double distance = std::numeric_limits<double>::infinity();  // [m]
  Point gradient = Point::Zero();                             // away from the obstacle
};

/// The edges and discs near each pose of a band, divided into those on the left and on the right,
/// and the time at which each pose is reached. Frozen while the band is optimised. Allocates only
/// to grow.
class BandFeatures {
 public:
  /// Finds what lies within `reach` of a pose, at the time of the pose.
  template <FeatureSpace S>
  void find(const S& space, std::span<const MovingObstacle> observed, const Band& band,
            double reach);

  /// The distances of a pose, at `p` now, to the nearest feature on its left and on its right.
  std::array<SideDistance, 2> distances(std::size_t pose, const Point& p) const;

 private:
  struct Feature {
    Segment core;
    double radius;
    Point velocity;
  };
  struct Near {
    std::uint32_t feature;
    bool right;
    bool inside;  // the pose lies inside the obstacle with this edge
  };
  struct Closest {
    double distance;  // from the core [m]
    Point away;       // from the closest point to the pose, not normalised
  };

  void add_observed(std::span<const MovingObstacle> observed, const Box& window);
  Closest closest(const Feature& feature, const Point& p, double time) const {
    const Point q = offset_along(p, -time, feature.velocity);
    const Point c = feature.core.point(feature.core.nearest_parameter(q));
    return {tutavia::distance(q, c), {q.x() - c.x(), q.y() - c.y()}};
  }

  std::vector<Feature> features_;
  std::vector<std::uint32_t> owners_;    // of each feature: 0 for the map, else observed + 1
  std::vector<Near> near_;               // of all poses
  std::vector<std::size_t> first_near_;  // of each pose, and one past the last
  std::vector<double> times_;            // of each pose [s]
  std::vector<Point> across_;            // the direction to the left of each pose
};

inline void BandFeatures::add_observed(std::span<const MovingObstacle> observed,
                                       const Box& window) {
  for (std::uint32_t i = 0; i < observed.size(); ++i) {
    const Obstacle& shape = observed[i].shape;
    const double drift = observed[i].velocity.norm() * (times_.empty() ? 0 : times_.back());
    if (!box_of(shape).inflated(drift).meets(window)) continue;
    const auto add = [&](const Segment& core, double radius) {
      features_.push_back({core, radius, observed[i].velocity});
      owners_.push_back(i + 1);
    };
    if (const Disc* disc = std::get_if<Disc>(&shape)) {
      add({disc->center, disc->center}, disc->radius);
      continue;
    }
    const Polygon& polygon = std::get<Polygon>(shape);
    const auto add_edge = [&](const Point& a, const Point& b) { add({a, b}, 0); };
    for_each_edge(polygon.outer, add_edge);
    for (const Ring& hole : polygon.holes) for_each_edge(hole, add_edge);
  }
}

template <FeatureSpace S>
void BandFeatures::find(const S& space, std::span<const MovingObstacle> observed, const Band& band,
                        double reach) {
  features_.clear();
  owners_.clear();
  near_.clear();
  first_near_.assign(1, 0);
  times_.assign(1, 0);
  across_.clear();
  Box window;
  for (std::size_t i = 0; i < band.poses.size(); ++i) {
    window.include(band.poses[i].position);
    if (i > 0) times_.push_back(times_.back() + band.intervals[i - 1]);
    across_.emplace_back(-std::sin(band.poses[i].heading), std::cos(band.poses[i].heading));
  }
  window = window.inflated(reach);
  space.for_each_feature(window, [&](const Segment& core, double radius) {
    features_.push_back({core, radius, Point::Zero()});
    owners_.push_back(0);
  });
  add_observed(observed, window);
  for (std::size_t i = 0; i < band.poses.size(); ++i) {
    const Point& p = band.poses[i].position;
    // The features of one obstacle follow one another.
    std::uint32_t owner = 0;
    bool in_owner = space.is_inside(p);
    for (std::uint32_t k = 0; k < features_.size(); ++k) {
      const Closest found = closest(features_[k], p, times_[i]);
      if (!(found.distance - features_[k].radius < reach)) continue;
      if (owners_[k] != owner) {
        owner = owners_[k];
        const MovingObstacle& obstacle = observed[owner - 1];
        const Polygon* polygon = std::get_if<Polygon>(&obstacle.shape);
        in_owner = polygon != nullptr &&
                   contains(*polygon, offset_along(p, -times_[i], obstacle.velocity));
      }
      const bool right = found.away.dot(across_[i]) > 0;
      near_.push_back({k, right, in_owner && features_[k].radius == 0});
    }
    first_near_.push_back(near_.size());
  }
}

inline std::array<SideDistance, 2> BandFeatures::distances(std::size_t pose, const Point& p) const {
  std::array<SideDistance, 2> result;
  for (std::size_t i = first_near_[pose]; i < first_near_[pose + 1]; ++i) {
    const Near& near = near_[i];
    const Feature& feature = features_[near.feature];
    const Closest found = closest(feature, p, times_[pose]);
    SideDistance& side = result[near.right ? 1 : 0];
    const double distance = (near.inside ? -found.distance : found.distance) - feature.radius;
    if (!(distance < side.distance)) continue;
    // On the obstacle itself any direction does: across the heading.
    const Point away = found.distance > 0 ? Point(found.away / found.distance) : across_[pose];
    side = {distance, near.inside ? Point(-away) : away};
  }
  return result;
}

}  // namespace tutavia::detail
