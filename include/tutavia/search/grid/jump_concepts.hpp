// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/grid/bitboard/places.hpp"
#include "tutavia/grid/cell.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/search/grid/goal_estimate.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/label_map.hpp"
#include "tutavia/search/grid/wide_bucket_queue.hpp"
#include "tutavia/search/heuristic.hpp"

/// \file
/// The parts of a jump point search: open list, scanner and guide.

namespace tutavia::detail {

/// The open list of a jump point search: WideBucketQueue for consistent estimates, or BinaryHeap.
///
/// `reset(least)` empties it; no key may be less than `least`. `push(key, node, tag)` adds an
/// entry. `seek_first()` returns a lower bound on all keys; the key of the entry that `pop()` then
/// returns exceeds it by less than `width`.
template <class L>
concept OpenList = std::default_initializable<L> &&
    requires(L& open, const L& constant, Cost key, std::uint32_t number) {
  { L::width } -> std::convertible_to<Cost>;
  open.reset(key);
  { constant.empty() } -> std::same_as<bool>;
  open.push(key, number, number);
  { open.seek_first() } -> std::same_as<Cost>;
  { open.pop().node } -> std::convertible_to<std::uint32_t>;
  { open.pop().tag } -> std::convertible_to<std::uint32_t>;
};

/// A jump from a cell in one direction.
struct Jump {
  std::uint32_t end = 0;  ///< index of the cell `length` steps away
  /// Steps to the jump point or, without one, to the last free cell or the blocked one behind it.
  int length = 0;
  bool at_jump_point = false;
};

/// Computes the jumps of a JumpSearch. \pre steps are allowed from the cell in the direction
///
/// `straight(step, place)` is the jump from a cell in a straight direction. `diagonal(step, cell,
/// place, visit)` is the jump in a diagonal one, whose last cell is always free. It calls `visit(k,
/// horizontal, vertical)` for every number k of steps after which a straight jump leads to a jump
/// point, with the straight jumps from there; not for the jump point at its own end.
template <class S>
concept JumpScanner = requires(const S& scanner, std::size_t step, Cell cell, const Place& place,
                               void (*visit)(int, Jump, Jump)) {
  { scanner.straight(step, place) } -> std::same_as<Jump>;
  { scanner.diagonal(step, cell, place, visit) } -> std::same_as<Jump>;
};

/// The horizontal and the vertical component of a diagonal step, as steps.
constexpr std::size_t horizontal_of(std::size_t diagonal) { return steps[diagonal].x > 0 ? 0 : 4; }
constexpr std::size_t vertical_of(std::size_t diagonal) { return diagonal < 4 ? 2 : 6; }

/// A scanner with a prefetch: `prefetch(index)` announces the index of a cell from which the search
/// will jump.
template <class S>
concept PrefetchingScanner = JumpScanner<S> && requires(const S& scanner, std::uint32_t index) {
  scanner.prefetch(index);
};

/// The guide of a JumpSearch: `Open` is the type of its open list, `estimate(cell)` the estimated
/// cost from a cell to the goal.
template <class G>
concept JumpGuide = OpenList<typename G::Open> && requires(const G& guide, Cell cell) {
  { guide.estimate(cell) } -> std::same_as<Cost>;
};

/// A guide with lines of sight, as in Theta*: if `line_of_sight(a, b)` holds between the parent a
/// of a cell and a jump point b reached from the cell, a becomes the parent of b.
template <class G>
concept LookBackGuide = JumpGuide<G> && requires(const G& guide, Cell cell) {
  { guide.line_of_sight(cell, cell) } -> std::same_as<bool>;
};

/// Memory of a jump point search.
template <OpenList Open>
struct JumpScratchWith {
  LabelMap labels;
  Open open;
  std::vector<Cell> cells;
};
using JumpScratch = JumpScratchWith<WideBucketQueue>;

/// The guide of plain jump point search: octile distance, without lines of sight.
struct OctileGuide {
  using Open = WideBucketQueue;

  explicit OctileGuide(const GridQuery& linked) : octile{linked.goal_cell, linked.goal_offset} {}
  Cost estimate(Cell cell) const { return octile(cell); }

  OctileHeuristic octile;
};

}  // namespace tutavia::detail
