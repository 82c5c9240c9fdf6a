// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/geometry/tangent/oriented_box.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"
#include "tutavia/smooth/string/string_bends.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/index/passing_radius.hpp"

/// \file
/// ChainFinder: finds what a string runs around when the bends between two others are removed.

namespace tutavia::detail {

enum class PointInRing { inside, on, outside };

/// The location of a point relative to a closed polyline, by the even-odd rule.
inline PointInRing locate(const std::vector<Point>& ring, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[i + 1 == ring.size() ? 0 : i + 1];
    const bool crosses = (a.y() > p.y()) != (b.y() > p.y());
    if (!crosses && !(a.y() == p.y() && b.y() == p.y())) continue;
    const int turn = orientation(a, b, p);
    if (turn == 0 && Box::around({a, b}).contains(p)) return PointInRing::on;
    if (crosses && (turn > 0) == (b.y() > a.y())) inside = !inside;
  }
  return inside ? PointInRing::inside : PointInRing::outside;
}

/// A string is a path that is pulled taut around circles, its bends. When the bends between two
/// others, A and C, are removed, ChainFinder finds and proves the circles that the string then runs
/// around. `side` is the direction of the removed turns: +1 left, -1 right. Call `find_obstacles`
/// once; then `wrap` and `add_blocking` in turn until nothing blocks the chain.
template <FeatureSpace S>
class ChainFinder {
 public:
  ChainFinder(const S& space, const StringBends& string, const Budget& budget)
      : space_(space),
        string_(string),
        budget_(budget),
        error_bound_(space.distance_error_bound()),
        radius_(passing_radius(space, 0)) {}

  const Chain& chain() const { return chain_; }
  std::size_t obstacle_count() const { return obstacles_.size(); }

  /// Finds the circles that the string sweeps over when it is pulled to the straight line between
  /// two bends.
  void find_obstacles(std::size_t a, std::size_t c, int side) {
    swept_.clear();
    for (std::size_t i = a; i != c; i = string_[i].next) {
      swept_.push_back(string_[i].out.from);
      swept_.push_back(string_[i].out.to);
    }
    if (const auto straight = tangent_line(string_[a].circle, string_[c].circle)) {
      swept_.insert(swept_.end(), {straight->to, straight->from});
    }
    obstacles_.clear();
    near_.clear();
    const OrientedBox band(swept_, string_.edge_to(c).to);
    band.for_each_box(radius_, [&](const Box& box) {
      for_each_circle(box, side, [&](const OrientedCircle& circle) {
        if (band.is_far(circle.center, circle.radius)) return;
        const bool is_inside = locate(swept_, circle.center) == PointInRing::inside;
        (is_inside ? obstacles_ : near_).push_back(circle);
      });
    });
    filter_obstacles(a, c);
  }

  /// Turns nearby circles that block the chain's edges into obstacles. Returns whether there are
  /// any.
  bool add_blocking(std::size_t a, std::size_t c) {
    const std::size_t known = obstacles_.size();
    for (const OrientedCircle& circle : near_) {
      for (const TangentLine& tangent : chain_.edges) {
        if (circle.radius > 0 && blocks(circle, Segment{tangent.from, tangent.to})) {
          obstacles_.push_back(circle);
          break;
        }
      }
    }
    if (obstacles_.size() > known) filter_obstacles(a, c);
    return obstacles_.size() > known;
  }

  /// Builds a chain from A to C around the obstacles by gift wrapping: first to the obstacle
  /// farthest to the outer side of the straight line, then always to the one with the smallest
  /// turn, the nearest of ties. A large circle may occur more than once.
  bool wrap(std::size_t a, std::size_t c, int side) {
    chain_.circles.clear();
    chain_.edges.clear();
    OrientedCircle from = string_[a].circle;
    const auto straight = tangent_line(from, string_[c].circle);
    Point direction = straight ? straight->direction : string_[a].out.direction;
    std::size_t at = obstacles_.size();
    while (chain_.edges.size() <= 2 * obstacles_.size() + 1) {
      if (chain_.edges.size() % 16 == 15 && budget_.exceeded()) return false;
      double least = std::numeric_limits<double>::infinity();
      std::optional<TangentLine> best;
      std::size_t chosen = obstacles_.size();
      for (std::size_t i = 0; i <= obstacles_.size(); ++i) {
        if (i == at && i < obstacles_.size()) continue;
        const auto tangent =
            tangent_line(from, i < obstacles_.size() ? obstacles_[i] : string_[c].circle);
        if (!tangent) continue;
        double turn = side * turn_angle(direction, tangent->direction);
        const bool is_first = straight && chain_.edges.empty();
        if (!is_first && turn < -1e-6) turn += 2 * std::numbers::pi;
        if (turn < least - 1e-12 || (turn < least + 1e-12 && tangent->length < best->length)) {
          least = turn;
          best = tangent;
          chosen = i;
        }
      }
      if (!best || least > std::numbers::pi) return false;
      chain_.edges.push_back(*best);
      direction = best->direction;
      if (chosen == obstacles_.size()) return true;
      at = chosen;
      from = obstacles_[chosen];
      chain_.circles.push_back(from);
    }
    return false;
  }

  /// Whether the chain from A to C turns by as much as the string does. If the turns differ by a
  /// full turn, the chain winds around something that the string does not.
  bool turns_as_before(std::size_t a, std::size_t c, int side) const {
    double before = 0, after = 0;
    for (std::size_t i = string_[a].next; i != c; i = string_[i].next) {
      before += string_[i].is_pin
                    ? turn_angle(string_.edge_to(i).direction, string_[i].out.direction)
                    : string_[i].turn;
    }
    Point direction = string_[a].out.direction;
    for (const TangentLine& tangent : chain_.edges) {
      after += turn_angle(direction, tangent.direction);
      direction = tangent.direction;
    }
    after += turn_angle(direction, string_.edge_to(c).direction);
    // A reversal may count as a turn to either side.
    const double gap = std::abs(before - after);
    return gap < 1e-6 || (gap > 2 * std::numbers::pi - 1e-6 && side * before > 0 &&
                          std::abs(std::abs(before) - std::numbers::pi) < 1e-6);
  }

  /// Whether all new pieces are proved. Circles that block an unproved piece become obstacles.
  bool is_proved(std::size_t a, std::size_t c, int side) {
    bool proved = true;
    for_each_new_piece(a, c, [&](const auto& piece) {
      if (is_proved_free(space_, piece)) return;
      proved = false;
      for_each_circle(piece.box(), side, [&](const OrientedCircle& circle) {
        if (blocks(circle, piece)) obstacles_.push_back(circle);
      });
    });
    if (!proved) filter_obstacles(a, c);
    return proved;
  }

 private:
  /// Calls `visit(circle)` for the circles around vertices and discs near a box. No string bends at
  /// a vertex that is not convex: cells know theirs exactly. Among polygons all vertices count,
  /// since a ring may cross itself.
  template <class Visit>
  void for_each_circle(const Box& box, int side, Visit visit) const {
    const auto around = [&](const Point& center, double radius) {
      visit(OrientedCircle{center, passing_radius(space_, radius), side});
    };
    if constexpr (std::same_as<S, CellSpace>) {
      space_.for_each_corner(box.inflated(radius_),
                             [&](const Corner& corner) { around(corner.position, corner.radius); });
    } else {
      space_.for_each_feature(box.inflated(radius_), [&](const Segment& core, double radius) {
        around(core.a, radius);  // every vertex is the first end of an edge
      });
    }
  }

  /// Removes obstacles that are duplicates, are bends already or lie within others.
  void filter_obstacles(std::size_t a, std::size_t c) {
    const auto before = [](const OrientedCircle& p, const OrientedCircle& q) {
      if (p.center.x() != q.center.x()) return p.center.x() < q.center.x();
      if (p.center.y() != q.center.y()) return p.center.y() < q.center.y();
      return p.radius < q.radius;
    };
    std::sort(obstacles_.begin(), obstacles_.end(), before);
    obstacles_.erase(std::unique(obstacles_.begin(), obstacles_.end(), same_circle),
                     obstacles_.end());
    double largest = 0;
    for (const OrientedCircle& circle : obstacles_) largest = std::max(largest, circle.radius);
    const auto is_within = [](const OrientedCircle& p, const OrientedCircle& q) {
      return p.radius < q.radius && distance(p.center, q.center) <= q.radius - p.radius;
    };
    const auto is_idle = [&](const OrientedCircle& circle) {
      for (std::size_t i = a; i != string_[c].next; i = string_[i].next) {
        if (circle.center == string_[i].circle.center || is_within(circle, string_[i].circle)) {
          return true;
        }
      }
      return circle.radius < largest &&
             std::any_of(obstacles_.begin(), obstacles_.end(),
                         [&](const OrientedCircle& other) { return is_within(circle, other); });
    };
    kept_.clear();
    std::copy_if(obstacles_.begin(), obstacles_.end(), std::back_inserter(kept_),
                 [&](const OrientedCircle& circle) { return !is_idle(circle); });
    std::swap(obstacles_, kept_);
  }

  /// Calls `visit(piece)` for all new pieces: the chain's edges and arcs, and the arcs around A and
  /// C if they become longer.
  template <class Visit>
  void for_each_new_piece(std::size_t a, std::size_t c, Visit visit) const {
    const auto arcs = [&](const OrientedCircle& circle, const Point& in, const Point& out,
                          double turn) {
      for_each_arc(circle, in, out, turn, error_bound_, visit);
    };
    for (const TangentLine& tangent : chain_.edges) visit(Segment{tangent.from, tangent.to});
    for (std::size_t i = 0; i < chain_.circles.size(); ++i) {
      const TangentLine &in = chain_.edges[i], &out = chain_.edges[i + 1];
      arcs(chain_.circles[i], in.to, out.from, chain_.turn(i));
    }
    const auto grown = [&](std::size_t i, const Point& in, const Point& out, double turn) {
      if (std::abs(turn) > std::abs(string_[i].turn)) arcs(string_[i].circle, in, out, turn);
    };
    if (!string_[a].is_pin)
      grown(a, string_.edge_to(a).to, chain_.edges.front().from, string_.turn_after(a, chain_));
    if (!string_[c].is_pin)
      grown(c, chain_.edges.back().to, string_[c].out.from, string_.turn_before(c, chain_));
  }

  /// Whether a circle blocks a piece. A circle of radius 0 blocks only if it lies on the border of
  /// the swept area: the string may have touched it all the time.
  bool blocks(const OrientedCircle& circle, const Segment& edge) const {
    if (circle.radius == 0) return locate(swept_, circle.center) == PointInRing::on;
    const Point along{edge.b.x() - edge.a.x(), edge.b.y() - edge.a.y()};
    const Point across{circle.center.x() - edge.a.x(), circle.center.y() - edge.a.y()};
    return circle.side * cross(along, across) >= 0 &&
           distance(circle.center, edge) < circle.radius - error_bound_;
  }
  bool blocks(const OrientedCircle& circle, const Arc& arc) const {
    return closest_approach(arc, Segment{circle.center, circle.center}).distance <
           circle.radius - error_bound_;
  }

  const S& space_;
  const StringBends& string_;
  const Budget& budget_;
  double error_bound_;
  double radius_;                          // radius of circles around vertices
  std::vector<Point> swept_;               // border of the area that the string sweeps, closed
  std::vector<OrientedCircle> obstacles_;  // circles inside it
  std::vector<OrientedCircle> near_;       // circles near it
  std::vector<OrientedCircle> kept_;
  Chain chain_;
};

}  // namespace tutavia::detail
