// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>

#include "tutavia/core/stop_token.hpp"

/// \file
/// Budget: limits on the time and work of one query.

namespace tutavia {

/// Limits of one query, for search, smoothing and certification. The default has no limits.
///
/// Example: examples/08_budget.cpp.
struct Budget {
  using Clock = std::chrono::steady_clock;

  /// The reason why a query ends early.
  enum class End {
    exhausted,  ///< out of time
    cancelled,  ///< stopped on request
  };

  Clock::time_point deadline = Clock::time_point::max();
  std::uint64_t max_expansions = std::numeric_limits<std::uint64_t>::max();
  StopToken stop{};  ///< cancel from any thread through its StopSource

  /// A budget that ends `seconds` from now.
  static Budget for_seconds(double seconds) {
    constexpr double forever = 1e9;  // beyond it, and for NaN, there is no deadline
    Budget budget;
    if (seconds < forever) {
      seconds = seconds > 0 ? seconds : 0;
      budget.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(seconds));
    }
    return budget;
  }

  bool cancelled() const { return stop.stop_requested(); }

  /// The reason to end the query now, if any. Reads the clock: call it once every few hundred
  /// steps.
  std::optional<End> exceeded() const {
    if (cancelled()) return End::cancelled;
    if (deadline != Clock::time_point::max() && Clock::now() >= deadline) {
      return End::exhausted;
    }
    return std::nullopt;
  }
};

}  // namespace tutavia
