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
/// What a jump point search is made of: an open list, a scanner and a guide.

namespace tutavia::detail {

/// The open list of a jump point search: WideBucketQueue, for estimates that are consistent, or
/// BinaryHeap.
///
/// `reset(least)` empties it, and no key will be less. `push(key, node, note)` puts an entry in.
/// `offset_along()` is a lower bound of all keys, less than `width` below that of the entry which
/// `pop()` then takes out.
template <class L>
concept OpenList = std::default_initializable<L> &&
    requires(L& open, const L& constant, Cost key, std::uint32_t number) {
  { L::width } -> std::convertible_to<Cost>;
  open.reset(key);
  { constant.empty() } -> std::same_as<bool>;
  open.push(key, number, number);
  { open.seek_first() } -> std::same_as<Cost>;
  { open.pop().node } -> std::convertible_to<std::uint32_t>;
  { open.pop().note } -> std::convertible_to<std::uint32_t>;
};

/// What jumps for a JumpSearch.
///
/// `straight<Step>(cell)` is the number of steps to the jump point in that direction, or -n where
/// there are n steps to a wall. `diagonal<Step>(cell, goal, visit)` calls `visit(k, horizontal,
/// vertical)` for each number k of diagonal steps after which one of the two straight jumps from
/// there leads to a jump point, or to a goal next to the cell `goal`; the jumps are as `straight`
/// has them.
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

/// A scanner that reads ahead: `prefetch(cell)` announces a cell that will be jumped from.
template <class S>
concept PrefetchingScanner = JumpScanner<S> && requires(const S& scanner, Cell cell) {
  scanner.prefetch(cell);
};

/// What guides a JumpSearch: `Open` is the type of its open list, `estimate(cell)` what the way
/// from a cell to the goal may cost.
template <class G>
concept JumpGuide = OpenList<typename G::Open> && requires(const G& guide, Cell cell) {
  { guide.estimate(cell) } -> std::same_as<Cost>;
};

/// A guide that looks back: the jump points that a cell's parent sees, by `sees(a, b)`, become the
/// parent's own.
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

/// What guides jump point search proper: octile distance, and no looking back.
struct OctileGuide {
  using Open = WideBucketQueue;

  explicit OctileGuide(const GridQuery& linked) : octile{linked.goal_cell, linked.goal_offset} {}
  Cost estimate(Cell cell) const { return octile(cell); }

  OctileHeuristic octile;
};

}  // namespace tutavia::detail
