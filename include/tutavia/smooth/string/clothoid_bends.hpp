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
/// SpiralBends: a taut string as bends around enlarged circles, shaped by spirals.

namespace tutavia::detail {

/// The numbered bends of a taut string. Each has a circle larger than the string's own by a margin,
/// and a shape between the two circles. Bends from which the string has lifted off are not in the
/// linked list that starts at bend 0.
class SpiralBends {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  struct Options {
    double margin;              ///< largest growth of a circle [m]
    double min_turning_radius;  ///< [m]
    bool has_beziers;           ///< cubic Bezier spirals instead of clothoids
  };

  struct Bend {
    OrientedCircle core;  // the original circle
    double turn;          // left positive [rad]
    double margin;        // [m]
    double radius;        // of the enlarged circle, which the edges touch [m]
    std::size_t previous, next;
    bool is_stale = true;  // whether the next edge and the shape are outdated
    bool may_lift = true;
    TangentLine out{};  // the edge to the next bend
    double wanted = 0;  // leg of the shape if the edges were long enough
    BendShape shape{};
    int tries = 0;
  };

  /// \pre the curve is made of segments and arcs
  SpiralBends(const Curve& curve, const Options& options, double error_bound)
      : options_(options), error_bound_(error_bound) {
    split(curve);
  }

  Bend& operator[](std::size_t i) { return bends_[i]; }
  const Bend& operator[](std::size_t i) const { return bends_[i]; }
  OrientedCircle circle(std::size_t i) const {
    return {bends_[i].core.center, bends_[i].radius, bends_[i].core.side};
  }
  bool is_end(std::size_t i) const { return bends_[i].previous == none || bends_[i].next == none; }
  /// The edge from the previous bend.
  const TangentLine& edge_to(std::size_t i) const { return bends_[bends_[i].previous].out; }
  /// The turn towards the side of the circle [rad].
  double turn_magnitude(std::size_t i) const { return bends_[i].core.side * bends_[i].turn; }
  /// Spirals may come slightly closer than the original circle, so that few evaluations prove them.
  WidenedBend widened(std::size_t i) const {
    const Bend& bend = bends_[i];
    return {circle(i), bend.core.radius, bend.core.radius + bend.margin / 64, bend.turn,
            options_.has_beziers};
  }
  BendShape shape(std::size_t i, double room) const {
    return widened(i).gentlest_shape(room, options_.min_turning_radius);
  }

  /// Whether the original string kept the least turning radius.
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
      if (const Segment rest = rest_of_edge(i); rest.a != rest.b) curve.push_back(rest);
    }
    if (curve.empty()) curve.push_back(Segment{bends_[0].core.center, bends_[0].core.center});
    return curve;
  }

  /// Sets a bend's circle from its margin and the least turning radius.
  void grow(std::size_t i) {
    Bend& bend = bends_[i];
    bend.radius = bend.core.radius + bend.margin;
    const double least = options_.min_turning_radius;
    if (least > bend.core.radius) {
      // The smaller of two circles: one on which an arc of that radius leaves room for its spirals,
      // and one whose spiral pair touches the original circle.
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

  /// A bend's circle determines the edges on both sides, hence the turns of the adjacent bends,
  /// hence how much the bends beyond may take of the edges between, hence the rests of the next
  /// edges.
  void make_stale(std::size_t i) {
    std::size_t at = i;
    int count = 4;  // the bend and three after it, and three before
    for (; count < 7 && bends_[at].previous != none; ++count) at = bends_[at].previous;
    for (; count > 0 && at != none; --count, at = bends_[at].next) bends_[at].is_stale = true;
  }

  /// Restores the bends between two others from which the string had lifted off. Returns whether
  /// there were any.
  bool restore(std::size_t i, std::size_t j) {
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

  /// Removes a bend from which the string has lifted off.
  void lift(std::size_t i) {
    const Bend& bend = bends_[i];
    bends_[bend.previous].next = bend.next;
    bends_[bend.next].previous = bend.previous;
    make_stale(bend.previous);
    make_stale(bend.next);
  }

  /// The share of the edge after bend i that the bend `whose`, at one of its ends, may take: its
  /// wanted leg if there is enough for both, else a proportional share. A little is left over to
  /// keep the edge's direction.
  double room(std::size_t i, std::size_t whose) const {
    const double wanted = bends_[i].wanted + bends_[bends_[i].next].wanted;
    const double length = 0.99 * bends_[i].out.length;
    return wanted <= length ? bends_[whose].wanted : length * (bends_[whose].wanted / wanted);
  }

  /// The end of a bend's shape, and its start. The start is the previous shape's end if nothing is
  /// left of the edge between them.
  Point last(std::size_t i) const {
    if (is_end(i)) return bends_[i].core.center;
    return offset_along(bends_[i].out.from, bends_[i].shape.leg, bends_[i].out.direction);
  }
  Point first(std::size_t i) const {
    if (is_end(i)) return bends_[i].core.center;
    const Point begin = offset_along(edge_to(i).to, -bends_[i].shape.leg, edge_to(i).direction);
    const Point end = last(bends_[i].previous);
    return distance(begin, end) <= error_bound_ ? end : begin;
  }
  /// The rest of the edge after bend i between the shapes at its ends.
  Segment rest_of_edge(std::size_t i) const {
    const std::size_t j = bends_[i].next;
    return {last(i), j == none ? last(i) : first(j)};
  }

  template <class Visit>
  void for_each_piece(std::size_t i, Visit visit) const {
    if (is_end(i)) return;
    const Bend& bend = bends_[i];
    widened(i).for_each_piece(bend.shape, {first(i), edge_to(i).direction},
                              {last(i), bend.out.direction}, error_bound_, visit);
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

  /// Splits the string into bends: arcs become bends around their centres, other corners bends
  /// around themselves.
  void split(const Curve& curve) {
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
      } else if (const Segment& segment = *piece.get_if<Segment>();
                 segment.length() > error_bound_) {
        const double turn =
            is_zero(direction) ? 0 : turn_angle(direction, segment.start_direction());
        if (std::abs(turn) > 1e-6) add(segment.a, 0, turn);
        direction = segment.end_direction();
      }
    }
    add(curve.end(), 0, 0);
    for (std::size_t i = 1; i + 1 < bends_.size(); ++i) grow(i);
    bends_.front().margin = bends_.back().margin = 0;
  }

  Options options_;
  double error_bound_;
  std::vector<Bend> bends_;
  bool had_corner_ = false;  // at an arc's start, where there is no bend
};

}  // namespace tutavia::detail
