// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/grid/movement.hpp"
#include "tutavia/search/grid_labels.hpp"

/// \file
/// JumpLabels: what a search knows about the few cells it stops at.

namespace tutavia {

/// Labels of jump points, found by the cell's index: open addressing with linear probing (Knuth
/// 1998, section 6.4, algorithm L). The labels are words as in GridLabels, so labels of earlier
/// queries count as empty places and nothing is cleared between queries.
class JumpLabels {
 public:
  struct Label {
    std::uint64_t word;
    std::uint32_t cell;
    std::uint32_t parent;  ///< index of the cell that the jump came from; itself for a first cell
  };

  /// Forgets all labels.
  void begin() {
    if (query_ == LabelWords::last_query) {
      labels_.assign(labels_.size(), Label{});
      query_ = 0;
    }
    words_ = LabelWords(++query_);
    size_ = 0;
    if (labels_.empty()) labels_.resize(1024, Label{});
  }

  /// Notes a way of cost `g` that arrives by the step `arrival`, if it is the first or a better
  /// one.
  bool improve(std::uint32_t cell, Cost g, std::size_t arrival, std::uint32_t parent) {
    Label* label = &find(cell);
    const std::uint64_t word = words_.word(g, arrival);
    if (words_.is_current(label->word)) {
      if (!words_.is_better(word, label->word)) return false;
    } else if (4 * ++size_ > 3 * labels_.size()) {
      grow();
      label = &find(cell);
    }
    *label = {word, cell, parent};
    return true;
  }

  /// \pre the cell was reached
  Cost g(std::uint32_t cell) { return words_.g(find(cell).word); }
  std::size_t arrival(std::uint32_t cell) { return LabelWords::arrival(find(cell).word); }
  std::uint32_t parent(std::uint32_t cell) { return find(cell).parent; }

  std::size_t memory() const { return labels_.size() * sizeof(Label); }
  std::size_t size() const { return size_; }

 private:
  /// The label of a cell, or the empty place for it.
  Label& find(std::uint32_t cell) {
    const std::size_t mask = labels_.size() - 1;
    std::size_t i = (cell * std::uint64_t{0x9E3779B97F4A7C15u}) >> 32 & mask;
    while (labels_[i].cell != cell && words_.is_current(labels_[i].word)) i = (i + 1) & mask;
    return labels_[i];
  }

  void grow() {
    std::vector<Label> old(2 * labels_.size(), Label{});
    old.swap(labels_);
    for (const Label& label : old) {
      if (words_.is_current(label.word)) find(label.cell) = label;
    }
  }

  std::vector<Label> labels_;
  std::size_t size_ = 0;
  std::uint64_t query_ = 0;
  LabelWords words_{0};
};

}  // namespace tutavia
