// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "tutavia/core/parts/compiler.hpp"
#include "tutavia/core/parts/zeroed_array.hpp"
#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/movement.hpp"

/// \file
/// GridLabels: an eight-byte label per cell, with path cost and step of arrival.

namespace tutavia::detail {

/// Labels packed into words that compare larger when they are better: the query's number (13 bits),
/// the inverted bits of g (47 bits, more than any path on a grid of 2^32 cells needs) and the step
/// of arrival (4 bits). Labels of earlier queries lose every comparison, so nothing is cleared
/// between queries. One comparison decides whether a path is the first or cheaper.
class LabelWords {
 public:
  static constexpr std::uint64_t last_query = (std::uint64_t{1} << 13) - 1;

  /// The labels of query 1, ..., last_query; 0 marks a cell without a label.
  explicit LabelWords(std::uint64_t query) : base_((query << g_bits | g_mask) << step_bits) {}

  /// The label of a path of cost `g` that arrives by the step `arrival`.
  std::uint64_t word(Cost g, std::size_t arrival) const {
    return (base_ - (static_cast<std::uint64_t>(g) << step_bits)) | arrival;
  }
  /// The label of a path that costs `more`.
  static std::uint64_t farther(std::uint64_t label, Cost more) {
    return label - (static_cast<std::uint64_t>(more) << step_bits);
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
  /// A tag that distinguishes a label from the labels that soon replace it at the same cell.
  static std::uint32_t tag(std::uint64_t label) {
    return static_cast<std::uint32_t>(label >> step_bits);
  }

 private:
  static constexpr int g_bits = 47, step_bits = 4;
  static constexpr std::uint64_t g_mask = (std::uint64_t{1} << g_bits) - 1;
  static constexpr std::uint64_t step_mask = (std::uint64_t{1} << step_bits) - 1;

  std::uint64_t base_;
};

/// For each cell, the cost g of the best path found to it and the step by which that path arrives.
/// Memory pages without a reached cell are never allocated.
class GridLabels {
 public:
  /// The labels of one query, passed by value to inner loops.
  class View {
   public:
    View(std::uint64_t* labels, std::uint64_t query) : labels_(labels), words_(query) {}

    /// Records a path to a cell (see LabelWords::word) if it is the first or a cheaper one; returns
    /// whether it is.
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

    /// Prefetches the label of a cell.
    void prefetch(std::size_t cell) const { tutavia::detail::prefetch(labels_ + cell); }

   private:
    std::uint64_t* labels_;
    LabelWords words_;
  };

  /// Invalidates all labels. Allocates for a larger grid, and once every 8191 queries.
  View reset(std::size_t size) {
    if (labels_.size() < size || query_ == LabelWords::last_query) {
      labels_ = ZeroedArray<std::uint64_t>(size);
      query_ = 0;
    }
    ++query_;
    return view();
  }
  /// The labels of the current query, for reading.
  View view() const { return {const_cast<std::uint64_t*>(labels_.data()), query_}; }

 private:
  ZeroedArray<std::uint64_t> labels_;
  std::uint64_t query_ = 0;
};

}  // namespace tutavia::detail
