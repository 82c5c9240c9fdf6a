// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <utility>

#include "tutavia/grid/bitboard/corner_cells.hpp"
#include "tutavia/grid/bitboard/stop_planes.hpp"
#include "tutavia/grid/bitboard/transposed.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/links.hpp"
#include "tutavia/world/frame.hpp"

/// \file
/// GridLayer: the grid of a space, with its frame and its derived tables.

namespace tutavia::detail {

/// A grid of the corners that a path may pass: those of free cells, except where two blocked cells
/// touch at the corner only.
/// \pre `OccupancyGrid::fits(width + 1, height + 1)`
inline OccupancyGrid open_corners(const OccupancyGrid& grid) {
  auto corners =
      OccupancyGrid::blocked(grid.width() + 1, grid.height() + 1, std::int64_t{1} << 31).value();
  for (int y = 0; y <= grid.height(); ++y) {
    for (int x = 0; x <= grid.width(); ++x) {
      const CornerCells around(grid, {x, y});
      if (around.any_free() && !around.is_double()) corners.set({x, y}, true);
    }
  }
  return corners;
}

/// A grid, its frame in the plane and its movement rule: the common part of LatticeSpace and
/// CellSpace.
class GridLayer {
 public:
  GridLayer(OccupancyGrid grid, const Frame& frame, MovementRule movement)
      : grid_(std::move(grid)), frame_(frame), movement_(movement) {}

  const OccupancyGrid& grid() const { return grid_; }
  const Frame& frame() const { return frame_; }
  MovementRule movement() const { return movement_; }

  /// Built at the first call, safely from several threads. Copies of the layer share them.
  const StopPlanes& stop_planes() const {
    std::call_once(lazy_->once, [this] { lazy_->planes.emplace(grid_); });
    return *lazy_->planes;
  }

  /// The grid with rows and columns exchanged; built like `stop_planes`.
  const OccupancyGrid& columns() const {
    std::call_once(lazy_->columns_once, [this] { lazy_->columns.emplace(transposed(grid_)); });
    return *lazy_->columns;
  }

  /// See `open_corners`; built like `stop_planes`. (x, y) is the lower left corner of cell (x, y).
  /// The outside of the grid is blocked.
  const OccupancyGrid& corners() const {
    std::call_once(lazy_->corners_once, [this] { lazy_->corners.emplace(open_corners(grid_)); });
    return *lazy_->corners;
  }

  /// The free cells whose reference points lie within sqrt(2) delta of `p` and for which
  /// `segment_free(p, reference point)` holds. If `p` lies within `merge` of the reference point of
  /// a free cell, that cell alone.
  template <class SegmentFree>
  EndpointLinks links(const Point& p, double merge, const SegmentFree& segment_free) const {
    EndpointLinks result;
    const double delta = frame_.resolution;
    const Cell centre = frame_.nearest_cell(p);
    const auto usable = [&](Cell cell) { return grid_.contains(cell) && grid_.is_free(cell); };
    if (usable(centre) && distance(frame_.point(centre), p) <= merge) {
      result.push_back({centre, 0});
      return result;
    }
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const Cell cell = centre + Cell{x, y};
        if (!usable(cell)) continue;
        const Point node = frame_.point(cell);
        const double length = distance(node, p);
        if (length <= std::numbers::sqrt2 * delta * (1 + 1e-9) && segment_free(p, node)) {
          result.push_back({cell, length});
        }
      }
    }
    return result;
  }

 private:
  OccupancyGrid grid_;
  Frame frame_;
  MovementRule movement_;

  struct Lazy {
    std::once_flag once;
    std::optional<StopPlanes> planes;
    std::once_flag columns_once;
    std::optional<OccupancyGrid> columns;
    std::once_flag corners_once;
    std::optional<OccupancyGrid> corners;
  };
  std::shared_ptr<Lazy> lazy_ = std::make_shared<Lazy>();
};

}  // namespace tutavia::detail
