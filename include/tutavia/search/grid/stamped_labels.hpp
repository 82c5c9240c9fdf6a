// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "tutavia/core/parts/zeroed_array.hpp"

/// \file
/// StampedLabels: labels that are forgotten from one query to the next without being cleared.

namespace tutavia::detail {

/// Labels by index. A Label has a member `std::uint32_t query`, the number of the query that wrote
/// it, so that those of earlier queries are told apart and, once warm, nothing is cleared or
/// allocated. What is never written takes no memory, as far as whole pages go untouched.
template <class Label>
class StampedLabels {
 public:
  /// Forgets all labels. Allocates for more of them than ever, and once in 2^32 queries.
  void reset(std::size_t size) {
    if (labels_.size() < size || query_ == std::numeric_limits<std::uint32_t>::max()) {
      labels_ = ZeroedArray<Label>(size);
      query_ = 0;
    }
    ++query_;
  }

  /// The label of this query, or nullptr where it has none.
  const Label* find(std::size_t i) const {
    return labels_[i].query == query_ ? &labels_[i] : nullptr;
  }
  /// The label written last, be it of this query or an earlier one.
  Label& operator[](std::size_t i) { return labels_[i]; }
  const Label& operator[](std::size_t i) const { return labels_[i]; }
  /// Writes a label, of this query whatever it says.
  void set(std::size_t i, Label label) {
    label.query = query_;
    labels_[i] = label;
  }

 private:
  ZeroedArray<Label> labels_;
  std::uint32_t query_ = 0;
};

}  // namespace tutavia::detail
