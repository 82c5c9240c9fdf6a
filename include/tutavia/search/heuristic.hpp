// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Heuristics on grids.

namespace tutavia {

/// How a search estimates the cost from a cell to the goal. On eight-connected grids octile,
/// Euclidean and Chebyshev distance never exceed it (they are admissible, in this order of
/// strength); Manhattan distance does, by a factor of up to sqrt(2), and so gives paths up to that
/// much longer. On four-connected grids all are admissible and Manhattan distance is the strongest.
enum class HeuristicKind { octile, euclidean, chebyshev, manhattan };

}  // namespace tutavia
