// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>

#include "support/reference_distance.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// An independent judge of vehicles' paths, in long double: the clearance of every disc of the
/// footprint by branch and bound over the motion, curvature and headings from the pieces' numbers.
/// It shares types with the library, but no computation.

namespace tutavia::test {

/// Position and heading of a vehicle along one piece, in long double.
class ReferenceMotion {
 public:
  ReferenceMotion(const Piece& piece, Gear gear) : piece_(piece), gear_(gear) {}

  /// The place of a point that the vehicle carries, at a fraction t of the piece.
  Point carried(Real t, const Point& offset) const {
    Real x = 0, y = 0, heading = 0;
    locate(t, x, y, heading);
    if (gear_ == Gear::reverse) heading += std::acos(Real(-1));
    const Real c = std::cos(heading), s = std::sin(heading);
    return {static_cast<double>(x + c * offset.x() - s * offset.y()),
            static_cast<double>(y + s * offset.x() + c * offset.y())};
  }
  Real heading(Real t) const {
    Real x = 0, y = 0, heading = 0;
    locate(t, x, y, heading);
    return gear_ == Gear::reverse ? heading + std::acos(Real(-1)) : heading;
  }
  Real length() const {
    if (const Arc* arc = piece_.get_if<Arc>()) return Real(arc->radius) * std::abs(arc->sweep);
    if (const Clothoid* clothoid = piece_.get_if<Clothoid>()) return clothoid->arc_length;
    return std::hypot(Real(end_of(piece_).x()) - start_of(piece_).x(),
                      Real(end_of(piece_).y()) - start_of(piece_).y());
  }
  /// Largest curvature [1/m]; infinity for a turn on the spot.
  Real curvature() const {
    if (const Arc* arc = piece_.get_if<Arc>()) return arc->sweep == 0 ? 0 : 1 / Real(arc->radius);
    if (const Clothoid* clothoid = piece_.get_if<Clothoid>()) {
      const Real from = clothoid->start_curvature;
      const Real to = from + Real(clothoid->sharpness) * clothoid->arc_length;
      return clothoid->arc_length > 0 ? std::max(std::abs(from), std::abs(to)) : 0;
    }
    return 0;
  }
  /// Largest change of the heading over the whole piece [rad].
  Real turn() const {
    if (const Arc* arc = piece_.get_if<Arc>()) return std::abs(Real(arc->sweep));
    return curvature() * length();
  }

 private:
  void locate(Real t, Real& x, Real& y, Real& heading) const {
    if (const Arc* arc = piece_.get_if<Arc>()) {
      const Real angle = Real(arc->start_angle) + t * arc->sweep;
      x = arc->center.x() + Real(arc->radius) * std::cos(angle);
      y = arc->center.y() + Real(arc->radius) * std::sin(angle);
      heading = angle + (std::signbit(arc->sweep) ? -1 : 1) * std::acos(Real(-1)) / 2;
    } else if (const Clothoid* clothoid = piece_.get_if<Clothoid>()) {
      const Real k = clothoid->start_curvature, c = clothoid->sharpness;
      const auto direction = [&](Real s) { return clothoid->start_heading + s * (k + c * s / 2); };
      const Real s = t * clothoid->arc_length;
      const int parts = 1 + static_cast<int>(4 * curvature() * s);
      x = clothoid->a.x();
      y = clothoid->a.y();
      for (int i = 0; i < parts; ++i) {
        const Real from = s * i / parts;
        add_part(direction(from), k + c * from, c, s / parts, x, y);
      }
      heading = direction(s);
    } else {
      const Point a = start_of(piece_), b = end_of(piece_);
      const Real dx = Real(b.x()) - a.x(), dy = Real(b.y()) - a.y();
      x = a.x() + t * dx;
      y = a.y() + t * dy;
      heading = std::atan2(dy, dx);
    }
  }

  /// Adds the way along a short part of a clothoid, by the power series of its direction: with
  /// exp(i (k s + c s^2 / 2)) = sum a_n s^n, (n + 1) a_(n+1) = i (k a_n + c a_(n-1)).
  static void add_part(Real heading, Real k, Real c, Real s, Real& x, Real& y) {
    std::complex<Real> term = 1, before = 0, sum = 0;  // a_n s^n and a_(n-1) s^(n-1)
    for (int n = 0; n < 60; ++n) {
      sum += term / Real(n + 1);
      const std::complex<Real> next =
          std::complex<Real>(0, 1) * (k * s * term + c * s * s * before) / Real(n + 1);
      before = term;
      term = next;
    }
    sum *= s * std::polar<Real>(1, heading);
    x += sum.real();
    y += sum.imag();
  }

  const Piece& piece_;
  Gear gear_;
};

/// By how much the nearest disc of the footprint misses the safety radius, at most: 0 if every disc
/// keeps it (up to 1e-6 m between the points looked at, which are closer together near obstacles).
inline Real clearance_deficit(const Workspace& world, const Vehicle& vehicle,
                              const VehiclePath& path) {
  Real deficit = 0;
  for (std::size_t i = 0; i < path.gears.size(); ++i) {
    const ReferenceMotion motion(path.curve.pieces()[i], path.gears[i]);
    for (const FootprintDisc& disc : vehicle.footprint) {
      const Real least = Real(disc.radius) + world.safety_radius;
      const Real way = motion.length() + disc.offset.norm() * motion.turn();
      const auto look = [&](auto self, Real from, Real to) -> void {
        const Point p = motion.carried((from + to) / 2, disc.offset);
        if (!world.bounds.inflated(1e-12 * (1 + world.bounds.largest_coordinate())).contains(p)) {
          deficit = std::numeric_limits<Real>::infinity();
        }
        const Real spare = reference_clearance(world, p) - least;
        deficit = std::max(deficit, -spare);
        const Real reach = way * (to - from) / 2;  // how far the ends are, at most
        const bool inside = world.bounds.inflated(-static_cast<double>(reach)).contains(p);
        if ((spare >= reach && inside) || reach < 1e-6L || deficit > 1e-3L) return;
        self(self, from, (from + to) / 2);
        self(self, (from + to) / 2, to);
      };
      look(look, 0, 1);
    }
  }
  return deficit;
}

/// The largest gap between positions [m] or headings [rad] where two pieces meet, and between the
/// ends and the poses that were asked for.
inline Real largest_jump(const VehiclePath& path, const Pose& start, const Pose& goal) {
  Real jump = 0;
  const auto compare = [&](const Point& p, Real heading, const Point& q, Real other) {
    jump = std::max({jump, std::hypot(Real(p.x()) - q.x(), Real(p.y()) - q.y()),
                     std::abs(std::remainder(heading - other, 2 * std::acos(Real(-1))))});
  };
  Point last = start.position;
  Real heading = start.heading;
  for (std::size_t i = 0; i < path.gears.size(); ++i) {
    const ReferenceMotion motion(path.curve.pieces()[i], path.gears[i]);
    compare(motion.carried(0, {0, 0}), motion.heading(0), last, heading);
    last = motion.carried(1, {0, 0});
    heading = motion.heading(1);
  }
  compare(last, heading, goal.position, goal.heading);
  return jump;
}

inline Real largest_curvature(const VehiclePath& path) {
  Real largest = 0;
  for (std::size_t i = 0; i < path.gears.size(); ++i) {
    largest = std::max(largest, ReferenceMotion(path.curve.pieces()[i], path.gears[i]).curvature());
  }
  return largest;
}

}  // namespace tutavia::test
