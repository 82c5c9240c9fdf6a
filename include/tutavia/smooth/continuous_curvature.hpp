// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/certify/certify_vehicle.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/clothoid.hpp"
#include "tutavia/geometry/continuous_drives.hpp"
#include "tutavia/geometry/curvature.hpp"
#include "tutavia/geometry/piece.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/search/vehicle/driving_costs.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/smooth/vehicle/improve_path.hpp"
#include "tutavia/smooth/vehicle/path_parts.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// ContinuousCurvature: gives a vehicle's path a curvature that never jumps.

namespace tutavia {

/// Replaces a vehicle's path by drives of continuous curvature (see ContinuousDrives), each proved
/// free for the whole footprint.
///
/// The candidates are the ends of the pieces and up to `places` poses at equal steps of arc
/// length. Dynamic programming finds the cheapest chain of drives between any two of them; straight
/// parts of the path may stay. The chain is then improved in the same way, between the poses on it
/// at which the wheels stand straight, while that saves more than a thousandth.
///
/// Guarantees: the result keeps the ends, the headings there, the turning radius and the gears that
/// the vehicle has; its curvature is continuous, changes by at most `max_sharpness`, and is 0 at
/// the ends and at cusps. Turns take more room than at the turning radius alone, so the result may
/// be longer and have more cusps than the path, or there is none (`not_proved`). A vehicle that
/// turns on the spot keeps its path.
///
/// Errors: `invalid_option` for a sharpness that is negative or not finite, a weight below 1, a
/// negative cusp_cost and less than 2 or more than 1000 places; `not_proved`; those of the budget
/// while there is no chain, otherwise the best one so far is returned.
///
/// Example: examples/13_car.cpp.
struct ContinuousCurvature {
  static constexpr std::string_view name = "continuous_curvature";

  /// Largest change of the curvature with arc length [1/m^2]; 0: to full lock within a turning
  /// radius, 1 / min_turning_radius^2.
  double max_sharpness = 0;
  double reverse_weight = 1.5;  ///< a metre in reverse costs so much
  double cusp_cost = 1;         ///< a change of gear costs so much [m]
  int places = 40;

  template <ClearanceSpace S>
  Expected<VehiclePath, Failure> smooth(const S& space, const Vehicle& vehicle,
                                        const VehiclePath& path, const Budget& budget) const {
    if (!(max_sharpness >= 0) || !std::isfinite(max_sharpness)) {
      return fail(PlanError::invalid_option, "max_sharpness must be finite and not negative");
    }
    if (auto valid = detail::check_chain_options(name, costs(), places); !valid) {
      return std::move(valid).unexpected();
    }
    const double radius = vehicle.min_turning_radius;
    if (!(radius > 0) || path.empty()) return path;
    const SteeringLimits limits{radius, max_sharpness > 0 ? max_sharpness : 1 / (radius * radius)};
    const ContinuousDrives drives(limits, vehicle.reverse);
    detail::FootprintTest footprint(vehicle);
    const auto improve = [&](const VehiclePath& from) {
      return detail::chain_of(space, footprint, drives, costs(), from, cut(from, limits), budget);
    };
    std::optional<VehiclePath> first = improve(path);
    if (!first) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
      return fail(PlanError::not_proved,
                  "no drives of continuous curvature along this path are free; more `places`, a "
                  "larger `max_sharpness` or a search with a larger turning radius may help");
    }
    return detail::improve_path(std::move(*first), costs(), budget, improve);
  }

  /// A curve without gears is no path of a vehicle: `invalid_option`.
  template <class S>
  Expected<Curve, Failure> smooth(const S&, const Curve&, const Budget&) const {
    return fail(PlanError::invalid_option,
                "continuous_curvature smooths routes with headings; search with hybrid_astar");
  }

 private:
  detail::DrivingCosts costs() const { return {1, reverse_weight, cusp_cost}; }

  /// The parts between neighbouring candidates, after an empty one at the start. Straight ones and
  /// whole turns of continuous curvature may stay.
  std::vector<detail::PathPart> cut(const VehiclePath& path, const SteeringLimits& limits) const {
    std::vector<detail::PathPart> parts{{0, 0, 0, 0}};
    for (std::size_t i = 0; i < path.gears.size(); ++i) {
      const std::optional<std::size_t> last = end_of_turn(path, i, limits);
      if (last && !is_straight(path.curve.pieces()[i])) {
        parts.push_back({i, 0, 1, *last});
        i = *last;
      } else {
        detail::cut_piece(path, i, path.length() / places, last.has_value(), parts);
      }
    }
    return parts;
  }

  static bool is_straight(const Piece& piece) {
    return piece.visit([](const auto& p) { return max_curvature(p); }) == 0;
  }

  /// The last of the pieces from `first` on between which the curvature does not jump, from 0 to 0
  /// in one gear; none if the curvature jumps before, or changes too sharply.
  static std::optional<std::size_t> end_of_turn(const VehiclePath& path, std::size_t first,
                                                const SteeringLimits& limits) {
    const double rounding = 1e-12 / limits.min_turning_radius;
    double before = 0;
    for (std::size_t i = first; i < path.gears.size(); ++i) {
      const Piece& piece = path.curve.pieces()[i];
      if (path.gears[i] != path.gears[first]) return std::nullopt;
      if (const Clothoid* clothoid = piece.get_if<Clothoid>();
          clothoid != nullptr &&
          std::abs(clothoid->sharpness) > limits.max_sharpness * (1 + 1e-12)) {
        return std::nullopt;
      }
      const auto at = [&](double t) {
        return piece.visit([&](const auto& p) { return curvature(p, t); });
      };
      if (!(std::abs(at(0) - before) <= rounding)) return std::nullopt;
      before = at(1);
      if (std::abs(before) <= rounding) return i;
    }
    return std::nullopt;
  }
};

}  // namespace tutavia
