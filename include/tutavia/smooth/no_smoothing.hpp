// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// NoSmoothing: the route as it is.

namespace tutavia {

/// Returns its input.
struct NoSmoothing {
  static constexpr std::string_view name = "none";

  template <class S>
  Expected<Curve, Failure> smooth(const S&, const Curve& curve, const Budget&) const {
    return curve;
  }
};

}  // namespace tutavia
