// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"

/// \file
/// StringBends: a string as a linked list of bends.

namespace tutavia::detail {

/// The circles that replace the bends between two others, A and C, and the tangent edges from A via
/// the circles to C.
struct Chain {
  std::vector<OrientedCircle> circles;
  std::vector<TangentLine> edges;

  /// The turn around a circle, left positive [rad].
  double turn(std::size_t i) const {
    return turn_angle(edges[i].direction, edges[i + 1].direction);
  }
};

inline bool same_circle(const OrientedCircle& a, const OrientedCircle& b) {
  return a.center == b.center && a.radius == b.radius;
}

/// Whether a string that turns by so much lies on a circle. A turn that may be rounding alone does
/// not lift it off.
inline bool lies_on(const OrientedCircle& circle, double turn) {
  return circle.side * turn >= -1e-12;
}

/// A string around pins (the path's own vertices) and circles, as a list of numbered bends. It
/// starts at bend 0 and ends at bend `last()`.
class StringBends {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  struct Bend {
    OrientedCircle circle;
    bool is_pin;
    double turn;      // around the circle, left positive; may exceed a full turn [rad]
    TangentLine out;  // to the next bend
    std::size_t previous, next;
  };

  /// A string along a polyline, pinned at every point.
  explicit StringBends(const std::vector<Point>& nodes) {
    bends_.reserve(2 * nodes.size());
    for (const Point& p : nodes) {
      if (!bends_.empty() && bends_.back().circle.center == p) continue;
      const std::size_t i = bends_.size();
      bends_.push_back({{p, 0, 1}, true, 0, {}, i == 0 ? none : i - 1, none});
      if (i == 0) continue;
      bends_[i - 1].next = i;
      // Stands for the tangent if the distance vanishes in rounding.
      const TangentLine nowhere{bends_[i - 1].circle.center, p, {1, 0}, 0};
      bends_[i - 1].out = tangent_line(bends_[i - 1].circle, bends_[i].circle).value_or(nowhere);
    }
    last_ = bends_.size() - 1;
  }

  std::size_t last() const { return last_; }
  const Bend& operator[](std::size_t i) const { return bends_[i]; }
  /// The edge from the previous bend.
  const TangentLine& edge_to(std::size_t i) const { return bends_[bends_[i].previous].out; }
  int side_of_turn(std::size_t i) const {
    const double turn =
        bends_[i].is_pin ? cross(edge_to(i).direction, bends_[i].out.direction) : bends_[i].turn;
    return turn >= 0 ? 1 : -1;
  }
  bool is_taut(std::size_t i) const {
    return !bends_[i].is_pin && lies_on(bends_[i].circle, bends_[i].turn);
  }

  Curve curve(double error_bound) const {
    Curve curve;
    Point at = bends_[0].circle.center;
    for (std::size_t i = 0; i != last_ && last_ != 0; i = bends_[i].next) {
      const Bend& bend = bends_[i];
      // A bend that turns by less than the construction's error has no arc.
      for_each_arc(bend.circle, at, bend.out.from, bend.turn, error_bound, [&](const Arc& arc) {
        curve.push_back(arc);
        at = arc.b;
      });
      curve.push_back(Segment{at, bend.out.to});
      at = bend.out.to;
    }
    if (curve.empty()) curve.push_back(Segment{at, at});
    return curve;
  }

  /// The turns of A and C if the chain is put between them.
  double turn_after(std::size_t a, const Chain& chain) const {
    return bends_[a].turn + turn_angle(bends_[a].out.direction, chain.edges.front().direction);
  }
  double turn_before(std::size_t c, const Chain& chain) const {
    return bends_[c].turn + turn_angle(chain.edges.back().direction, edge_to(c).direction);
  }

  /// Whether two bends are pins at one point, so that the string between them goes out and back.
  bool is_spur(std::size_t a, std::size_t c) const {
    return bends_[a].is_pin && bends_[c].is_pin && same_circle(bends_[a].circle, bends_[c].circle);
  }
  /// Removes everything between two such pins, and one of them. Returns the bend before the change.
  std::size_t close_spur(std::size_t a, std::size_t c) {
    if (c != last_) {
      bends_[a].out = bends_[c].out;
      link(a, bends_[c].next);
    } else if (a != 0) {
      a = bends_[a].previous;
      link(a, c);
    } else {
      last_ = 0;
      bends_[0].next = none;
    }
    return a;
  }

  /// Replaces everything between two bends by the chain, unless that makes the string longer.
  bool replace(std::size_t a, std::size_t c, const Chain& chain) {
    const double turn_a = bends_[a].is_pin ? 0 : turn_after(a, chain);
    const double turn_c = bends_[c].is_pin ? 0 : turn_before(c, chain);
    double before = length_around(c, bends_[c].turn);
    for (std::size_t i = a; i != c; i = bends_[i].next) {
      before += length_around(i, bends_[i].turn) + bends_[i].out.length;
    }
    double after = length_around(a, turn_a) + length_around(c, turn_c);
    for (const TangentLine& edge : chain.edges) after += edge.length;
    for (std::size_t i = 0; i < chain.circles.size(); ++i) {
      after += chain.circles[i].radius * std::abs(chain.turn(i));
    }
    // Each pull shortens the string or removes a bend, so pulling terminates.
    const double least = 1e-12 * before;
    if (!(after < before - least || (chain.circles.empty() && after <= before + least))) {
      return false;
    }
    bends_[a].turn = turn_a;
    bends_[c].turn = turn_c;
    bends_[a].out = chain.edges[0];
    for (std::size_t i = 0; i < chain.circles.size(); ++i) {
      bends_.push_back({chain.circles[i], false, chain.turn(i), chain.edges[i + 1], none, none});
      link(a, bends_.size() - 1);
      a = bends_.size() - 1;
    }
    link(a, c);
    return true;
  }

 private:
  void link(std::size_t i, std::size_t j) {
    bends_[i].next = j;
    bends_[j].previous = i;
  }
  double length_around(std::size_t i, double turn) const {
    return bends_[i].circle.radius * std::abs(turn);
  }

  std::vector<Bend> bends_;
  std::size_t last_ = 0;
};

}  // namespace tutavia::detail
