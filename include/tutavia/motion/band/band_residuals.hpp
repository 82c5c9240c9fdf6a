// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "tutavia/motion/band.hpp"
#include "tutavia/motion/band/band_features.hpp"
#include "tutavia/motion/differential_drive.hpp"

/// \file
/// BandResiduals: the terms of a band's cost as squared residuals, with their gradients.

namespace tutavia::detail {

/// A pose of the band that is drawn towards a point.
struct ViaPoint {
  std::size_t pose;
  Point point;
};

/// What a band must do, beside avoiding obstacles.
struct BandProblem {
  DriveLimits limits;
  BandWeights weights;
  double clearance = 0;      // from obstacles [m]
  Twist start;               // before the first interval
  std::optional<Twist> end;  // after the last one, if the band must come to it
  std::span<const ViaPoint> vias;
};

/// The residuals of a band. Each belongs to three steps of variables: to the poses i, i + 1 and
/// i + 2, and the intervals that lead to them, i - 1, i and i + 1. Its gradient has x, y, heading
/// and interval of each. Times and nearest obstacles are frozen in `features`.
///
/// Source: Roesmann, Feiten, Woesch, Hoffmann and Bertram 2012, "Trajectory modification
/// considering dynamic constraints of autonomous robots"; every limit is a squared hinge.
class BandResiduals {
 public:
  using Gradient = Eigen::Matrix<double, 12, 1>;

  BandResiduals(const BandProblem& problem, const BandFeatures& features, const Band& band)
      : problem_(problem), features_(features), band_(band) {}

  /// Calls `visit(term, i, residual, gradient)` for every residual. That of an obstacle that is
  /// far enough is left out.
  template <class Visit>
  void for_each(Visit visit) const;

 private:
  // Where the variables of pose i + k stand in a gradient, and the interval that leads to it.
  static constexpr int x(int k) { return 4 * k; }
  static constexpr int y(int k) { return 4 * k + 1; }
  static constexpr int heading(int k) { return 4 * k + 2; }
  static constexpr int interval(int k) { return 4 * k + 3; }

  /// The weight of a limit that is not reached, relative to one that is exceeded.
  static constexpr double stiffness = 0.3;

  /// A quantity with its gradient.
  struct Value {
    double value = 0;
    Gradient gradient = Gradient::Zero();
  };

  /// The speed from pose i + k to the next one, along the mean heading.
  Value speed(std::size_t i, int k) const;
  /// The angular speed from pose i + k to the next one.
  Value angular_speed(std::size_t i, int k) const;
  /// The change of a speed from `before` to `after` per time. The interval is 0 for the ends.
  static Value acceleration(const Value& before, const Value& after, double time, int first,
                            int second);

  template <class Visit>
  void visit_step(std::size_t i, Visit& visit) const;
  template <class Visit>
  void visit_accelerations(std::size_t i, Visit& visit) const;
  template <class Visit>
  void visit_ends(Visit& visit) const;
  template <class Visit>
  void visit_position(std::size_t i, Visit& visit) const;

  /// The part of a value above `most` or below `least`, weighted. Within its limits the residual is
  /// 0, but its gradient stays, smaller: it stiffens the step, which would otherwise run far beyond
  /// limits that it cannot see (docs/decisions/0013).
  template <class Visit>
  static void visit_hinge(BandTerm term, std::size_t i, Value value, double least, double most,
                          double weight, Visit& visit) {
    // A band is laid at its limits: rounding must not decide which of them are exceeded.
    constexpr double rounding = 1e-9;
    const double beyond = value.value > most + rounding    ? value.value - most
                          : value.value < least - rounding ? value.value - least
                                                           : 0;
    const double root = std::sqrt(beyond == 0 ? stiffness * weight : weight);
    value.gradient *= root;
    visit(term, i, root * beyond, value.gradient);
  }

  const BandProblem& problem_;
  const BandFeatures& features_;
  const Band& band_;
};

inline BandResiduals::Value BandResiduals::speed(std::size_t i, int k) const {
  const auto j = i + static_cast<std::size_t>(k);
  const Pose &p = band_.poses[j], &q = band_.poses[j + 1];
  const double dt = band_.intervals[j], mean = 0.5 * (p.heading + q.heading);
  const double c = std::cos(mean), s = std::sin(mean);
  const double dx = q.position.x() - p.position.x(), dy = q.position.y() - p.position.y();
  Value result;
  result.value = (dx * c + dy * s) / dt;
  result.gradient[x(k)] = -c / dt;
  result.gradient[y(k)] = -s / dt;
  result.gradient[x(k + 1)] = c / dt;
  result.gradient[y(k + 1)] = s / dt;
  const double turned = 0.5 * (dy * c - dx * s) / dt;
  result.gradient[heading(k)] = turned;
  result.gradient[heading(k + 1)] = turned;
  result.gradient[interval(k + 1)] = -result.value / dt;
  return result;
}

inline BandResiduals::Value BandResiduals::angular_speed(std::size_t i, int k) const {
  const auto j = i + static_cast<std::size_t>(k);
  const double dt = band_.intervals[j];
  Value result;
  result.value = (band_.poses[j + 1].heading - band_.poses[j].heading) / dt;
  result.gradient[heading(k)] = -1 / dt;
  result.gradient[heading(k + 1)] = 1 / dt;
  result.gradient[interval(k + 1)] = -result.value / dt;
  return result;
}

inline BandResiduals::Value BandResiduals::acceleration(const Value& before, const Value& after,
                                                        double time, int first, int second) {
  Value result{(after.value - before.value) / time, (after.gradient - before.gradient) / time};
  // The time is the mean of two intervals, or one of them.
  const double share = first == second ? 1 : 0.5;
  result.gradient[interval(first)] -= share * result.value / time;
  if (first != second) result.gradient[interval(second)] -= share * result.value / time;
  return result;
}

template <class Visit>
void BandResiduals::visit_step(std::size_t i, Visit& visit) const {
  const BandWeights& weights = problem_.weights;
  const DriveLimits& limits = problem_.limits;
  const Pose &p = band_.poses[i], &q = band_.poses[i + 1];
  const double dx = q.position.x() - p.position.x(), dy = q.position.y() - p.position.y();
  const auto visit_linear = [&](BandTerm term, double weight, double value, auto... entries) {
    const double root = std::sqrt(weight);
    Gradient gradient = Gradient::Zero();
    ((gradient[entries.first] = root * entries.second), ...);
    visit(term, i, root * value, gradient);
  };
  using Entry = std::pair<int, double>;
  visit_linear(BandTerm::length, weights.length, dx, Entry{x(0), -1.0}, Entry{x(1), 1.0});
  visit_linear(BandTerm::length, weights.length, dy, Entry{y(0), -1.0}, Entry{y(1), 1.0});
  visit_linear(BandTerm::time, weights.time, band_.intervals[i], Entry{interval(1), 1.0});
  // Both headings form the same angle with the chord of an arc.
  const double cp = std::cos(p.heading), sp = std::sin(p.heading);
  const double cq = std::cos(q.heading), sq = std::sin(q.heading);
  visit_linear(BandTerm::non_holonomic, weights.non_holonomic, (cp + cq) * dy - (sp + sq) * dx,
               Entry{x(0), sp + sq}, Entry{y(0), -cp - cq}, Entry{x(1), -sp - sq},
               Entry{y(1), cp + cq}, Entry{heading(0), -sp * dy - cp * dx},
               Entry{heading(1), -sq * dy - cq * dx});
  visit_hinge(BandTerm::speed, i, speed(i, 0), -limits.max_backward_speed, limits.max_speed,
              weights.speed, visit);
  visit_hinge(BandTerm::angular_speed, i, angular_speed(i, 0), -limits.max_angular_speed,
              limits.max_angular_speed, weights.angular_speed, visit);
}

template <class Visit>
void BandResiduals::visit_accelerations(std::size_t i, Visit& visit) const {
  const DriveLimits& limits = problem_.limits;
  const double time = 0.5 * (band_.intervals[i] + band_.intervals[i + 1]);
  visit_hinge(BandTerm::acceleration, i, acceleration(speed(i, 0), speed(i, 1), time, 1, 2),
              -limits.max_acceleration, limits.max_acceleration, problem_.weights.acceleration,
              visit);
  visit_hinge(BandTerm::angular_acceleration, i,
              acceleration(angular_speed(i, 0), angular_speed(i, 1), time, 1, 2),
              -limits.max_angular_acceleration, limits.max_angular_acceleration,
              problem_.weights.angular_acceleration, visit);
}

template <class Visit>
void BandResiduals::visit_ends(Visit& visit) const {
  const DriveLimits& limits = problem_.limits;
  const auto visit_both = [&](std::size_t i, const Value& before, const Value& after,
                              const Value& turn_before, const Value& turn_after) {
    const double time = band_.intervals[i];
    visit_hinge(BandTerm::acceleration, i, acceleration(before, after, time, 1, 1),
                -limits.max_acceleration, limits.max_acceleration, problem_.weights.acceleration,
                visit);
    visit_hinge(BandTerm::angular_acceleration, i,
                acceleration(turn_before, turn_after, time, 1, 1), -limits.max_angular_acceleration,
                limits.max_angular_acceleration, problem_.weights.angular_acceleration, visit);
  };
  const auto constant = [](double value) {
    Value result;
    result.value = value;
    return result;
  };
  visit_both(0, constant(problem_.start.v), speed(0, 0), constant(problem_.start.omega),
             angular_speed(0, 0));
  if (!problem_.end) return;
  const std::size_t last = band_.intervals.size() - 1;
  visit_both(last, speed(last, 0), constant(problem_.end->v), angular_speed(last, 0),
             constant(problem_.end->omega));
}

template <class Visit>
void BandResiduals::visit_position(std::size_t i, Visit& visit) const {
  const double root = std::sqrt(problem_.weights.clearance);
  for (const SideDistance& side : features_.distances(i, band_.poses[i].position)) {
    const double lack = problem_.clearance - side.distance;
    if (!(lack > 0)) continue;
    Gradient gradient = Gradient::Zero();
    gradient[x(0)] = -root * side.gradient.x();
    gradient[y(0)] = -root * side.gradient.y();
    visit(BandTerm::clearance, i, root * lack, gradient);
  }
}

template <class Visit>
void BandResiduals::for_each(Visit visit) const {
  const std::size_t steps = band_.intervals.size();
  for (std::size_t i = 0; i < steps; ++i) {
    visit_step(i, visit);
    if (i + 1 < steps) visit_accelerations(i, visit);
    if (i > 0) visit_position(i, visit);
  }
  visit_ends(visit);
  const double root = std::sqrt(problem_.weights.via_point);
  for (const ViaPoint& via : problem_.vias) {
    for (int axis = 0; axis < 2; ++axis) {
      Gradient gradient = Gradient::Zero();
      gradient[axis == 0 ? x(0) : y(0)] = root;
      visit(BandTerm::via_point, via.pose,
            root * (band_.poses[via.pose].position[axis] - via.point[axis]), gradient);
    }
  }
}

}  // namespace tutavia::detail
