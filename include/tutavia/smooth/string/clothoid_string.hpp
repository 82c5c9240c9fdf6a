// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/string/clothoid_bends.hpp"

/// \file
/// How the bends of a taut string become spirals.

namespace tutavia::detail {

/// A taut string whose circles are made larger by a margin each, so that there is room for spirals
/// between the straight ways and the old circles.
///
/// A bend that does not get its spirals proved gives up half its margin, and in the end all of it:
/// then it is an arc of the old circle. So do the bends at both ends of a way that is not proved.
/// When no margin is left the string is what it was.
template <ClearanceSpace S>
class ClothoidString {
 public:
  using Options = SpiralBends::Options;

  /// \pre the curve is made of segments and arcs
  ClothoidString(const S& space, const Curve& curve, const Options& options)
      : space_(space), options_(options), bends_(curve, options, space.distance_error_bound()) {}

  /// Makes the circles larger. Fails with `not_proved`, or what the budget says; then there is no
  /// curve.
  std::optional<Failure> widen(const Budget& budget) {
    while (true) {
      if (const auto exceeded = budget.exceeded()) {
        return Failure{.code = to_error(*exceeded), .detail = "while smoothing"};
      }
      const bool is_done = draw_ways() && draw_bends() && prove();
      if (failure_ || is_done) return failure_;
    }
  }

  /// Whether the string as it was kept the least turning radius.
  bool was_gentle() const { return bends_.was_gentle(); }
  Curve curve() const { return bends_.curve(); }

 private:
  static constexpr std::size_t none = SpiralBends::none;
  using Bend = SpiralBends::Bend;
  /// Margins below this part of the whole are not worth it.
  static constexpr double least_margin = 1.0 / 40;

  /// Takes margin from a bend. Returns whether it had any.
  bool shrink(std::size_t i) {
    Bend& bend = bends_[i];
    if (bends_.is_end(i) || bend.margin == 0) return false;
    bend.margin /= 2;
    if (bend.margin < least_margin * options_.margin) bend.margin = 0;
    bends_.grow(i);
    return true;
  }

  /// Makes room on the way after bend i, which is not free.
  void relax_edge(std::size_t i) {
    const std::size_t j = bends_[i].next;
    const bool is_back = bends_.unlift(i, j), gives = shrink(i), gives_too = shrink(j);
    if (!is_back && !gives && !gives_too) give_up(i);
  }
  /// Makes room at bend i, which is not free.
  void yield_bend(std::size_t i) {
    if (shrink(i)) return;
    const std::size_t before = bends_[i].previous, after = bends_[i].next;
    const bool is_back = bends_.unlift(before, i), is_back_too = bends_.unlift(i, after);
    const bool gives = shrink(before), gives_too = shrink(after);
    if (!is_back && !is_back_too && !gives && !gives_too) give_up(i);
  }

  void give_up(std::size_t i) {
    const Point& p = bends_[i].core.center;
    failure_ = Failure{.code = PlanError::not_proved,
                       .detail = "no bend that is gentle enough can be proved around (" +
                                 std::to_string(p.x()) + ", " + std::to_string(p.y()) + ")"};
  }

  /// The ways between the circles, and the turns around them. False: they have changed.
  bool draw_ways() {
    bool fits = true;
    for (std::size_t i = 0; bends_[i].next != none; i = bends_[i].next) {
      const std::size_t j = bends_[i].next;
      if (!bends_[i].is_stale && !bends_[j].is_stale) continue;
      if (const auto way = tangent_line(bends_.circle(i), bends_.circle(j))) {
        bends_[i].out = *way;
      } else {
        relax_edge(i);
        fits = false;
      }
    }
    if (!fits || failure_) return false;
    for (std::size_t i = bends_[0].next; bends_[i].next != none; i = bends_[i].next) {
      Bend& bend = bends_[i];
      if (!bend.is_stale) continue;
      const double turn = turn_angle(bends_.way_to(i).direction, bend.out.direction);
      bend.turn += std::remainder(turn - bend.turn, 2 * std::numbers::pi);
      if (bends_.turn_magnitude(i) > 1e-6 || (!bend.may_lift && bends_.turn_magnitude(i) > -1e-6))
        continue;
      fits = false;
      if (bend.may_lift) {  // the string has left this circle
        bends_.lift(i);
      } else {
        yield_bend(i);
      }
    }
    return fits;
  }

  /// The shapes of all bends. False: circles have changed.
  bool draw_bends() {
    for (std::size_t i = bends_[0].next; bends_[i].next != none; i = bends_[i].next) {
      if (!bends_[i].is_stale) continue;
      bends_[i].wanted = bends_.shape(i, std::numeric_limits<double>::infinity()).leg;
    }
    bool fits = true;
    for (std::size_t i = bends_[0].next; bends_[i].next != none; i = bends_[i].next) {
      Bend& bend = bends_[i];
      if (!bend.is_stale) continue;
      bend.shape = bends_.shape(i, std::min(bends_.room(bend.previous, i), bends_.room(i, i)));
      if (bend.shape.radius >= options_.min_turning_radius) continue;
      // Larger circles give gentler shapes, if the ways are long enough.
      if (bend.tries++ < 20) {
        bends_.grow(i);
      } else {
        yield_bend(i);
      }
      fits = false;
    }
    return fits;
  }
  /// Proves what is new. False: something is not proved, and circles have changed.
  bool prove() {
    blocked_bends_.clear();
    blocked_ways_.clear();
    for (std::size_t i = 0; i != none; i = bends_[i].next) {
      if (!bends_[i].is_stale) continue;
      bends_[i].is_stale = false;
      bool proved = true;
      bends_.for_each_piece(
          i, [&](const auto& piece) { proved = proved && is_proved_free(space_, piece); });
      if (!proved) blocked_bends_.push_back(i);
      if (!is_proved_free(space_, bends_.rest_of_way(i))) blocked_ways_.push_back(i);
    }
    for (const std::size_t i : blocked_bends_) yield_bend(i);
    for (const std::size_t i : blocked_ways_) relax_edge(i);
    return blocked_bends_.empty() && blocked_ways_.empty();
  }

  const S& space_;
  Options options_;
  SpiralBends bends_;
  std::optional<Failure> failure_;
  std::vector<std::size_t> blocked_bends_, blocked_ways_;
};

}  // namespace tutavia::detail
