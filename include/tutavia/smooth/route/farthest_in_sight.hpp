// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>

/// \file
/// The farthest node of a path in sight, found by O(log n) lines of sight.
///
/// Sight need not be monotone along a path. The node found is in sight and its successor is hidden
/// (or it is the last node), but nodes farther on may be in sight again.

namespace tutavia::detail {

/// The last node of [seen, hidden) in sight, by bisection.
template <std::predicate<std::size_t> Sees>
std::size_t bisect_sight(std::size_t seen, std::size_t hidden, const Sees& sees) {
  while (seen + 1 < hidden) {
    const std::size_t middle = seen + (hidden - seen) / 2;
    if (sees(middle)) {
      seen = middle;
    } else {
      hidden = middle;
    }
  }
  return seen;
}

/// A node of (i, end] in sight, or i + 1: looks ahead in doubling steps until a node is hidden,
/// then bisects. `sees(j)` tells whether node j is in sight of node i. \pre i < end
template <std::predicate<std::size_t> Sees>
std::size_t farthest_looking_ahead(std::size_t i, std::size_t end, const Sees& sees) {
  std::size_t seen = i + 1;
  for (std::size_t step = 2; seen < end; step *= 2) {
    const std::size_t probe = std::min(i + step, end);
    if (!sees(probe)) return bisect_sight(seen, probe, sees);
    seen = probe;
  }
  return seen;
}

/// The same from the end backwards; may find later nodes, where sight opens again.
template <std::predicate<std::size_t> Sees>
std::size_t farthest_looking_back(std::size_t i, std::size_t end, const Sees& sees) {
  std::size_t seen = end, hidden = end + 1;
  for (std::size_t step = 1; seen > i + 1 && !sees(seen); step *= 2) {
    hidden = seen;
    seen -= std::min(step, seen - (i + 1));
  }
  return bisect_sight(seen, hidden, sees);
}

}  // namespace tutavia::detail
