// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/plan/statistics.hpp"
#include "tutavia/plan/vehicle.hpp"

/// \file
/// Route: the result of a searcher.

namespace tutavia {

/// A curve from start to goal, both exact, inside free space.
struct Route {
  Curve curve{};
  /// The minimised cost: the length [m], unless the searcher documents another one.
  double cost = 0;
  Statistics stats{};
  /// A route with headings: the vehicle that drives it, and a gear per piece. Empty in routes of a
  /// robot without headings.
  std::optional<Vehicle> vehicle{};
  std::vector<Gear> gears{};
  /// Width of the risk zone that the search avoided [m], 0 without one, and its weight (see
  /// RiskZone). Planner keeps the smoothed curve out of the zone wherever the route is out of it.
  double risk_width = 0;
  double risk_weight = 0;
  /// Name of the search that found the route, if several took part (FirstOf, AutoSearch).
  std::string_view found_by{};
};

}  // namespace tutavia
