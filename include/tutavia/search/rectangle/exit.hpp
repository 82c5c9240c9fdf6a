// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <utility>
#include <vector>

#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/search/grid/open_heap.hpp"
#include "tutavia/search/rectangle/cell_set.hpp"
#include "tutavia/search/rectangle/free_rectangle.hpp"
#include "tutavia/search/rectangle/portal_chain.hpp"

/// \file
/// Exit: a way out of a free rectangle, what it costs, and a wave of them.

namespace tutavia::detail {

/// Cells on the edge of a free rectangle whose neighbours beyond it are free: a way out of it. The
/// next rectangle grows from these cells over the edge, so that the two share them.
struct Exit {
  CellInterval cells;         ///< their side leads out; a root is a single cell
  std::uint32_t parent = 0;   ///< the exit that the rectangle grew from; a root's is itself
  CellRectangle rectangle{};  ///< that grew from this one, if it was expanded
  double g = 0;               ///< what the evaluation keeps
  std::uint32_t costs = 0;    ///< the same
  std::uint64_t asked = 0;    ///< in which expansion it was considered last
};

/// What exits cost to one wave of rectangles. It keeps memory of its own.
///
/// - `reset(goal, offset, grid)`: a query begins; the goal is where the wave goes to
/// - `root(exit, cost)`, `enter(exit, parent)`: the key of a new exit
/// - `place_before(exit, cell)`: where the way to a cell of its rectangle passes it
/// - `meet(exit, other evaluation, other's exit, joint)`: the length and the cell of the best
///   meeting in the cells `joint` of the other's exit, which lie in the rectangle that grew from
///   `exit`
template <class E>
concept ExitEvaluation = std::default_initializable<E> &&
    requires(E& evaluation, const E& other, Exit& exit, const Exit& from, const CellInterval& cells,
             Cell cell, Cost cost, const OccupancyGrid& grid) {
  evaluation.reset(cell, cost, grid);
  { evaluation.root(exit, cost) } -> std::same_as<double>;
  { evaluation.enter(exit, from) } -> std::same_as<double>;
  { evaluation.place_before(from, cell) } -> std::same_as<int>;
  { evaluation.meet(from, other, from, cells) } -> std::same_as<std::pair<double, Cell>>;
};

/// An evaluation that looks at cells from the exit expanded last: `expand(exit)` says that a
/// rectangle grows from it, or is looked at again; `reach(edge)` that its side `edge` is left next.
template <class E>
concept CellwiseEvaluation = ExitEvaluation<E> &&
    requires(E& evaluation, const Exit& from, const CellInterval& edge) {
  evaluation.expand(from);
  evaluation.reach(edge);
};

/// What a wave of rectangles keeps between queries: memory.
template <ExitEvaluation Evaluation>
struct RectangleExpansion {
  struct Entry {
    double key;
    std::uint32_t exit;
    friend bool operator<(const Entry& a, const Entry& b) {  // worse < better
      return a.key != b.key ? a.key > b.key : a.exit > b.exit;
    }
  };

  std::vector<Exit> exits;
  std::vector<std::uint32_t> expanded;
  OpenHeap<Entry> open;
  CellSet marked, covered;             // cells of exits, cells of rectangles
  std::vector<std::uint32_t> markers;  // of the cells that are marked: a exit that holds it
  Evaluation evaluation;
};

template <ExitEvaluation Evaluation>
struct BidirectionalRectanglesScratch {
  std::array<RectangleExpansion<Evaluation>, 2> waves;
  std::vector<CellRun> exits;
  std::vector<Rail> rails;
  std::vector<Cell> cells;
};

}  // namespace tutavia::detail
