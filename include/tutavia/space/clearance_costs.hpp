// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "tutavia/grid/cell_costs.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// clearance_costs: cell costs that increase near obstacles.

namespace tutavia {

/// How much more a step near obstacles costs.
struct ClearanceCostOptions {
  double distance = 1;  ///< beyond the safety radius, where the extra cost ends [m]
  double weight = 2;    ///< extra cost at the safety radius, times the length; 0 to 7.96
};

/// Extra costs of cells that decrease linearly from `weight` at the safety radius to 0 at
/// `distance` beyond it. Errors: `invalid_option` for a distance that is not positive and finite,
/// or a weight out of range.
template <ClearanceGridSpace S>
Expected<std::shared_ptr<const CellCosts>, Failure> clearance_costs(
    const S& space, const ClearanceCostOptions& options) {
  if (!(options.distance > 0) || !std::isfinite(options.distance)) {
    return fail(PlanError::invalid_option, "distance must be positive and finite");
  }
  if (!(options.weight >= 0 && options.weight <= 255.0 / 32)) {
    return fail(PlanError::invalid_option, "weight must lie between 0 and 7.96");
  }
  auto costs = std::make_shared<CellCosts>(space.grid());
  for (int y = 0; y < costs->height(); ++y) {
    for (int x = 0; x < costs->width(); ++x) {
      const Cell cell{x, y};
      if (!space.grid().is_free(cell)) continue;
      const Point p = space.frame().point(cell);
      const double cap = space.safety_radius() + options.distance;
      const double gap = space.nearest(Segment{p, p}, cap).distance - space.safety_radius();
      const double share = std::clamp(1 - gap / options.distance, 0.0, 1.0);
      costs->set(cell, static_cast<std::uint8_t>(std::lround(32 * options.weight * share)));
    }
  }
  return std::shared_ptr<const CellCosts>(std::move(costs));
}

}  // namespace tutavia
