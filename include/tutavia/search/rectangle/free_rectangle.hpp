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
/// FreeRectangles: rectangles of free cells, grown from a line of them.

namespace tutavia::detail {

/// The places of a line from the first to the last.
struct CellRun {
  int first = 0, last = -1;
  int size() const { return last - first + 1; }
};

/// Cells of one line with a side of it: along x (`axis` 0, `line` is a row) or along y (1, a
/// column), towards higher lines (`side` 1) or lower ones (-1).
struct CellInterval {
  int axis = 0, line = 0, first = 0, last = 0, side = 1;

  Cell cell(int place) const { return axis == 0 ? Cell{place, line} : Cell{line, place}; }
  Cell middle() const { return cell((first + last) / 2); }
  CellRun run() const { return {first, last}; }
  /// The same places on the next line.
  CellInterval beyond() const { return {axis, line + side, first, last, side}; }
};

/// All cells of some columns and rows.
struct CellRectangle {
  std::array<CellRun, 2> runs;  ///< of columns, of rows

  bool contains(Cell cell) const {
    return runs[0].first <= cell.x && cell.x <= runs[0].last && runs[1].first <= cell.y &&
           cell.y <= runs[1].last;
  }
  /// The cells of a side: along `axis`, at its end towards `side`.
  CellInterval edge(int axis, int side) const {
    const CellRun& along = runs[static_cast<std::size_t>(axis)];
    const CellRun& across = runs[static_cast<std::size_t>(1 - axis)];
    return {axis, side > 0 ? across.last : across.first, along.first, along.last, side};
  }
  /// The cells of an interval that lie in it; none where `last` is less than `first`.
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

/// Tells an observer of a rectangle, if it wishes to know.
template <LinkedSpace S, Observer O>
void notify_rectangle(O& observer, const S& space, const CellInterval& from,
                      const CellRectangle& r) {
  if constexpr (RectangleObserver<O>) {
    const Frame& frame = space.frame();
    observer.on_rectangle(
        Segment{frame.point(from.cell(from.first)), frame.point(from.cell(from.last))},
        Box{frame.point({r.runs[0].first, r.runs[1].first}),
            frame.point({r.runs[0].last, r.runs[1].last})});
  }
}

/// Whether the cells of a run of row `y` are free. \pre they lie in the grid
inline bool all_free(const OccupancyGrid& grid, int y, const CellRun& run) {
  return run_is_free(grid.words().data(), grid.index({run.first, y}),
                     static_cast<std::uint32_t>(run.size()));
}

/// Grows rectangles in the free cells of a space, a run of cells at a time.
class FreeRectangles {
 public:
  template <ColumnSpace S>
  explicit FreeRectangles(const S& space) : lines_{&space.grid(), &space.columns()} {}

  /// Whether the cells of a line are free; false for lines beyond the grid.
  bool is_free(int axis, int line, const CellRun& run) const {
    const OccupancyGrid& lines = of(axis);
    return line >= 0 && line < lines.height() && all_free(lines, line, run);
  }

  /// The largest free rectangle that grows from free cells: towards their side as far as that is
  /// free in their width, then along them both ways.
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

  /// A free rectangle that holds a free cell: its sides go out in turn, a line at a time, until
  /// none can.
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

  /// Appends the free runs of a line, as far as they lie in `within`; none beyond the grid.
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

  /// Rows (axis 0), or columns as rows.
  const OccupancyGrid& of(int axis) const { return *lines_[static_cast<std::size_t>(axis)]; }

 private:
  std::array<const OccupancyGrid*, 2> lines_;
};

}  // namespace tutavia::detail
