// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// NodePlacement: where the nodes of any-angle paths lie.

namespace tutavia {

/// Where the paths of a search may bend.
enum class NodePlacement {
  cell_centre,  ///< at the reference points of the space's grid
  /// At corners of cells, by the rules of CornerGraph; for a CellSpace of safety radius 0. The
  /// first query on a space builds its grid of corners, in O(cells).
  cell_corner,
};

}  // namespace tutavia
