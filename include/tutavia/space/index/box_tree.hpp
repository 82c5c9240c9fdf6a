// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "tutavia/core/parts/compiler.hpp"
#include "tutavia/geometry/box.hpp"

/// \file
/// BoxTree: finds the boxes that meet a box.

namespace tutavia::detail {

/// An immutable, packed R-tree over numbered boxes: a query costs O(log n + k) for n boxes and k
/// answers, building O(n log n).
///
/// Boxes are halved along the longer side of their centres' extent until at most sixteen are left
/// (top-down bulk loading, Lee and Lee 2003, "OMT"). Parts are whole powers of sixteen, so every
/// node but the last of a level is full, and a child's index follows from its parent's: there are
/// no pointers.
///
/// A node holds the boxes of its sixteen children in single precision, relative to the extent of
/// all boxes. That rounding is monotone, so no box that meets the query is missed, but a few others
/// may be reported: results are candidates.
class BoxTree {
 public:
  using Entry = std::pair<Box, std::uint32_t>;

  BoxTree() = default;
  /// \pre the boxes are finite and not empty
  explicit BoxTree(std::vector<Entry> entries) {
    if (entries.empty()) return;
    Box extent;
    for (const Entry& entry : entries) {
      extent.include(entry.first.min);
      extent.include(entry.first.max);
    }
    origin_ = centre(extent);
    const double size = std::fmax(extent.max.x() - origin_.x(), extent.max.y() - origin_.y());
    if (size > 0x1p-1000) scale_ = 1 / size;
    sort(entries, 0, entries.size());
    std::vector<RoundedBox> boxes;
    for (const Entry& entry : entries) {
      boxes.push_back(rounded(entry.first));
      numbers_.push_back(entry.second);
    }
    while (!boxes.empty()) boxes = add_level(boxes);
  }

  /// Calls `visit(number)` for every box that meets `box`, touching included, and perhaps for boxes
  /// that miss it by less than a millionth of the extent of all boxes.
  template <class Visit>
  void for_each_in(const Box& box, Visit visit) const {
    if (nodes_.empty()) return;
    const RoundedBox target = rounded(box);
    // The unvisited children of one node per level, from the root down.
    struct Open {
      std::uint32_t node;
      std::uint32_t children;  // one bit each
    };
    std::array<Open, max_levels> open;
    std::size_t level = levels_.size() - 1;
    open[level] = {0, nodes_[levels_[level]].meets(target)};
    while (true) {
      if (open[level].children == 0) {
        if (++level == levels_.size()) return;
        continue;
      }
      const auto k = static_cast<std::uint32_t>(std::countr_zero(open[level].children));
      open[level].children &= open[level].children - 1;
      const std::uint32_t child = fan_out * open[level].node + k;
      if (level == 0) {
        visit(numbers_[child]);
      } else {
        --level;
        open[level] = {child, nodes_[levels_[level] + child].meets(target)};
      }
    }
  }

 private:
  static constexpr std::uint32_t fan_out = 16;
  static constexpr std::size_t max_levels = 8;  // 16^8 = 2^32

  struct RoundedBox {
    float min_x, min_y, max_x, max_y;
  };

  /// Sixteen boxes, stored for comparisons four at a time (vector extensions of g++ and clang).
  class Node {
   public:
    void set(std::size_t k, const RoundedBox& box) {
      min_x_[k / 4][k % 4] = box.min_x, min_y_[k / 4][k % 4] = box.min_y;
      max_x_[k / 4][k % 4] = box.max_x, max_y_[k / 4][k % 4] = box.max_y;
    }
    /// Which of the boxes meet a box, one bit each.
    TUTAVIA_ALWAYS_INLINE std::uint32_t meets(const RoundedBox& box) const {
      Masks bits = meets(0, box) & Masks{1, 2, 4, 8};
      bits |= meets(1, box) & (Masks{1, 2, 4, 8} << 4);
      bits |= meets(2, box) & (Masks{1, 2, 4, 8} << 8);
      bits |= meets(3, box) & (Masks{1, 2, 4, 8} << 12);
      bits |= __builtin_shufflevector(bits, bits, 2, 3, 0, 1);
      return static_cast<std::uint32_t>(bits[0] | bits[1]);
    }

   private:
    using Floats = float __attribute__((vector_size(16)));
    using Masks = std::int32_t __attribute__((vector_size(16)));  // all bits or none

    Masks meets(std::size_t four, const RoundedBox& box) const {
      return (min_x_[four] <= box.max_x) & (max_x_[four] >= box.min_x) &
             (min_y_[four] <= box.max_y) & (max_y_[four] >= box.min_y);
    }

    // Empty boxes, which meet nothing.
    static constexpr std::array<Floats, 4> filled_with(float x) {
      const Floats four{x, x, x, x};
      return {four, four, four, four};
    }
    static constexpr float infinity = std::numeric_limits<float>::infinity();
    std::array<Floats, 4> min_x_ = filled_with(infinity), min_y_ = filled_with(infinity);
    std::array<Floats, 4> max_x_ = filled_with(-infinity), max_y_ = filled_with(-infinity);
  };

  TUTAVIA_ALWAYS_INLINE RoundedBox rounded(const Box& box) const {
    const auto relative = [this](const Point& p, int axis) {
      const double x = (p[axis] - origin_[axis]) * scale_;  // in [-1, 1] for boxes of the tree
      return static_cast<float>(x < -2 ? -2 : x > 2 ? 2 : x);
    };
    return {relative(box.min, 0), relative(box.min, 1), relative(box.max, 0), relative(box.max, 1)};
  }

  /// Orders entries so that every consecutive run of sixteen to a power is spatially compact.
  static void sort(std::vector<Entry>& entries, std::size_t first, std::size_t last) {
    const std::size_t count = last - first;
    const auto at = [&](std::size_t i) { return entries.begin() + static_cast<std::ptrdiff_t>(i); };
    if (count <= fan_out) {  // in input order
      std::sort(at(first), at(last), [](auto& a, auto& b) { return a.second < b.second; });
      return;
    }
    std::size_t part = fan_out;
    while (part * fan_out < count) part *= fan_out;
    Box centres;
    for (std::size_t i = first; i < last; ++i) centres.include(centre(entries[i].first));
    const int axis = centres.width() >= centres.height() ? 0 : 1;
    const std::size_t middle = first + (count + part - 1) / part / 2 * part;
    std::nth_element(at(first), at(middle), at(last), [axis](const Entry& a, const Entry& b) {
      const double x = centre(a.first)[axis], y = centre(b.first)[axis];
      return x != y ? x < y : a.second < b.second;
    });
    sort(entries, first, middle);
    sort(entries, middle, last);
  }
  static Point centre(const Box& box) {
    return {0.5 * box.min.x() + 0.5 * box.max.x(), 0.5 * box.min.y() + 0.5 * box.max.y()};
  }

  /// Adds the level of nodes above `boxes`. Returns their boxes, or none once the root is added.
  std::vector<RoundedBox> add_level(const std::vector<RoundedBox>& boxes) {
    levels_.push_back(nodes_.size());
    nodes_.resize(nodes_.size() + (boxes.size() + fan_out - 1) / fan_out);
    std::vector<RoundedBox> parents;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const RoundedBox& box = boxes[i];
      nodes_[levels_.back() + i / fan_out].set(i % fan_out, box);
      if (i % fan_out == 0) parents.push_back(box);
      RoundedBox& parent = parents.back();
      parent = {std::min(parent.min_x, box.min_x), std::min(parent.min_y, box.min_y),
                std::max(parent.max_x, box.max_x), std::max(parent.max_y, box.max_y)};
    }
    if (parents.size() == 1) parents.clear();
    return parents;
  }

  Point origin_ = Point::Zero();
  double scale_ = 1;
  std::vector<Node> nodes_;             // level by level, leaves first
  std::vector<std::size_t> levels_;     // first node of each level
  std::vector<std::uint32_t> numbers_;  // of the boxes, in leaf order
};

}  // namespace tutavia::detail
