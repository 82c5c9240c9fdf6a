// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "tutavia/geometry/predicates.hpp"
#include "tutavia/grid/bitboard/corner_cells.hpp"
#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/line_of_sight.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// CornerGraph: a space whose nodes are the corners of a CellSpace's cells.

namespace tutavia::detail {

/// The free space of a point among blocked cells, with nodes at the corners of free cells, by the
/// rules of the Grid-Based Path Planning Competition. A path may slide along blocked cells and
/// touch their corners, but may not pass between two that share a side or only a corner. A view:
/// the cells must outlive it.
class CornerGraph {
 public:
  /// \pre the safety radius is 0
  explicit CornerGraph(const CellSpace& cells)
      : cells_(&cells), frame_{cells.corner({0, 0}), cells.frame().resolution} {}

  /// The corners that a path may pass.
  const OccupancyGrid& grid() const { return cells_->corners(); }
  /// The frame of the corners; its origin is the corner of cell (0, 0).
  const Frame& frame() const { return frame_; }
  const Box& bounds() const { return cells_->bounds(); }
  bool is_free(const Point& p) const { return cells_->is_free(p); }

  /// The legal steps along and through free cells from a corner in `grid()`, by its index there.
  StepSet successors(std::size_t index) const {
    static constexpr SuccessorTable all = successor_table(MovementRule::allow);
    const CornerCells around(cells_->grid(), grid().cell(index));
    const std::array sides{around.se, around.ne, around.nw,
                           around.sw};  // the cell clockwise of each straight step
    unsigned free = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const bool here = sides[i], next = sides[(i + 1) % 4];
      free |= static_cast<unsigned>(here || next) << (2 * i) | static_cast<unsigned>(next)
                                                                   << (2 * i + 1);
    }
    return static_cast<StepSet>(free & all[grid().view().neighbourhood(index)]);
  }

  /// Whether the straight segment between two corners is free.
  bool line_of_sight(Cell a, Cell b) const {
    return corner_line_of_sight(cells_->grid().view(), cells_->columns().view(), a, b);
  }

  bool segment_free(const Point& p, const Point& q) const {
    return cells_->segment_free(p, q) && !passes_double_corner(p, q);
  }

  /// Links a point to the corners of the cells that contain it; a point on a corner is linked to
  /// that corner alone.
  EndpointLinks links(const Point& p) const {
    EndpointLinks result;
    if (!bounds().contains(p)) return result;
    const OccupancyGrid& corners = grid();
    const Cell nearest = frame_.nearest_cell(p);
    if (frame_.point(nearest) == p && corners.contains(nearest) && corners.is_free(nearest)) {
      result.push_back({nearest, 0});
      return result;
    }
    for (int y = nearest.y - 1; y <= nearest.y; ++y) {
      for (int x = nearest.x - 1; x <= nearest.x; ++x) {
        const Cell cell{x, y};
        if (!cells_->grid().contains(cell) || !cells_->grid().is_free(cell)) continue;
        if (!Box{frame_.point(cell), frame_.point(cell + Cell{1, 1})}.contains(p)) continue;
        for (const Cell corner : {cell, cell + Cell{1, 0}, cell + Cell{1, 1}, cell + Cell{0, 1}}) {
          const bool known =
              std::any_of(result.begin(), result.end(),
                          [&](const EndpointLink& link) { return link.cell == corner; });
          if (known || !corners.is_free(corner)) continue;
          result.push_back({corner, distance(p, frame_.point(corner))});
        }
      }
    }
    return result;
  }

 private:
  /// Whether a corner where two blocked cells touch lies between the ends of a free segment.
  bool passes_double_corner(const Point& p, const Point& q) const {
    // Coordinates in cells, along the segment's main axis; `near` exceeds all rounding.
    const Point a = (p - frame_.origin) / frame_.resolution;
    const Point b = (q - frame_.origin) / frame_.resolution;
    const bool steep = std::abs(b.y() - a.y()) > std::abs(b.x() - a.x());
    const double u = steep ? a.y() : a.x(), v = steep ? a.x() : a.y();
    const double end = steep ? b.y() : b.x();
    if (u == end) return false;
    const double slope = ((steep ? b.x() : b.y()) - v) / (end - u);
    constexpr double near = 1e-4;
    const int last = static_cast<int>(std::floor(std::fmax(u, end)));
    for (int i = static_cast<int>(std::ceil(std::fmin(u, end))); i <= last; ++i) {
      const double across = v + (i - u) * slope;
      const int j = static_cast<int>(std::floor(across + 0.5));
      if (std::abs(across - j) > near) continue;
      const Cell corner = steep ? Cell{j, i} : Cell{i, j};
      if (grid().is_free(corner)) continue;
      const Point c = frame_.point(corner);
      if (c != p && c != q && Segment{p, q}.box().contains(c) && orientation(p, q, c) == 0) {
        return true;
      }
    }
    return false;
  }

  const CellSpace* cells_;
  Frame frame_;
};

}  // namespace tutavia::detail
