// SPDX-License-Identifier: MIT
#pragma once

#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/statistics.hpp"

/// \file
/// Route: the result of a searcher.

namespace tutavia {

/// A curve from start to goal, both exact, inside free space.
struct Route {
  Curve curve{};
  /// The minimised cost: the length [m], unless the searcher documents another one.
  double cost = 0;
  Statistics stats{};
};

}  // namespace tutavia
