// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tutavia/geometry/pose.hpp"
#include "tutavia/geometry/steering_word.hpp"
#include "tutavia/geometry/tangent/turning_circles.hpp"

/// \file
/// ReedsSheppWords: the formulas of the 48 words of Reeds and Shepp.

namespace tutavia::detail {

/// The words of Reeds and Shepp between two poses, family by family. `found.limit()` is the length
/// from which on words are of no interest; `found(length, make)` receives the others, as a function
/// that makes the word.
///
/// Every formula is written for a first turn to the left, with the sign s of its gear: reflecting
/// is the side, and flipping time is s. The names t and v are the angles of the first and the last
/// turn, as changes of heading to the left and to the side of that turn.
template <class Found>
class ReedsSheppWords {
 public:
  ReedsSheppWords(const TurningCircles& circles, Found& found) : circles_(circles), found_(found) {}

  /// All 48 words, in one order.
  void visit() {
    each([this](const Side& side, double s) { turn_straight_turn(side, s); });
    each([this](const Side& side, double s) { turn_straight_counterturn(side, s); });
    each([this](const Side& side, double s) { three_turns(side, s); });
    each([this](const Side& side, double s) { four_turns_one_cusp(side, s); });
    each([this](const Side& side, double s) { four_turns_two_cusps(side, s); });
    each([this](const Side& side, double s) { quarter_then_straight(side, s); });
    each([this](const Side& side, double s) { straight_then_quarter(side, s); });
    each([this](const Side& side, double s) { straight_between_quarters(side, s); });
  }

 private:
  using Side = TurningCircles::Side;
  static constexpr double pi = std::numbers::pi;
  static constexpr Steering left = Steering::left, right = Steering::right;
  static constexpr Steering straight = Steering::straight;

  /// A turn with a sign: forwards or in reverse.
  struct Turn {
    Steering steering;
    double sign;
    double angle;  ///< of any number of circles
  };

  template <class Family>
  void each(Family family) {
    for (const Side& side : circles_.sides) {
      family(side, 1);
      family(side, -1);
    }
  }

  template <class... Moves>
  void offer(const Side& side, const Turn& first, const Turn& last, const Moves&... middle) {
    add(side, first.steering, first.sign * left_turn(first.sign * first.angle), last.steering,
        last.sign * left_turn(last.sign * last.angle), middle...);
  }

  /// Reports a word, unless one of its turns is longer than half a circle.
  template <class... Moves>
  void add(const Side& side, Steering first, double t, Steering last, double v,
           const Moves&... middle) {
    if (std::max(std::abs(t), std::abs(v)) > pi + steering_rounding) return;
    const double length = (std::abs(t) + ... + std::abs(middle.length)) + std::abs(v);
    if (!(length < found_.limit())) return;
    found_(length, [&] {
      SteeringWord word;
      for (const SteeringMove& move : {SteeringMove{first, t}, middle..., SteeringMove{last, v}}) {
        const int steering = static_cast<int>(move.steering);
        word.push_back(
            {side.mirror > 0 ? move.steering : static_cast<Steering>(-steering), move.length});
      }
      return word;
    });
  }

  /// Whether a word with these moves in the middle may be short enough: its other two turns have to
  /// bring what the middle leaves of the change of heading. `slack` is what rounding takes off it.
  template <class... Moves>
  bool is_promising(const Side& side, double slack, const Moves&... middle) const {
    const double rest = std::abs(side.turn - (0.0 + ... + middle.turn()));
    const double bound = (std::min(rest, 2 * pi - rest) + ... + std::abs(middle.length));
    return bound - slack < found_.limit();
  }

  /// L+S+L+ (8.1).
  void turn_straight_turn(const Side& side, double s) {
    const auto& [distance, excess, first, last] = side.same;
    const double around = s > 0 ? 0 : pi;
    if (!is_promising(side, 4 * circles_.rounding, SteeringMove{straight, distance})) return;
    const auto [t, u, v] = around_one_side(s * (first + around), distance, s * (last - around),
                                           s * side.turn, circles_);
    add(side, left, s * t, left, s * v, SteeringMove{straight, s * u});
  }

  /// L+S+R+ (8.2).
  void turn_straight_counterturn(const Side& side, double s) {
    const auto& [distance, excess, first, last] = side.opposite;
    if (excess < -4 * circles_.rounding) return;
    const double length = std::sqrt(std::max(excess, 0.0));
    if (!is_promising(side, 4 * circles_.turn_rounding, SteeringMove{straight, length})) return;
    const double slope = std::atan2(2, s * length);
    const auto [t, u, v] =
        around_both_sides(s * (first + slope), length, s * (last + slope), circles_);
    add(side, left, s * t, right, s * v, SteeringMove{straight, s * u});
  }

  /// L+R-L+, L+R-L- and L-R-L+ (8.3 and 8.4): for either sign of the second turn, the first and the
  /// last have any signs, but not both that of the second.
  void three_turns(const Side& side, double s) {
    const auto& [distance, excess, first, last] = side.same;
    if (distance > 4 + circles_.rounding) return;
    const double half = std::asin(std::min(distance / 4, 1.0));
    const SteeringMove middle{right, -2 * s * half};
    if (!is_promising(side, steering_rounding, middle)) return;
    const double slope = s > 0 ? pi - half : half;
    offer(side, {left, s, first + slope}, {left, s, last + slope}, middle);
    offer(side, {left, s, first + slope}, {left, -s, last + slope}, middle);
    offer(side, {left, -s, first + slope}, {left, s, last + slope}, middle);
  }

  /// L+R+L-R- with second and third turns of one length u (8.7): cos u = (2 + distance) / 4.
  void four_turns_one_cusp(const Side& side, double s) {
    const auto& [distance, excess, first, last] = side.opposite;
    if (excess > 0) return;
    const double u = 2 * std::asin(std::sqrt(-excess / (8 * (2 + distance))));
    const SteeringMove second{right, s * u}, third{left, -s * u};
    if (!is_promising(side, steering_rounding, second, third)) return;
    offer(side, {left, s, first + pi / 2 + s * u}, {right, -s, last + pi / 2 - s * u}, second,
          third);
  }

  /// L+R-L-R+ with second and third turns of one length u, at most a quarter of a circle (8.8):
  /// cos u = (20 - distance^2) / 16.
  void four_turns_two_cusps(const Side& side, double s) {
    const auto& [distance, excess, first, last] = side.opposite;
    if (excess < 0 || excess > 16 * (1 + circles_.rounding)) return;
    const double u = 2 * std::asin(std::sqrt(excess / 32));
    const SteeringMove second{right, -s * u}, third{left, -s * u};
    if (!is_promising(side, steering_rounding, second, third)) return;
    const double slope = pi / 2 + s * std::atan2(std::sin(u), 2 - std::cos(u));
    offer(side, {left, s, first + slope}, {right, s, last + slope}, second, third);
  }

  /// L+R-S-L- and L+R-S-R-, with a quarter of a circle second (8.9 and 8.10).
  void quarter_then_straight(const Side& side, double s) {
    const SteeringMove quarter{right, -s * pi / 2};
    const SteeringMove beside{straight, -s * straight_beside(side.same.excess, 2)};
    if (s * beside.length <= 0 && is_promising(side, steering_rounding, quarter, beside)) {
      const auto& [distance, excess, first, last] = side.same;
      const double slope = pi / 2 + s * std::atan2(2, 2 - s * beside.length);
      offer(side, {left, s, first + slope}, {left, -s, last - slope - s * pi / 2}, quarter, beside);
    }
    const SteeringMove across{straight, -s * straight_across(side.opposite.distance)};
    if (s * across.length <= 0 && is_promising(side, steering_rounding, quarter, across)) {
      const auto& [distance, excess, first, last] = side.opposite;
      offer(side, {left, s, first + pi / 2}, {right, -s, last + pi / 2 + s * pi / 2}, quarter,
            across);
    }
  }

  /// L-S-R-L+ and L-S-L-R+, with a quarter of a circle third: words of the last family, driven from
  /// their end.
  void straight_then_quarter(const Side& side, double s) {
    const SteeringMove counter{right, -s * pi / 2}, quarter{left, -s * pi / 2};
    const SteeringMove beside{straight, -s * straight_beside(side.same.excess, 2)};
    if (s * beside.length <= 0 && is_promising(side, steering_rounding, beside, counter)) {
      const auto& [distance, excess, first, last] = side.same;
      const double slope = std::atan2(2, beside.length - 2 * s);
      offer(side, {left, -s, first + slope}, {left, s, last - slope - s * pi / 2}, beside, counter);
    }
    const SteeringMove across{straight, -s * straight_across(side.opposite.distance)};
    if (s * across.length <= 0 && is_promising(side, steering_rounding, across, quarter)) {
      const auto& [distance, excess, first, last] = side.opposite;
      const double around = s > 0 ? pi : 0;
      offer(side, {left, -s, first + around}, {right, s, last + around - s * pi / 2}, across,
            quarter);
    }
  }

  /// L+R-S-L-R+, with quarters of a circle second and fourth (8.11).
  void straight_between_quarters(const Side& side, double s) {
    const auto& [distance, excess, first, last] = side.opposite;
    const SteeringMove second{right, -s * pi / 2}, fourth{left, -s * pi / 2};
    const SteeringMove third{straight, -s * straight_beside(excess, 4)};
    if (s * third.length > 0 || !is_promising(side, steering_rounding, second, third, fourth)) {
      return;
    }
    const double slope = pi / 2 + s * std::atan2(2, 4 - s * third.length);
    offer(side, {left, s, first + slope}, {right, s, last + slope}, second, third, fourth);
  }

  /// The straight move of a word whose circles lie side by side, 2 apart, and along it by the
  /// result and `quarters`, that quarters of a circle take. Negative if there is none.
  double straight_beside(double excess, double quarters) const {
    return excess < 0 ? -1 : without_rounding(std::sqrt(excess) - quarters);
  }
  /// The same for circles in one line with it.
  double straight_across(double distance) const { return without_rounding(distance - 2); }
  double without_rounding(double length) const {
    return length < -circles_.rounding ? -1 : std::max(length, 0.0);
  }

  const TurningCircles& circles_;
  Found& found_;
};

template <class Found>
void find_reeds_shepp_words(const Pose& from, const Pose& to, double radius, Found& found) {
  ReedsSheppWords<Found>(TurningCircles::at(from, to, radius), found).visit();
}

}  // namespace tutavia::detail
