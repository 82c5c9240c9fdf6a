// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/pose.hpp"

/// \file
/// VehiclePath: a curve that a vehicle drives, forwards and backwards.

namespace tutavia {

/// The direction in which a vehicle drives.
enum class Gear : std::uint8_t { forward, reverse };

constexpr std::string_view to_string(Gear gear) {
  return gear == Gear::forward ? "forward" : "reverse";
}

namespace detail {

/// An angle in (-pi, pi]. \pre finite
inline double wrapped_angle(double angle) {
  const double result = std::remainder(angle, 2 * std::numbers::pi);
  return result <= -std::numbers::pi ? std::numbers::pi : result;
}

/// The side to which an arc turns: 1 to the left, -1 to the right; by the sign of its sweep, even
/// if that is zero, so that an arc which is a single point keeps its direction when it is reversed.
inline double turning_side(const Arc& arc) { return std::signbit(arc.sweep) ? -1 : 1; }

/// The direction of travel on a piece at parameter t [rad], not wrapped. It is taken from the
/// angles that arcs and clothoids store, so they have one even if they are a single point.
template <class P>
double travel_direction(const P& piece, double t) {
  if constexpr (std::is_same_v<P, Arc>) {
    return piece.start_angle + t * piece.sweep + turning_side(piece) * (std::numbers::pi / 2);
  } else if constexpr (std::is_same_v<P, Clothoid>) {
    return piece.start_heading + piece.turn_to(t);
  } else {
    return heading(piece.derivative(t));
  }
}

/// The straight piece from `from` to `to`, which lies in direction `heading`: a segment, unless it
/// is so short that rounded ends would not keep the direction to 1e-12; then a clothoid without
/// curvature.
inline Piece straight_piece(const Point& from, const Point& to, double heading) {
  const double length = distance(from, to);
  const double rounding = 0x1p-51 * std::fmax(max_magnitude(from), max_magnitude(to));
  if (rounding <= 0.25e-12 * length) return Segment{from, to};
  return Clothoid{from, to, heading, 0, 0, length};
}

}  // namespace detail

/// The path of the reference point of a vehicle, in the order of travel, with the gear of every
/// piece. Pieces are segments, arcs and clothoids. The vehicle's heading is the direction of travel
/// in forward gear, and the opposite in reverse. It is continuous, also at cusps, where the gear
/// changes.
struct VehiclePath {
  Curve curve{};
  std::vector<Gear> gears{};  ///< one per piece

  /// \pre the piece starts where the curve ends
  void push_back(const Piece& piece, Gear gear) {
    curve.push_back(piece);
    gears.push_back(gear);
  }

  /// Appends another path. \pre it starts where this one ends
  void append(const VehiclePath& other) {
    for (std::size_t i = 0; i < other.gears.size(); ++i) {
      push_back(other.curve.pieces()[i], other.gears[i]);
    }
  }

  bool empty() const { return curve.empty(); }
  double length() const { return curve.length(); }

  /// Position and heading at parameter t of piece i; the heading in (-pi, pi].
  Pose pose(std::size_t i, double t) const {
    const Piece& piece = curve.pieces()[i];
    const double direction =
        piece.visit([&](const auto& p) { return detail::travel_direction(p, t); });
    const double turned = gears[i] == Gear::forward ? 0.0 : std::numbers::pi;
    return {piece.visit([&](const auto& p) -> Point { return p.point(t); }),
            detail::wrapped_angle(direction + turned)};
  }
  /// Position and heading at arc length s, which is clamped. \pre not empty
  Pose at(double s) const {
    const auto [i, t] = curve.locate(s);
    return pose(i, t);
  }
  /// \pre not empty
  Pose start() const { return pose(0, 0); }
  /// \pre not empty
  Pose end() const { return pose(gears.size() - 1, 1); }

  /// Arc lengths at which the gear changes [m].
  std::vector<double> cusps() const {
    std::vector<double> result;
    for (std::size_t i = 1; i < gears.size(); ++i) {
      if (gears[i] != gears[i - 1]) result.push_back(curve.length_before(i));
    }
    return result;
  }

  /// The path from its end to its start, with the same poses: every gear is the other one.
  VehiclePath reversed() const {
    VehiclePath result;
    result.curve = curve.reversed();
    for (std::size_t i = gears.size(); i-- > 0;) {
      result.gears.push_back(gears[i] == Gear::forward ? Gear::reverse : Gear::forward);
    }
    return result;
  }
};

}  // namespace tutavia
