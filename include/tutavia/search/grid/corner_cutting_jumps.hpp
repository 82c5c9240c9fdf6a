// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>

#include "tutavia/core/assert.hpp"
#include "tutavia/grid/bitboard/stop_planes.hpp"
#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// CornerCuttingScanner: the jumps of a jump point search whose steps may cut corners.

namespace tutavia::detail {

/// Scans for jump points under the rules `no_squeeze` and `allow` (see JumpScanner).
///
/// A jump point is a cell at which the canonical table of the rule holds a step that does not just
/// continue the jump. On a straight run that is a diagonal step behind a blocked cell: a blocked
/// cell beside x is followed by a free one beside x + 1. Under `no_squeeze` x + 1 must be free as
/// well. Under `no_cut` the same pattern makes x + 1 a stop, so the stop planes of that rule serve
/// all three: a run stops one cell before its next stop. Diagonal runs have jump points, too, and
/// end at them.
///
/// No shortest path is lost, and one step of arrival per cell is enough. Let n be reached by a
/// shortest path whose last two steps are p -> x -> n. The table omits x -> n if a way around x is
/// cheaper, which cannot be. It also omits x -> n if p -> x is straight and a way p -> y -> n costs
/// the same: then x -> n and p -> y are the same diagonal step, and y -> n is straight. By
/// induction over costs, y is reached at its least cost. The table keeps y -> n whatever the step
/// of arrival at y: after a diagonal step only cheaper ways count, and after a straight one at a
/// right angle the diagonal past y, which is free, would be cheaper. Source of the pruning: Harabor
/// and Grastien 2011, "Online graph pruning for pathfinding on grid maps", section 3 (`allow`).
class CornerCuttingScanner {
 public:
  /// \pre the rule is `no_squeeze` or `allow`
  CornerCuttingScanner(const OccupancyGrid& grid, const StopPlanes& planes, MovementRule rule)
      : grid_(grid.view()),
        planes_(planes),
        table_(canonical_table(rule)),
        squeezes_(rule == MovementRule::allow) {
    TUTAVIA_ASSERT(rule == MovementRule::no_squeeze || rule == MovementRule::allow);
  }

  template <std::size_t Step>
  int straight(Cell from) const {
    return straight<Step>(planes_.plane_index(from));
  }

  /// Like the diagonals of JumpScanner, and returns the number of steps to the jump point at which
  /// the diagonal ends; 0 if there is none.
  template <std::size_t Step, class Visit>
  int diagonal(Cell from, Cell goal, Visit visit) const {
    constexpr Cell d = steps[Step];
    constexpr std::size_t horizontal = d.x == 1 ? 0 : 4, vertical = d.y == 1 ? 2 : 6;
    constexpr unsigned continued = 1u << Step | 1u << horizontal | 1u << vertical;
    const std::size_t along_rows = offset(d.x, 1) + offset(d.y, grid_.stride);
    const std::size_t along_columns = offset(d.x, planes_.column_stride()) + offset(d.y, 1);
    // Numbers of steps after which the goal's row and column are reached.
    const int at_row = (goal.y - from.y) * d.y, at_column = (goal.x - from.x) * d.x;
    StopPlanes::PlaneIndex at = planes_.plane_index(from);
    unsigned successors = table_[no_step][grid_.neighbourhood(at.in_rows)];
    for (int k = 1; (successors >> Step & 1u) != 0; ++k) {
      at.in_rows += along_rows;
      at.in_columns += along_columns;
      successors = table_[Step][grid_.neighbourhood(at.in_rows)];
      if ((successors & ~continued) != 0) return k;
      const int sideways = straight<horizontal>(at), upright = straight<vertical>(at);
      const bool near_goal = std::abs(at_row - k) <= 1 || std::abs(at_column - k) <= 1;
      if (sideways > 0 || upright > 0 || near_goal) visit(k, sideways, upright);
    }
    return 0;
  }

 private:
  static std::size_t offset(int sign, std::size_t distance) {
    return sign == 1 ? distance : -distance;
  }

  template <std::size_t Step>
  int straight(StopPlanes::PlaneIndex at) const {
    constexpr Cell d = steps[Step];
    const std::size_t along_rows = d.y == 0 ? offset(d.x, 1) : offset(d.y, grid_.stride);
    const std::size_t along_columns =
        d.y == 0 ? offset(d.x, planes_.column_stride()) : offset(d.y, 1);
    const auto advance = [&](int count) {
      at.in_rows += along_rows * static_cast<std::size_t>(count);
      at.in_columns += along_columns * static_cast<std::size_t>(count);
    };
    int distance = planes_.template jump<Step>(at);
    advance(distance);
    if (distance == 1 && grid_.is_free(at.in_rows)) {  // the cell of departure is no jump point
      const int more = planes_.template jump<Step>(at);
      advance(more);
      distance += more;
    }
    const bool stops =
        grid_.is_free(at.in_rows) || (squeezes_ && opens_beside<Step>(at.in_rows - along_rows));
    return stops ? distance - 1 : 1 - distance;
  }

  /// Whether a cell has a diagonal step behind a blocked cell beside it.
  template <std::size_t Step>
  bool opens_beside(std::size_t index) const {
    const Neighbourhood around = grid_.neighbourhood(index);
    return (!is_free(around, (Step + 2) % 8) && is_free(around, (Step + 1) % 8)) ||
           (!is_free(around, (Step + 6) % 8) && is_free(around, (Step + 7) % 8));
  }

  OccupancyGrid::View grid_;
  const StopPlanes& planes_;
  const CanonicalTable& table_;
  bool squeezes_;  // between two blocked cells
};

}  // namespace tutavia::detail
