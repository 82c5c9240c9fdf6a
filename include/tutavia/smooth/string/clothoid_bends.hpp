// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"
#include "tutavia/smooth/string/widened_bend.hpp"

/// \file
/// SpiralBends: a string as bends around circles that were made larger, with spirals.

namespace tutavia::detail {

/// The bends of a taut string by number: each has a circle larger than the string's own by a
/// margin, and a shape between the two. Those that the string left are no longer in the list that
/// begins at bend 0.
class SpiralBends {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  struct Options {
    double margin;              ///< most by which a circle grows [m]
    double min_turning_radius;  ///< [m]
    bool has_beziers;           ///< cubic Bezier spirals in the place of clothoids
  };

  struct Bend {
    OrientedCircle core;  // as it was
    double turn;          // left positive [rad]
    double margin;        // [m]
    double radius;        // of the circle that the ways touch [m]
    std::size_t previous, next;
    bool is_stale = true;  // the way to the next bend, and the shape
    bool may_lift = true;
    TangentLine out{};  // the way to the next bend
    double wanted = 0;  // leg of the shape that would be taken if the ways were long enough
    BendShape shape{};
    int tries = 0;
  };

  /// \pre the curve is made of segments and arcs
  SpiralBends(const Curve& curve, const Options& options, double slack)
      : options_(options), slack_(slack) {
    take(curve);
  }

  Bend& operator[](std::size_t i) { return bends_[i]; }
  const Bend& operator[](std::size_t i) const { return bends_[i]; }
  OrientedCircle circle(std::size_t i) const {
    return {bends_[i].core.center, bends_[i].radius, bends_[i].core.side};
  }
  bool is_end(std::size_t i) const { return bends_[i].previous == none || bends_[i].next == none; }
  /// From the bend before.
  const TangentLine& way_to(std::size_t i) const { return bends_[bends_[i].previous].out; }
  /// The turn to the side that the circle is on [rad].
  double turn_magnitude(std::size_t i) const { return bends_[i].core.side * bends_[i].turn; }
  /// ClothoidSmoother::Spirals may come a little less near than the old circle, so that few looks
  /// prove them.
  WidenedBend widened(std::size_t i) const {
    const Bend& bend = bends_[i];
    return {circle(i), bend.core.radius, bend.core.radius + bend.margin / 64, bend.turn,
            options_.has_beziers};
  }
  BendShape shape(std::size_t i, double room) const {
    return widened(i).gentlest_shape(room, options_.min_turning_radius);
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
      if (turn_magnitude(i) < WidenedBend::widest_pair) {
        const double tangent = std::cos(turn_magnitude(i) / 2);
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

  /// Takes a bend out that the string has left.
  void lift(std::size_t i) {
    const Bend& bend = bends_[i];
    bends_[bend.previous].next = bend.next;
    bends_[bend.next].previous = bend.previous;
    make_stale(bend.previous);
    make_stale(bend.next);
  }

  /// How much of the way after bend i the bend `whose` may take, one of the two at its ends: what
  /// it wants if there is enough for both, else its share. Enough is left to have a direction.
  double room(std::size_t i, std::size_t whose) const {
    const double wanted = bends_[i].wanted + bends_[bends_[i].next].wanted;
    const double length = 0.99 * bends_[i].out.length;
    return wanted <= length ? bends_[whose].wanted : length * (bends_[whose].wanted / wanted);
  }

  /// Where the shape of a bend ends, and where it begins: there, where nothing is left of the way
  /// before it.
  Point last(std::size_t i) const {
    if (is_end(i)) return bends_[i].core.center;
    return offset_along(bends_[i].out.from, bends_[i].shape.leg, bends_[i].out.direction);
  }
  Point first(std::size_t i) const {
    if (is_end(i)) return bends_[i].core.center;
    const Point begin = offset_along(way_to(i).to, -bends_[i].shape.leg, way_to(i).direction);
    const Point end = last(bends_[i].previous);
    return distance(begin, end) <= slack_ ? end : begin;
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
                              {last(i), bend.out.direction}, slack_, visit);
  }

 private:
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
        if (!is_zero(direction)) {
          const double turn = turn_angle(direction, arc->start_direction());
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
      } else if (const Segment& way = *piece.get_if<Segment>(); way.length() > slack_) {
        const double turn = is_zero(direction) ? 0 : turn_angle(direction, way.start_direction());
        if (std::abs(turn) > 1e-6) add(way.a, 0, turn);
        direction = way.end_direction();
      }
    }
    add(curve.end(), 0, 0);
    for (std::size_t i = 1; i + 1 < bends_.size(); ++i) grow(i);
    bends_.front().margin = bends_.back().margin = 0;
  }

  Options options_;
  double slack_;
  std::vector<Bend> bends_;
  bool had_corner_ = false;  // before an arc, where there is no bend of its own
};

}  // namespace tutavia::detail
