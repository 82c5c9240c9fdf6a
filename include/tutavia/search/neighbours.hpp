// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Neighbours: which nodes a random tree rewires.

namespace tutavia {

/// Which nodes of a tree of n nodes count as near a new one. Both rules are those of Karaman and
/// Frazzoli 2011, section 3.3, for the plane. Each multiplies the bound that their theorems need by
/// `rewire_factor`.
enum class Neighbours {
  k_nearest,  ///< the e (1 + 1/2) ln n nearest
  /// Those within the smaller of the step and 2 sqrt(1 + 1/2) sqrt(A / pi) sqrt(ln n / n). A is the
  /// area of the bounds, an upper bound on the area of free space.
  radius,
};

}  // namespace tutavia
