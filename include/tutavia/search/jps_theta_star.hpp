// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/core/parts/remove_redundant.hpp"
#include "tutavia/search/grid/binary_heap.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// JPS_Theta*: weighted jump point search with line-of-sight tests.

namespace tutavia {

/// Jump point search whose heuristic is the Chebyshev distance h times a weight: `far_weight` if h
/// exceeds `switch_distance` cells, else `near_weight`. Line-of-sight tests remove bends from its
/// path.
///
/// Complete on the grid. Before bends are removed the path costs at most max(1, far_weight,
/// near_weight) times a cheapest one; removing bends never lengthens it. Errors: `invalid_option`
/// for any movement rule but `no_cut`, and for weights that are negative, not finite or above 10^6;
/// others as for AStar.
///
/// Source: Yang et al., "Improved A* based on fused Theta*". Its text describes line-of-sight tests
/// after the search, its name those of Theta* during the search.
///
/// Example: examples/searches_on_cells.cpp.
struct JpsThetaStar {
  static constexpr std::string_view name = "jps_theta_star";
  using Scratch = detail::JumpScratchWith<detail::BinaryHeap>;

  /// When JpsThetaStar tests lines of sight.
  enum class LineOfSight {
    never,         ///< keeps the path of the weighted jump point search
    after_search,  ///< removes nodes whose neighbours see each other
    in_search,     ///< a parent may be any node that sees the child, as in Theta*; then as above
  };

  double far_weight = 2.0;
  double near_weight = 0.8;
  double switch_distance = 12;  ///< [cells]
  LineOfSight lines_of_sight = LineOfSight::after_search;

  template <detail::JumpLineOfSightSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (auto valid = detail::check_no_cut(space, name); !valid)
      return std::move(valid).unexpected();
    for (const double weight : {far_weight, near_weight}) {
      if (!(0 <= weight && weight <= 1e6)) {
        return fail(PlanError::invalid_option, "weights must lie between 0 and 10^6");
      }
    }
    const detail::PlaneScanner scanner(space);
    const auto straighten = [&](std::vector<Cell>& cells) {
      if (lines_of_sight == LineOfSight::never) return;
      detail::remove_redundant(cells, [&](Cell a, Cell b) { return space.line_of_sight(a, b); });
    };
    if (lines_of_sight == LineOfSight::in_search) {
      static_assert(detail::LookBackGuide<LineOfSightGuide<S>>);
      return detail::jump_search(
          space, query, scanner,
          [&](const detail::GridQuery& linked) {
            return LineOfSightGuide<S>{{*this, linked.goal_cell}, space};
          },
          scratch, observer, straighten);
    }
    return detail::jump_search(
        space, query, scanner,
        [&](const detail::GridQuery& linked) {
          return Guide{*this, linked.goal_cell};
        },
        scratch, observer, straighten);
  }

 private:
  struct Guide {
    using Open = detail::BinaryHeap;

    const JpsThetaStar& options;
    Cell goal;

    Cost estimate(Cell cell) const {
      const double h = std::max(std::abs(cell.x - goal.x), std::abs(cell.y - goal.y));
      const double weight = h > options.switch_distance ? options.far_weight : options.near_weight;
      return static_cast<Cost>(weight * h * static_cast<double>(straight_cost));
    }
  };
  template <LineOfSightSpace S>
  struct LineOfSightGuide : Guide {
    const S& space;

    bool line_of_sight(Cell a, Cell b) const { return space.line_of_sight(a, b); }
  };
};

}  // namespace tutavia
