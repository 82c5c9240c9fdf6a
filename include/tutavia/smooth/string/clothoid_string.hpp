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
/// ClothoidString: turns the bends of a taut string into spirals.

namespace tutavia::detail {

/// A taut string whose circles are enlarged by a margin each, which makes room for spirals between
/// the straight edges and the original circles.
///
/// If the spirals of a bend cannot be proved, its margin is halved, and in the end set to 0: the
/// bend is then an arc of the original circle. If an edge cannot be proved, the same happens to the
/// bends at both its ends. With all margins 0 the string is the original one.
template <ClearanceSpace S>
class ClothoidString {
 public:
  using Options = SpiralBends::Options;

  /// \pre the curve is made of segments and arcs
  ClothoidString(const S& space, const Curve& curve, const Options& options)
      : space_(space), options_(options), bends_(curve, options, space.distance_error_bound()) {}

  /// Enlarges the circles. Errors: `not_proved`; those of the budget. After an error there is no
  /// curve.
  Expected<void, Failure> widen(const Budget& budget) {
    while (true) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
      const bool is_done = update_edges() && update_shapes() && prove();
      if (!result_ || is_done) return result_;
    }
  }

  /// Whether the original string kept the least turning radius.
  bool was_gentle() const { return bends_.was_gentle(); }
  Curve curve() const { return bends_.curve(); }

 private:
  static constexpr std::size_t none = SpiralBends::none;
  using Bend = SpiralBends::Bend;
  /// Margins below this fraction of the whole are set to 0.
  static constexpr double least_margin = 1.0 / 40;

  /// Halves the margin of a bend. Returns whether it had any.
  bool shrink(std::size_t i) {
    Bend& bend = bends_[i];
    if (bends_.is_end(i) || bend.margin == 0) return false;
    bend.margin /= 2;
    if (bend.margin < least_margin * options_.margin) bend.margin = 0;
    bends_.grow(i);
    return true;
  }

  /// Makes room for the edge after bend i, which is not free.
  void relax_edge(std::size_t i) {
    const std::size_t j = bends_[i].next;
    const bool is_back = bends_.restore(i, j), gives = shrink(i), gives_too = shrink(j);
    if (!is_back && !gives && !gives_too) give_up(i);
  }
  /// Makes room for bend i, which is not free.
  void relax_bend(std::size_t i) {
    if (shrink(i)) return;
    const std::size_t before = bends_[i].previous, after = bends_[i].next;
    const bool is_back = bends_.restore(before, i), is_back_too = bends_.restore(i, after);
    const bool gives = shrink(before), gives_too = shrink(after);
    if (!is_back && !is_back_too && !gives && !gives_too) give_up(i);
  }

  void give_up(std::size_t i) {
    result_ = fail(PlanError::not_proved, "no bend that is gentle enough can be proved around " +
                                              to_text(bends_[i].core.center));
  }

  /// Computes the edges between the circles and the turns around them. Returns false if circles
  /// have changed.
  bool update_edges() {
    bool fits = true;
    for (std::size_t i = 0; bends_[i].next != none; i = bends_[i].next) {
      const std::size_t j = bends_[i].next;
      if (!bends_[i].is_stale && !bends_[j].is_stale) continue;
      if (const auto edge = tangent_line(bends_.circle(i), bends_.circle(j))) {
        bends_[i].out = *edge;
      } else {
        relax_edge(i);
        fits = false;
      }
    }
    if (!fits || !result_) return false;
    for (std::size_t i = bends_[0].next; bends_[i].next != none; i = bends_[i].next) {
      Bend& bend = bends_[i];
      if (!bend.is_stale) continue;
      const double turn = turn_angle(bends_.edge_to(i).direction, bend.out.direction);
      bend.turn += std::remainder(turn - bend.turn, 2 * std::numbers::pi);
      if (bends_.turn_magnitude(i) > 1e-6 || (!bend.may_lift && bends_.turn_magnitude(i) > -1e-6))
        continue;
      fits = false;
      if (bend.may_lift) {  // the string has lifted off this circle
        bends_.lift(i);
      } else {
        relax_bend(i);
      }
    }
    return fits;
  }

  /// Computes the shapes of all bends. Returns false if circles have changed.
  bool update_shapes() {
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
      // Larger circles give gentler shapes if the edges are long enough.
      if (bend.tries++ < 20) {
        bends_.grow(i);
      } else {
        relax_bend(i);
      }
      fits = false;
    }
    return fits;
  }
  /// Proves all new pieces. Returns false if one is not proved; circles have then changed.
  bool prove() {
    blocked_bends_.clear();
    blocked_edges_.clear();
    for (std::size_t i = 0; i != none; i = bends_[i].next) {
      if (!bends_[i].is_stale) continue;
      bends_[i].is_stale = false;
      bool proved = true;
      bends_.for_each_piece(
          i, [&](const auto& piece) { proved = proved && is_proved_free(space_, piece); });
      if (!proved) blocked_bends_.push_back(i);
      if (!is_proved_free(space_, bends_.rest_of_edge(i))) blocked_edges_.push_back(i);
    }
    for (const std::size_t i : blocked_bends_) relax_bend(i);
    for (const std::size_t i : blocked_edges_) relax_edge(i);
    return blocked_bends_.empty() && blocked_edges_.empty();
  }

  const S& space_;
  Options options_;
  SpiralBends bends_;
  Expected<void, Failure> result_;  // why the string cannot be widened, if it cannot
  std::vector<std::size_t> blocked_bends_, blocked_edges_;
};

}  // namespace tutavia::detail
