// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <vector>

/// \file
/// remove_redundant: a forward scan that removes redundant nodes of a path.

namespace tutavia::detail {

/// Removes nodes of a path whose neighbours see each other: from each kept node it advances while
/// `sees(kept, next)` holds, and keeps the last node seen. The path never becomes longer, but need
/// not be the shortest of its homotopy class. O(n) lines of sight. Source: the redundant-node
/// removal of Yang et al., "Improved A* based on fused Theta*".
template <class Node, std::predicate<const Node&, const Node&> Sees>
void remove_redundant(std::vector<Node>& path, const Sees& sees) {
  if (path.size() < 3) return;
  std::size_t kept = 1;  // nodes kept so far
  for (std::size_t next = 2; next < path.size(); ++next) {
    if (!sees(path[kept - 1], path[next])) path[kept++] = path[next - 1];
  }
  path[kept++] = path.back();
  path.resize(kept);
}

}  // namespace tutavia::detail
