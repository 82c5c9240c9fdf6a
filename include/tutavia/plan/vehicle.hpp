// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// Vehicle: turning radius, gears and footprint of a robot.

namespace tutavia {

/// A disc that is fixed to a vehicle.
struct FootprintDisc {
  Point offset = Point::Zero();  ///< of its centre from the reference point: ahead, to the left [m]
  double radius = 0;             ///< [m]
};

/// What a vehicle may drive, and the room that it takes.
///
/// The reference point is the one whose path is planned and that turns at the turning radius: the
/// middle of the rear axle of a car. The footprint is a union of discs. The space's safety radius
/// is the distance that each of them keeps from obstacles.
struct Vehicle {
  /// Of the reference point [m], at least 1e-9; or 0: the vehicle turns on the spot, which only a
  /// footprint of one disc around the reference point may do.
  double min_turning_radius = 0;
  bool reverse = false;  ///< whether it may drive backwards
  std::vector<FootprintDisc> footprint{FootprintDisc{}};

  /// A point: the safety radius of the space is all its room.
  static Vehicle point(double min_turning_radius = 0, bool reverse = false) {
    return {min_turning_radius, reverse, {FootprintDisc{}}};
  }
  /// A disc around the reference point.
  static Vehicle disc(double radius, double min_turning_radius = 0, bool reverse = false) {
    return {min_turning_radius, reverse, {FootprintDisc{Point::Zero(), radius}}};
  }
  /// A rectangle, covered by few discs that stay within `margin` of it. The rear axle lies as far
  /// from the back as the front axle from the front. Margin 0 stands for an eighteenth of the
  /// shorter side: 0.1 m for a car.
  /// \pre 0 <= wheelbase <= length, 0 < width, 0 <= margin, and no side is 10^4 margins long
  static Vehicle car(double length, double width, double wheelbase, double min_turning_radius,
                     bool reverse = true, double margin = 0);

  /// Whether the vehicle is one disc around the reference point.
  bool is_centred_disc() const {
    return footprint.size() == 1 && detail::is_zero(footprint[0].offset);
  }
  /// The largest distance of a point of the footprint from the reference point [m].
  double reach() const {
    double result = 0;
    for (const FootprintDisc& disc : footprint) {
      result = std::fmax(result, disc.offset.norm() + disc.radius);
    }
    return result;
  }
};

namespace detail {

/// Turns of a smaller radius are lost in the rounding of coordinates [m].
inline constexpr double least_turning_radius = 1e-9;

}  // namespace detail

/// Errors: `invalid_option` for a turning radius that is negative, not finite or between 0 and 1e-9
/// m, a footprint without discs, discs that are not finite or have a negative radius, and for a
/// vehicle that turns on the spot but is not one disc around its reference point.
inline Expected<void, Failure> validate(const Vehicle& vehicle) {
  const double radius = vehicle.min_turning_radius;
  if (!(radius >= 0) || !std::isfinite(radius)) {
    return fail(PlanError::invalid_option, "min_turning_radius must be finite and not negative");
  }
  if (radius > 0 && radius < detail::least_turning_radius) {
    return fail(PlanError::invalid_option,
                "min_turning_radius must be at least 1e-9 m, or 0 to turn on the spot");
  }
  if (vehicle.footprint.empty()) {
    return fail(PlanError::invalid_option, "the footprint has no disc");
  }
  for (std::size_t i = 0; i < vehicle.footprint.size(); ++i) {
    const FootprintDisc& disc = vehicle.footprint[i];
    if (detail::is_finite(disc.offset) && disc.radius >= 0 && std::isfinite(disc.radius)) continue;
    return fail(PlanError::invalid_option,
                "disc " + std::to_string(i) +
                    " of the footprint must be finite, with a radius that is not negative");
  }
  if (radius == 0 && !vehicle.is_centred_disc()) {
    return fail(PlanError::invalid_option,
                "min_turning_radius must be positive unless the footprint is one disc around the "
                "reference point");
  }
  return {};
}

namespace detail {

/// Few discs that cover a rectangle of size `length` x `width` around the origin and stay within
/// `margin` of it. \pre 0 < width <= length, margin > 0
///
/// A disc at distance t from the nearest side has the radius t + margin, so it covers a stretch of
/// h(t) = sqrt(margin^2 + 2 margin t) to both sides of its centre along that side. Discs of t =
/// width / 2 along the axis leave the four corners. Towards each of them follow discs on the
/// diagonal, each with the smallest t whose stretches along both sides still meet those of the one
/// before; the last contains the corner.
inline std::vector<FootprintDisc> rectangle_cover(double length, double width, double margin) {
  constexpr double slack = 1 + 1e-12;  // for rounding
  const auto half_stretch = [&](double t) { return std::sqrt(margin * (margin + 2 * t)); };
  std::vector<FootprintDisc> discs;
  const double last = (length - width) / 2;  // of the centres on the axis
  const int gaps = static_cast<int>(std::ceil(last / half_stretch(width / 2)));
  for (int i = 0; i <= gaps; ++i) {
    const double x = gaps == 0 ? 0.0 : last * (2.0 * i / gaps - 1);
    discs.push_back({{x, 0}, (width / 2 + margin) * slack});
  }
  const double containing_corner = margin * (1 + std::numbers::sqrt2);
  for (double t = width / 2; t > containing_corner;) {
    const double open = t - half_stretch(t);  // from the corner
    t = containing_corner;
    if (t + half_stretch(t) < open) t = open + margin - std::sqrt(2 * margin * (open + margin));
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        discs.push_back({{x * (length / 2 - t), y * (width / 2 - t)}, (t + margin) * slack});
      }
    }
  }
  return discs;
}

}  // namespace detail

inline Vehicle Vehicle::car(double length, double width, double wheelbase,
                            double min_turning_radius, bool reverse, double margin) {
  if (margin == 0) margin = std::fmin(length, width) / 18;
  TUTAVIA_ASSERT(0 < width && 0 <= wheelbase && wheelbase <= length && 0 < margin);
  TUTAVIA_ASSERT(std::fmax(length, width) <= 1e4 * margin);
  const bool is_long = length >= width;
  Vehicle vehicle{
      min_turning_radius, reverse,
      detail::rectangle_cover(std::fmax(length, width), std::fmin(length, width), margin)};
  for (FootprintDisc& disc : vehicle.footprint) {
    if (!is_long) disc.offset = {disc.offset.y(), disc.offset.x()};
    disc.offset.x() += wheelbase / 2;
  }
  return vehicle;
}

}  // namespace tutavia
