// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "tutavia/geometry/pose.hpp"
#include "tutavia/geometry/steering_word.hpp"
#include "tutavia/geometry/tangent/turning_circles.hpp"
#include "tutavia/geometry/vehicle_path.hpp"

/// \file
/// dubins_word and dubins_path: the shortest drive forwards between two poses.

namespace tutavia {

namespace detail {

/// Calls `visit(word)` for the Dubins words that begin with a turn to one side: LSL, LSR and LRL,
/// or their mirror images. t, u and v are the lengths of the three moves.
template <class Visit>
void for_each_dubins_word(const TurningCircles& circles, const TurningCircles::Side& side,
                          Visit visit) {
  constexpr double pi = std::numbers::pi;
  const Steering near = side.mirror > 0 ? Steering::left : Steering::right;
  const Steering far = side.mirror > 0 ? Steering::right : Steering::left;
  const auto offer = [&](double t, const SteeringMove& middle, const Steering& last, double v) {
    SteeringWord word;
    word.push_back({near, t});
    word.push_back(middle);
    word.push_back({last, v});
    visit(word);
  };
  const TurningCircles::Between& same = side.same;
  const TurningCircles::Between& opposite = side.opposite;
  const auto one = around_one_side(same.first, same.distance, same.last, side.turn, circles);
  offer(one.first, {Steering::straight, one.straight}, near, one.last);
  if (opposite.excess >= -4 * circles.rounding) {
    const double u = std::sqrt(std::fmax(opposite.excess, 0.0)), slope = std::atan2(2, u);
    const auto both = around_both_sides(opposite.first + slope, u, opposite.last + slope, circles);
    offer(both.first, {Steering::straight, both.straight}, far, both.last);
  }
  if (same.distance <= 4 + circles.rounding) {
    const double slope = pi - std::asin(std::fmin(same.distance / 4, 1.0));
    offer(left_turn(same.first + slope), {far, 2 * slope}, near, left_turn(same.last + slope));
  }
}

}  // namespace detail

/// The shortest drive forwards from one pose to another with turns of at least `radius` [m] (Dubins
/// 1957, "On curves of minimal length with a constraint on average curvature"; Shkel and Lumelsky
/// 2001, "Classification of the Dubins set"). Of words whose lengths differ by less than 1e-10 of
/// themselves, the first of LSL, LSR, LRL, RSR, RSL and RLR is taken: rounding does not choose.
/// \pre the poses are finite, radius > 0
inline SteeringWord dubins_word(const Pose& from, const Pose& to, double radius) {
  const auto circles = detail::TurningCircles::at(from, to, radius);
  SteeringWord best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& side : circles.sides) {
    detail::for_each_dubins_word(circles, side, [&](const SteeringWord& word) {
      const double length = word.length();
      if (!(length < (1 - detail::steering_tie) * least)) return;
      least = length;
      best = word;
    });
  }
  return best;
}

/// The path of `dubins_word`. \pre the poses are finite, radius > 0
inline VehiclePath dubins_path(const Pose& from, const Pose& to, double radius) {
  return vehicle_path(dubins_word(from, to, radius), from, to, radius);
}

}  // namespace tutavia
