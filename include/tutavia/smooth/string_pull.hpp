// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/geometry/tangent/funnel.hpp"
#include "tutavia/grid/bitboard/free_runs.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// StringPull: pulls a path on cells taut.

namespace tutavia {

namespace detail {

/// The side that two free runs of neighbouring rows share, with its ends as seen when crossing it.
struct Portal {
  Cell right, left;
  friend bool operator==(const Portal&, const Portal&) = default;
};

/// Follows a polyline through the free runs of rows and records the portals that it crosses. A
/// portal crossed back at once is removed, so the remaining sequence identifies the homotopy class.
class PortalTrace {
 public:
  explicit PortalTrace(const CellSpace& space) : space_(space), runs_(space.cells()) {}

  /// Follows a straight segment; false if it is not free. \pre both points lie within the bounds
  bool go(const Point& p, const Point& q) {
    if (p == q) return true;
    if (p.y() == q.y()) return go_level(p, q);
    const bool up = p.y() < q.y();
    const int from = row_of(p), to = row_of(q);
    // The first and last rows that it passes. A point on a grid line belongs to the rows on both
    // sides.
    int row = !up && is_on_level(p, from) ? from - 1 : from;
    const int last = up && is_on_level(q, to) ? to - 1 : to;
    if (!enter(row, first_column(p, q, row))) return false;
    while (row != last) {
      const int level = up ? row + 1 : row;
      row += up ? 1 : -1;
      // The segment must leave a row by the run by which it entered.
      if (!holds(column_at(q, p, level)) || !enter(row, column_at(p, q, level))) return false;
    }
    return holds(first_column(q, p, last));
  }

  const std::vector<Portal>& portals() const { return portals_; }

 private:
  const OccupancyGrid& grid() const { return space_.cells(); }
  double x_of(int column) const { return space_.corner({column, 0}).x(); }
  double y_of(int row) const { return space_.corner({0, row}).y(); }
  bool is_on_level(const Point& p, int row) const { return p.y() == y_of(row); }
  bool is_free(Cell cell) const { return grid().contains(cell) && grid().is_free(cell); }

  /// The last row or column that starts at or before a coordinate.
  int row_of(const Point& p) const {
    int row = static_cast<int>(std::floor((p.y() - y_of(0)) / space_.frame().resolution));
    while (y_of(row) > p.y()) --row;
    while (y_of(row + 1) <= p.y()) ++row;
    return row;
  }
  int column_of(const Point& p) const {
    int column = static_cast<int>(std::floor((p.x() - x_of(0)) / space_.frame().resolution));
    while (x_of(column) > p.x()) --column;
    while (x_of(column + 1) <= p.x()) ++column;
    return column;
  }

  /// The column that a rising or falling segment enters when it crosses a grid line.
  int column_at(const Point& p, const Point& q, int level) const {
    const double t = (y_of(level) - p.y()) / (q.y() - p.y());
    const Point on(p.x() + t * (q.x() - p.x()), y_of(level));
    int column = column_of(on);
    // Decided by the corner: a rising segment passes to the right of it, a falling one to the left.
    const int up = p.y() < q.y() ? 1 : -1;
    const auto side = [&](int x) { return up * orientation(p, q, space_.corner({x, level})); };
    while (side(column) < 0) --column;
    while (side(column + 1) >= 0) ++column;
    return beside(column, up > 0 ? level : level - 1, side(column) == 0, p, q);
  }
  /// The column in which a segment starts within a row.
  int first_column(const Point& p, const Point& q, int row) const {
    const int column = column_of(p);
    return beside(column, row, x_of(column) == p.x(), p, q);
  }
  /// On a line between two columns, the column in which the segment continues; if it runs along the
  /// line, the free column.
  int beside(int column, int row, bool on_line, const Point& p, const Point& q) const {
    if (!on_line || q.x() > p.x()) return column;
    if (q.x() < p.x()) return column - 1;
    return is_free({column, row}) ? column : column - 1;
  }

  /// Follows a horizontal segment along a row, or between two rows.
  bool go_level(const Point& p, const Point& q) {
    const bool right = p.x() < q.x();
    const int row = row_of(p);
    const int column = first_column(p, q, row);
    const int last = first_column(q, p, row);
    if (!is_on_level(p, row)) return enter(row, column) && holds(last);
    if (!has_run_ || (run_.y0 != row && run_.y0 != row - 1) || !holds(column)) {
      if (!enter(is_free({column, row}) ? row : row - 1, column)) return false;
    }
    while (!holds(last)) {
      // At the end of its run it continues in an overlapping run of the other row.
      const int end = right ? run_.x1 - 1 : run_.x0, other = run_.y0 == row ? row - 1 : row;
      if (!is_free({end + (right ? 1 : -1), other}) || !enter(other, end)) return false;
    }
    return true;
  }

  bool holds(int column) const { return run_.x0 <= column && column < run_.x1; }

  /// Enters the run that contains a cell; false if it does not adjoin the current run.
  bool enter(int row, int column) {
    const Cell cell{column, row};
    if (!is_free(cell)) return false;
    if (has_run_ && run_.y0 == row && holds(column)) return true;
    const CellBox next = runs_.open(static_cast<FreeRuns::Piece>(grid().index(cell)));
    if (has_run_) {
      const int x0 = std::max(run_.x0, next.x0), x1 = std::min(run_.x1, next.x1);
      const bool up = next.y0 == run_.y0 + 1;
      if (x0 >= x1 || (!up && next.y0 != run_.y0 - 1)) return false;
      const int level = up ? next.y0 : run_.y0;
      const Portal portal =
          up ? Portal{{x1, level}, {x0, level}} : Portal{{x0, level}, {x1, level}};
      if (!portals_.empty() && portals_.back() == Portal{portal.left, portal.right}) {
        portals_.pop_back();
      } else {
        portals_.push_back(portal);
      }
    }
    run_ = next;
    has_run_ = true;
    return true;
  }

  const CellSpace& space_;
  FreeRuns runs_;
  CellBox run_{};
  bool has_run_ = false;
  std::vector<Portal> portals_;
};

}  // namespace detail

/// The shortest path on cells in the homotopy class of the input: the input can be deformed into it
/// without crossing a blocked cell. It bends at corners of cells.
///
/// A path may slide along blocked cells and touch their corners, but does not pass between two that
/// share a side or only a corner. The input may be any path of straight pieces on a CellSpace of
/// safety radius 0, such as the paths of grid searches between centres or corners. The result is
/// never longer than the input and exact up to the rounding of lengths. O(rows crossed). Errors:
/// `invalid_option` for a safety radius other than 0; `invalid_input` for curved pieces and for a
/// path that is not free by these rules; those of the budget.
///
/// Example: examples/smoothers.cpp.
struct StringPull {
  static constexpr std::string_view name = "string_pull";

  Expected<Curve, Failure> smooth(const CellSpace& space, const Curve& curve,
                                  const Budget& budget) const {
    if (space.safety_radius() != 0) {
      return fail(PlanError::invalid_option, "string_pull is defined for safety radius 0");
    }
    if (curve.empty()) return curve;
    const auto invalid = [](std::size_t piece, const char* what) {
      return fail(PlanError::invalid_input, "piece " + std::to_string(piece) + what);
    };
    if (!space.is_free(curve.start())) return invalid(0, " starts in a blocked cell");
    detail::PortalTrace trace(space);
    for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while pulling a string");
      const Segment* segment = curve.pieces()[i].get_if<Segment>();
      if (segment == nullptr) return invalid(i, " is not straight");
      const bool within =
          space.bounds().contains(segment->a) && space.bounds().contains(segment->b);
      if (!within || !trace.go(segment->a, segment->b)) return invalid(i, " is not free");
    }
    std::vector<std::pair<Point, Point>> portals;
    portals.reserve(trace.portals().size());
    for (const detail::Portal& portal : trace.portals()) {
      portals.emplace_back(space.corner(portal.right), space.corner(portal.left));
    }
    Curve result;
    Point from = curve.start();
    const std::vector<Point> path = detail::funnel_path(portals, from, curve.end());
    for (std::size_t i = 1; i < path.size(); ++i) {
      const bool last = i + 1 == path.size();
      if (!last && (path[i] == from || orientation(from, path[i], path[i + 1]) == 0)) continue;
      if (last && path[i] == from && !result.empty()) continue;
      result.push_back(Segment{from, path[i]});
      from = path[i];
    }
    return result;
  }
};

}  // namespace tutavia
