// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/certify/certify_vehicle.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/search/vehicle/drive_chain.hpp"
#include "tutavia/search/vehicle/driving_costs.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/smooth/vehicle/improve_path.hpp"
#include "tutavia/smooth/vehicle/path_parts.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// VehicleShortcut: shortens a vehicle's path by drives of Reeds and Shepp, or of Dubins.

namespace tutavia {

/// Replaces parts of a vehicle's path by shortest drives that are proved free.
///
/// The candidates are the ends of the pieces and up to `places` poses at equal steps of arc
/// length. Dynamic programming finds the cheapest chain of parts of the path and of shortest drives
/// between any two candidates, each proved. It is repeated while it saves more than a thousandth.
/// The result never costs more than the input by the weights below, and keeps its ends, its
/// headings there and the turning radius. A vehicle that turns on the spot keeps its path. If the
/// budget ends, the best path so far is returned.
///
/// Errors: `invalid_option` for a weight below 1, a negative cusp_cost and less than 2 or more than
/// 1000 places.
///
/// Example: examples/13_car.cpp.
struct VehicleShortcut {
  static constexpr std::string_view name = "vehicle_shortcut";

  double reverse_weight = 1.5;  ///< a metre in reverse costs so much
  double cusp_cost = 1;         ///< a change of gear costs so much [m]
  int places = 40;

  template <ClearanceSpace S>
  Expected<VehiclePath, Failure> smooth(const S& space, const Vehicle& vehicle,
                                        const VehiclePath& path, const Budget& budget) const {
    if (auto valid = detail::check_chain_options(name, costs(), places); !valid) {
      return std::move(valid).unexpected();
    }
    if (!(vehicle.min_turning_radius > 0) || path.empty()) return path;
    detail::FootprintTest footprint(vehicle);
    const detail::CircularDrives drives(vehicle);
    return detail::improve_path(path, costs(), budget, [&](const VehiclePath& from) {
      std::vector<detail::PathPart> parts{{0, 0, 0, 0}};
      for (std::size_t i = 0; i < from.gears.size(); ++i) {
        detail::cut_piece(from, i, from.length() / places, true, parts);
      }
      return detail::chain_of(space, footprint, drives, costs(), from, parts, budget);
    });
  }

  /// A curve without gears is no path of a vehicle: `invalid_option`.
  template <class S>
  Expected<Curve, Failure> smooth(const S&, const Curve&, const Budget&) const {
    return fail(PlanError::invalid_option,
                "vehicle_shortcut smooths routes with headings; search with hybrid_astar");
  }

  /// The cost of a path by the weights [m].
  double cost_of(const VehiclePath& path) const { return detail::cost_of(path, costs()); }

 private:
  detail::DrivingCosts costs() const { return {1, reverse_weight, cusp_cost}; }
};

}  // namespace tutavia
