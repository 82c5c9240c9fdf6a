// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

/// \file
/// Statistics: the effort of one planning query.

namespace tutavia {

/// The effort of one query. Counts are exact and reproducible; times are wall-clock microseconds.
struct Statistics {
  std::uint64_t expanded = 0;   ///< expansions of nodes taken from the open list
  std::uint64_t generated = 0;  ///< labels created or improved
  /// Nodes expanded at least once: fewer than `expanded` where nodes are re-opened. Counted by
  /// SsaAStar, unless the straight segment is the answer; empty in other searches, because counting
  /// takes 3 to 5 % of their time.
  std::optional<std::uint64_t> distinct{};
  double search_us = 0;
  double smooth_us = 0;
  double certify_us = 0;
  std::uint64_t seed = 0;
};

}  // namespace tutavia
