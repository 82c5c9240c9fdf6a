// SPDX-License-Identifier: MIT
#pragma once

#include "support/random_grids.hpp"
#include "tutavia/plan/query.hpp"

/// \file
/// Random queries on grids.

namespace tutavia::test {

/// A query between the reference points of two cells, as `random_cell` draws them.
template <class S>
Query random_query(Random& random, const S& space) {
  const Cell start = random_cell(random, space.grid()), goal = random_cell(random, space.grid());
  return {.start = space.frame().point(start), .goal = space.frame().point(goal)};
}

}  // namespace tutavia::test
