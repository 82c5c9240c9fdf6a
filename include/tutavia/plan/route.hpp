// SPDX-License-Identifier: MIT
#pragma once

#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/statistics.hpp"

/// \file
/// Route: what a searcher returns.

namespace tutavia {

/// A curve from start to goal, both exact, inside free space.
struct Route {
  Curve curve{};
  double cost =
      0;  ///< what the search minimised; the length [m] unless the searcher says otherwise
  Statistics stats{};
};

}  // namespace tutavia
