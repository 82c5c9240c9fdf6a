// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <utility>

#include "tutavia/grid/bitboard/corner_cells.hpp"
#include "tutavia/grid/bitboard/stop_planes.hpp"
#include "tutavia/grid/bitboard/transposed.hpp"
#include "tutavia/grid/bitboard/turn_planes.hpp"
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

  /// Copies of a layer share an identity, other layers do not.
  std::shared_ptr<const void> identity() const { return lazy_; }

  /// Built at the first call, safely from several threads. Copies of the layer share them.
  const StopPlanes& stop_planes() const {
    return lazy_->stops.get([this] { return StopPlanes(grid_); });
  }

  /// Built like `stop_planes`.
  const TurnPlanes& turn_planes() const {
    return lazy_->turns.get([this] { return TurnPlanes(grid_, stop_planes()); });
  }

  /// The grid with rows and columns exchanged; built like `stop_planes`.
  const OccupancyGrid& columns() const {
    return lazy_->columns.get([this] { return transposed(grid_); });
  }

  /// See `open_corners`; built like `stop_planes`. (x, y) is the lower left corner of cell (x, y).
  /// The outside of the grid is blocked.
  const OccupancyGrid& corners() const {
    return lazy_->corners.get([this] { return open_corners(grid_); });
  }

  /// The free cells whose reference points lie within sqrt(2) delta of `p` and for which
  /// `segment_free(p, reference point)` holds. If `p` lies within `merge` of the reference point of
  /// a free cell, that cell alone.
  ///
  /// If there is none, rings of cells farther away are tried, up to `most_rings`: the result is the
  /// nearest cell of the first ring in which one can be reached, and those around it.
  template <class SegmentFree>
  EndpointLinks links(const Point& p, double merge, const SegmentFree& segment_free) const {
    const Cell centre = frame_.nearest_cell(p);
    if (is_usable(centre) && distance(frame_.point(centre), p) <= merge) {
      EndpointLinks result;
      result.push_back({centre, 0});
      return result;
    }
    EndpointLinks result;
    const double reach = std::numbers::sqrt2 * frame_.resolution * (1 + 1e-9);
    add_links(p, centre, reach, segment_free, result);
    for (int ring = 2; result.empty() && ring <= most_rings; ++ring) {
      const auto nearest = nearest_in_ring(p, centre, ring, segment_free);
      if (!nearest) continue;
      result = EndpointLinks(*nearest);
      add_links(p, *nearest, std::numeric_limits<double>::infinity(), segment_free, result);
    }
    return result;
  }
  static constexpr int most_rings = 16;

 private:
  bool is_usable(Cell cell) const { return grid_.contains(cell) && grid_.is_free(cell); }

  /// Adds the links of `p` to a cell and those around it, of a length up to `reach`.
  template <class SegmentFree>
  void add_links(const Point& p, Cell centre, double reach, const SegmentFree& segment_free,
                 EndpointLinks& links) const {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const Cell cell = centre + Cell{x, y};
        if (!is_usable(cell)) continue;
        const Point node = frame_.point(cell);
        const double length = distance(node, p);
        if (length <= reach && segment_free(p, node)) links.push_back({cell, length});
      }
    }
  }

  /// The nearest cell, of those `ring` steps from a centre, to which the segment from `p` is free.
  template <class SegmentFree>
  std::optional<Cell> nearest_in_ring(const Point& p, Cell centre, int ring,
                                      const SegmentFree& segment_free) const {
    std::optional<Cell> nearest;
    double least = std::numeric_limits<double>::infinity();
    const auto look_at = [&](Cell cell) {
      if (!is_usable(cell)) return;
      const Point node = frame_.point(cell);
      const double length = distance(node, p);
      if (!(length < least) || !segment_free(p, node)) return;
      least = length;
      nearest = cell;
    };
    for (int i = -ring; i <= ring; ++i) {
      look_at(centre + Cell{i, -ring});
      look_at(centre + Cell{i, ring});
      if (i == -ring || i == ring) continue;
      look_at(centre + Cell{-ring, i});
      look_at(centre + Cell{ring, i});
    }
    return nearest;
  }

  OccupancyGrid grid_;
  Frame frame_;
  MovementRule movement_;

  /// A value that is made at its first use, whichever thread that is in.
  template <class T>
  class MadeOnce {
   public:
    template <class Make>
    const T& get(const Make& make) {
      std::call_once(once_, [&] { value_.emplace(make()); });
      return *value_;
    }

   private:
    std::once_flag once_;
    std::optional<T> value_;
  };

  struct Lazy {
    MadeOnce<StopPlanes> stops;
    MadeOnce<TurnPlanes> turns;
    MadeOnce<OccupancyGrid> columns, corners;
  };
  std::shared_ptr<Lazy> lazy_ = std::make_shared<Lazy>();
};

}  // namespace tutavia::detail
