// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/search/tree/point_buckets.hpp"

/// \file
/// SearchTree: a tree of points with path costs and nearest-neighbour queries.

namespace tutavia::detail {

/// A tree of points, numbered in the order of insertion; the root is node 0. The cost of a node is
/// exactly, to the bit, its parent's cost plus that of the edge between them. Keeps its memory from
/// one tree to the next.
class SearchTree {
 public:
  using Node = PointBuckets::Index;
  static constexpr Node none = PointBuckets::none;

  /// Starts a new tree. \pre the root lies in the bounds
  void reset(const Box& bounds, const Point& root) {
    points_.reset(bounds);
    links_.clear();
    points_.add(root);
    links_.push_back({0, 0, none, none, none, none});
  }

  /// Removes all nodes.
  void clear() { links_.clear(); }

  std::size_t size() const { return links_.size(); }
  const PointBuckets& points() const { return points_; }
  Point position(Node node) const { return points_[node]; }
  /// Cost of the path from the root.
  double cost(Node node) const { return links_[node].cost; }
  /// Cost of the edge from the parent.
  double edge_cost(Node node) const { return links_[node].edge_cost; }
  /// `none` for the root.
  Node parent(Node node) const { return links_[node].parent; }

  Node add(Node parent, const Point& p, double edge_cost) {
    const Node node = points_.add(p);
    links_.push_back({cost(parent) + edge_cost, edge_cost, none, none, none, none});
    link(node, parent);
    return node;
  }

  /// Gives a node a new parent and updates the costs of the node and its descendants. \pre the
  /// parent is not a descendant of the node
  void rewire(Node node, Node parent, double edge_cost) {
    unlink(node);
    link(node, parent);
    links_[node].edge_cost = edge_cost;
    links_[node].cost = cost(parent) + edge_cost;
    for (Node below = after(node, node); below != none; below = after(below, node)) {
      links_[below].cost = cost(links_[below].parent) + links_[below].edge_cost;
    }
  }

  /// The points on the path from the root to a node.
  std::vector<Point> path_to(Node node) const {
    std::vector<Point> path;
    for (Node n = node; n != none; n = parent(n)) path.push_back(position(n));
    return {path.rbegin(), path.rend()};
  }

  /// Calls `visit(from, to)` for the ends of every edge, away from the root.
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    for (Node node = 1; node < size(); ++node) visit(position(parent(node)), position(node));
  }

 private:
  struct NodeLinks {
    double cost, edge_cost;
    Node parent, child, next, previous;  // next and previous are siblings
  };

  void link(Node node, Node parent) {
    NodeLinks& links = links_[node];
    Node& first = links_[parent].child;
    links.parent = parent;
    links.previous = none;
    links.next = first;
    if (first != none) links_[first].previous = node;
    first = node;
  }

  void unlink(Node node) {
    const NodeLinks& links = links_[node];
    TUTAVIA_ASSERT(links.parent != none);
    if (links.next != none) links_[links.next].previous = links.previous;
    (links.previous != none ? links_[links.previous].next : links_[links.parent].child) =
        links.next;
  }

  /// The descendant of `top` after `current` in preorder.
  Node after(Node current, Node top) const {
    if (links_[current].child != none) return links_[current].child;
    while (current != top && links_[current].next == none) current = links_[current].parent;
    return current == top ? none : links_[current].next;
  }

  PointBuckets points_;
  std::vector<NodeLinks> links_;
};

}  // namespace tutavia::detail
