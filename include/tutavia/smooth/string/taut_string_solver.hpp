// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/geometry/tangent/oriented_box.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/space/index/passing_radius.hpp"

/// \file
/// How a string is pulled taut.

namespace tutavia::detail {

/// A string along a polyline that is pulled tight bend by bend and stays proved throughout.
///
/// Bends are pins (the path's own joints) and circles of the safety radius around obstacle vertices
/// (around discs: larger ones). A bend that is not taut is taken out: the string between its
/// neighbours A and C then runs straight, or around the circles that lie in the way.
template <FeatureSpace S>
class PulledString {
 public:
  PulledString(const S& space, const std::vector<Point>& nodes, const Budget& budget)
      : space_(space), budget_(budget), slack_(space.slack()), radius_(passing_radius(space, 0)) {
    bends_.reserve(2 * nodes.size());
    for (const Point& p : nodes) {
      if (!bends_.empty() && bends_.back().circle.center == p) continue;
      const std::size_t i = bends_.size();
      bends_.push_back({{p, 0, 1}, true, 0, {}, i == 0 ? none : i - 1, none});
      if (i == 0) continue;
      bends_[i - 1].next = i;
      // None between points whose distance vanishes in rounding.
      const Bitangent nowhere{bends_[i - 1].circle.center, p, {1, 0}, 0};
      bends_[i - 1].out = bitangent(bends_[i - 1].circle, bends_[i].circle).value_or(nowhere);
    }
    last_ = bends_.size() - 1;
  }

  /// Pulls until every bend is taut or cannot be pulled in a proved way.
  std::optional<PlanError> pull() {
    for (std::size_t b = bends_[0].next; b != none && b != last_;) {
      if (const auto exceeded = budget_.exceeded()) return to_error(*exceeded);
      const std::optional<std::size_t> before = is_taut(b) ? std::nullopt : take_out(b);
      b = !before ? bends_[b].next : *before == 0 ? bends_[0].next : *before;
    }
    return std::nullopt;
  }

  Curve curve() const {
    Curve curve;
    Point at = bends_[0].circle.center;
    for (std::size_t i = 0; i != last_ && last_ != 0; i = bends_[i].next) {
      const Bend& bend = bends_[i];
      // Within the allowance of its construction a bend that hardly turns has no arc.
      for_each_arc(bend.circle, at, bend.out.from, bend.turn, slack_, [&](const Arc& arc) {
        curve.push_back(arc);
        at = arc.b;
      });
      curve.push_back(Segment{at, bend.out.to});
      at = bend.out.to;
    }
    if (curve.empty()) curve.push_back(Segment{at, at});
    return curve;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  struct Bend {
    SidedCircle circle;
    bool is_pin;
    double turn;    // around the circle, left positive; may exceed a full turn [rad]
    Bitangent out;  // to the next bend
    std::size_t previous, next;
  };
  /// The circles that take a bend's place, and the ways from A to the first ... and on to C.
  struct Chain {
    std::vector<SidedCircle> circles;
    std::vector<Bitangent> ways;
  };

  const Bitangent& way_to(std::size_t i) const { return bends_[bends_[i].previous].out; }
  int side_of_turn(std::size_t i) const {
    const double turn =
        bends_[i].is_pin ? cross(way_to(i).direction, bends_[i].out.direction) : bends_[i].turn;
    return turn >= 0 ? 1 : -1;
  }
  bool is_taut(std::size_t i) const {
    return !bends_[i].is_pin && bends_[i].turn * bends_[i].circle.side >= 0;
  }
  static bool is_same(const SidedCircle& a, const SidedCircle& b) {
    return a.center == b.center && a.radius == b.radius;
  }

  /// Takes a bend out, if what replaces it is proved and no longer; with it the neighbours that the
  /// string then lifts off. Returns the bend before what is new.
  std::optional<std::size_t> take_out(std::size_t b) {
    std::size_t a = bends_[b].previous, c = bends_[b].next;
    if (bends_[a].is_pin && bends_[c].is_pin && is_same(bends_[a].circle, bends_[c].circle)) {
      return close_spur(a, c);
    }
    const int side = side_of_turn(b);
    find_obstacles(a, c, side);
    for (int proofs = 0; proofs < 8;) {
      if (!wrap(a, c, side)) break;
      if (add_barring(a, c)) continue;
      const bool lifts_a = !bends_[a].is_pin && bends_[a].circle.side * turn_after(a) < 0;
      const bool lifts_c = !bends_[c].is_pin && bends_[c].circle.side * turn_before(c) < 0;
      if (lifts_a || lifts_c) {
        (lifts_a ? a : c) = lifts_a ? bends_[a].previous : bends_[c].next;
        find_obstacles(a, c, side);
        continue;
      }
      if (!turns_as_before(a, c, side)) break;
      const std::size_t known = obstacles_.size();
      if (is_proved(a, c, side)) return replace(a, c) ? std::optional(a) : std::nullopt;
      if (obstacles_.size() == known) break;
      ++proofs;
    }
    return std::nullopt;
  }

  /// A way out and back again between two pins in one place goes.
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
  void link(std::size_t i, std::size_t j) { bends_[i].next = j, bends_[j].previous = i; }

  /// Calls `visit(circle)` for the circles around the vertices and discs near a box.
  template <class Visit>
  void for_each_circle(const Box& box, int side, Visit visit) const {
    space_.for_each_feature(box.inflated(radius_), [&](const Segment& core, double radius) {
      // Every vertex is the first end of an edge.
      visit(SidedCircle{core.a, passing_radius(space_, radius), side});
    });
  }

  /// Finds the circles that the string crosses on its way to the straight line between two bends.
  void find_obstacles(std::size_t a, std::size_t c, int side) {
    swept_.clear();
    for (std::size_t i = a; i != c; i = bends_[i].next) {
      swept_.push_back(bends_[i].out.from);
      swept_.push_back(bends_[i].out.to);
    }
    if (const auto straight = bitangent(bends_[a].circle, bends_[c].circle)) {
      swept_.insert(swept_.end(), {straight->to, straight->from});
    }
    obstacles_.clear();
    near_.clear();
    const Band band(swept_, way_to(c).to);
    band.for_each_box(radius_, [&](const Box& box) {
      for_each_circle(box, side, [&](const SidedCircle& circle) {
        if (band.is_far(circle.center, circle.radius)) return;
        const bool is_inside = place_in(swept_, circle.center) == Place::inside;
        (is_inside ? obstacles_ : near_).push_back(circle);
      });
    });
    settle_obstacles(a, c);
  }

  /// Makes obstacles of the circles beside that come into the chain's ways; whether there are any.
  bool add_barring(std::size_t a, std::size_t c) {
    const std::size_t known = obstacles_.size();
    for (const SidedCircle& circle : near_) {
      for (const Bitangent& way : chain_.ways) {
        if (circle.radius > 0 && bars(circle, Segment{way.from, way.to})) {
          obstacles_.push_back(circle);
          break;
        }
      }
    }
    if (obstacles_.size() > known) settle_obstacles(a, c);
    return obstacles_.size() > known;
  }

  /// Drops obstacles that count twice, are bends already or lie within others.
  void settle_obstacles(std::size_t a, std::size_t c) {
    const auto before = [](const SidedCircle& p, const SidedCircle& q) {
      if (p.center.x() != q.center.x()) return p.center.x() < q.center.x();
      if (p.center.y() != q.center.y()) return p.center.y() < q.center.y();
      return p.radius < q.radius;
    };
    std::sort(obstacles_.begin(), obstacles_.end(), before);
    obstacles_.erase(std::unique(obstacles_.begin(), obstacles_.end(), is_same), obstacles_.end());
    double largest = 0;
    for (const SidedCircle& circle : obstacles_) largest = std::max(largest, circle.radius);
    const auto is_within = [](const SidedCircle& p, const SidedCircle& q) {
      return p.radius < q.radius && distance(p.center, q.center) <= q.radius - p.radius;
    };
    const auto is_idle = [&](const SidedCircle& circle) {
      for (std::size_t i = a; i != bends_[c].next; i = bends_[i].next) {
        if (circle.center == bends_[i].circle.center || is_within(circle, bends_[i].circle)) {
          return true;
        }
      }
      return circle.radius < largest &&
             std::any_of(obstacles_.begin(), obstacles_.end(),
                         [&](const SidedCircle& other) { return is_within(circle, other); });
    };
    left_.clear();
    std::copy_if(obstacles_.begin(), obstacles_.end(), std::back_inserter(left_),
                 [&](const SidedCircle& circle) { return !is_idle(circle); });
    std::swap(obstacles_, left_);
  }

  enum class Place { inside, on, outside };

  /// Where a point lies of a closed polyline, by the even-odd rule.
  static Place place_in(const std::vector<Point>& ring, const Point& p) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[i + 1 == ring.size() ? 0 : i + 1];
      const bool crosses = (a.y() > p.y()) != (b.y() > p.y());
      if (!crosses && !(a.y() == p.y() && b.y() == p.y())) continue;
      const int turn = orientation(a, b, p);
      if (turn == 0 && Box::around({a, b}).contains(p)) return Place::on;
      if (crosses && (turn > 0) == (b.y() > a.y())) inside = !inside;
    }
    return inside ? Place::inside : Place::outside;
  }

  /// Makes a chain from A to C around the obstacles: first to what lies farthest to the outer side
  /// of the straight way, then always on to what asks for the smallest turn, and to the nearest of
  /// these. A circle that is large may come in more than once.
  bool wrap(std::size_t a, std::size_t c, int side) {
    chain_.circles.clear();
    chain_.ways.clear();
    SidedCircle from = bends_[a].circle;
    const auto straight = bitangent(from, bends_[c].circle);
    Point direction = straight ? straight->direction : bends_[a].out.direction;
    std::size_t at = obstacles_.size();
    while (chain_.ways.size() <= 2 * obstacles_.size() + 1) {
      if (chain_.ways.size() % 16 == 15 && budget_.exceeded()) return false;
      double least = std::numeric_limits<double>::infinity();
      std::optional<Bitangent> best;
      std::size_t chosen = obstacles_.size();
      for (std::size_t i = 0; i <= obstacles_.size(); ++i) {
        if (i == at && i < obstacles_.size()) continue;
        const auto way = bitangent(from, i < obstacles_.size() ? obstacles_[i] : bends_[c].circle);
        if (!way) continue;
        double turn = side * deflection(direction, way->direction);
        const bool is_first = straight && chain_.ways.empty();
        if (!is_first && turn < -1e-6) turn += 2 * std::numbers::pi;
        if (turn < least - 1e-12 || (turn < least + 1e-12 && way->length < best->length)) {
          least = turn, best = way, chosen = i;
        }
      }
      if (!best || least > std::numbers::pi) return false;
      chain_.ways.push_back(*best);
      direction = best->direction;
      if (chosen == obstacles_.size()) return true;
      at = chosen;
      from = obstacles_[chosen];
      chain_.circles.push_back(from);
    }
    return false;
  }

  /// Whether the chain, on its way from A to C, turns by as much as the string does: with a whole
  /// turn more or less it would wind around something that the string does not.
  bool turns_as_before(std::size_t a, std::size_t c, int side) const {
    double before = 0, after = 0;
    for (std::size_t i = bends_[a].next; i != c; i = bends_[i].next) {
      before += bends_[i].is_pin ? deflection(way_to(i).direction, bends_[i].out.direction)
                                 : bends_[i].turn;
    }
    Point direction = bends_[a].out.direction;
    for (const Bitangent& way : chain_.ways) {
      after += deflection(direction, way.direction);
      direction = way.direction;
    }
    after += deflection(direction, way_to(c).direction);
    // A way straight back may count as a turn to either side.
    const double gap = std::abs(before - after);
    return gap < 1e-6 || (gap > 2 * std::numbers::pi - 1e-6 && side * before > 0 &&
                          std::abs(std::abs(before) - std::numbers::pi) < 1e-6);
  }

  /// What A and C turn with the chain between them.
  double turn_after(std::size_t a) const {
    return bends_[a].turn + deflection(bends_[a].out.direction, chain_.ways.front().direction);
  }
  double turn_before(std::size_t c) const {
    return bends_[c].turn + deflection(chain_.ways.back().direction, way_to(c).direction);
  }

  /// Calls `visit(piece)` for all that the chain brings in: its ways and arcs, and the arcs around
  /// A and C as they become where they grow.
  template <class Visit>
  void for_each_new_piece(std::size_t a, std::size_t c, Visit visit) const {
    const auto arcs = [&](const SidedCircle& circle, const Point& in, const Point& out,
                          double turn) { for_each_arc(circle, in, out, turn, slack_, visit); };
    for (const Bitangent& way : chain_.ways) visit(Segment{way.from, way.to});
    for (std::size_t i = 0; i < chain_.circles.size(); ++i) {
      const Bitangent &in = chain_.ways[i], &out = chain_.ways[i + 1];
      arcs(chain_.circles[i], in.to, out.from, deflection(in.direction, out.direction));
    }
    const auto grown = [&](std::size_t i, const Point& in, const Point& out, double turn) {
      if (std::abs(turn) > std::abs(bends_[i].turn)) arcs(bends_[i].circle, in, out, turn);
    };
    if (!bends_[a].is_pin) grown(a, way_to(a).to, chain_.ways.front().from, turn_after(a));
    if (!bends_[c].is_pin) grown(c, chain_.ways.back().to, bends_[c].out.from, turn_before(c));
  }

  /// Whether all new pieces are proved; the circles that bar one that is not become obstacles.
  bool is_proved(std::size_t a, std::size_t c, int side) {
    bool proved = true;
    for_each_new_piece(a, c, [&](const auto& piece) {
      if (is_proved_free(space_, piece)) return;
      proved = false;
      for_each_circle(piece.box(), side, [&](const SidedCircle& circle) {
        if (bars(circle, piece)) obstacles_.push_back(circle);
      });
    });
    if (!proved) settle_obstacles(a, c);
    return proved;
  }

  /// Whether a circle comes into a piece. Circles that are points do not; what blocks the string
  /// then may be one that it touched all the time.
  bool bars(const SidedCircle& circle, const Segment& way) const {
    if (circle.radius == 0) return place_in(swept_, circle.center) == Place::on;
    const Point along{way.b.x() - way.a.x(), way.b.y() - way.a.y()};
    const Point across{circle.center.x() - way.a.x(), circle.center.y() - way.a.y()};
    return circle.side * cross(along, across) >= 0 &&
           distance(circle.center, way) < circle.radius - slack_;
  }
  bool bars(const SidedCircle& circle, const Arc& arc) const {
    return approach(arc, Segment{circle.center, circle.center}).distance < circle.radius - slack_;
  }

  double length_around(std::size_t i, double turn) const {
    return bends_[i].circle.radius * std::abs(turn);
  }

  /// Puts the chain in the place of all between two bends, unless that makes the string longer.
  bool replace(std::size_t a, std::size_t c) {
    const double turn_a = bends_[a].is_pin ? 0 : turn_after(a);
    const double turn_c = bends_[c].is_pin ? 0 : turn_before(c);
    double before = length_around(c, bends_[c].turn);
    for (std::size_t i = a; i != c; i = bends_[i].next) {
      before += length_around(i, bends_[i].turn) + bends_[i].out.length;
    }
    double after = length_around(a, turn_a) + length_around(c, turn_c);
    for (const Bitangent& way : chain_.ways) after += way.length;
    turns_.clear();
    for (std::size_t i = 0; i < chain_.circles.size(); ++i) {
      turns_.push_back(deflection(chain_.ways[i].direction, chain_.ways[i + 1].direction));
      after += chain_.circles[i].radius * std::abs(turns_[i]);
    }
    // Each pull shortens the string or takes a bend out of it: it comes to an end.
    const double least = 1e-12 * before;
    if (!(after < before - least || (chain_.circles.empty() && after <= before + least))) {
      return false;
    }
    bends_[a].turn = turn_a;
    bends_[c].turn = turn_c;
    bends_[a].out = chain_.ways[0];
    for (std::size_t i = 0; i < chain_.circles.size(); ++i) {
      bends_.push_back({chain_.circles[i], false, turns_[i], chain_.ways[i + 1], none, none});
      link(a, bends_.size() - 1);
      a = bends_.size() - 1;
    }
    link(a, c);
    return true;
  }

  const S& space_;
  const Budget& budget_;
  double slack_;
  double radius_;  // of the circles around vertices
  std::vector<Bend> bends_;
  std::size_t last_ = 0;
  // Of the pull that is being made.
  std::vector<Point> swept_;
  std::vector<SidedCircle> obstacles_, near_, left_;
  Chain chain_;
  std::vector<double> turns_;
};

}  // namespace tutavia::detail
