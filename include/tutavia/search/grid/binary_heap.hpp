// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "tutavia/grid/movement.hpp"
#include "tutavia/search/grid/open_heap.hpp"

/// \file
/// BinaryHeap: an open list for keys that may decrease.

namespace tutavia::detail {

/// A binary heap with the interface of WideBucketQueue, for heuristics that are not consistent.
/// Ties go to the entry pushed last.
class BinaryHeap {
 public:
  struct Entry {
    Cost key;
    std::uint32_t sequence;
    std::uint32_t node;
    std::uint32_t tag;  ///< for the searcher's own use

    friend bool operator<(const Entry& a, const Entry& b) {  // worse < better
      return a.key != b.key ? a.key > b.key : a.sequence < b.sequence;
    }
  };

  static constexpr Cost width = 1;  ///< keys are compared exactly

  /// Empties the heap.
  void reset(Cost) {
    entries_.clear();
    sequence_ = 0;
  }

  bool empty() const { return entries_.empty(); }

  void push(Cost key, std::uint32_t node, std::uint32_t tag) {
    entries_.push({key, sequence_++, node, tag});
  }

  /// The smallest key. \pre not empty
  Cost seek_first() const { return entries_.top().key; }

  /// Removes and returns an entry with the smallest key. \pre not empty
  Entry pop() { return entries_.pop(); }

 private:
  OpenHeap<Entry> entries_;
  std::uint32_t sequence_ = 0;
};

}  // namespace tutavia::detail
