// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "tutavia/core/parts/compiler.hpp"
#include "tutavia/core/parts/zeroed_array.hpp"
#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/movement.hpp"

/// \file
/// GridLabels: what a search knows about each cell, in eight bytes.

namespace tutavia::detail {

/// Labels as words that grow as they get better: the query's number (13 bits), the bits of g
/// inverted (47 bits, which no path on a grid of 2^32 cells exceeds), the step of arrival (4 bits).
/// So labels of earlier queries lose every comparison, nothing is cleared between queries, and one
/// comparison decides whether a way is new or better.
class LabelWords {
 public:
  static constexpr std::uint64_t last_query = (std::uint64_t{1} << 13) - 1;

  /// The labels of query 1, ..., last_query; 0 is a label of none.
  explicit LabelWords(std::uint64_t query) : base_((query << g_bits | g_mask) << step_bits) {}

  /// The label of a way of cost `g` that arrives by the step `arrival`.
  std::uint64_t word(Cost g, std::size_t arrival) const {
    return (base_ - (static_cast<std::uint64_t>(g) << step_bits)) | arrival;
  }
  /// Whether a label of this query has a smaller g than `old`, or `old` is of an earlier query.
  static bool is_better(std::uint64_t label, std::uint64_t old) {
    return label > (old | step_mask);
  }
  bool is_current(std::uint64_t label) const { return label >= base_ - (g_mask << step_bits); }
  Cost g(std::uint64_t label) const {
    return static_cast<Cost>((base_ - (label & ~step_mask)) >> step_bits);
  }
  static std::size_t arrival(std::uint64_t label) { return label & step_mask; }
  /// Tells a label from the labels of the same cell that come soon after it.
  static std::uint32_t note(std::uint64_t label) {
    return static_cast<std::uint32_t>(label >> step_bits);
  }

 private:
  static constexpr int g_bits = 47, step_bits = 4;
  static constexpr std::uint64_t g_mask = (std::uint64_t{1} << g_bits) - 1;
  static constexpr std::uint64_t step_mask = (std::uint64_t{1} << step_bits) - 1;

  std::uint64_t base_;
};

/// For each cell the cost g of the best way found to it and the step by which that way arrives.
/// Cells never reached take no memory, as far as whole pages of them go untouched.
class GridLabels {
 public:
  /// The labels of one query, by value for inner loops.
  class View {
   public:
    View(std::uint64_t* labels, std::uint64_t query) : labels_(labels), words_(query) {}

    /// Notes a way to a cell (see LabelWords::word), if it is the first or a better one.
    bool improve(std::size_t cell, std::uint64_t label) const {
      if (!LabelWords::is_better(label, labels_[cell])) return false;
      labels_[cell] = label;
      return true;
    }

    const LabelWords& words() const { return words_; }
    /// The label of a cell, as a word.
    std::uint64_t operator[](std::size_t cell) const { return labels_[cell]; }

    bool reached(std::size_t cell) const { return words_.is_current(labels_[cell]); }
    /// \pre reached(cell)
    Cost g(std::size_t cell) const { return words_.g(labels_[cell]); }
    /// \pre reached(cell)
    std::size_t arrival(std::size_t cell) const { return LabelWords::arrival(labels_[cell]); }

    /// The label of a cell is going to be looked at.
    void prefetch(std::size_t cell) const { tutavia::detail::prefetch(labels_ + cell); }

   private:
    std::uint64_t* labels_;
    LabelWords words_;
  };

  /// Forgets all labels. Allocates for a larger grid, and once in 8191 queries.
  View reset(std::size_t size) {
    if (labels_.size() < size || query_ == LabelWords::last_query) {
      labels_ = ZeroedArray<std::uint64_t>(size);
      query_ = 0;
    }
    ++query_;
    return view();
  }
  /// The labels of the query begun last, to be read.
  View view() const { return {const_cast<std::uint64_t*>(labels_.data()), query_}; }

 private:
  ZeroedArray<std::uint64_t> labels_;
  std::uint64_t query_ = 0;
};

}  // namespace tutavia::detail
