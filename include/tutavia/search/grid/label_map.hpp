// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tutavia/core/parts/compiler.hpp"
#include "tutavia/core/parts/zeroed_array.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/search/grid/grid_labels.hpp"

/// \file
/// LabelMap: the labels of jump points, few or many.

namespace tutavia::detail {

/// Labels of jump points by cell index. The labels are words as in GridLabels: labels of earlier
/// queries count as empty, so nothing is cleared between queries.
///
/// Few labels are kept in a hash map, close to each other in memory: open addressing with linear
/// probing (Knuth 1998, section 6.4, algorithm L). Once the map would take more than 1/64 of the
/// memory of an array of all cells, such an array takes its place: on random maps and in mazes
/// every tenth cell is a jump point, and the processor cannot predict how long a search in the map
/// takes.
class LabelMap {
 public:
  struct Label {
    std::uint64_t word;
    std::uint32_t cell;
    std::uint32_t parent;  ///< index of the cell where the jump started; itself for a start cell
  };

  /// Invalidates all labels, for cells with indices below `cells`.
  void reset(std::size_t cells) {
    if (query_ == LabelWords::last_query) {
      slots_.assign(slots_.size(), Label{});
      array_ = ZeroedArray<Label>();
      query_ = 0;
    }
    cells_ = cells;
    // Queries are often alike: an array that paid for itself serves the next one from its start.
    by_cell_ = by_cell_ && cells <= array_.size() && 4 * size_ >= most_slots();
    words_ = LabelWords(++query_);
    size_ = 0;
    if (slots_.empty()) slots_.resize(1024, Label{});
    mask_ = slots_.size() - 1;
  }

  /// Records a path to a cell (see LabelWords::word) if it is the first or a cheaper one; returns
  /// whether it is.
  TUTAVIA_ALWAYS_INLINE bool improve(std::uint32_t cell, std::uint64_t word, std::uint32_t parent) {
    Label& label = find(cell);
    if (!LabelWords::is_better(word, label.word)) return false;  // an empty slot loses
    size_ += words_.is_current(label.word) ? 0 : 1;
    label = {word, cell, parent};
    if (!by_cell_ && 4 * size_ > 3 * mask_) grow();
    return true;
  }

  /// \pre the cell was reached
  const Label& operator[](std::uint32_t cell) { return find(cell); }

  const LabelWords& words() const { return words_; }

  std::size_t memory() const { return (slots_.size() + array_.size()) * sizeof(Label); }
  std::size_t size() const { return size_; }

 private:
  /// Slots of the hash map that an array by cell replaces when they are full.
  std::size_t most_slots() const {
    constexpr std::size_t largest_array = std::size_t{1} << 26;  // 1 GiB, mostly untouched
    return cells_ <= largest_array ? cells_ / 64 : std::numeric_limits<std::size_t>::max();
  }

  /// The slot at which probing for a cell starts.
  std::size_t home_slot(std::uint32_t cell) const {
    return (cell * std::uint64_t{0x9E3779B97F4A7C15u}) >> 32 & mask_;
  }

  /// The label of a cell, or the empty slot for it.
  TUTAVIA_ALWAYS_INLINE Label& find(std::uint32_t cell) {
    if (by_cell_) return array_[cell];
    std::size_t i = home_slot(cell);
    while (slots_[i].cell != cell && words_.is_current(slots_[i].word)) i = (i + 1) & mask_;
    return slots_[i];
  }

  void grow() {
    if (slots_.size() >= most_slots()) {
      if (array_.size() < cells_) array_ = ZeroedArray<Label>(cells_);
      by_cell_ = true;
      for (const Label& label : slots_) {
        if (words_.is_current(label.word)) array_[label.cell] = label;
      }
      return;
    }
    std::vector<Label> old(2 * slots_.size(), Label{});
    old.swap(slots_);
    mask_ = slots_.size() - 1;
    for (const Label& label : old) {
      if (words_.is_current(label.word)) find(label.cell) = label;
    }
  }

  std::vector<Label> slots_;  // 2^n of them
  ZeroedArray<Label> array_;  // by cell
  bool by_cell_ = false;
  std::size_t cells_ = 0;
  std::size_t mask_ = 0;  // 2^n - 1
  std::size_t size_ = 0;
  std::uint64_t query_ = 0;
  LabelWords words_{0};
};

}  // namespace tutavia::detail
