// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// Query: the input of a searcher.

namespace tutavia {

/// Start, goal and budget of one search. A missing start or goal is `invalid_input`. A search that
/// does not plan headings refuses a query with headings by `invalid_option` (HybridAStar plans
/// them).
struct Query {
  Point start{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  Point goal{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  std::optional<double> start_heading{};  ///< [rad]; empty: any
  std::optional<double> goal_heading{};   ///< [rad]; empty: any
  Budget budget{};
  std::uint64_t seed = 0;  ///< for searchers that draw random numbers
};

}  // namespace tutavia
