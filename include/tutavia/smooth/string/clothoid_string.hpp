// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
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
#include "tutavia/smooth/string/widened_bend.hpp"

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
class SpiralString {
 public:
  struct Options {
    double margin;              ///< most by which a circle grows [m]
    double min_turning_radius;  ///< [m]
    bool has_beziers;           ///< cubic Bezier spirals in the place of clothoids
  };

  /// \pre the curve is made of segments and arcs
  SpiralString(const S& space, const Curve& curve, const Options& options)
      : space_(space), options_(options) {
    take(curve);
  }

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
  bool was_gentle() const {
    if (had_corner_ && options_.min_turning_radius > 0) return false;
    return std::all_of(bends_.begin(), bends_.end(), [&](const Bend& bend) {
      return bend.turn == 0 || bend.core.radius >= options_.min_turning_radius;
    });
  }

  Curve curve() const {
    Curve curve;
    for (std::size_t i = 0; i != none; i = bends_[i].next) {
      for_each_piece(i, [&](const auto& piece) { curve.push_back(piece); });
      if (const Segment rest = rest_of_way(i); rest.a != rest.b) curve.push_back(rest);
    }
    if (curve.empty()) curve.push_back(Segment{bends_[0].core.center, bends_[0].core.center});
    return curve;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  /// Margins below this part of the whole are not worth it.
  static constexpr double least_margin = 1.0 / 40;
  struct Bend {
    SidedCircle core;  // as it was
    double turn;       // left positive [rad]
    double margin;     // [m]
    double radius;     // of the circle that the ways touch [m]
    std::size_t previous, next;
    bool is_stale = true;  // the way to the next bend, and the shape
    bool may_lift = true;
    Bitangent out{};    // the way to the next bend
    double wanted = 0;  // leg of the shape that would be taken if the ways were long enough
    BendShape shape{};
    int tries = 0;
  };

  SidedCircle circle(std::size_t i) const {
    return {bends_[i].core.center, bends_[i].radius, bends_[i].core.side};
  }
  bool is_end(std::size_t i) const { return bends_[i].previous == none || bends_[i].next == none; }
  const Bitangent& way_to(std::size_t i) const { return bends_[bends_[i].previous].out; }
  double wrap(std::size_t i) const { return bends_[i].core.side * bends_[i].turn; }
  /// Spirals may come a little less near than the old circle, so that few looks prove them.
  WidenedBend widened(std::size_t i) const {
    const Bend& bend = bends_[i];
    return {circle(i), bend.core.radius, bend.core.radius + bend.margin / 64, bend.turn,
            options_.has_beziers};
  }
  BendShape shape(std::size_t i, double room) const {
    return widened(i).gentlest_shape(room, options_.min_turning_radius);
  }

  void add(const Point& center, double radius, double turn) {
    const std::size_t i = bends_.size();
    if (i > 0) bends_.back().next = i;
    bends_.push_back({.core = {center, radius, turn >= 0 ? 1 : -1},
                      .turn = turn,
                      .margin = options_.margin,
                      .radius = radius,
                      .previous = i == 0 ? none : i - 1,
                      .next = none});
  }

  /// Takes the string apart: arcs become bends around their centres, other joints bends around
  /// themselves.
  void take(const Curve& curve) {
    add(curve.start(), 0, 0);
    Point direction = Point::Zero();
    for (const Piece& piece : curve.pieces()) {
      if (const Arc* arc = piece.get_if<Arc>()) {
        if (!is_null(direction)) {
          const double turn = deflection(direction, arc->start_direction());
          had_corner_ = had_corner_ || std::abs(turn) > 1e-6;
        }
        const Bend& last = bends_.back();
        const bool goes_on = bends_.size() > 1 && last.core.center == arc->center &&
                             last.core.radius == arc->radius && last.turn * arc->sweep > 0;
        if (goes_on) {
          bends_.back().turn += arc->sweep;
        } else {
          add(arc->center, arc->radius, arc->sweep);
        }
        direction = arc->end_direction();
      } else if (const Segment& way = *piece.get_if<Segment>(); way.length() > space_.slack()) {
        const double turn = is_null(direction) ? 0 : deflection(direction, way.start_direction());
        if (std::abs(turn) > 1e-6) add(way.a, 0, turn);
        direction = way.end_direction();
      }
    }
    add(curve.end(), 0, 0);
    for (std::size_t i = 1; i + 1 < bends_.size(); ++i) grow(i);
    bends_.front().margin = bends_.back().margin = 0;
  }

  /// Sets a bend's circle to what its margin and the least turning radius ask for.
  void grow(std::size_t i) {
    Bend& bend = bends_[i];
    bend.radius = bend.core.radius + bend.margin;
    const double least = options_.min_turning_radius;
    if (least > bend.core.radius) {
      // The smaller of two circles: one on which an arc of that radius has room for its spirals,
      // and one that a pair of them touches the old circle with.
      double wanted = least + bend.margin;
      const WidenedBend before = widened(i);
      if (wrap(i) < WidenedBend::widest_pair) {
        const double tangent = std::cos(wrap(i) / 2);
        const double with_pair = (least * before.unit_pair().drop + before.inner_radius) * tangent;
        wanted = std::min(wanted, with_pair * (1 + 1e-3));
      }
      bend.radius = std::max(bend.radius, wanted);
    }
    make_stale(i);
  }

  /// A bend's place decides the ways to both sides, so the turns of the bends next to it, so how
  /// much the bends beyond may take of the ways between, and so what is left of the next ways.
  void make_stale(std::size_t i) {
    std::size_t at = i;
    int count = 4;  // the bend and three after it, and three before
    for (; count < 7 && bends_[at].previous != none; ++count) at = bends_[at].previous;
    for (; count > 0 && at != none; --count, at = bends_[at].next) bends_[at].is_stale = true;
  }

  /// Takes margin from a bend. Returns whether it had any.
  bool shrink(std::size_t i) {
    Bend& bend = bends_[i];
    if (is_end(i) || bend.margin == 0) return false;
    bend.margin /= 2;
    if (bend.margin < least_margin * options_.margin) bend.margin = 0;
    grow(i);
    return true;
  }

  /// Makes room on the way after bend i, which is not free.
  void yield_way(std::size_t i) {
    const std::size_t j = bends_[i].next;
    const bool is_back = unlift(i, j), gives = shrink(i), gives_too = shrink(j);
    if (!is_back && !gives && !gives_too) give_up(i);
  }
  /// Makes room at bend i, which is not free.
  void yield_bend(std::size_t i) {
    if (shrink(i)) return;
    const std::size_t before = bends_[i].previous, after = bends_[i].next;
    const bool is_back = unlift(before, i), is_back_too = unlift(i, after);
    const bool gives = shrink(before), gives_too = shrink(after);
    if (!is_back && !is_back_too && !gives && !gives_too) give_up(i);
  }

  void give_up(std::size_t i) {
    const Point& p = bends_[i].core.center;
    failure_ = Failure{.code = PlanError::not_proved,
                       .detail = "no bend that is gentle enough can be proved around (" +
                                 std::to_string(p.x()) + ", " + std::to_string(p.y()) + ")"};
  }

  /// Puts back the bends between two others that the string had left. Returns whether there were
  /// any.
  bool unlift(std::size_t i, std::size_t j) {
    if (j == i + 1) return false;
    for (std::size_t k = i + 1; k <= j; ++k) {
      bends_[k - 1].next = k;
      bends_[k].previous = k - 1;
    }
    for (std::size_t k = i + 1; k < j; ++k) {
      bends_[k].may_lift = false;
      bends_[k].margin = 0;
      grow(k);
    }
    return true;
  }

  /// The ways between the circles, and the turns around them. False: they have changed.
  bool draw_ways() {
    bool fits = true;
    for (std::size_t i = 0; bends_[i].next != none; i = bends_[i].next) {
      const std::size_t j = bends_[i].next;
      if (!bends_[i].is_stale && !bends_[j].is_stale) continue;
      if (const auto way = bitangent(circle(i), circle(j))) {
        bends_[i].out = *way;
      } else {
        yield_way(i);
        fits = false;
      }
    }
    if (!fits || failure_) return false;
    for (std::size_t i = bends_[0].next; bends_[i].next != none; i = bends_[i].next) {
      Bend& bend = bends_[i];
      if (!bend.is_stale) continue;
      const double turn = deflection(way_to(i).direction, bend.out.direction);
      bend.turn += std::remainder(turn - bend.turn, 2 * std::numbers::pi);
      if (wrap(i) > 1e-6 || (!bend.may_lift && wrap(i) > -1e-6)) continue;
      fits = false;
      if (bend.may_lift) {  // the string has left this circle
        bends_[bend.previous].next = bend.next;
        bends_[bend.next].previous = bend.previous;
        make_stale(bend.previous);
        make_stale(bend.next);
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
      bends_[i].wanted = shape(i, std::numeric_limits<double>::infinity()).leg;
    }
    bool fits = true;
    for (std::size_t i = bends_[0].next; bends_[i].next != none; i = bends_[i].next) {
      Bend& bend = bends_[i];
      if (!bend.is_stale) continue;
      bend.shape = shape(i, std::min(room(bend.previous, i), room(i, i)));
      if (bend.shape.radius >= options_.min_turning_radius) continue;
      // Larger circles give gentler shapes, if the ways are long enough.
      if (bend.tries++ < 20) {
        grow(i);
      } else {
        yield_bend(i);
      }
      fits = false;
    }
    return fits;
  }
  /// How much of the way after bend i the bend `whose` may take, one of the two at its ends: what
  /// it wants if there is enough for both, else its share. Enough is left to have a direction.
  double room(std::size_t i, std::size_t whose) const {
    const double wanted = bends_[i].wanted + bends_[bends_[i].next].wanted;
    const double length = 0.99 * bends_[i].out.length;
    return wanted <= length ? bends_[whose].wanted : length * (bends_[whose].wanted / wanted);
  }

  /// Proves what is new. False: something is not proved, and circles have changed.
  bool prove() {
    blocked_bends_.clear();
    blocked_ways_.clear();
    for (std::size_t i = 0; i != none; i = bends_[i].next) {
      if (!bends_[i].is_stale) continue;
      bends_[i].is_stale = false;
      bool proved = true;
      for_each_piece(i,
                     [&](const auto& piece) { proved = proved && is_proved_free(space_, piece); });
      if (!proved) blocked_bends_.push_back(i);
      if (!is_proved_free(space_, rest_of_way(i))) blocked_ways_.push_back(i);
    }
    for (const std::size_t i : blocked_bends_) yield_bend(i);
    for (const std::size_t i : blocked_ways_) yield_way(i);
    return blocked_bends_.empty() && blocked_ways_.empty();
  }

  /// Where the shape of a bend ends, and where it begins: there, where nothing is left of the way
  /// before it.
  Point last(std::size_t i) const {
    if (is_end(i)) return bends_[i].core.center;
    return advance(bends_[i].out.from, bends_[i].shape.leg, bends_[i].out.direction);
  }
  Point first(std::size_t i) const {
    if (is_end(i)) return bends_[i].core.center;
    const Point begin = advance(way_to(i).to, -bends_[i].shape.leg, way_to(i).direction);
    const Point end = last(bends_[i].previous);
    return distance(begin, end) <= space_.slack() ? end : begin;
  }
  /// What the bends at its ends leave of the way after bend i.
  Segment rest_of_way(std::size_t i) const {
    const std::size_t j = bends_[i].next;
    return {last(i), j == none ? last(i) : first(j)};
  }

  template <class Visit>
  void for_each_piece(std::size_t i, Visit visit) const {
    if (is_end(i)) return;
    const Bend& bend = bends_[i];
    widened(i).for_each_piece(bend.shape, {first(i), way_to(i).direction},
                              {last(i), bend.out.direction}, space_.slack(), visit);
  }

  const S& space_;
  Options options_;
  std::vector<Bend> bends_;
  bool had_corner_ = false;  // before an arc, where there is no bend of its own
  std::optional<Failure> failure_;
  std::vector<std::size_t> blocked_bends_, blocked_ways_;
};

}  // namespace tutavia::detail
