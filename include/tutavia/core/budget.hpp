// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>

/// \file
/// Budget: how much time and work one query may take.

namespace tutavia {

/// Limits of one query; they hold for search, smoothing and certification alike. The default has
/// none.
struct Budget {
  using Clock = std::chrono::steady_clock;

  /// Why a query has to end before its answer.
  enum class End {
    exhausted,  ///< out of time
    cancelled,  ///< stopped on request
  };

  Clock::time_point deadline = Clock::time_point::max();
  std::uint64_t max_expansions = std::numeric_limits<std::uint64_t>::max();
  std::stop_token stop{};  ///< ask its std::stop_source to stop, from any thread

  /// A budget that ends `seconds` from now.
  static Budget for_seconds(double seconds) {
    constexpr double forever = 1e9;  // beyond it (and for NaN) the clock's range decides
    Budget budget;
    if (seconds < forever) {
      seconds = seconds > 0 ? seconds : 0;
      budget.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(seconds));
    }
    return budget;
  }

  bool cancelled() const { return stop.stop_requested(); }

  /// What ends the query now, if anything does. Reads the clock: call it once per some hundred
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
