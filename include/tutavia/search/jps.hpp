// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdlib>
#include <string_view>

#include "tutavia/grid/bitboard/stop_planes.hpp"
#include "tutavia/search/grid/corner_cutting_jumps.hpp"
#include "tutavia/search/grid/jump_search.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Jps: jump point search without preprocessing.

namespace tutavia {

namespace detail {

/// Scans for jump points in the stop planes of a grid (see JumpScanner).
struct PlaneScanner {
  OccupancyGrid::View grid;
  const StopPlanes& planes;

  template <std::size_t Step>
  int straight(Cell from) const {
    return straight<Step>(planes.plane_index(from));
  }
  template <std::size_t Step>
  int straight(const StopPlanes::PlaneIndex& from) const {
    const int distance = planes.template jump<Step>(from);
    const auto steps_on = static_cast<std::size_t>(distance);
    const std::size_t stop = Step == 0   ? from.in_rows + steps_on
                             : Step == 2 ? from.in_rows + steps_on * grid.stride
                             : Step == 4 ? from.in_rows - steps_on
                                         : from.in_rows - steps_on * grid.stride;
    return grid.is_free(stop) ? distance : 1 - distance;
  }

  template <std::size_t Step, class Visit>
  void diagonal(Cell from, Cell goal, Visit visit) const {
    constexpr Cell d = steps[Step];
    constexpr std::size_t horizontal = d.x == 1 ? 0 : 4, vertical = d.y == 1 ? 2 : 6;
    const auto signed_offset = [](int sign, std::size_t offset) {
      return sign == 1 ? offset : -offset;
    };
    const std::size_t beside_x = signed_offset(d.x, 1), beside_y = signed_offset(d.y, grid.stride);
    const std::size_t along_columns =
        signed_offset(d.x, planes.column_stride()) + signed_offset(d.y, 1);
    // Numbers of steps after which the goal's row and column are reached.
    const int at_row = (goal.y - from.y) * d.y, at_column = (goal.x - from.x) * d.x;
    StopPlanes::PlaneIndex at = planes.plane_index(from);
    for (int k = 1; grid.is_free(at.in_rows + beside_x) && grid.is_free(at.in_rows + beside_y) &&
                    grid.is_free(at.in_rows + beside_x + beside_y);
         ++k) {
      at.in_rows += beside_x + beside_y;
      at.in_columns += along_columns;
      const int sideways = straight<horizontal>(at), upright = straight<vertical>(at);
      const bool near_goal = std::abs(at_row - k) <= 1 || std::abs(at_column - k) <= 1;
      if (sideways > 0 || upright > 0 || near_goal) visit(k, sideways, upright);
    }
  }
};

}  // namespace detail

/// Jump point search: A* that skips cells which only continue a path. Paths have the same length as
/// those of A* under every rule with diagonal steps; far faster in open areas. Errors:
/// `invalid_option` for the movement rule `four_connected`. Other guarantees and errors as for
/// AStar.
///
/// Source: Harabor and Grastien 2011, "Online graph pruning for pathfinding on grid maps"
/// (`allow`), and 2014, "Improving jump point search" (`no_cut`; diagonal jump points pruned). The
/// jump points of `no_squeeze` are derived in search/grid/corner_cutting_jumps.hpp.
///
/// Example: examples/searches_on_cells.cpp.
struct Jps {
  static constexpr std::string_view name = "jps";
  using Scratch = detail::JumpScratch;

  template <JumpSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (auto valid = detail::check_has_rule(space); !valid) return std::move(valid).unexpected();
    if (space.movement() == MovementRule::four_connected) {
      return fail(PlanError::invalid_option, "jps needs a movement rule with diagonal steps");
    }
    if (space.movement() != MovementRule::no_cut) {
      const detail::CornerCuttingScanner scanner(space.grid(), space.stop_planes(),
                                                 space.movement());
      return detail::jump_search(space, query, scanner, scratch, observer);
    }
    const detail::PlaneScanner scanner{space.grid().view(), space.stop_planes()};
    return detail::jump_search(space, query, scanner, scratch, observer);
  }
};

}  // namespace tutavia
