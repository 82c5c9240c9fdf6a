// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/grid/cell.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/search/grid/stamped_labels.hpp"
#include "tutavia/search/grid/wide_bucket_queue.hpp"

/// \file
/// IntervalScratch: memory of an any-angle search.

namespace tutavia::detail {

/// A search node: a side through which a piece is entered, and the part of it that a root sees.
struct IntervalNode {
  double f = 0;                  ///< lower bound on the length of paths through it [cells]
  double g = 0;                  ///< length of the path to the root [cells]
  Cell root{};                   ///< the last corner at which the path bends
  std::uint32_t piece = 0;       ///< the piece to be entered
  Cell right{}, left{};          ///< the side's ends, as seen from the previous piece
  Cell right_ray{}, left_ray{};  ///< points on the rays from the root that bound its view
};

/// The label of a corner at which paths bend.
struct IntervalRoot {
  double g;
  std::uint32_t parent;
  std::uint32_t query;
};

/// The open list, the roots reached, and the dead ends that a query may enter.
class IntervalScratch {
 public:
  using Node = IntervalNode;

  void reset(std::size_t corners, std::size_t pieces) {
    roots_.reset(corners);
    passages_.reset(pieces);
    open_.reset(0);
    nodes_.clear();
    successors.clear();
  }

  /// The root at a corner; nullptr if no path bends there yet.
  const IntervalRoot* find_root(std::uint32_t corner) const { return roots_.find(corner); }
  /// \pre the corner was reached
  const IntervalRoot& root(std::uint32_t corner) const { return roots_[corner]; }
  void set_root(std::uint32_t corner, double g, std::uint32_t parent) {
    roots_.set(corner, {g, parent, 0});
  }

  /// Whether a dead end contains the start or the goal, or leads to one that does.
  bool is_passage(std::size_t piece) const { return passages_.find(piece) != nullptr; }
  void set_passage(std::size_t piece) { passages_.set(piece, {}); }

  bool empty() const { return open_.empty(); }
  /// Selects the nodes with the least f and returns a lower bound on it. \pre not empty
  double seek_first() {
    least_ = open_.seek_first();
    return static_cast<double>(least_) / scale;
  }
  void push(const Node& node) {
    open_.push(key(node), static_cast<std::uint32_t>(nodes_.size()), 0);
    nodes_.push_back(node);
  }
  /// Whether a node would be popped at once if it were pushed.
  bool is_next(const Node& node) const { return key(node) < least_ + WideBucketQueue::width; }
  /// A node with approximately the least f. \pre `seek_first` was called after the last push
  const Node& pop() { return nodes_[open_.pop().node]; }

  std::vector<Node> successors;

 private:
  struct Passage {
    std::uint32_t query;
  };
  static constexpr auto scale = static_cast<double>(straight_cost);
  static Cost key(const Node& node) { return static_cast<Cost>(node.f * scale); }

  StampedLabels<IntervalRoot> roots_;
  StampedLabels<Passage> passages_;
  WideBucketQueue open_;
  Cost least_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace tutavia::detail
