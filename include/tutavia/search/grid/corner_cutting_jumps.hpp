// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "tutavia/core/assert.hpp"
#include "tutavia/grid/bitboard/places.hpp"
#include "tutavia/grid/bitboard/stop_planes.hpp"
#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/search/grid/jump_concepts.hpp"

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
        places_(grid),
        planes_{planes.plane(0), planes.plane(2), planes.plane(4), planes.plane(6)},
        table_(canonical_table(rule)),
        squeezes_(rule == MovementRule::allow) {
    TUTAVIA_ASSERT(rule == MovementRule::no_squeeze || rule == MovementRule::allow);
  }

  Jump straight(std::size_t step, const Place& from) const {
    const StopPlanes::Plane& plane = planes_[step / 2];
    int distance = plane.jump(from);
    if (distance == 1) {
      const Place next = places_.advanced(from, step, 1);
      // The cell of departure is no jump point.
      if (grid_.is_free(next.in_rows())) distance += plane.jump(next);
    }
    const bool stops =
        grid_.is_free(places_.advanced(from, step, distance).in_rows()) ||
        (squeezes_ && opens_beside(places_.advanced(from, step, distance - 1), step));
    const Place end = places_.advanced(from, step, distance - 1);
    return {static_cast<std::uint32_t>(end.in_rows()), distance - 1, stops};
  }

  template <class Visit>
  Jump diagonal(std::size_t step, Cell, const Place& from, Visit visit) const {
    const std::size_t horizontal = horizontal_of(step), vertical = vertical_of(step);
    const unsigned continued = 1u << step | 1u << horizontal | 1u << vertical;
    unsigned successors = table_[no_step][grid_.neighbourhood(from.in_rows())];
    for (int k = 1;; ++k) {
      if ((successors >> step & 1u) == 0) return {0, k - 1, false};
      const Place at = places_.advanced(from, step, k);
      successors = table_[step][grid_.neighbourhood(at.in_rows())];
      if ((successors & ~continued) != 0)
        return {static_cast<std::uint32_t>(at.in_rows()), k, true};
      const Jump sideways = straight(horizontal, at), upright = straight(vertical, at);
      if (sideways.at_jump_point || upright.at_jump_point) visit(k, sideways, upright);
    }
  }

 private:
  /// Whether a cell has a diagonal step behind a blocked cell beside it.
  bool opens_beside(const Place& cell, std::size_t step) const {
    const Neighbourhood around = grid_.neighbourhood(cell.in_rows());
    return (!is_free(around, (step + 2) % 8) && is_free(around, (step + 1) % 8)) ||
           (!is_free(around, (step + 6) % 8) && is_free(around, (step + 7) % 8));
  }

  OccupancyGrid::View grid_;
  Places places_;
  std::array<StopPlanes::Plane, 4> planes_;
  const CanonicalTable& table_;
  bool squeezes_;  // between two blocked cells
};

}  // namespace tutavia::detail
