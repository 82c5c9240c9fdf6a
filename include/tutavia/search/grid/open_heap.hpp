// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

/// \file
/// OpenHeap: what waits in a search, the best first.

namespace tutavia::detail {

/// A binary heap of entries; `a < b` says that entry a is worse than b. The order never depends on
/// the heap where no two entries are equal. Keeps its memory from one query to the next.
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
  /// Takes the best entry. \pre not empty
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
