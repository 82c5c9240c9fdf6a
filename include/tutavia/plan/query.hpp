// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// Query: the input of a searcher.

namespace tutavia {

/// Start, goal and budget of one search. A missing start or goal is `invalid_input`.
struct Query {
  Point start{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  Point goal{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  Budget budget{};
  std::uint64_t seed = 0;  ///< for searchers that draw random numbers
};

}  // namespace tutavia
