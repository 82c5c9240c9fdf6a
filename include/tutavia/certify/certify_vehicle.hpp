// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "tutavia/certify/certify.hpp"
#include "tutavia/certify/vehicle/carried_point.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/plan/vehicle.hpp"

/// \file
/// certify for vehicles: proves that a vehicle can drive a path, and that its footprint is safe.

namespace tutavia {

/// What is proved of a path that a vehicle drives.
struct VehicleCertificate {
  /// Whether the path can be driven and the whole footprint keeps the safety radius.
  ProofStatus status = ProofStatus::undecided;
  /// Of the footprint: bounds of the least distance between its discs and the obstacles. `point` is
  /// the centre of the disc that comes nearest.
  Certificate clearance{};
  std::size_t disc = 0;         ///< index of that disc
  double max_curvature = 0;     ///< of the reference point's path [1/m]
  double max_heading_jump = 0;  ///< between two consecutive pieces [rad]
  /// Whether gears, curvature and headings are what the vehicle can drive.
  bool is_drivable = false;
};

namespace detail {

/// Headings of consecutive pieces may differ by so much [rad].
inline constexpr double heading_tolerance = 1e-9;
/// The ends of a piece may lie off its curve by so much, relative to its coordinates and to the
/// turning radius, in which centres of turns are computed.
inline constexpr double gap_tolerance = 1e-12;

/// The largest distance of a piece's stored ends from the curve that its numbers define [m].
template <class P>
double end_gap(const P& piece) {
  if constexpr (std::is_same_v<P, Arc> || std::is_same_v<P, Clothoid>) {
    return piece.evaluation_error();  // with a few roundings besides
  } else {
    return 0;
  }
}

/// Measures curvature and headings of a path. Whether each piece is of a kind that a vehicle can
/// follow, in a gear that it has, without gaps, turns on the spot or corners.
inline void measure_driving(const Vehicle& vehicle, const VehiclePath& path,
                            VehicleCertificate& certificate) {
  const auto& pieces = path.curve.pieces();
  if (pieces.empty() || path.gears.size() != pieces.size() || has_gap(path.curve)) return;
  bool possible = true;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Segment* segment = pieces[i].get_if<Segment>();
    const bool has_direction = segment != nullptr
                                   ? segment->a != segment->b
                                   : pieces[i].holds<Arc>() || pieces[i].holds<Clothoid>();
    possible = possible && has_direction && (path.gears[i] == Gear::forward || vehicle.reverse);
    const double magnitude = max_magnitude(start_of(pieces[i])) + max_magnitude(end_of(pieces[i]));
    const double gap = pieces[i].visit([](const auto& piece) { return end_gap(piece); });
    const double length = path.curve.length_before(i + 1) - path.curve.length_before(i);
    const double scale = 1e-3 + magnitude + length + vehicle.min_turning_radius;
    possible = possible && gap <= gap_tolerance * scale;
    certificate.max_curvature = std::max(certificate.max_curvature, max_curvature(pieces[i]));
    if (const Arc* arc = pieces[i].get_if<Arc>(); arc != nullptr && arc->radius == 0) {
      possible = possible && (arc->sweep == 0 || vehicle.min_turning_radius == 0);
    }
    if (i == 0) continue;
    const double jump = path.pose(i, 0).heading - path.pose(i - 1, 1).heading;
    certificate.max_heading_jump =
        std::max(certificate.max_heading_jump, std::abs(wrapped_angle(jump)));
  }
  certificate.is_drivable = possible && certificate.max_heading_jump <= heading_tolerance &&
                            certificate.max_curvature * vehicle.min_turning_radius <= 1 + 1e-12;
}

/// Calls `use(path, error)` with the path of a disc's centre along a piece.
template <class Use>
void visit_carried(const Piece& any, Gear gear, const Point& offset, double heading_jump,
                   double magnitude, const Use& use) {
  const double sign = gear == Gear::forward ? 1 : -1;
  const Point ahead{sign * offset.x(), sign * offset.y()};
  any.visit([&](const auto& piece) {
    using P = std::remove_cvref_t<decltype(piece)>;
    if constexpr (std::is_same_v<P, Segment> || std::is_same_v<P, Arc> ||
                  std::is_same_v<P, Clothoid>) {
      if constexpr (std::is_same_v<P, Arc>) {  // a turn on the spot, or no motion at all
        if (is_zero(offset) && piece.a == piece.b && piece.length() == 0) {
          return use(Segment{piece.a, piece.b}, 0.0);
        }
      }
      if (is_zero(offset)) return use(piece, 0.0);
      const double largest = std::fmax(magnitude, piece.box().largest_coordinate());
      use(carried(piece, ahead),
          carrying_error(piece, offset, largest) + offset.norm() * heading_jump);
    }
  });
}

/// Whether pieces are proved free for the footprint of a vehicle. A disc around the whole footprint
/// is tried first, then the disc that failed last.
class FootprintTest {
 public:
  explicit FootprintTest(const Vehicle& vehicle) : discs_(vehicle.footprint) {
    Box box;
    for (const FootprintDisc& disc : discs_) {
      box.include(disc.offset - Point(disc.radius, disc.radius));
      box.include(disc.offset + Point(disc.radius, disc.radius));
    }
    around_.offset = lerp(box.min, box.max, 0.5);
    for (const FootprintDisc& disc : discs_) {
      around_.radius =
          std::fmax(around_.radius, distance(around_.offset, disc.offset) + disc.radius);
    }
    around_.radius *= 1 + 1e-12;
  }

  template <ClearanceSpace S>
  bool is_free(const S& space, const Piece& piece, Gear gear) {
    if (discs_.size() > 1 && keeps(space, piece, gear, around_, around_.radius)) return true;
    for (std::size_t k = 0; k < discs_.size(); ++k) {
      if (keeps(space, piece, gear, discs_[k])) continue;
      std::rotate(discs_.begin(), discs_.begin() + static_cast<std::ptrdiff_t>(k),
                  discs_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      return false;
    }
    return true;
  }
  template <ClearanceSpace S>
  bool is_free(const S& space, const VehiclePath& path) {
    for (std::size_t i = 0; i < path.gears.size(); ++i) {
      if (!is_free(space, path.curve.pieces()[i], path.gears[i])) return false;
    }
    return true;
  }

 private:
  /// Whether a disc keeps the safety radius, and its centre `border` metres from the bounds' sides.
  template <ClearanceSpace S>
  static bool keeps(const S& space, const Piece& piece, Gear gear, const FootprintDisc& disc,
                    double border = 0) {
    bool proved = false;
    visit_carried(piece, gear, disc.offset, heading_tolerance, space.largest_coordinate(),
                  [&](const auto& path, double error) {
                    if (border > 0 && !space.bounds().contains(path.box().inflated(border))) return;
                    const double least = disc.radius + space.safety_radius() + error;
                    proved = prove_distance(space, path, least).status == ProofStatus::proved;
                  });
    return proved;
  }

  std::vector<FootprintDisc> discs_;
  FootprintDisc around_;
};

}  // namespace detail

/// Proves that a vehicle can drive a path and that every disc of its footprint keeps the space's
/// safety radius from every obstacle, with its centre within the bounds (up to rounding), at every
/// point of the continuous motion.
///
/// A point that is fixed to a vehicle moves along a segment where the reference point does, and
/// along an arc around the same centre where that does; both are decided in closed form. Along a
/// clothoid its path is enclosed by chords. `is_drivable` says that the pieces are segments, arcs
/// and clothoids without gaps, that no curvature exceeds 1 / min_turning_radius, that headings
/// continue (to 1e-9 rad, which the proof allows for), and that the vehicle has the gears. The
/// status is `violated` if not; it is never `proved` for an invalid vehicle.
template <ClearanceSpace S>
VehicleCertificate certify(const S& space, const Vehicle& vehicle, const VehiclePath& path,
                           const CertifyOptions& options = {}, const Budget& budget = {}) {
  VehicleCertificate certificate;
  certificate.clearance.distance_error_bound = space.distance_error_bound();
  if (!validate(vehicle)) return certificate;
  detail::measure_driving(vehicle, path, certificate);
  if (!certificate.is_drivable) {
    certificate.status = ProofStatus::violated;
    return certificate;
  }
  for (std::size_t k = 0; k < vehicle.footprint.size(); ++k) {
    const FootprintDisc& disc = vehicle.footprint[k];
    Certificate one = detail::certify_pieces(
        space, path.gears.size(), disc.radius + space.safety_radius(),
        [&](std::size_t i, const auto& use) {
          detail::visit_carried(path.curve.pieces()[i], path.gears[i], disc.offset,
                                certificate.max_heading_jump, space.largest_coordinate(), use);
        },
        options, budget);
    one.lower -= disc.radius;
    one.upper -= disc.radius;
    const bool nearest = k == 0 || one.upper < certificate.clearance.upper;
    const double lower = k == 0 ? one.lower : std::min(one.lower, certificate.clearance.lower);
    const std::size_t evaluations = certificate.clearance.evaluations + one.evaluations;
    if (nearest || one.status != ProofStatus::proved) {
      certificate.clearance = one;
      certificate.disc = k;
    }
    certificate.clearance.lower = lower;
    certificate.clearance.evaluations = evaluations;
    certificate.status = one.status;
    if (one.status != ProofStatus::proved) break;
  }
  return certificate;
}

}  // namespace tutavia
