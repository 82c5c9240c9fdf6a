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
/// Passage: a way out of a free rectangle, what it costs, and a wave of them.

namespace tutavia::detail {

/// Cells on the edge of a free rectangle whose neighbours beyond it are free: a way out of it. The
/// next rectangle grows from these cells over the edge, so that the two share them.
struct Passage {
  CellInterval cells;         ///< their side leads out; a root is a single cell
  std::uint32_t parent = 0;   ///< the passage that the rectangle grew from; a root's is itself
  CellRectangle rectangle{};  ///< that grew from this one, if it was expanded
  double g = 0;               ///< what the evaluation keeps
  std::uint32_t costs = 0;    ///< the same
  std::uint64_t asked = 0;    ///< in which expansion it was considered last
};

/// What passages cost to one wave of rectangles. It keeps memory of its own.
///
/// - `begin(goal, offset, grid)`: a query begins; the goal is where the wave goes to
/// - `root(passage, cost)`, `enter(passage, parent)`: the key of a new passage
/// - `place_before(passage, cell)`: where the way to a cell of its rectangle passes it
/// - `meet(passage, other evaluation, other's passage, joint)`: the length and the cell of the best
///   meeting in the cells `joint` of the other's passage, which lie in the rectangle that grew from
///   `passage`
template <class E>
concept PassageEvaluation = std::default_initializable<E> &&
    requires(E& evaluation, const E& other, Passage& passage, const Passage& from,
             const CellInterval& cells, Cell cell, Cost cost, const OccupancyGrid& grid) {
  evaluation.begin(cell, cost, grid);
  { evaluation.root(passage, cost) } -> std::same_as<double>;
  { evaluation.enter(passage, from) } -> std::same_as<double>;
  { evaluation.place_before(from, cell) } -> std::same_as<int>;
  { evaluation.meet(from, other, from, cells) } -> std::same_as<std::pair<double, Cell>>;
};

/// An evaluation that looks at cells from the passage expanded last: `expand(passage)` says that a
/// rectangle grows from it, or is looked at again; `reach(edge)` that its side `edge` is left next.
template <class E>
concept ReachEvaluation = PassageEvaluation<E> &&
    requires(E& evaluation, const Passage& from, const CellInterval& edge) {
  evaluation.expand(from);
  evaluation.reach(edge);
};

/// What a wave of rectangles keeps between queries: memory.
template <PassageEvaluation Evaluation>
struct RectangleWave {
  struct Entry {
    double key;
    std::uint32_t passage;
    friend bool operator<(const Entry& a, const Entry& b) {  // worse < better
      return a.key != b.key ? a.key > b.key : a.passage > b.passage;
    }
  };

  std::vector<Passage> passages;
  std::vector<std::uint32_t> expanded;
  OpenList<Entry> open;
  CellSet marked, covered;             // cells of passages, cells of rectangles
  std::vector<std::uint32_t> markers;  // of the cells that are marked: a passage that holds it
  Evaluation evaluation;
};

template <PassageEvaluation Evaluation>
struct RectangleWavesScratch {
  std::array<RectangleWave<Evaluation>, 2> waves;
  std::vector<CellRun> exits;
  std::vector<Rail> rails;
  std::vector<Cell> cells;
};

}  // namespace tutavia::detail
