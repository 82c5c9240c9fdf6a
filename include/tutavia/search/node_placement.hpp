// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// NodePlacement: where paths at any angle bend.

namespace tutavia {

/// Where the paths of a search bend.
enum class NodePlacement {
  cell_centre,  ///< at the reference points of the space's grid
  /// At corners of cells, by the rules of CornerGraph; on a CellSpace of radius 0. The first query
  /// on a space makes its grid of corners, in O(cells).
  cell_corner,
};

}  // namespace tutavia
