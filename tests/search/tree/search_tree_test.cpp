// SPDX-License-Identifier: MIT
#include "tutavia/search/tree/search_tree.hpp"

#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "support/tree_invariants.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using Node = SearchTree::Node;

bool descends_from(const SearchTree& tree, Node node, Node ancestor) {
  while (node != SearchTree::none && node != ancestor) node = tree.parent(node);
  return node == ancestor;
}

TEST_CASE("costs stay the sums of edges through any rewiring", "[soak]") {
  SearchTree tree;
  for (std::uint64_t seed = 1; seed <= test::scaled(20); ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    tree.reset({{0, 0}, {1, 1}}, {0.5, 0.5});
    for (int i = 0; i < 200; ++i) {
      const auto any = [&] { return static_cast<Node>(random.below(tree.size())); };
      tree.add(any(), {random.uniform(), random.uniform()}, random.uniform());
      const Node node = any(), parent = any();
      if (node != 0 && !descends_from(tree, parent, node)) {
        tree.rewire(node, parent, random.uniform());
        CHECK(tree.parent(node) == parent);
      }
      test::check_tree(tree);
    }
  }
}

TEST_CASE("a tree gives the way to a node and all its edges") {
  SearchTree tree;
  tree.reset({{0, 0}, {4, 4}}, {1, 1});
  const Node a = tree.add(0, {2, 1}, 1), b = tree.add(a, {2, 2}, 1), c = tree.add(0, {1, 2}, 1);
  CHECK(tree.path_to(b) == std::vector<Point>{{1, 1}, {2, 1}, {2, 2}});
  tree.rewire(b, c, 5);
  CHECK(tree.path_to(b) == std::vector<Point>{{1, 1}, {1, 2}, {2, 2}});
  CHECK(tree.cost(b) == 6);
  CHECK(tree.edge_cost(b) == 5);
  std::size_t edges = 0;
  tree.for_each_edge([&](const Point& from, const Point& to) {
    ++edges;
    CHECK(from != to);
  });
  CHECK(edges == 3);
  tree.reset({{0, 0}, {1, 1}}, {0, 0});
  CHECK(tree.size() == 1);
  CHECK(tree.path_to(0).size() == 1);
}

}  // namespace
