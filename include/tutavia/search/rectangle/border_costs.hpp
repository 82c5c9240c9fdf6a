// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

#include "tutavia/search/heuristic.hpp"
#include "tutavia/search/rectangle/free_rectangle.hpp"

/// \file
/// BorderCosts: octile distances from an interval of cells to the sides of a free rectangle.

namespace tutavia::detail {

/// Path costs from an interval of cells, each of which has an initial cost, to cells on the sides
/// of a free rectangle that grew from the interval. Linear in the length of both. Keeps its memory.
///
/// A path of m steps along the interval and d steps across it uses min(m, d) diagonal steps. First,
/// costs are relaxed along the interval, so that neighbours differ by at most one straight step.
/// Then only sources within d columns can be optimal, which leaves a sliding-window minimum of
/// width d in each direction.
class BorderCosts {
 public:
  /// The cheapest path to a cell: its cost, and the coordinate of its source in the interval.
  struct Source {
    Cost cost = std::numeric_limits<Cost>::max();
    int u = 0;
  };

  /// Starts with a new interval; `cost_of(u)` is the initial cost of the cell at coordinate u.
  template <class CostOf>
  void reset(const CellInterval& from, CostOf cost_of) {
    from_ = from;
    costs_.resize(size());
    for (int u = from.first; u <= from.last; ++u) costs_[offset(u)] = cost_of(u);
    for (std::size_t i = 1; i < size(); ++i) relax(costs_[i], costs_[i - 1] + straight_cost);
    for (std::size_t i = size() - 1; i-- > 0;) relax(costs_[i], costs_[i + 1] + straight_cost);
  }

  /// Computes the costs of the cells on a side of the rectangle, or on any other line in it.
  void reach(const CellInterval& side) {
    first_ = side.first;
    reached_.assign(static_cast<std::size_t>(side.last - side.first) + 1,
                    std::numeric_limits<Cost>::max());
    for (const int direction : {1, -1}) {
      if (side.axis == from_.axis) {
        reach_line(side, direction);
      } else {
        reach_column(side, direction);
      }
    }
  }
  /// The cost of a cell on the side computed last.
  Cost operator[](int u) const { return reached_[static_cast<std::size_t>(u - first_)]; }

  /// The cheapest path to any cell of the rectangle; linear in the interval.
  Source reach(Cell cell) const {
    Source best;
    for (int u = from_.first; u <= from_.last; ++u) {
      const Cost cost = costs_[offset(u)] + octile_cost(cell, from_.cell(u));
      if (cost < best.cost) best = {cost, u};
    }
    return best;
  }

 private:
  static constexpr Cost diagonal_extra = diagonal_cost - straight_cost;

  static void relax(Cost& to, Cost cost) { to = std::min(to, cost); }
  std::size_t size() const { return static_cast<std::size_t>(from_.run().size()); }
  std::size_t offset(int u) const { return static_cast<std::size_t>(u - from_.first); }

  /// Relaxes the cells of a side parallel to the interval from sources in one direction. Positions
  /// x count in the other direction, from the interval's end.
  void reach_line(const CellInterval& side, int direction) {
    const int depth = std::abs(side.line - from_.line), count = from_.run().size();
    const auto n = static_cast<std::size_t>(count), d = static_cast<std::size_t>(depth);
    const int origin = direction > 0 ? from_.first : from_.last;
    const int begin_x = std::max(direction > 0 ? side.first - origin : origin - side.last, 0);
    const int end_x = direction > 0 ? side.last - origin : origin - side.first;
    if (begin_x > end_x) return;
    find_minima(direction, d);
    const Cost across = straight_cost * depth;
    int x = begin_x;
    const auto at = [&]() -> Cost& {
      return reached_[static_cast<std::size_t>(origin + direction * x - first_)];
    };
    // Four ranges of x: all sources up to x lie within the window; a full window of d + 1 sources;
    // a window cut off by the interval's end; only the last source.
    for (const int last = std::min(end_x, depth); x <= last; ++x) {
      relax(at(), prefix_[static_cast<std::size_t>(std::min(x, count - 1))] + diagonal_extra * x +
                      across);
    }
    for (const int last = std::min(end_x, count - 1); x <= last; ++x) {
      const auto i = static_cast<std::size_t>(x);
      relax(at(), std::min(suffix_[i - d], prefix_[i]) + diagonal_extra * x + across);
    }
    if (x > end_x) return;
    // Suffix minima up to the interval's end.
    for (std::size_t i = n - 1; i-- > 0 && i + d + 1 > n - 1;) {
      suffix_[i] = std::min(slanted_[i], suffix_[i + 1]);
    }
    for (const int last = std::min(end_x, count - 1 + depth); x <= last; ++x) {
      relax(at(), suffix_[static_cast<std::size_t>(x - depth)] + diagonal_extra * x + across);
    }
    const Cost at_end = costs_[direction > 0 ? n - 1 : 0];
    for (; x <= end_x; ++x) {
      relax(at(), at_end + straight_cost * (x - (count - 1)) + diagonal_extra * depth);
    }
  }

  /// Splits the interval into blocks of d + 1 cells. Computes prefix and suffix minima per block of
  /// the costs minus `diagonal_extra` per step; two of them give any window's minimum.
  void find_minima(int direction, std::size_t d) {
    const std::size_t n = size();
    slanted_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      slanted_[i] = costs_[direction > 0 ? i : n - 1 - i] - diagonal_extra * static_cast<Cost>(i);
    }
    prefix_ = slanted_;
    for (std::size_t i = 1, in_block = 1; i < n; ++i, ++in_block) {
      if (in_block > d) {
        in_block = 0;
      } else {
        relax(prefix_[i], prefix_[i - 1]);
      }
    }
    suffix_ = slanted_;
    for (std::size_t i = n - 1, in_block = (n - 1) % (d + 1); i-- > 0;) {
      if (in_block == 0) {
        in_block = d;
      } else {
        relax(suffix_[i], suffix_[i + 1]);
        --in_block;
      }
    }
  }

  /// Relaxes the cells of a side across the interval from sources in one direction.
  void reach_column(const CellInterval& side, int direction) {
    const int nearest =
        direction > 0 ? std::max(from_.first, side.line) : std::min(from_.last, side.line);
    if (nearest < from_.first || nearest > from_.last) return;
    const int gap = std::abs(nearest - side.line);
    const int count = direction > 0 ? from_.last - nearest + 1 : nearest - from_.first + 1;
    prefix_.resize(static_cast<std::size_t>(count));  // prefix minima
    for (int i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      prefix_[k] = costs_[offset(nearest + direction * i)] + diagonal_extra * (gap + i);
      if (i > 0) relax(prefix_[k], prefix_[k - 1]);
    }
    const Cost at_nearest = costs_[offset(nearest)];
    for (int v = side.first; v <= side.last; ++v) {
      const int depth = std::abs(v - from_.line);
      const auto near = static_cast<std::size_t>(std::clamp(depth - gap, 0, count - 1));
      relax(reached_[static_cast<std::size_t>(v - first_)],
            depth < gap ? at_nearest + straight_cost * gap + diagonal_extra * depth
                        : prefix_[near] + straight_cost * depth);
    }
  }

  CellInterval from_{};
  int first_ = 0;                                // of the side computed last
  std::vector<Cost> costs_;                      // along the interval
  std::vector<Cost> reached_;                    // along the side
  std::vector<Cost> slanted_, prefix_, suffix_;  // see find_minima
};

}  // namespace tutavia::detail
