// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <vector>

/// \file
/// remove_redundant: the forward scan that drops the nodes a path can do without.

namespace tutavia::detail {

/// Drops nodes of a path where the one before sees the one after: from each node kept it steps
/// forward while `sees(kept, next)` holds, and keeps the last node seen. The path gets no longer;
/// it need not become the shortest of its kind. O(n) lines of sight. Source: the redundant-node
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
