// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "tutavia/core/parts/zeroed_array.hpp"

/// \file
/// StampedLabels: labels that become invalid with the next query, without being cleared.

namespace tutavia::detail {

/// Labels by index. A Label has a member `std::uint32_t query`, the number of the query that wrote
/// it. Labels of earlier queries are thus invalid, and nothing is cleared; once the memory is large
/// enough, nothing is allocated. Memory pages that are never written are never allocated.
template <class Label>
class StampedLabels {
 public:
  /// Invalidates all labels. Reallocates when `size` exceeds every earlier one, and once every 2^32
  /// queries.
  void reset(std::size_t size) {
    if (labels_.size() < size || query_ == std::numeric_limits<std::uint32_t>::max()) {
      labels_ = ZeroedArray<Label>(size);
      query_ = 0;
    }
    ++query_;
  }

  /// The label of this query; nullptr if there is none.
  const Label* find(std::size_t i) const {
    return labels_[i].query == query_ ? &labels_[i] : nullptr;
  }
  /// The label written last, by this query or an earlier one.
  Label& operator[](std::size_t i) { return labels_[i]; }
  const Label& operator[](std::size_t i) const { return labels_[i]; }
  /// Writes a label and sets its `query`.
  void set(std::size_t i, Label label) {
    label.query = query_;
    labels_[i] = label;
  }

 private:
  ZeroedArray<Label> labels_;
  std::uint32_t query_ = 0;
};

}  // namespace tutavia::detail
