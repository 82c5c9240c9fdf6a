// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "tutavia/grid/bitboard/bits.hpp"
#include "tutavia/grid/bitboard/stop_planes.hpp"
#include "tutavia/grid/bitboard/turn_planes.hpp"
#include "tutavia/search/grid/corner_cutting_jumps.hpp"
#include "tutavia/search/grid/jump_search.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Jps: jump point search without preprocessing.

namespace tutavia {

namespace detail {

/// Finds jump points in the planes of a grid (see JumpScanner).
class PlaneScanner {
 public:
  template <JumpSpace S>
  explicit PlaneScanner(const S& space) : grid_(space.grid().view()), places_(space.grid()) {
    for (std::size_t i = 0; i < 4; ++i) {
      straight_[i] = space.stop_planes().plane(2 * i);
      diagonal_[i] = space.turn_planes().plane(2 * i + 1);
    }
  }

  Jump straight(std::size_t step, const Place& from) const {
    const int length = straight_[step / 2].jump(from);
    const std::size_t end =
        from.in_rows() + static_cast<std::size_t>(length) * places_.per_step(step);
    return {static_cast<std::uint32_t>(end), length, grid_.is_free(end)};
  }

  template <class Visit>
  Jump diagonal(std::size_t step, Cell cell, const Place& from, Visit visit) const {
    const TurnPlanes::Plane& plane = diagonal_[step / 2];
    const std::size_t horizontal = horizontal_of(step), vertical = vertical_of(step);
    const std::size_t first = plane.bit(cell);
    for (int k = 0;;) {
      k += plane.jump(first + static_cast<std::size_t>(k));
      const Place at = places_.advanced(from, step, k);
      const bool is_end = !grid_.is_free(at.in_rows()) ||
                          !grid_.is_free(at.in_rows() - places_.per_step(horizontal)) ||
                          !grid_.is_free(at.in_rows() - places_.per_step(vertical));
      if (is_end) return {0, k - 1, false};
      visit(k, straight(horizontal, at), straight(vertical, at));
    }
  }

 private:
  OccupancyGrid::View grid_;
  Places places_;
  std::array<StopPlanes::Plane, 4> straight_;
  std::array<TurnPlanes::Plane, 4> diagonal_;
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
    return detail::jump_search(space, query, detail::PlaneScanner(space), scratch, observer);
  }
};

}  // namespace tutavia
