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
/// Exit: an exit of a free rectangle, its evaluation, and the state of a rectangle expansion.

namespace tutavia::detail {

/// An exit of a free rectangle: cells on its edge whose neighbours beyond the edge are free. The
/// next rectangle grows from these cells over the edge, so the two rectangles share them.
struct Exit {
  CellInterval cells;         ///< their side points outwards; a root is a single cell
  std::uint32_t parent = 0;   ///< the exit from which its rectangle grew; a root is its own parent
  CellRectangle rectangle{};  ///< grown from this exit, if it was expanded
  double g = 0;               ///< for the evaluation
  std::uint32_t costs = 0;    ///< for the evaluation
  std::uint64_t last_visited = 0;  ///< the expansion that considered it last
};

/// The cost of exits in one side of a bidirectional search. An evaluation keeps its memory between
/// queries.
///
/// - `reset(goal, offset, grid)`: starts a query towards `goal`
/// - `root(exit, cost)`, `enter(exit, parent)`: the key of a new exit
/// - `source_of(exit, cell)`: the coordinate in `exit` through which the path to a cell of its
///   rectangle passes
/// - `meet(exit, other evaluation, other's exit, cells)`: the length and the cell of the best
///   meeting in `cells`, which belong to the other's exit and lie in the rectangle grown from
///   `exit`
template <class E>
concept ExitEvaluation = std::default_initializable<E> &&
    requires(E& evaluation, const E& other, Exit& exit, const Exit& from, const CellInterval& cells,
             Cell cell, Cost cost, const OccupancyGrid& grid) {
  evaluation.reset(cell, cost, grid);
  { evaluation.root(exit, cost) } -> std::same_as<double>;
  { evaluation.enter(exit, from) } -> std::same_as<double>;
  { evaluation.source_of(from, cell) } -> std::same_as<int>;
  { evaluation.meet(from, other, from, cells) } -> std::same_as<std::pair<double, Cell>>;
};

/// An evaluation that computes costs per cell, from the exit expanded last. `expand(exit)` is
/// called before a rectangle that grew from `exit` is used; `reach(edge)` before exits over its
/// side `edge` are entered.
template <class E>
concept CellwiseEvaluation = ExitEvaluation<E> &&
    requires(E& evaluation, const Exit& from, const CellInterval& edge) {
  evaluation.expand(from);
  evaluation.reach(edge);
};

/// An evaluation with a moving target. `aim_at(cells)` is called before the exits of a rectangle
/// are entered, with the exit that the other side has expanded last.
template <class E>
concept AimedEvaluation = ExitEvaluation<E> && requires(E& evaluation, const CellInterval& cells) {
  evaluation.aim_at(cells);
};

/// State of a rectangle expansion from one end; keeps its memory between queries.
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
  std::vector<std::uint32_t> markers;  // per marked cell: an exit that contains it
  Evaluation evaluation;
};

template <ExitEvaluation Evaluation>
struct BidirectionalRectanglesScratch {
  std::array<RectangleExpansion<Evaluation>, 2> expansions;
  std::vector<CellRun> exits;
  std::vector<CellPortal> portals;
  std::vector<Cell> cells;
};

}  // namespace tutavia::detail
