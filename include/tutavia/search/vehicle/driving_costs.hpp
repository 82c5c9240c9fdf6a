// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "tutavia/geometry/steering_word.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/plan/vehicle.hpp"

/// \file
/// DrivingCosts: what driving costs, beside its length.

namespace tutavia::detail {

/// The cost of driving, beside its length.
struct DrivingCosts {
  double forward = 1;  ///< of a metre
  double reverse = 1;  ///< of a metre in reverse
  double cusp = 0;     ///< of a change of gear [m]
};

/// The length of a move at this turning radius [m]; 0 if it is rounding.
inline double driven_length(const SteeringMove& move, double radius) {
  const double length = radius * std::abs(move.length);
  return length <= steering_rounding * radius ? 0 : length;
}

/// The cost of a word that follows a move in gear `before` [m]. `length(move)` is the length of a
/// move [m]; moves of length 0 cost nothing.
template <class Word, class Length>
double cost_of(const Word& word, const DrivingCosts& costs, std::optional<Gear> before,
               const Length& length) {
  double cost = 0;
  for (std::size_t i = 0; i < word.size; ++i) {
    const double driven = length(word.moves[i]);
    if (driven == 0) continue;
    const Gear gear = gear_of(word.moves[i].length);
    if (before && *before != gear) cost += costs.cusp;
    cost += (gear == Gear::reverse ? costs.reverse : costs.forward) * driven;
    before = gear;
  }
  return cost;
}

/// The cost of a path [m].
inline double cost_of(const VehiclePath& path, const DrivingCosts& costs) {
  double cost = costs.cusp * static_cast<double>(path.cusps().size());
  for (std::size_t i = 0; i < path.gears.size(); ++i) {
    const double length = path.curve.length_before(i + 1) - path.curve.length_before(i);
    cost += path.gears[i] == Gear::reverse ? costs.reverse * length : costs.forward * length;
  }
  return cost;
}

/// The route of a vehicle, at the cost of its path.
inline Route route_of(VehiclePath path, const Vehicle& vehicle, const DrivingCosts& costs) {
  Route route;
  route.cost = cost_of(path, costs);
  route.curve = std::move(path.curve);
  route.gears = std::move(path.gears);
  route.vehicle = vehicle;
  return route;
}

}  // namespace tutavia::detail
