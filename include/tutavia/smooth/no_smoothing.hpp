// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/vehicle.hpp"

/// \file
/// NoSmoothing: returns the route unchanged.

namespace tutavia {

/// Returns its input.
///
/// Example: examples/smoothers.cpp.
struct NoSmoothing {
  static constexpr std::string_view name = "none";

  template <class S>
  Expected<Curve, Failure> smooth(const S&, const Curve& curve, const Budget&) const {
    return curve;
  }
  template <class S>
  Expected<VehiclePath, Failure> smooth(const S&, const Vehicle&, const VehiclePath& path,
                                        const Budget&) const {
    return path;
  }
};

}  // namespace tutavia
