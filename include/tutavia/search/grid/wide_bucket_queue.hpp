// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tutavia/grid/movement.hpp"

/// \file
/// WideBucketQueue: an open list for keys that increase by any amount.

namespace tutavia::detail {

/// A monotone priority queue of 4096 circular buckets, 2^Shift wide, with two levels of occupancy
/// words and an overflow list. Keys within a bucket are last in, first out. Buckets are narrow, so
/// few nodes are popped out of order and re-opened. Nothing is freed between queries.
template <int Shift>
class WideBucketQueueOf {
 public:
  struct Entry {
    std::uint32_t node;
    std::uint32_t tag;   ///< for the searcher's own use
    std::uint32_t next;  // in the same bucket
  };

  static constexpr Cost width = Cost{1} << Shift;  ///< of a bucket

  /// Empties the queue. \pre no key will be less than `least`
  void reset(Cost least) {
    pool_.clear();
    overflow_.clear();
    occupied_.fill(0);
    words_ = 0;
    current_ = least >> Shift;
    least_overflow_ = std::numeric_limits<Cost>::max();
  }

  bool empty() const { return words_ == 0 && overflow_.empty(); }

  void push(Cost key, std::uint32_t node, std::uint32_t tag) {
    const Cost bucket = std::max(key >> Shift, current_);
    if (bucket - current_ >= static_cast<Cost>(count)) {
      overflow_.push_back({bucket, node, tag});
      least_overflow_ = std::min(least_overflow_, bucket);
    } else {
      put(static_cast<std::size_t>(bucket) % count, {node, tag, none});
    }
  }

  /// Selects the first non-empty bucket and returns a lower bound on all keys. \pre not empty
  Cost seek_first() {
    Cost first = words_ == 0 ? least_overflow_ : first_in_circle();
    if (first >= least_overflow_) {
      absorb_overflow();
      first = first_in_circle();
    }
    current_ = first;
    return current_ << Shift;
  }

  /// Removes and returns an entry of the bucket that `seek_first` selected.
  Entry pop() {
    const auto bucket = static_cast<std::size_t>(current_) % count;
    const Entry entry = pool_[heads_[bucket]];
    heads_[bucket] = entry.next;
    // Unpredictable, so branch-free.
    std::uint64_t& word = occupied_[bucket / 64];
    word &= ~(std::uint64_t{entry.next == none} << (bucket % 64));
    words_ &= ~(std::uint64_t{word == 0} << (bucket / 64));
    return entry;
  }

 private:
  static constexpr std::size_t count = 4096;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct OverflowEntry {
    Cost bucket;
    std::uint32_t node;
    std::uint32_t tag;
  };

  void put(std::size_t bucket, Entry entry) {
    const std::uint64_t bit = std::uint64_t{1} << (bucket % 64);
    entry.next = (occupied_[bucket / 64] & bit) != 0 ? heads_[bucket] : none;
    heads_[bucket] = static_cast<std::uint32_t>(pool_.size());
    pool_.push_back(entry);
    occupied_[bucket / 64] |= bit;
    words_ |= std::uint64_t{1} << (bucket / 64);
  }

  /// The first non-empty bucket from the current one on, around the circle. \pre there is one
  Cost first_in_circle() const {
    const auto at = static_cast<std::size_t>(current_) % count;
    const std::uint64_t here = occupied_[at / 64] >> (at % 64);
    if (here != 0) return current_ + std::countr_zero(here);
    const std::size_t next = at / 64 + 1;
    const auto rotation = static_cast<int>(next % 64);
    const std::size_t word =
        next + static_cast<std::size_t>(std::countr_zero(std::rotr(words_, rotation)));
    const std::size_t bucket =
        64 * word + static_cast<std::size_t>(std::countr_zero(occupied_[word % 64]));
    return current_ + static_cast<Cost>(bucket - at);
  }

  /// Moves the circle to the smallest bucket of the overflow list and takes in the entries that
  /// then fit.
  void absorb_overflow() {
    current_ = least_overflow_;
    least_overflow_ = std::numeric_limits<Cost>::max();
    std::size_t kept = 0;
    for (const OverflowEntry entry : overflow_) {
      if (entry.bucket - current_ < static_cast<Cost>(count)) {
        put(static_cast<std::size_t>(entry.bucket) % count, {entry.node, entry.tag, none});
      } else {
        least_overflow_ = std::min(least_overflow_, entry.bucket);
        overflow_[kept++] = entry;
      }
    }
    overflow_.resize(kept);
  }

  std::array<std::uint32_t, count> heads_{};
  std::array<std::uint64_t, 64> occupied_{};
  std::uint64_t words_ = 0;  // which words of occupied_ are not 0
  Cost current_ = 0;         // bucket number
  std::vector<Entry> pool_;
  std::vector<OverflowEntry> overflow_;
  Cost least_overflow_ = std::numeric_limits<Cost>::max();  // bucket number
};

/// Buckets of 1/14 of a cell: for searches that re-open nodes when a cheaper path is found.
using WideBucketQueue = WideBucketQueueOf<10>;

}  // namespace tutavia::detail
