// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "tutavia/search/tree/search_tree.hpp"

/// \file
/// Invariants of every tree of a sampling search, and its fingerprint.

namespace tutavia::test {

/// Every node reaches the root through its parents, and its cost is the sum of those edges.
inline void check_tree(const detail::SearchTree& tree) {
  std::size_t wrong = 0;
  for (detail::SearchTree::Node node = 0; node < tree.size(); ++node) {
    if ((tree.parent(node) == detail::SearchTree::none) != (node == 0)) ++wrong;
    if (node == 0) continue;
    if (tree.cost(node) != tree.cost(tree.parent(node)) + tree.edge_cost(node)) ++wrong;
    std::size_t steps = 0;
    detail::SearchTree::Node ancestor = node;
    while (ancestor != 0 && ancestor != detail::SearchTree::none && steps <= tree.size()) {
      ancestor = tree.parent(ancestor);
      ++steps;
    }
    if (ancestor != 0) ++wrong;
  }
  CHECK(wrong == 0);
}

/// FNV-1a over parents, and over positions and costs to the bit.
inline std::uint64_t fingerprint(const detail::SearchTree& tree) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](std::uint64_t word) {
    for (int i = 0; i < 64; i += 8) hash = (hash ^ (word >> i & 0xff)) * 0x100000001b3u;
  };
  for (detail::SearchTree::Node node = 0; node < tree.size(); ++node) {
    add(tree.parent(node));
    add(std::bit_cast<std::uint64_t>(tree.position(node).x()));
    add(std::bit_cast<std::uint64_t>(tree.position(node).y()));
    add(std::bit_cast<std::uint64_t>(tree.cost(node)));
  }
  return hash;
}

}  // namespace tutavia::test
