// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/grid/movement.hpp"

/// \file
/// BucketQueue: an open list for keys that increase by small amounts.

namespace tutavia::detail {

/// An entry of a BucketQueue.
struct BucketEntry {
  std::uint32_t node;
  std::uint32_t tag;  ///< for the searcher's own use
};

/// Memory of a BucketQueue; never freed between queries.
using Buckets = std::array<std::vector<BucketEntry>, 64>;

/// A monotone priority queue of 64 circular buckets, each 2^Shift wide, with an occupancy word
/// (Dial 1969, "Shortest path forest with topological ordering"; Denardo and Fox 1979 for the
/// width).
///
/// Keys within a bucket are last in, first out. So a search must re-open nodes, unless every step
/// costs at least the width of a bucket. Every key pushed must lie within 63 buckets of the one
/// that `seek_first` selected.
template <int Shift>
class BucketQueue {
 public:
  static constexpr Cost width = Cost{1} << Shift;  ///< of a bucket

  /// An empty queue. \pre no key will be less than `least`
  BucketQueue(Buckets& buckets, Cost least)
      : buckets_(buckets), current_(static_cast<std::uint64_t>(least) >> Shift) {
    for (std::vector<BucketEntry>& bucket : buckets) bucket.clear();
  }

  bool empty() const { return occupied_ == 0; }

  void push(Cost key, std::uint32_t node, std::uint32_t tag) {
    const auto bucket = static_cast<std::size_t>((static_cast<std::uint64_t>(key) >> Shift) % 64);
    buckets_[bucket].push_back({node, tag});
    occupied_ |= std::uint64_t{1} << bucket;
  }

  /// A lower bound on all keys of the bucket selected last.
  Cost current() const { return static_cast<Cost>(current_ << Shift); }
  /// Whether a key belongs to the bucket selected last.
  bool is_current(Cost key) const { return static_cast<std::uint64_t>(key) >> Shift == current_; }

  /// Selects the first non-empty bucket and returns a lower bound on all keys. \pre not empty
  Cost seek_first() {
    const auto rotation = static_cast<int>(current_ % 64);
    current_ += static_cast<unsigned>(std::countr_zero(std::rotr(occupied_, rotation)));
    return current();
  }

  /// Removes and returns an entry of the bucket that `seek_first` selected.
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
