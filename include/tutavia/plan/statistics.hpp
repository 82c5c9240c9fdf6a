// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// \file
/// Statistics: the effort of one planning query.

namespace tutavia {

/// The effort of one query. Counts are exact and reproducible; times are wall-clock microseconds.
struct Statistics {
  std::uint64_t expanded = 0;   ///< nodes taken from the open list and expanded
  std::uint64_t generated = 0;  ///< labels created or improved
  double search_us = 0;
  double smooth_us = 0;
  double certify_us = 0;
  std::uint64_t seed = 0;
};

}  // namespace tutavia
