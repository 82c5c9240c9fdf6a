// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/pose.hpp"
#include "tutavia/motion/drive/obstacle_distance.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// TrackedPath: a curve and how far a robot has come along it.

namespace tutavia::detail {

/// Errors: `invalid_input` for a path to follow that is empty, not finite, or longer than 10^6 m.
inline Expected<void, Failure> check_path(const Curve& path) {
  if (path.empty()) return fail(PlanError::invalid_input, "the path is empty");
  for (std::size_t i = 0; i < path.pieces().size(); ++i) {
    if (!path.pieces()[i].visit([](const auto& piece) { return piece.is_finite(); })) {
      return fail(PlanError::invalid_input, "pieces[" + std::to_string(i) + "] is not finite");
    }
  }
  if (!(path.length() <= 1e6)) {
    return fail(PlanError::invalid_input, "the path is longer than 1000000 m");
  }
  return {};
}

/// A curve with samples at equal steps, and the arc length up to which a robot has followed it.
/// After construction nothing allocates.
class TrackedPath {
 public:
  static constexpr double step = 0.1;  // between samples, at most [m]

  TrackedPath() = default;
  explicit TrackedPath(Curve curve) : curve_(std::move(curve)), samples_(curve_.sample(step)) {}

  bool empty() const { return samples_.empty(); }
  const Curve& curve() const { return curve_; }
  double length() const { return curve_.length(); }
  double progress() const { return progress_; }
  double remaining() const { return length() - progress_; }
  std::span<const CurvePoint> samples() const { return samples_; }
  /// The index of the first sample at arc length s or more.
  std::size_t sample_at(double s) const {
    const double spacing = samples_.size() > 1 ? length() / double(samples_.size() - 1) : 1;
    const double index = spacing > 0 ? std::ceil(s / spacing) : 0;
    return static_cast<std::size_t>(std::clamp(index, 0.0, double(samples_.size() - 1)));
  }
  /// The pose of the curve at arc length s, from the samples.
  const CurvePoint& near(double s) const { return samples_[sample_at(s)]; }

  /// Moves the progress to the sample nearest to `p`, and returns its distance. Looks from 0.3 m
  /// behind to 0.6 m ahead, and on while the path comes nearer: so the robot does not take a later
  /// part of the path for the present one where both pass nearby.
  double advance(const Point& p) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t last = sample_at(progress_ + 0.6);
    for (std::size_t i = sample_at(progress_ - 0.3); i <= last; ++i) {
      const double d = distance(p, samples_[i].position);
      if (!(d < least)) continue;
      least = d;
      progress_ = samples_[i].s;
      if (i == last && last + 1 < samples_.size()) ++last;
    }
    return least;
  }

  /// The arc length at which a robot that drives on at `speed` first comes nearer than `clearance`
  /// to an obstacle, within `ahead` metres; and the index of the obstacle.
  struct Block {
    double s;
    std::size_t obstacle;
  };
  std::optional<Block> first_block(std::span<const MovingObstacle> observed, double clearance,
                                   double speed, double ahead) const {
    std::optional<Block> first;
    const std::size_t begin = sample_at(progress_), end = sample_at(progress_ + ahead);
    for (std::size_t k = 0; k < observed.size(); ++k) {
      const MovingObstacle& obstacle = observed[k];
      const double drift = obstacle.velocity.norm() * ahead / speed;
      const Box box = box_of(obstacle.shape).inflated(clearance + drift);
      for (std::size_t i = begin; i <= end; ++i) {
        const CurvePoint& sample = samples_[i];
        if (first && sample.s >= first->s) break;
        if (!box.contains(sample.position)) continue;
        const double time = (sample.s - progress_) / speed;
        const Point q = offset_along(sample.position, -time, obstacle.velocity);
        if (distance_to(Segment{q, q}, obstacle.shape).distance < clearance) {
          first = {sample.s, k};
          break;
        }
      }
    }
    return first;
  }

 private:
  Curve curve_;
  std::vector<CurvePoint> samples_;
  double progress_ = 0;
};

}  // namespace tutavia::detail
