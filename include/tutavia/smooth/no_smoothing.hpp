// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"

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
};

}  // namespace tutavia
