// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/search/grid/goal_estimate.hpp"
#include "tutavia/search/rectangle/bidirectional_rectangles.hpp"
#include "tutavia/search/rectangle/border_costs.hpp"

/// \file
/// SBREA*: rectangle expansion from both ends, with nodes that slide along their portals.

namespace tutavia {

namespace detail {

/// Evaluates exits by the octile distances to each of their cells.
class OctileCost {
 public:
  void reset(Cell goal, Cost goal_offset, const OccupancyGrid&) {
    estimate_ = {goal, goal_offset};
    costs_.clear();
  }

  double root(Exit& root, Cost cost) {
    root.costs = static_cast<std::uint32_t>(costs_.size());
    costs_.push_back(cost);
    return static_cast<double>(cost + estimate_(root.cells.cell(root.cells.first)));
  }

  void expand(const Exit& from) {
    border_.reset(from.cells, [&](int u) { return cost_of(from, u); });
  }
  void reach(const CellInterval& edge) { border_.reach(edge); }

  double enter(Exit& exit, const Exit&) {
    exit.costs = static_cast<std::uint32_t>(costs_.size());
    Cost key = std::numeric_limits<Cost>::max();
    for (int u = exit.cells.first; u <= exit.cells.last; ++u) {
      costs_.push_back(border_[u]);
      key = std::min(key, border_[u] + estimate_(exit.cells.cell(u)));
    }
    return static_cast<double>(key);
  }

  int source_of(const Exit& exit, Cell to) {
    expand(exit);
    return border_.reach(to).u;
  }

  std::pair<double, Cell> meet(const Exit&, const OctileCost& other, const Exit& to,
                               const CellInterval& meeting) {
    border_.reach(meeting);
    std::pair best{std::numeric_limits<Cost>::max(), Cell{}};
    for (int u = meeting.first; u <= meeting.last; ++u) {
      const Cost cost = border_[u] + other.cost_of(to, u);
      if (cost < best.first) best = {cost, meeting.cell(u)};
    }
    return {static_cast<double>(best.first), best.second};
  }

 private:
  Cost cost_of(const Exit& exit, int u) const {
    return costs_[exit.costs + static_cast<std::size_t>(u - exit.cells.first)];
  }

  OctileHeuristic estimate_{};
  BorderCosts border_;       // from the exit expanded last
  std::vector<Cost> costs_;  // of the cells of all exits
};

}  // namespace detail

/// Grows free rectangles from the start and from the goal in turn until they meet. Each search
/// expands in the order of A*, with octile distances to every cell of its exits. The path's nodes
/// then slide along the exits to shorten it, and collinear nodes are removed.
///
/// Complete on the grid, not optimal: it stops at the first meeting. The test suite reports by how
/// much its paths exceed the optimum. `Statistics::expanded` counts rectangles; `Route::cost` is
/// the length. Errors: `invalid_option` for any movement rule but `no_cut`; others as for AStar.
///
/// Source: the paper on improved REA* (see ImprovedReaStar) compares with SBREA* and its slide
/// rail, without their steps; docs/algorithms.md has this reading of them. REA* itself: see
/// ReaStar.
///
/// Example: examples/searches_on_cells.cpp.
struct SbReaStar {
  static constexpr std::string_view name = "sb_rea_star";
  using Scratch = detail::BidirectionalRectanglesScratch<detail::OctileCost>;

  template <ColumnSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    return detail::bidirectional_rectangles(
        space, query, scratch, observer, name, false,
        [](std::vector<detail::CellPortal>& portals, std::size_t, std::vector<Cell>& cells) {
          detail::slide(portals);
          detail::append_corners(portals, cells);
        });
  }
};

}  // namespace tutavia
