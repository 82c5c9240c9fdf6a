// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/grid/movement.hpp"

/// \file
/// BucketQueue: an open list for keys that rise slowly.

namespace tutavia::detail {

/// What waits in a BucketQueue.
struct BucketEntry {
  std::uint32_t node;
  std::uint32_t note;  ///< the searcher's own
};

/// The memory of a BucketQueue; nothing is freed between queries.
using Buckets = std::array<std::vector<BucketEntry>, 64>;

/// A monotone priority queue of 64 circular buckets, each 2^Shift wide, with an occupancy word
/// (Dial 1969, "Shortest path forest with topological ordering"; Denardo and Fox 1979 for the
/// width).
///
/// Keys within one bucket come last in, first out, so a search has to re-open nodes, unless no
/// step is cheaper than a bucket is wide. Every key pushed has to lie in the 63 buckets from the
/// one that `seek_first` has moved to.
template <int Shift>
class BucketQueue {
 public:
  static constexpr Cost width = Cost{1} << Shift;  ///< of a bucket

  /// An empty queue; no key will be less than `least`.
  BucketQueue(Buckets& buckets, Cost least)
      : buckets_(buckets), current_(static_cast<std::uint64_t>(least) >> Shift) {
    for (std::vector<BucketEntry>& bucket : buckets) bucket.clear();
  }

  bool empty() const { return occupied_ == 0; }

  void push(Cost key, std::uint32_t node, std::uint32_t note) {
    const auto bucket = (static_cast<std::uint64_t>(key) >> Shift) % 64;
    buckets_[bucket].push_back({node, note});
    occupied_ |= std::uint64_t{1} << bucket;
  }

  /// Moves on to the first bucket with entries; no key in the queue is less than the result.
  /// \pre not empty
  Cost seek_first() {
    const auto turn = static_cast<int>(current_ % 64);
    current_ += static_cast<unsigned>(std::countr_zero(std::rotr(occupied_, turn)));
    return static_cast<Cost>(current_ << Shift);
  }

  /// Takes an entry from the bucket that `seek_first` has moved to.
  BucketEntry pop() {
    std::vector<BucketEntry>& bucket = buckets_[current_ % 64];
    const BucketEntry entry = bucket.back();
    bucket.pop_back();
    occupied_ &= ~(std::uint64_t{bucket.empty()} << (current_ % 64));
    return entry;
  }

 private:
  Buckets& buckets_;
  std::uint64_t occupied_ = 0;
  std::uint64_t current_;
};

}  // namespace tutavia::detail
