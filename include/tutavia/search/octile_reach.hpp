// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

#include "tutavia/search/free_rectangle.hpp"
#include "tutavia/search/heuristic.hpp"

/// \file
/// OctileReach: octile distances inside a free rectangle, from an interval of its cells.

namespace tutavia {

/// What it costs to go from an interval of cells, each of which has a cost of its own, to cells of
/// the sides of a free rectangle that grew from it. Linear in both. Keeps its memory.
class OctileReach {
 public:
  /// The cheapest way to a cell: its cost, and the place in the interval that it starts from.
  struct Source {
    Cost cost = std::numeric_limits<Cost>::max();
    int place = 0;
  };

  /// Starts anew from an interval; `cost_of(place)` is what a cell of it costs.
  template <class CostOf>
  void begin(const CellInterval& from, CostOf cost_of) {
    from_ = from;
    costs_.clear();
    for (int u = from.first; u <= from.last; ++u) costs_.push_back(cost_of(u));
  }

  /// Reaches the cells of a side of the rectangle.
  void reach(const CellInterval& side) {
    first_ = side.first;
    last_ = side.last;
    reached_.assign(static_cast<std::size_t>(side.last - side.first + 1), Source{});
    if (side.axis == from_.axis) {
      reach_line(std::abs(side.line - from_.line));
    } else {
      reach_column(side.line);
    }
  }
  /// How a cell of the side reached last is reached.
  Source& operator[](int place) { return reached_[static_cast<std::size_t>(place - first_)]; }

  /// How any cell of the rectangle is reached; linear in the interval.
  Source reach(Cell cell) const {
    Source best;
    for (int u = from_.first; u <= from_.last; ++u) {
      const Cost cost = cost_of(u) + octile_cost(cell, from_.cell(u));
      if (cost < best.cost) best = {cost, u};
    }
    return best;
  }

 private:
  static constexpr Cost aslant = diagonal_cost - straight_cost;

  Cost cost_of(int u) const { return costs_[static_cast<std::size_t>(u - from_.first)]; }

  static void lower(Source& to, const Source& from, Cost way) {
    if (from.cost < std::numeric_limits<Cost>::max() && from.cost + way < to.cost) {
      to = {from.cost + way, from.place};
    }
  }

  /// The cells of a side that lies `depth` lines from the interval. The way from a cell of the
  /// interval to one that lies `aside` has as many slant steps as the smaller of depth and aside,
  /// and is straight for the rest: so the cheapest of them is sought among those within `depth` on
  /// either hand, by a sliding window, and among those beyond.
  void reach_line(int depth) {
    for (const int hand : {1, -1}) {  // the cells to the left, then to the right
      window_.clear();                // of cost - aslant * place, ever dearer
      std::size_t head = 0;
      Source beyond;  // of cost - straight * place
      const int begin = hand > 0 ? std::min(first_, from_.first) : std::max(last_, from_.last);
      const int end = hand > 0 ? last_ + 1 : first_ - 1;
      for (int u = begin; u != end; u += hand) {
        if (from_.first <= u && u <= from_.last) {
          const Source entering{cost_of(u) - aslant * hand * u, u};
          while (window_.size() > head && window_.back().cost > entering.cost) window_.pop_back();
          window_.push_back(entering);
        }
        const int gone = u - hand * (depth + 1);
        if (from_.first <= gone && gone <= from_.last) {
          if (head < window_.size() && window_[head].place == gone) ++head;
          const Cost cost = cost_of(gone) - straight_cost * hand * gone;
          if (cost < beyond.cost) beyond = {cost, gone};
        }
        if (u < first_ || u > last_) continue;
        if (head < window_.size()) {
          lower((*this)[u], window_[head], aslant * hand * u + straight_cost * depth);
        }
        lower((*this)[u], beyond, straight_cost * hand * u + aslant * depth);
      }
    }
  }

  /// The cells of a side across the interval, at `column`. Cells no further aside than a line is
  /// deep are cheapest of those up to there, others of those from there on.
  void reach_column(int column) {
    const int hand = column <= from_.first ? 1 : -1;
    const int nearest = hand > 0 ? from_.first : from_.last;
    const int count = from_.last - from_.first + 1;
    before_.clear();
    after_.assign(static_cast<std::size_t>(count) + 1, Source{});
    for (int k = 0; k < count; ++k) {
      const int u = nearest + hand * k;
      const Source source{cost_of(u) + aslant * std::abs(u - column), u};
      before_.push_back(k > 0 && before_.back().cost <= source.cost ? before_.back() : source);
    }
    for (int k = count; k-- > 0;) {
      const int u = nearest + hand * k;
      const Source source{cost_of(u) + straight_cost * std::abs(u - column), u};
      const auto i = static_cast<std::size_t>(k);
      after_[i] = after_[i + 1].cost <= source.cost ? after_[i + 1] : source;
    }
    for (int v = first_; v <= last_; ++v) {
      const int depth = std::abs(v - from_.line);
      const int within = std::clamp(depth - std::abs(nearest - column) + 1, 0, count);
      const auto i = static_cast<std::size_t>(within);
      if (within > 0) lower((*this)[v], before_[i - 1], straight_cost * depth);
      lower((*this)[v], after_[i], aslant * depth);
    }
  }

  CellInterval from_{};
  int first_ = 0, last_ = -1;  // of the side reached last
  std::vector<Cost> costs_;    // along the interval
  std::vector<Source> reached_, window_, before_, after_;
};

}  // namespace tutavia
