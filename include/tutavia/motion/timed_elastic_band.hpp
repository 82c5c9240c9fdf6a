// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/motion/band.hpp"
#include "tutavia/motion/band/band_solver.hpp"
#include "tutavia/motion/differential_drive.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// TimedElasticBand: a local trajectory by optimisation of poses and times.

namespace tutavia {

/// Why an optimisation ended.
enum class BandEnd : std::uint8_t {
  converged,        ///< the last round changed the cost by less than `tolerance`
  iteration_limit,  ///< it was still falling when the iterations were used up
  stalled,          ///< no step of the last round lowered the cost
};

constexpr std::string_view to_string(BandEnd end) {
  switch (end) {
    case BandEnd::converged:
      return "converged";
    case BandEnd::iteration_limit:
      return "iteration_limit";
    case BandEnd::stalled:
      return "stalled";
  }
  return "unknown";
}

/// The result of an optimisation, beside the band.
struct BandReport {
  BandCost before{};   ///< of the band that was given
  BandCost after{};    ///< of the band that was returned, never higher in total
  int iterations = 0;  ///< steps tried
  BandEnd end = BandEnd::iteration_limit;

  bool converged() const { return end == BandEnd::converged; }
};

/// What a band must do at its ends and on its way.
struct BandTask {
  Twist start{};                  ///< the robot's speed before the band
  std::optional<Twist> end{};     ///< its speed after the band; without one, any
  bool free_end_heading = false;  ///< the heading of the last pose may turn
  std::span<const Point> via{};   ///< points to pass near, in no particular order
};

/// A trajectory of poses and times between them for a robot with differential drive, by
/// Levenberg-Marquardt on a weighted sum of squares: length, time, and squared hinges for limits of
/// speed, angular speed and both accelerations, for the distance from obstacles, for motion across
/// the heading and for via points. First and last position are fixed.
///
/// Distances to polygons, discs and cells are exact; obstacles that move are taken where they will
/// be at the time of each pose. The nearest obstacle on either side of a pose counts. Times and
/// sides are found anew in every round (`rounds`), and poses are inserted and removed so that
/// intervals stay near `reference_interval`.
///
/// The cost never rises. That is all: the result is a local minimum of a sum of costs, in the
/// homotopy class of the initial band, and may break any limit or touch an obstacle. Only commands
/// that pass a MotionGate are safe.
///
/// Source: Roesmann, Feiten, Woesch, Hoffmann and Bertram 2012, "Trajectory modification
/// considering dynamic constraints of autonomous robots"; the printed equation (21) of the
/// JPS_Theta* paper rewards the greatest speed, and is corrected to hinges.
///
/// Example: examples/local_planning.cpp.
struct TimedElasticBand {
  static constexpr std::string_view name = "timed_elastic_band";
  using Scratch = detail::BandScratch;

  DriveLimits limits{};
  BandWeights weights{};
  double clearance = 0.5;           ///< below which an obstacle costs [m]
  double reference_interval = 0.3;  ///< [s]
  double hysteresis = 0.1;          ///< how far intervals may differ from it [s]
  int rounds = 4;                   ///< each finds obstacles and resizes the band
  int steps = 5;                    ///< of Levenberg-Marquardt in each round
  double tolerance = 1e-2;          ///< relative change of the cost at which to end
  std::size_t max_poses = 64;

  /// Errors: `invalid_option`, which names the option.
  Expected<void, Failure> validate() const;

  /// Lays a band along a curve from arc length `from` to `to`; its first pose is `start`.
  /// Reuses the memory of `band`. \pre the curve is not empty
  void lay(const Curve& path, double from, double to, const Pose& start, Band& band) const;

  /// Optimises a band in place. Allocates only to grow. Errors: `invalid_option`; `invalid_input`
  /// for a band of fewer than two poses, with numbers that are not finite, or with intervals that
  /// are not positive.
  template <FeatureSpace S>
  Expected<BandReport, Failure> optimize(const S& space, std::span<const MovingObstacle> observed,
                                         const BandTask& task, Band& band, Scratch& scratch) const;

  /// Inserts and removes poses so that intervals come near the reference. Returns whether it did.
  bool resize(Band& band) const;
};

/// The twist that takes a robot along the arc from a band's first pose to its second in the first
/// interval. \pre two poses or more
inline Twist first_twist(const Band& band) {
  const Pose &p = band.poses[0], &q = band.poses[1];
  const double time = band.intervals[0], half = 0.5 * (q.heading - p.heading);
  const Point d{q.position.x() - p.position.x(), q.position.y() - p.position.y()};
  const double mean = p.heading + half;
  const double chord = d.x() * std::cos(mean) + d.y() * std::sin(mean);
  const double stretch = std::abs(half) < 1e-4 ? 1 : half / std::sin(half);
  // Beyond half a turn the chord says nothing about the arc.
  const bool is_arc = std::abs(half) < 0.5 * std::numbers::pi;
  return {is_arc ? chord * stretch / time : 0, 2 * half / time};
}

inline Expected<void, Failure> TimedElasticBand::validate() const {
  if (auto valid = tutavia::validate(limits); !valid) return valid;
  const auto invalid = [](const char* rule) { return fail(PlanError::invalid_option, rule); };
  for (const double weight : {weights.length, weights.time, weights.speed, weights.angular_speed,
                              weights.acceleration, weights.angular_acceleration,
                              weights.non_holonomic, weights.clearance, weights.via_point}) {
    if (!(weight >= 0 && std::isfinite(weight)))
      return invalid("weights must be finite and not negative");
  }
  if (!(weights.time > 0)) return invalid("weights.time must be positive");
  if (!(clearance >= 0 && std::isfinite(clearance)))
    return invalid("clearance must be finite and not negative");
  if (!(reference_interval > 0 && std::isfinite(reference_interval)))
    return invalid("reference_interval must be positive and finite");
  if (!(hysteresis > 0 && hysteresis < reference_interval))
    return invalid("hysteresis must lie between 0 and reference_interval");
  if (rounds < 1 || steps < 1) return invalid("rounds and steps must be at least 1");
  if (!(tolerance >= 0)) return invalid("tolerance must not be negative");
  if (max_poses < 3 || max_poses > 100000)
    return invalid("max_poses must lie between 3 and 100000");
  return {};
}

inline void TimedElasticBand::lay(const Curve& path, double from, double to, const Pose& start,
                                  Band& band) const {
  band.poses.clear();
  band.intervals.clear();
  band.poses.reserve(max_poses + 1);
  band.intervals.reserve(max_poses + 1);
  band.poses.push_back(start);
  const double spacing = limits.max_speed * reference_interval;
  const auto count = static_cast<std::size_t>(
      std::clamp(std::ceil((to - from) / spacing), 2.0, static_cast<double>(max_poses - 1)));
  for (std::size_t i = 1; i <= count; ++i) {
    const CurvePoint at = path.at(from + (to - from) * double(i) / double(count));
    const Pose& before = band.poses.back();
    const double turn = std::remainder(at.heading - before.heading, 2 * std::numbers::pi);
    const double time =
        std::max({distance(before.position, at.position) / limits.max_speed,
                  std::abs(turn) / limits.max_angular_speed, 0.1 * reference_interval});
    band.intervals.push_back(time);
    band.poses.push_back({at.position, before.heading + turn});
  }
}

inline bool TimedElasticBand::resize(Band& band) const {
  bool changed = false;
  for (std::size_t i = 0; i < band.intervals.size();) {
    const double time = band.intervals[i];
    if (time > reference_interval + hysteresis && band.poses.size() < max_poses) {
      const Pose &p = band.poses[i], &q = band.poses[i + 1];
      const Pose middle{detail::lerp(p.position, q.position, 0.5), 0.5 * (p.heading + q.heading)};
      band.intervals[i] = 0.5 * time;
      band.intervals.insert(band.intervals.begin() + std::ptrdiff_t(i), 0.5 * time);
      band.poses.insert(band.poses.begin() + std::ptrdiff_t(i) + 1, middle);
      if (0.5 * time <= reference_interval + hysteresis) i += 2;
      changed = true;
    } else if (time < reference_interval - hysteresis && band.poses.size() > 3) {
      // With the next interval; the last one goes to that before it.
      const std::size_t first = i + 1 < band.intervals.size() ? i : i - 1;
      band.intervals[first] += band.intervals[first + 1];
      band.intervals.erase(band.intervals.begin() + std::ptrdiff_t(first) + 1);
      band.poses.erase(band.poses.begin() + std::ptrdiff_t(first) + 1);
      i = first + 1;
      changed = true;
    } else {
      ++i;
    }
  }
  return changed;
}

template <FeatureSpace S>
Expected<BandReport, Failure> TimedElasticBand::optimize(const S& space,
                                                         std::span<const MovingObstacle> observed,
                                                         const BandTask& task, Band& band,
                                                         Scratch& scratch) const {
  if (auto valid = validate(); !valid) return std::move(valid).unexpected();
  if (!detail::is_valid(band)) {
    return fail(PlanError::invalid_input,
                "a band needs two finite poses or more, and positive intervals between them");
  }
  detail::BandProblem problem{limits, weights, clearance, task.start, task.end, {}};
  detail::BandSolver solver(problem, task.via, task.free_end_heading, scratch);
  const double reach = 1.5 * clearance;
  const double shortest = 0.05 * reference_interval;
  BandReport report;
  Band &current = scratch.current, &best = scratch.best;
  current = band;
  best = band;
  solver.look_around(space, observed, current, reach);
  report.before = report.after = solver.cost(current);
  bool changed = false;
  for (double& interval : current.intervals) {
    changed = changed || interval < shortest;
    interval = std::max(interval, shortest);
  }
  for (int round = 0; round < rounds; ++round) {
    changed = resize(current) || changed;
    if (changed) solver.look_around(space, observed, current, reach);
    changed = false;
    const auto outcome = solver.descend(current, steps, shortest, tolerance);
    report.iterations += outcome.steps;
    solver.look_around(space, observed, current, reach);
    const BandCost now = solver.cost(current);
    const double change = report.after.total() - now.total();
    if (change > 0) {
      report.after = now;
      best = current;
    }
    report.end = outcome.stalled ? BandEnd::stalled : BandEnd::iteration_limit;
    if (outcome.settled && std::abs(change) <= tolerance * report.after.total()) {
      report.end = BandEnd::converged;
      break;
    }
  }
  band = best;
  return report;
}

}  // namespace tutavia
