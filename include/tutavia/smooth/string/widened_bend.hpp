// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tutavia/geometry/clothoid.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/tangent/clothoid_pair.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"

/// \file
/// WidenedBend: the spirals that replace one bend of a string.

namespace tutavia::detail {

/// The shape that replaces a bend.
struct BendShape {
  enum class Form {
    arc,     ///< an arc of the enlarged circle; with radius 0: the corner
    pair,    ///< two mirrored spirals
    spirals  ///< two spirals with an arc between them
  };

  Form form = Form::arc;
  double radius = 0;  ///< least radius of curvature [m]
  double turn = 0;    ///< of each spiral [rad]
  double leg = 0;     ///< from the shape's start to the edge's tangent point [m]
};

/// An end of a bend's shape on a straight edge: its position and the edge's direction.
struct BendEnd {
  Point position, direction;
};

/// A bend of a string around an enlarged circle.
struct WidenedBend {
  OrientedCircle circle;  ///< the enlarged circle, which the edges touch
  double core_radius;     ///< of the original circle [m]
  double inner_radius;    ///< least distance of spirals from its centre [m]
  double turn;            ///< left positive [rad]
  bool has_beziers;       ///< cubic Bezier spirals instead of clothoids; pairs only

  /// Bends that turn by more have no pair [rad].
  static constexpr double widest_pair = 0.9 * std::numbers::pi;
  /// Spirals that turn by less are no gentler than a jump of the curvature [rad].
  static constexpr double least_turn = 0.01;

  double turn_magnitude() const { return circle.side * turn; }
  /// \pre turn_magnitude() < widest_pair
  ClothoidPair unit_pair() const {
    return has_beziers ? ClothoidPair::of_beziers(turn_magnitude())
                       : ClothoidPair::of_clothoids(turn_magnitude());
  }

  /// The gentlest shape that takes at most `room` of the edges before and after the bend. An arc if
  /// no other shape has a radius of at least `least_radius`.
  BendShape gentlest_shape(double room, double least_radius) const;

  /// Calls `visit(piece)` for the pieces of a shape between two edges. \pre the shape is one of
  /// this bend, and both ends lie as it requires
  template <class Visit>
  void for_each_piece(const BendShape& shape, const BendEnd& in, const BendEnd& out,
                      double tolerance, Visit visit) const;

 private:
  BendShape arc() const { return {BendShape::Form::arc, circle.radius, 0, 0}; }
  BendShape spirals(double room, double least_radius) const;
};

inline BendShape WidenedBend::gentlest_shape(double room, double least_radius) const {
  if (!(circle.radius > core_radius) || !(turn_magnitude() > 1e-6)) return arc();
  if (turn_magnitude() < widest_pair) {
    const ClothoidPair pair = unit_pair();
    const double to_corner = circle.radius / std::cos(turn_magnitude() / 2);
    const double touch =
        circle.radius * std::tan(turn_magnitude() / 2);  // from the tangent point to the corner
    const double radius =
        std::min((to_corner - inner_radius) / pair.drop, (room + touch) / pair.leg);
    // Inside the enlarged circle: no longer than its arc.
    const bool is_inside = radius * pair.drop >= to_corner - circle.radius;
    if (radius >= std::max(inner_radius, least_radius) && is_inside) {
      return {BendShape::Form::pair, radius, turn_magnitude() / 2, radius * pair.leg - touch};
    }
  }
  return has_beziers ? arc() : spirals(room, least_radius);
}

/// Spirals onto an arc around the same centre, if there is room and the arc clears the original
/// circle. The arc alone if they would be too short.
inline BendShape WidenedBend::spirals(double room, double least_radius) const {
  const double least = std::max(inner_radius, least_radius);
  // The shift of the centre grows nearly as the square of the turn, and its position along the edge
  // as the turn, so a few scaling steps find what fits.
  double spiral = std::min({turn_magnitude() / 2, std::sqrt(6 * (circle.radius / least - 1)), 1.5});
  for (int k = 0; k < 6 && spiral > least_turn; ++k) {
    const UnitClothoid unit = UnitClothoid::turning(spiral);
    const double radius = circle.radius / (1 + unit.centre.y()), leg = radius * unit.centre.x();
    const double shift = (circle.radius / least - 1) / unit.centre.y();
    const double scale = std::min(std::sqrt(shift), room / leg);
    if (scale >= 1) return {BendShape::Form::spirals, radius, spiral, leg};
    spiral *= scale * (1 - 1e-6);
  }
  return arc();
}

template <class Visit>
void WidenedBend::for_each_piece(const BendShape& shape, const BendEnd& in, const BendEnd& out,
                                 double tolerance, Visit visit) const {
  Point at = in.position;
  const auto visit_arcs = [&](double radius, const Point& to, double turns) {
    for_each_arc({circle.center, radius, circle.side}, at, to, turns, tolerance,
                 [&](const Arc& arc) {
                   visit(arc);
                   at = arc.b;
                 });
  };
  if (shape.form == BendShape::Form::arc) {
    visit_arcs(circle.radius, out.position, turn);
    if (at != out.position) visit(Segment{at, out.position});
    return;
  }
  if (has_beziers) {
    const double leg = shape.leg + circle.radius * std::tan(turn_magnitude() / 2);
    auto pair = bezier_spirals(offset_along(in.position, leg, in.direction), in.direction,
                               out.direction, leg);
    pair[0].points.front() = in.position;
    pair[1].points.back() = out.position;
    visit(pair[0]);
    visit(pair[1]);
    return;
  }
  const double bent = circle.side / shape.radius, length = 2 * shape.turn * shape.radius;
  const Clothoid before =
      Clothoid::from(in.position, heading(in.direction), 0, bent / length, length);
  Clothoid after = Clothoid::from(out.position, heading(out.direction) + std::numbers::pi, 0,
                                  -bent / length, length)
                       .reversed();
  visit(before);
  at = before.b;
  if (shape.form == BendShape::Form::spirals) {
    visit_arcs(shape.radius, after.a, turn - 2 * circle.side * shape.turn);
  }
  after.a = at;
  visit(after);
}

}  // namespace tutavia::detail
