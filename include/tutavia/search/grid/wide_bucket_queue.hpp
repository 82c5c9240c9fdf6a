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
/// WideBucketQueue: an open list for keys that rise by any amount.

namespace tutavia::detail {

/// A monotone priority queue of 4096 circular buckets, 2^Shift wide, with two levels of occupancy
/// words, and a list of what lies beyond them. Keys within one bucket come last in, first out;
/// buckets are narrow, so few nodes are taken out of order and have to be re-opened. Nothing is
/// freed between queries.
template <int Shift>
class WideBucketQueueOf {
 public:
  struct Entry {
    std::uint32_t node;
    std::uint32_t note;  ///< the searcher's own
    std::uint32_t next;  // in the same bucket
  };

  static constexpr Cost width = Cost{1} << Shift;  ///< of a bucket

  /// Empties the queue; no key will be less than `least`.
  void reset(Cost least) {
    pool_.clear();
    beyond_.clear();
    occupied_.fill(0);
    words_ = 0;
    current_ = least >> Shift;
    least_beyond_ = std::numeric_limits<Cost>::max();
  }

  bool empty() const { return words_ == 0 && beyond_.empty(); }

  void push(Cost key, std::uint32_t node, std::uint32_t note) {
    const Cost bucket = std::max(key >> Shift, current_);
    if (bucket - current_ >= static_cast<Cost>(count)) {
      beyond_.push_back({bucket, node, note});
      least_beyond_ = std::min(least_beyond_, bucket);
    } else {
      put(static_cast<std::size_t>(bucket) % count, {node, note, none});
    }
  }

  /// A lower bound of all keys; moves on to the first bucket with entries. \pre not empty
  Cost seek_first() {
    Cost first = words_ == 0 ? least_beyond_ : first_in_circle();
    if (first >= least_beyond_) {
      take_in();
      first = first_in_circle();
    }
    current_ = first;
    return current_ << Shift;
  }

  /// Takes an entry from the bucket that `seek_first` has moved to.
  Entry pop() {
    const auto bucket = static_cast<std::size_t>(current_) % count;
    const Entry entry = pool_[heads_[bucket]];
    heads_[bucket] = entry.next;
    // Whether this was the last one is anybody's guess: no branches.
    std::uint64_t& word = occupied_[bucket / 64];
    word &= ~(std::uint64_t{entry.next == none} << (bucket % 64));
    words_ &= ~(std::uint64_t{word == 0} << (bucket / 64));
    return entry;
  }

 private:
  static constexpr std::size_t count = 4096;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct Beyond {
    Cost bucket;
    std::uint32_t node;
    std::uint32_t note;
  };

  void put(std::size_t bucket, Entry entry) {
    const std::uint64_t bit = std::uint64_t{1} << (bucket % 64);
    entry.next = (occupied_[bucket / 64] & bit) != 0 ? heads_[bucket] : none;
    heads_[bucket] = static_cast<std::uint32_t>(pool_.size());
    pool_.push_back(entry);
    occupied_[bucket / 64] |= bit;
    words_ |= std::uint64_t{1} << (bucket / 64);
  }

  /// The first bucket with entries from the current one on, around the circle. \pre there is one
  Cost first_in_circle() const {
    const auto at = static_cast<std::size_t>(current_) % count;
    const std::uint64_t here = occupied_[at / 64] >> (at % 64);
    if (here != 0) return current_ + std::countr_zero(here);
    const std::size_t next = at / 64 + 1;
    const auto turn = static_cast<int>(next % 64);
    const std::size_t word =
        next + static_cast<std::size_t>(std::countr_zero(std::rotr(words_, turn)));
    const std::size_t bucket =
        64 * word + static_cast<std::size_t>(std::countr_zero(occupied_[word % 64]));
    return current_ + static_cast<Cost>(bucket - at);
  }

  /// Turns the circle to the least bucket beyond it and takes in what then lies within.
  void take_in() {
    current_ = least_beyond_;
    least_beyond_ = std::numeric_limits<Cost>::max();
    std::size_t kept = 0;
    for (const Beyond entry : beyond_) {
      if (entry.bucket - current_ < static_cast<Cost>(count)) {
        put(static_cast<std::size_t>(entry.bucket) % count, {entry.node, entry.note, none});
      } else {
        least_beyond_ = std::min(least_beyond_, entry.bucket);
        beyond_[kept++] = entry;
      }
    }
    beyond_.resize(kept);
  }

  std::array<std::uint32_t, count> heads_{};
  std::array<std::uint64_t, 64> occupied_{};
  std::uint64_t words_ = 0;  // which words of occupied_ are not 0
  Cost current_ = 0;         // bucket number
  std::vector<Entry> pool_;
  std::vector<Beyond> beyond_;
  Cost least_beyond_ = std::numeric_limits<Cost>::max();  // bucket number
};

/// Buckets of 1/14 of a cell: for searches that open nodes again where a better way turns up.
using WideBucketQueue = WideBucketQueueOf<10>;

}  // namespace tutavia::detail
