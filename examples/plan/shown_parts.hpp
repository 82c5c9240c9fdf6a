// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// \file
/// ShownParts: the parts of a picture that --show chooses.

namespace plan_program {

/// What a picture shows besides the map, the routes and the curves.
struct ShownParts {
  bool visited = false;    ///< nodes that the searches expanded
  bool tree = false;       ///< random trees, and their paths before nodes are removed
  bool zones = false;      ///< safety zones, and the risk zones that routes avoid
  bool passages = false;   ///< rectangles with the intervals through which they were entered
  bool profile = false;    ///< clearance and curvature along the curves
  bool footprint = false;  ///< outlines of vehicles along their paths

  /// Whether it shows parts of searches.
  bool has_search() const { return visited || tree || passages; }
};

/// What pictures show without --show.
constexpr ShownParts default_parts() {
  return {.tree = true, .zones = true, .passages = true, .footprint = true};
}

/// Reads a comma list of names. Throws a UsageError that names the part nearest to an unknown one.
ShownParts parse_shown_parts(const std::string& text);

}  // namespace plan_program
