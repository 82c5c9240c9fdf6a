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
/// SBREA*: rectangle expansion from both ends, with nodes that slide along their rails.

namespace tutavia {

namespace detail {

/// Exits by octile distances to each of their cells.
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
    reach_.reset(from.cells, [&](int place) { return cost_of(from, place); });
  }
  void reach(const CellInterval& edge) { reach_.reach(edge); }

  double enter(Exit& exit, const Exit&) {
    exit.costs = static_cast<std::uint32_t>(costs_.size());
    Cost key = std::numeric_limits<Cost>::max();
    for (int place = exit.cells.first; place <= exit.cells.last; ++place) {
      costs_.push_back(reach_[place]);
      key = std::min(key, reach_[place] + estimate_(exit.cells.cell(place)));
    }
    return static_cast<double>(key);
  }

  int place_before(const Exit& exit, Cell to) {
    expand(exit);
    return reach_.reach(to).place;
  }

  std::pair<double, Cell> meet(const Exit&, const OctileCost& other, const Exit& to,
                               const CellInterval& joint) {
    reach_.reach(joint);
    std::pair best{std::numeric_limits<Cost>::max(), Cell{}};
    for (int place = joint.first; place <= joint.last; ++place) {
      const Cost cost = reach_[place] + other.cost_of(to, place);
      if (cost < best.first) best = {cost, joint.cell(place)};
    }
    return {static_cast<double>(best.first), best.second};
  }

 private:
  Cost cost_of(const Exit& exit, int place) const {
    return costs_[exit.costs + static_cast<std::size_t>(place - exit.cells.first)];
  }

  OctileHeuristic estimate_{};
  BorderCosts reach_;        // from the exit that was expanded last
  std::vector<Cost> costs_;  // of the cells of exits
};

}  // namespace detail

/// Free rectangles that grow from the start and from the goal by turns until they meet, each wave
/// in the order of A* with octile distances to every cell of its exits. Then the path's nodes
/// slide along the exits to where it is shortest, and those on straight lines go.
///
/// Complete on the grid, not optimal: it stops where the waves meet first; the test suite reports
/// how much longer its paths are. Needs the movement rule `no_cut`, else `invalid_option`; other
/// errors as for AStar. `Statistics::expanded` counts rectangles; `Route::cost` is the length.
///
/// Source: named in Zhang, Li and Bi 2016, "Rectangle expansion A* pathfinding for grid maps"; how
/// its steps are read here, see docs/algorithms.md.
struct SbReaStar {
  static constexpr std::string_view name = "sb_rea_star";
  using Scratch = detail::BidirectionalRectanglesScratch<detail::OctileCost>;

  template <ColumnSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    return detail::bidirectional_rectangles(
        space, query, scratch, observer, name, false,
        [](std::vector<detail::Rail>& rails, std::size_t, std::vector<Cell>& cells) {
          detail::slide(rails);
          detail::append_corners(rails, cells);
        });
  }
};

}  // namespace tutavia
