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
/// SearchTree: a tree of points that knows what its ways cost, and who is near whom.

namespace tutavia::detail {

/// A tree of points, numbered in the order in which they are added; the root is node 0. The cost of
/// a node is, to the bit, its parent's cost plus that of the edge between them. Memory is kept from
/// one tree to the next.
class SearchTree {
 public:
  using Node = PointBuckets::Index;
  static constexpr Node none = PointBuckets::none;

  /// Starts again from a root in the bounds.
  void reset(const Box& bounds, const Point& root) {
    points_.reset(bounds);
    links_.clear();
    points_.add(root);
    links_.push_back({0, 0, none, none, none, none});
  }

  /// Forgets the tree.
  void clear() { links_.clear(); }

  std::size_t size() const { return links_.size(); }
  const PointBuckets& points() const { return points_; }
  Point position(Node node) const { return points_[node]; }
  /// Of the way from the root.
  double cost(Node node) const { return links_[node].cost; }
  /// Of the edge from the parent.
  double edge_cost(Node node) const { return links_[node].edge_cost; }
  /// None for the root.
  Node parent(Node node) const { return links_[node].parent; }

  Node add(Node parent, const Point& p, double edge_cost) {
    const Node node = points_.add(p);
    links_.push_back({cost(parent) + edge_cost, edge_cost, none, none, none, none});
    link(node, parent);
    return node;
  }

  /// Gives a node another parent, and it and its descendants their new costs.
  /// \pre the parent is no descendant of the node
  void rewire(Node node, Node parent, double edge_cost) {
    unlink(node);
    link(node, parent);
    links_[node].edge_cost = edge_cost;
    links_[node].cost = cost(parent) + edge_cost;
    for (Node below = after(node, node); below != none; below = after(below, node)) {
      links_[below].cost = cost(links_[below].parent) + links_[below].edge_cost;
    }
  }

  /// The points on the way from the root to a node.
  std::vector<Point> way_to(Node node) const {
    std::vector<Point> way;
    for (Node n = node; n != none; n = parent(n)) way.push_back(position(n));
    return {way.rbegin(), way.rend()};
  }

  /// Calls `visit(from, to)` for the ends of every edge, away from the root.
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    for (Node node = 1; node < size(); ++node) visit(position(parent(node)), position(node));
  }

 private:
  struct EndpointLinks {
    double cost, edge_cost;
    Node parent, child, next, previous;  // next and previous: children of the same parent
  };

  void link(Node node, Node parent) {
    EndpointLinks& links = links_[node];
    Node& first = links_[parent].child;
    links.parent = parent;
    links.previous = none;
    links.next = first;
    if (first != none) links_[first].previous = node;
    first = node;
  }

  void unlink(Node node) {
    const EndpointLinks& links = links_[node];
    TUTAVIA_ASSERT(links.parent != none);
    if (links.next != none) links_[links.next].previous = links.previous;
    (links.previous != none ? links_[links.previous].next : links_[links.parent].child) =
        links.next;
  }

  /// The descendant of `top` that comes after a node, parents before their children.
  Node after(Node current, Node top) const {
    if (links_[current].child != none) return links_[current].child;
    while (current != top && links_[current].next == none) current = links_[current].parent;
    return current == top ? none : links_[current].next;
  }

  PointBuckets points_;
  std::vector<EndpointLinks> links_;
};

}  // namespace tutavia::detail
