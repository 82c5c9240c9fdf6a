// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/core/parts/compiler.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/search/grid/grid_labels.hpp"

/// \file
/// LabelMap: a hash map of the labels of jump points.

namespace tutavia::detail {

/// Labels of jump points by cell index. Open addressing with linear probing (Knuth 1998, section
/// 6.4, algorithm L). The labels are words as in GridLabels: labels of earlier queries count as
/// empty slots, so nothing is cleared between queries.
class LabelMap {
 public:
  struct Label {
    std::uint64_t word;
    std::uint32_t cell;
    std::uint32_t parent;  ///< index of the cell where the jump started; itself for a start cell
  };

  /// Invalidates all labels.
  void reset() {
    if (query_ == LabelWords::last_query) {
      labels_.assign(labels_.size(), Label{});
      query_ = 0;
    }
    words_ = LabelWords(++query_);
    size_ = 0;
    if (labels_.empty()) labels_.resize(1024, Label{});
    mask_ = labels_.size() - 1;
  }

  /// Records a path to a cell (see LabelWords::word) if it is the first or a cheaper one; returns
  /// whether it is.
  bool improve(std::uint32_t cell, std::uint64_t word, std::uint32_t parent) {
    Label& label = find(cell);
    if (!LabelWords::is_better(word, label.word)) return false;  // an empty slot loses
    size_ += words_.is_current(label.word) ? 0 : 1;
    label = {word, cell, parent};
    if (4 * size_ > 3 * mask_) grow();
    return true;
  }

  /// \pre the cell was reached
  const Label& operator[](std::uint32_t cell) { return find(cell); }

  const LabelWords& words() const { return words_; }

  /// Prefetches the label of a cell.
  void prefetch(std::uint32_t cell) const { tutavia::detail::prefetch(&labels_[home_slot(cell)]); }

  std::size_t memory() const { return labels_.size() * sizeof(Label); }
  std::size_t size() const { return size_; }

 private:
  /// The slot at which probing for a cell starts.
  std::size_t home_slot(std::uint32_t cell) const {
    return (cell * std::uint64_t{0x9E3779B97F4A7C15u}) >> 32 & mask_;
  }

  /// The label of a cell, or the empty slot for it.
  Label& find(std::uint32_t cell) {
    std::size_t i = home_slot(cell);
    while (labels_[i].cell != cell && words_.is_current(labels_[i].word)) i = (i + 1) & mask_;
    return labels_[i];
  }

  void grow() {
    std::vector<Label> old(2 * labels_.size(), Label{});
    old.swap(labels_);
    mask_ = labels_.size() - 1;
    for (const Label& label : old) {
      if (words_.is_current(label.word)) find(label.cell) = label;
    }
  }

  std::vector<Label> labels_;  // 2^n of them
  std::size_t mask_ = 0;       // 2^n - 1
  std::size_t size_ = 0;
  std::uint64_t query_ = 0;
  LabelWords words_{0};
};

}  // namespace tutavia::detail
