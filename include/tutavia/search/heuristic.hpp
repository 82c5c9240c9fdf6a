// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// HeuristicKind: the heuristics of searches on grids.

namespace tutavia {

/// How a search estimates the cost from a cell to the goal. On eight-connected grids octile,
/// Euclidean and Chebyshev distance are admissible, from strongest to weakest. Manhattan distance
/// overestimates by a factor of up to sqrt(2), so paths may be longer by that factor. On
/// four-connected grids all four are admissible and Manhattan distance is the strongest.
enum class HeuristicKind { octile, euclidean, chebyshev, manhattan };

}  // namespace tutavia
