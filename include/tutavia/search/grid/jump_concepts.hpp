// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

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

/// Computes the jumps of a JumpSearch.
///
/// `straight<Step>(cell)` is the number of steps to the jump point in that direction, or -n if
/// there are n steps to an obstacle. `diagonal<Step>(cell, goal, visit)` calls `visit(k,
/// horizontal, vertical)` for each number k of diagonal steps after which a straight jump leads to
/// a jump point, or to a goal next to the cell `goal`. The two straight jumps are given as by
/// `straight`.
template <class S>
concept JumpScanner = requires(const S& scanner, Cell cell, void (*visit)(int, int, int)) {
  { scanner.template straight<0>(cell) } -> std::same_as<int>;
  { scanner.template straight<2>(cell) } -> std::same_as<int>;
  { scanner.template straight<4>(cell) } -> std::same_as<int>;
  { scanner.template straight<6>(cell) } -> std::same_as<int>;
  scanner.template diagonal<1>(cell, cell, visit);
  scanner.template diagonal<3>(cell, cell, visit);
  scanner.template diagonal<5>(cell, cell, visit);
  scanner.template diagonal<7>(cell, cell, visit);
};

/// A scanner whose diagonals end at jump points: `diagonal` returns the number of steps to the one
/// at which it ended, which it has not visited; 0 if there is none.
template <class S>
concept DiagonalStopScanner = JumpScanner<S> &&
    requires(const S& scanner, Cell cell, void (*visit)(int, int, int)) {
  { scanner.template diagonal<1>(cell, cell, visit) } -> std::same_as<int>;
};

/// A scanner with a prefetch: `prefetch(cell)` announces a cell from which the search will jump.
template <class S>
concept PrefetchingScanner = JumpScanner<S> && requires(const S& scanner, Cell cell) {
  scanner.prefetch(cell);
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
