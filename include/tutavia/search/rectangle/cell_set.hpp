// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/search/rectangle/free_rectangle.hpp"

/// \file
/// CellSet: a set of cells of a grid, one bit each.

namespace tutavia::detail {

/// A set of cells; runs and rectangles can be added at once. Keeps its memory.
class CellSet {
 public:
  /// Makes the set empty, for the cells of a grid.
  void reset(const OccupancyGrid& grid) {
    if (members_.width() != grid.width() || members_.height() != grid.height()) {
      members_ = OccupancyGrid::blocked(grid.width(), grid.height(),
                                        std::numeric_limits<std::int64_t>::max())
                     .value();
    }
    for (int y = 0; y < members_.height(); ++y) {
      members_.set_run(y, 0, members_.width() - 1, false);
    }
  }

  void add(Cell cell) { members_.set(cell, true); }
  void add(const CellRectangle& r) {
    for (int y = r.runs[1].first; y <= r.runs[1].last; ++y) {
      members_.set_run(y, r.runs[0].first, r.runs[0].last, true);
    }
  }

  /// Whether the set contains all cells of an interval.
  bool holds(const CellInterval& cells) const {
    if (cells.axis == 0) return all_free(members_, cells.line, cells.run());
    int y = cells.first;
    while (y <= cells.last && members_.is_free(Cell{cells.line, y})) ++y;
    return y > cells.last;
  }

  /// Calls `visit(cell)` for the cells of a rectangle that the set contains, row by row.
  template <class Visit>
  void for_each_in(const CellRectangle& r, Visit visit) const {
    for (int y = r.runs[1].first; y <= r.runs[1].last; ++y) {
      const auto next = [&](int x) { return members_.run_end(y, x, false); };
      for (int x = next(r.runs[0].first); x <= r.runs[0].last; x = next(x + 1)) visit(Cell{x, y});
    }
  }

  /// Whether the set contains any cell of an interval.
  bool meets(const CellInterval& cells) const {
    if (cells.axis == 0) return members_.run_end(cells.line, cells.first, false) <= cells.last;
    int y = cells.first;
    while (y <= cells.last && !members_.is_free(Cell{cells.line, y})) ++y;
    return y <= cells.last;
  }

 private:
  OccupancyGrid members_;  // a free cell is a member
};

}  // namespace tutavia::detail
