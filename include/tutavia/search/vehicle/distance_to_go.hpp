// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <vector>

#include "tutavia/geometry/segment.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// DistanceToGo: about how far a vehicle has to go, whatever its headings.

namespace tutavia::detail {

/// Estimates of the way from points to a goal among obstacles, on coarse cells.
///
/// A cell is open unless no point of it may be the reference point: unless the clearance at its
/// centre is below that of the largest disc around the reference point within the footprint, by
/// more than half of the cell's diagonal. So where there is a way, there is one over open cells.
/// The estimate is cos(pi / 8) of its octile length less two diagonals. In the open that is no more
/// than the way. Between obstacles that force a way to change cells all the time it may be up
/// to 1.31 times as much.
///
/// The distances are those of A* from the goal towards the start, which goes on where a point asks
/// for more (Silver 2005, "Cooperative pathfinding", section "Windowed hierarchical cooperative
/// A*": reverse resumable A*). So only cells near the way are looked at.
template <ClearanceSpace S>
class DistanceToGo {
 public:
  DistanceToGo(const S& space, const Vehicle& vehicle, const Point& start, const Point& goal,
               double resolution)
      : space_(space), resolution_(resolution) {
    double disc = -std::numeric_limits<double>::infinity();
    for (const FootprintDisc& part : vehicle.footprint) {
      disc = std::fmax(disc, part.radius - part.offset.norm());
    }
    const double slack = resolution / std::numbers::sqrt2 + 2 * space.distance_error_bound();
    threshold_ = space.safety_radius() + disc - (1 + 1e-9) * slack;
    const auto count = [&](double side) {
      return std::max(1, static_cast<int>(std::ceil(side / resolution)));
    };
    columns_ = count(space.bounds().width());
    rows_ = count(space.bounds().height());
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    towards_ = cell_at(start);
    reach(cell_at(goal), 0);
  }

  /// The estimate of the way from `p` to the goal [m], or less, from what is known already;
  /// infinity if there is no way. A cell that is not closed lies at least as far as the estimates
  /// of the cells that are still to be expanded say. \pre `p` lies within the bounds
  double operator()(const Point& p) const {
    const Place place = cell_at(p);
    const CellState& cell = at(place);
    if (cell.is_closed) return in_metres(cell.steps);
    if (open_.empty()) return std::numeric_limits<double>::infinity();
    return in_metres(open_.front().key - octile(place, towards_));
  }

  /// The same, after looking at more cells until the bound is as good as it gets, or at least
  /// `enough`.
  double refined(const Point& p, double enough) {
    const CellState& cell = at(cell_at(p));
    double bound = (*this)(p);
    while (!cell.is_closed && !open_.empty() && bound < enough) {
      expand_next();
      bound = (*this)(p);
    }
    return bound;
  }

 private:
  static constexpr double cosine_of_sixteenth = 0.92387953251128674;  // cos(pi / 8)

  struct Place {
    int x, y;
  };
  struct CellState {
    double steps = std::numeric_limits<double>::infinity();  // octile, in cells
    bool is_closed = false;
    bool is_tested = false;
    bool is_open = false;
  };
  struct Entry {
    double key;
    double steps;
    Place place;

    bool operator<(const Entry& other) const { return key > other.key; }
  };

  static double octile(Place a, Place b) {
    const int dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
    return std::max(dx, dy) + (std::numbers::sqrt2 - 1) * static_cast<double>(std::min(dx, dy));
  }
  double in_metres(double steps) const {
    const double slack = 2 * std::numbers::sqrt2 * resolution_;
    return std::fmax(0, (steps * resolution_ - slack) * cosine_of_sixteenth);
  }

  std::size_t index(Place p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(p.x);
  }
  CellState& at(Place p) { return cells_[index(p)]; }
  const CellState& at(Place p) const { return cells_[index(p)]; }
  Place cell_at(const Point& p) const {
    const Point& low = space_.bounds().min;
    const auto number = [&](double from, double to, int count) {
      return std::clamp(static_cast<int>((to - from) / resolution_), 0, count - 1);
    };
    return {number(low.x(), p.x(), columns_), number(low.y(), p.y(), rows_)};
  }

  bool is_open(Place p) {
    CellState& cell = at(p);
    if (!cell.is_tested) {
      cell.is_tested = true;
      const Point& low = space_.bounds().min;
      const Point centre{low.x() + (p.x + 0.5) * resolution_, low.y() + (p.y + 0.5) * resolution_};
      cell.is_open =
          threshold_ > 0
              ? !(space_.nearest(Segment{centre, centre}, threshold_).distance < threshold_) &&
                    !space_.is_inside(centre)
              : !(space_.clearance(centre) < threshold_);
    }
    return cell.is_open;
  }

  void reach(Place p, double steps) {
    CellState& cell = at(p);
    if (!(steps < cell.steps)) return;
    cell.steps = steps;
    open_.push_back({steps + octile(p, towards_), steps, p});
    std::push_heap(open_.begin(), open_.end());
  }

  void expand_next() {
    std::pop_heap(open_.begin(), open_.end());
    const Entry entry = open_.back();
    open_.pop_back();
    CellState& cell = at(entry.place);
    if (cell.is_closed || entry.steps > cell.steps) return;
    cell.is_closed = true;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Place next{entry.place.x + dx, entry.place.y + dy};
        if (next.x < 0 || next.y < 0 || next.x >= columns_ || next.y >= rows_) continue;
        if (at(next).is_closed || !is_open(next)) continue;
        reach(next, cell.steps + (dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1));
      }
    }
  }

  const S& space_;
  double resolution_;
  double threshold_ = 0;
  int columns_ = 0, rows_ = 0;
  Place towards_{};
  std::vector<CellState> cells_;
  std::vector<Entry> open_;
};

}  // namespace tutavia::detail
