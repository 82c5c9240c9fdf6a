// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "tutavia/plan/route.hpp"

/// \file
/// Whether a route lies in free space.

namespace tutavia::test {

/// Whether the straight line between the ends of every piece is free in the space.
template <class S>
bool is_free(const S& space, const Route& route) {
  const auto& pieces = route.curve.pieces();
  return std::all_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
    return space.segment_free(start_of(piece), end_of(piece));
  });
}

}  // namespace tutavia::test
