// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/search/vehicle/driving_costs.hpp"

/// \file
/// What smoothers of vehicles' paths share: the check of their options, and their repetition.

namespace tutavia::detail {

/// Errors: `invalid_option` for weights and numbers of places out of range.
inline Expected<void, Failure> check_chain_options(std::string_view name, const DrivingCosts& costs,
                                                   int places) {
  if (costs.reverse >= 1 && std::isfinite(costs.reverse) && costs.cusp >= 0 &&
      std::isfinite(costs.cusp) && places >= 2 && places <= 1000) {
    return {};
  }
  return fail(
      PlanError::invalid_option,
      std::string(name) +
          " needs a finite reverse_weight of 1 or more, a finite cusp_cost of 0 or more and "
          "2 to 1000 places");
}

/// Replaces a path by `improve(path)` while that costs less, until less than a thousandth is saved
/// or the budget ends.
template <class Improve>
VehiclePath improve_path(VehiclePath path, const DrivingCosts& costs, const Budget& budget,
                         const Improve& improve) {
  double cost = cost_of(path, costs);
  while (!budget.exceeded()) {
    std::optional<VehiclePath> better = improve(path);
    if (!better) break;
    const double reached = cost_of(*better, costs);
    if (!(reached < cost)) break;
    const bool is_little = reached > cost * (1 - 1e-3);
    path = std::move(*better);
    cost = reached;
    if (is_little) break;
  }
  return path;
}

}  // namespace tutavia::detail
