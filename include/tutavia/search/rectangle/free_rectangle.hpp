// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/grid/line_of_sight.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// FreeRectangles: grows rectangles of free cells from intervals of free cells.

namespace tutavia::detail {

/// The coordinates of a line from first to last.
struct CellRun {
  int first = 0, last = -1;
  int size() const { return last - first + 1; }
};

/// An interval of cells on one line, and one side of it: along x (`axis` 0, `line` is a row) or
/// along y (1, a column), with the side towards higher lines (`side` 1) or lower ones (-1).
struct CellInterval {
  int axis = 0, line = 0, first = 0, last = 0, side = 1;

  Cell cell(int u) const { return axis == 0 ? Cell{u, line} : Cell{line, u}; }
  Cell middle() const { return cell((first + last) / 2); }
  CellRun run() const { return {first, last}; }
  /// The same coordinates on the next line.
  CellInterval beyond() const { return {axis, line + side, first, last, side}; }
};

/// The cells in a run of columns and a run of rows.
struct CellRectangle {
  std::array<CellRun, 2> runs;  ///< of columns, of rows

  bool contains(Cell cell) const {
    return runs[0].first <= cell.x && cell.x <= runs[0].last && runs[1].first <= cell.y &&
           cell.y <= runs[1].last;
  }
  /// The cells of a side: those along `axis`, at the end towards `side`.
  CellInterval edge(int axis, int side) const {
    const CellRun& along = runs[static_cast<std::size_t>(axis)];
    const CellRun& across = runs[static_cast<std::size_t>(1 - axis)];
    return {axis, side > 0 ? across.last : across.first, along.first, along.last, side};
  }
  /// The cells of an interval inside the rectangle; empty (`last` < `first`) if there are none.
  CellInterval clip(const CellInterval& cells) const {
    const CellRun& along = runs[static_cast<std::size_t>(cells.axis)];
    const CellRun& across = runs[static_cast<std::size_t>(1 - cells.axis)];
    CellInterval result = cells;
    result.first = std::max(cells.first, along.first);
    result.last = std::min(cells.last, along.last);
    if (cells.line < across.first || cells.line > across.last) result.last = result.first - 1;
    return result;
  }
};

/// Reports a rectangle of one side of a search to an observer that is a RectangleObserver.
template <LinkedSpace S, Observer O>
void notify_rectangle(O& observer, const S& space, const CellInterval& from, const CellRectangle& r,
                      SearchSide side) {
  if constexpr (RectangleObserver<O>) {
    const Frame& frame = space.frame();
    const Segment interval{frame.point(from.cell(from.first)), frame.point(from.cell(from.last))};
    const Box rectangle{frame.point({r.runs[0].first, r.runs[1].first}),
                        frame.point({r.runs[0].last, r.runs[1].last})};
    if constexpr (TakesSide<O>) {
      observer.on_rectangle(interval, rectangle, side);
    } else {
      observer.on_rectangle(interval, rectangle);
    }
  }
}

/// Whether the cells of a run of row `y` are free. \pre they lie in the grid
inline bool all_free(const OccupancyGrid& grid, int y, const CellRun& run) {
  return run_is_free(grid.words().data(), grid.index({run.first, y}),
                     static_cast<std::uint32_t>(run.size()));
}

/// Grows rectangles in the free cells of a space, one run of cells at a time.
class FreeRectangles {
 public:
  template <ColumnSpace S>
  explicit FreeRectangles(const S& space) : lines_{&space.grid(), &space.columns()} {}

  /// Whether the cells of a run are free; false for lines beyond the grid.
  bool is_free(int axis, int line, const CellRun& run) const {
    const OccupancyGrid& lines = of(axis);
    return line >= 0 && line < lines.height() && all_free(lines, line, run);
  }

  /// The largest free rectangle grown from free cells: first over their side as far as the full
  /// width is free, then along the interval in both directions.
  CellRectangle grow(const CellInterval& from) const {
    CellRectangle r;
    CellRun& along = r.runs[static_cast<std::size_t>(from.axis)];
    CellRun& across = r.runs[static_cast<std::size_t>(1 - from.axis)];
    along = from.run();
    across = {from.line, from.line};
    int& front = from.side > 0 ? across.last : across.first;
    while (is_free(from.axis, front + from.side, along)) front += from.side;
    while (is_free(1 - from.axis, along.first - 1, across)) --along.first;
    while (is_free(1 - from.axis, along.last + 1, across)) ++along.last;
    return r;
  }

  /// A free rectangle around a free cell: its sides advance in turn, one line at a time, until none
  /// can.
  CellRectangle grow_around(Cell cell) const {
    CellRectangle r{{CellRun{cell.x, cell.x}, CellRun{cell.y, cell.y}}};
    for (bool grows = true; grows;) {
      grows = false;
      for (const auto& [axis, side] : {std::pair{0, 1}, {0, -1}, {1, -1}, {1, 1}}) {
        const CellInterval edge = r.edge(axis, side);
        if (!is_free(axis, edge.line + side, edge.run())) continue;
        CellRun& across = r.runs[static_cast<std::size_t>(1 - axis)];
        if (side > 0) {
          ++across.last;
        } else {
          --across.first;
        }
        grows = true;
      }
    }
    return r;
  }

  /// Appends the free runs of a line, clipped to `within`; none beyond the grid.
  void append_free_runs(int axis, int line, const CellRun& within,
                        std::vector<CellRun>& runs) const {
    const OccupancyGrid& lines = of(axis);
    if (line < 0 || line >= lines.height()) return;
    for (int u = within.first; u <= within.last;) {
      const int begin = lines.run_end(line, u, false);
      if (begin > within.last) return;
      const int end = std::min(lines.run_end(line, begin, true) - 1, within.last);
      runs.push_back({begin, end});
      u = end + 1;
    }
  }

  /// The grid for axis 0, its transpose for axis 1.
  const OccupancyGrid& of(int axis) const { return *lines_[static_cast<std::size_t>(axis)]; }

 private:
  std::array<const OccupancyGrid*, 2> lines_;
};

}  // namespace tutavia::detail
