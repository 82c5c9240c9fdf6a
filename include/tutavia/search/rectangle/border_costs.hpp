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
/// BorderCosts: octile distances inside a free rectangle, from an interval of its cells.

namespace tutavia::detail {

/// What it costs to go from an interval of cells, each of which has a cost of its own, to cells of
/// the sides of a free rectangle that grew from it. Linear in both. Keeps its memory.
///
/// A way of m steps along the interval and d across it costs as many slant steps as the smaller of
/// the two and is straight for the rest. Cells of the interval that cost more than a neighbour and
/// the step from it are lowered to that at first. Then none that is further aside than d is better
/// than one nearer by, and what is left is a least value within d on either hand.
class BorderCosts {
 public:
  /// The cheapest way to a cell: its cost, and the place in the interval that it starts from.
  struct Source {
    Cost cost = std::numeric_limits<Cost>::max();
    int place = 0;
  };

  /// Starts anew from an interval; `cost_of(place)` is what a cell of it costs.
  template <class CostOf>
  void reset(const CellInterval& from, CostOf cost_of) {
    from_ = from;
    costs_.resize(size());
    for (int u = from.first; u <= from.last; ++u) costs_[offset(u)] = cost_of(u);
    for (std::size_t i = 1; i < size(); ++i) lower(costs_[i], costs_[i - 1] + straight_cost);
    for (std::size_t i = size() - 1; i-- > 0;) lower(costs_[i], costs_[i + 1] + straight_cost);
  }

  /// Reaches the cells of a side of the rectangle, or of any other line in it.
  void reach(const CellInterval& side) {
    first_ = side.first;
    reached_.assign(static_cast<std::size_t>(side.last - side.first) + 1,
                    std::numeric_limits<Cost>::max());
    for (const int hand : {1, -1}) {
      if (side.axis == from_.axis) {
        reach_line(side, hand);
      } else {
        reach_column(side, hand);
      }
    }
  }
  /// What a cell of the side reached last costs.
  Cost operator[](int place) const { return reached_[static_cast<std::size_t>(place - first_)]; }

  /// How any cell of the rectangle is reached; linear in the interval.
  Source reach(Cell cell) const {
    Source best;
    for (int u = from_.first; u <= from_.last; ++u) {
      const Cost cost = costs_[offset(u)] + octile_cost(cell, from_.cell(u));
      if (cost < best.cost) best = {cost, u};
    }
    return best;
  }

 private:
  static constexpr Cost aslant = diagonal_cost - straight_cost;

  static void lower(Cost& to, Cost cost) { to = std::min(to, cost); }
  std::size_t size() const { return static_cast<std::size_t>(from_.run().size()); }
  std::size_t offset(int u) const { return static_cast<std::size_t>(u - from_.first); }

  /// The cells of a side along the interval, from cells of the interval on one hand. Places are
  /// counted towards the other hand, from the interval's end.
  void reach_line(const CellInterval& side, int hand) {
    const int depth = std::abs(side.line - from_.line), count = from_.run().size();
    const auto n = static_cast<std::size_t>(count), d = static_cast<std::size_t>(depth);
    const int origin = hand > 0 ? from_.first : from_.last;
    const int begin = std::max(hand > 0 ? side.first - origin : origin - side.last, 0);
    const int end = hand > 0 ? side.last - origin : origin - side.first;
    if (begin > end) return;
    find_least(hand, d);
    const Cost across = straight_cost * depth;
    int x = begin;
    const auto at = [&]() -> Cost& {
      return reached_[static_cast<std::size_t>(origin + hand * x - first_)];
    };
    // While all cells of the interval up to x are near; d + 1 of them; those at its end; only that.
    for (const int last = std::min(end, depth); x <= last; ++x) {
      lower(at(), up_to_[static_cast<std::size_t>(std::min(x, count - 1))] + aslant * x + across);
    }
    for (const int last = std::min(end, count - 1); x <= last; ++x) {
      const auto i = static_cast<std::size_t>(x);
      lower(at(), std::min(from_on_[i - d], up_to_[i]) + aslant * x + across);
    }
    if (x > end) return;
    // Least values up to the interval's end.
    for (std::size_t i = n - 1; i-- > 0 && i + d + 1 > n - 1;) {
      from_on_[i] = std::min(slope_[i], from_on_[i + 1]);
    }
    for (const int last = std::min(end, count - 1 + depth); x <= last; ++x) {
      lower(at(), from_on_[static_cast<std::size_t>(x - depth)] + aslant * x + across);
    }
    const Cost at_end = costs_[hand > 0 ? n - 1 : 0];
    for (; x <= end; ++x) {
      lower(at(), at_end + straight_cost * (x - (count - 1)) + aslant * depth);
    }
  }

  /// Finds the least costs, less `aslant` a step, of the part of a block of d + 1 neighbours up to
  /// each cell of the interval, and of the part from each on.
  void find_least(int hand, std::size_t d) {
    const std::size_t n = size();
    slope_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      slope_[i] = costs_[hand > 0 ? i : n - 1 - i] - aslant * static_cast<Cost>(i);
    }
    up_to_ = slope_;
    for (std::size_t i = 1, in_block = 1; i < n; ++i, ++in_block) {
      if (in_block > d) {
        in_block = 0;
      } else {
        lower(up_to_[i], up_to_[i - 1]);
      }
    }
    from_on_ = slope_;
    for (std::size_t i = n - 1, in_block = (n - 1) % (d + 1); i-- > 0;) {
      if (in_block == 0) {
        in_block = d;
      } else {
        lower(from_on_[i], from_on_[i + 1]);
        --in_block;
      }
    }
  }

  /// The cells of a side across the interval, from cells of the interval on one hand.
  void reach_column(const CellInterval& side, int hand) {
    const int nearest =
        hand > 0 ? std::max(from_.first, side.line) : std::min(from_.last, side.line);
    if (nearest < from_.first || nearest > from_.last) return;
    const int aside = std::abs(nearest - side.line);
    const int count = hand > 0 ? from_.last - nearest + 1 : nearest - from_.first + 1;
    up_to_.resize(static_cast<std::size_t>(count));  // the least of the cells up to each
    for (int i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      up_to_[k] = costs_[offset(nearest + hand * i)] + aslant * (aside + i);
      if (i > 0) lower(up_to_[k], up_to_[k - 1]);
    }
    const Cost at_nearest = costs_[offset(nearest)];
    for (int v = side.first; v <= side.last; ++v) {
      const int depth = std::abs(v - from_.line);
      const auto near = static_cast<std::size_t>(std::clamp(depth - aside, 0, count - 1));
      lower(reached_[static_cast<std::size_t>(v - first_)],
            depth < aside ? at_nearest + straight_cost * aside + aslant * depth
                          : up_to_[near] + straight_cost * depth);
    }
  }

  CellInterval from_{};
  int first_ = 0;                              // of the side reached last
  std::vector<Cost> costs_;                    // along the interval
  std::vector<Cost> reached_;                  // along the side
  std::vector<Cost> slope_, up_to_, from_on_;  // see find_least
};

}  // namespace tutavia::detail
