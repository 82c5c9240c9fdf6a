// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "tutavia/geometry/pose.hpp"
#include "tutavia/geometry/steering_word.hpp"
#include "tutavia/geometry/tangent/reeds_shepp_words.hpp"
#include "tutavia/geometry/tangent/turning_circles.hpp"
#include "tutavia/geometry/vehicle_path.hpp"

/// \file
/// reeds_shepp_word, reeds_shepp_length and reeds_shepp_path: the shortest drive between two poses,
/// forwards and backwards.

namespace tutavia {

namespace detail {

/// Finds the length of the shortest word.
struct ReedsSheppLength {
  double least = std::numeric_limits<double>::infinity();

  double limit() const { return least; }
  template <class Make>
  void operator()(double length, const Make&) {
    least = length;
  }
};

/// Finds the shortest word, and the first one in case of a tie.
struct ShortestReedsSheppWord {
  double least = std::numeric_limits<double>::infinity();
  SteeringWord word{};

  double limit() const { return (1 - steering_tie) * least; }
  template <class Make>
  void operator()(double length, const Make& make) {
    least = length;
    word = make();
  }
};

/// Visits all words.
template <class Visit>
struct AllReedsSheppWords {
  Visit& visit;

  static double limit() { return std::numeric_limits<double>::infinity(); }
  template <class Make>
  void operator()(double, const Make& make) {
    const SteeringWord word = make();
    visit(word);
  }
};

}  // namespace detail

/// Calls `visit(word)` for every one of the 48 words of Reeds and Shepp that leads from one pose to
/// the other with turns of `radius` [m]. The order is fixed: the families CSC, CCC, CCCC, CCSC,
/// CSCC and CCSCC, and within a family first turns to the left before those to the right. Turns
/// have at most half a circle, as those of shortest drives have. Words that share a path, because
/// moves have length 0, are all visited.
///
/// Source: Reeds and Shepp 1990, "Optimal paths for a car that goes both forwards and backwards",
/// section 8; here the formulas are derived from the centres of the turning circles.
/// \pre the poses are finite, radius > 0
template <class Visit>
void for_each_reeds_shepp_word(const Pose& from, const Pose& to, double radius, Visit visit) {
  detail::AllReedsSheppWords<Visit> found{visit};
  detail::find_reeds_shepp_words(from, to, radius, found);
}

/// The shortest drive from one pose to another, forwards and backwards, with turns of at least
/// `radius` [m]. Of words whose lengths differ by less than 1e-10 of themselves, the first in the
/// order of `for_each_reeds_shepp_word` is taken, so that rounding does not choose.
/// \pre the poses are finite, radius > 0
inline SteeringWord reeds_shepp_word(const Pose& from, const Pose& to, double radius) {
  detail::ShortestReedsSheppWord found;
  detail::find_reeds_shepp_words(from, to, radius, found);
  return found.word;
}

/// The length of the shortest drive [m]: that of `reeds_shepp_word`, or up to 1e-10 of it less.
/// \pre the poses are finite, radius > 0
inline double reeds_shepp_length(const Pose& from, const Pose& to, double radius) {
  detail::ReedsSheppLength found;
  detail::find_reeds_shepp_words(from, to, radius, found);
  return radius * found.least;
}

/// The path of `reeds_shepp_word`. \pre the poses are finite, radius > 0
inline VehiclePath reeds_shepp_path(const Pose& from, const Pose& to, double radius) {
  return vehicle_path(reeds_shepp_word(from, to, radius), from, to, radius);
}

}  // namespace tutavia
