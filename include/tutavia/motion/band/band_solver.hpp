// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "tutavia/motion/band/band_features.hpp"
#include "tutavia/motion/band/band_residuals.hpp"
#include "tutavia/motion/band/block_cholesky.hpp"

/// \file
/// BandSolver: Levenberg-Marquardt on a band.

namespace tutavia::detail {

/// Whether a band has two poses or more, finite, and positive intervals between them.
inline bool is_valid(const Band& band) {
  return band.poses.size() >= 2 && band.intervals.size() + 1 == band.poses.size() &&
         std::all_of(band.poses.begin(), band.poses.end(),
                     [](const Pose& p) { return p.is_finite(); }) &&
         std::all_of(band.intervals.begin(), band.intervals.end(),
                     [](double t) { return t > 0 && std::isfinite(t); });
}

/// The memory of an optimisation.
struct BandScratch {
  BandFeatures features;
  BlockSystem system;
  std::vector<ViaPoint> vias;
  Band current, best, trial;
};

/// Lowers the cost of a band whose obstacles and times are frozen. The variables of block i are
/// pose i + 1 and the logarithm of the interval that leads to it, which cannot become negative.
class BandSolver {
 public:
  /// What became of a descent.
  struct Outcome {
    int steps = 0;
    bool settled = false;  // the next step would change the cost by no more than the tolerance
    bool stalled = false;  // no step lowered it
  };

  BandSolver(BandProblem& problem, std::span<const Point> via, bool free_end_heading,
             BandScratch& scratch)
      : problem_(problem), via_(via), free_end_heading_(free_end_heading), scratch_(scratch) {}

  /// Finds obstacles, times, and the pose nearest to each via point.
  template <FeatureSpace S>
  void look_around(const S& space, std::span<const MovingObstacle> observed, const Band& band,
                   double reach) {
    scratch_.features.find(space, observed, band, reach);
    scratch_.vias.clear();
    for (const Point& point : via_) {
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < band.poses.size(); ++i) {
        if (distance(point, band.poses[i].position) < distance(point, band.poses[nearest].position))
          nearest = i;
      }
      scratch_.vias.push_back({nearest, point});
    }
    problem_.vias = scratch_.vias;
  }

  BandCost cost(const Band& band) const {
    BandCost cost;
    BandResiduals(problem_, scratch_.features, band)
        .for_each([&](BandTerm term, std::size_t, double residual, const auto&) {
          cost[term] += residual * residual;
        });
    return cost;
  }

  /// At most `steps` steps; intervals stay above `shortest`.
  Outcome descend(Band& band, int steps, double shortest, double tolerance);

 private:
  /// The normal equations at a band.
  void linearize(const Band& band);
  void hold_end();
  /// By how much the solution lowers the cost where the residuals are linear.
  double expected_gain() const;
  /// The band after a step.
  void step(const Band& band, double shortest, Band& result) const;

  BandProblem& problem_;
  std::span<const Point> via_;
  bool free_end_heading_;
  BandScratch& scratch_;
  double damping_ = 1e-3;  // of Levenberg and Marquardt, kept from round to round
};

inline void BandSolver::linearize(const Band& band) {
  const std::size_t blocks = band.intervals.size();
  BlockSystem& system = scratch_.system;
  system.reset(blocks);
  const auto in_logarithm = [&](const BandResiduals::Gradient& gradient, std::size_t k,
                                std::size_t i) {
    BlockSystem::Vector part = gradient.segment<4>(4 * std::ptrdiff_t(k));
    part[3] *= band.intervals[i + k - 1];
    return part;
  };
  const auto add = [&](BandTerm term, std::size_t i, double residual,
                       const BandResiduals::Gradient& gradient) {
    const bool changes_speed =
        term == BandTerm::acceleration || term == BandTerm::angular_acceleration;
    const bool is_position = term == BandTerm::clearance || term == BandTerm::via_point;
    const std::size_t count = is_position ? 1 : changes_speed ? 3 : 2;
    // Pose i + k belongs to block i + k - 1; the first pose is fixed.
    for (std::size_t a = i == 0 ? 1 : 0; a < count && i + a <= blocks; ++a) {
      const BlockSystem::Vector at_a = in_logarithm(gradient, a, i);
      system.right(i + a - 1) -= residual * at_a;
      for (std::size_t b = a; b < count && i + b <= blocks; ++b) {
        system.at(i + a - 1, i + b - 1).noalias() +=
            at_a * in_logarithm(gradient, b, i).transpose();
      }
    }
  };
  BandResiduals(problem_, scratch_.features, band).for_each(add);
  for (std::size_t i = 0; i < blocks; ++i) system.at(i, i).diagonal().array() += 1e-6;
  hold_end();
}

inline void BandSolver::hold_end() {
  BlockSystem& system = scratch_.system;
  const std::size_t last = system.blocks() - 1;
  for (int k = 0; k < (free_end_heading_ ? 2 : 3); ++k) {
    system.at(last, last).row(k).setZero();
    system.at(last, last).col(k).setZero();
    system.at(last, last)(k, k) = 1;
    system.right(last)[k] = 0;
    if (last >= 1) system.at(last - 1, last).col(k).setZero();
    if (last >= 2) system.at(last - 2, last).col(k).setZero();
  }
}

inline void BandSolver::step(const Band& band, double shortest, Band& result) const {
  result = band;
  for (std::size_t i = 0; i < band.intervals.size(); ++i) {
    const BlockSystem::Vector& d = scratch_.system.solution(i);
    Pose& pose = result.poses[i + 1];
    pose.position = {pose.position.x() + d[0], pose.position.y() + d[1]};
    pose.heading += d[2];
    result.intervals[i] =
        std::max(shortest, result.intervals[i] * std::exp(std::clamp(d[3], -0.7, 0.7)));
  }
}

inline double BandSolver::expected_gain() const {
  double gain = 0;
  for (std::size_t i = 0; i < scratch_.system.blocks(); ++i) {
    gain += scratch_.system.solution(i).dot(scratch_.system.right(i));
  }
  return gain;
}

inline BandSolver::Outcome BandSolver::descend(Band& band, int steps, double shortest,
                                               double tolerance) {
  Outcome outcome;
  double cost_now = cost(band).total();
  bool fresh = true, lowered = false;
  for (; outcome.steps < steps; ++outcome.steps) {
    if (fresh) linearize(band);
    fresh = false;
    if (scratch_.system.solve(damping_)) {
      if (expected_gain() <= tolerance * cost_now) {
        outcome.settled = true;
        return outcome;
      }
      step(band, shortest, scratch_.trial);
      const double next = cost(scratch_.trial).total();
      if (next < cost_now) {  // false for NaN, too
        cost_now = next;
        std::swap(band, scratch_.trial);
        damping_ = std::max(1e-9, 0.1 * damping_);
        fresh = lowered = true;
        continue;
      }
    }
    damping_ *= 10;
  }
  outcome.stalled = !lowered;
  return outcome;
}

}  // namespace tutavia::detail
