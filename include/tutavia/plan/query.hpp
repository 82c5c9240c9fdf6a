// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// Query: what a searcher is asked.

namespace tutavia {

/// From where to where, and at what expense. A goal that is left out is an `invalid_input`.
struct Query {
  Point start{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  Point goal{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  Budget budget{};
  std::uint64_t seed = 0;  ///< for searchers that draw random numbers
};

}  // namespace tutavia
