// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

/// \file
/// OpenHeap: the open list of a search as a binary heap.

namespace tutavia::detail {

/// A binary heap of entries; `a < b` means that entry a is worse than b. If no two entries are
/// equal, the order does not depend on the heap. Keeps its memory from one query to the next.
template <class Entry>
class OpenHeap {
 public:
  bool empty() const { return entries_.empty(); }
  void clear() { entries_.clear(); }

  void push(const Entry& entry) {
    entries_.push_back(entry);
    std::push_heap(entries_.begin(), entries_.end());
  }

  /// The best entry. \pre not empty
  const Entry& top() const { return entries_.front(); }
  /// Removes and returns the best entry. \pre not empty
  Entry pop() {
    std::pop_heap(entries_.begin(), entries_.end());
    const Entry entry = entries_.back();
    entries_.pop_back();
    return entry;
  }

 private:
  std::vector<Entry> entries_;
};

}  // namespace tutavia::detail
