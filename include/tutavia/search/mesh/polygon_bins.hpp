// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tutavia/grid/cell.hpp"
#include "tutavia/search/mesh/sides.hpp"

/// \file
/// PolygonBins: finds the polygons of a mesh near a cell.

namespace tutavia::detail {

/// For each square of 8 x 8 cells the polygons that touch it, and possibly a few more.
class PolygonBins {
 public:
  /// For a map of `width` x `height` cells.
  PolygonBins(int width, int height) : width_(width), height_(height), columns_(width / side + 1) {}

  /// Fills the bins with polygons 0 ... `count` - 1; `sides_of(polygon)` is a span of its sides.
  template <class SidesOf>
  void fill(std::uint32_t count, const SidesOf& sides_of) {
    first_.assign(bin_of(width_, height_) + 2, 0);
    for (std::uint32_t polygon = 0; polygon < count; ++polygon) {
      for_each_bin(sides_of(polygon), [&](std::size_t bin) { ++first_[bin + 1]; });
    }
    for (std::size_t bin = 1; bin < first_.size(); ++bin) first_[bin] += first_[bin - 1];
    polygons_.resize(first_.back());
    std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
    for (std::uint32_t polygon = 0; polygon < count; ++polygon) {
      for_each_bin(sides_of(polygon), [&](std::size_t bin) { polygons_[at[bin]++] = polygon; });
    }
  }

  /// Calls `visit(polygon)` for every polygon that may touch a cell.
  template <class Visit>
  void for_each_near(Cell cell, const Visit& visit) const {
    const std::size_t bin = bin_of(std::clamp(cell.x, 0, width_), std::clamp(cell.y, 0, height_));
    for (std::uint32_t i = first_[bin]; i < first_[bin + 1]; ++i) visit(polygons_[i]);
  }

  std::size_t memory() const { return (first_.size() + polygons_.size()) * sizeof(std::uint32_t); }

 private:
  static constexpr int side = 8;  // of a bin [cells]

  std::size_t bin_of(int x, int y) const {
    return static_cast<std::size_t>(y / side) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x / side);
  }

  template <class Visit>
  void for_each_bin(std::span<const PolygonSide> sides, const Visit& visit) const {
    int bottom = height_, top = 0;
    for (const PolygonSide& s : sides) {
      bottom = std::min(bottom, s.right.y);
      top = std::max(top, s.right.y);
    }
    for (int row = bottom / side; row <= top / side; ++row) {
      int low = width_, high = 0;
      for (const PolygonSide& s : sides) {
        const Cell a = s.right, b = s.left;
        const auto extend = [&](int y) {  // intersection of the side with a grid line
          if (y < std::min(a.y, b.y) || y > std::max(a.y, b.y)) return;
          const int rise = a.y == b.y ? 1 : b.y - a.y;
          const std::int64_t run = a.y == b.y ? 0 : (std::int64_t{b.x} - a.x) * (y - a.y);
          const auto x = static_cast<int>(a.x + run / rise);
          low = std::min(low, x - 1);
          high = std::max(high, x + 1);
        };
        extend(row * side);
        extend((row + 1) * side);
        if (a.y / side == row) {
          low = std::min(low, a.x);
          high = std::max(high, a.x);
        }
      }
      low = std::max(low, 0) / side;
      high = std::min(high, width_) / side;
      for (int column = low; column <= high; ++column) visit(bin_of(column * side, row * side));
    }
  }

  int width_, height_, columns_;
  std::vector<std::uint32_t> first_;  // per bin, and one past the last
  std::vector<std::uint32_t> polygons_;
};

}  // namespace tutavia::detail
