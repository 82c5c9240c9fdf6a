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
/// StringPull: a path on cells pulled taut.

namespace tutavia {

namespace detail {

/// The side that two free runs of neighbouring rows share, with its ends as seen by who crosses it.
struct Portal {
  Cell right, left;
  friend bool operator==(const Portal&, const Portal&) = default;
};

/// Follows a polyline through the free runs of rows and notes the portals it crosses, those left
/// out that it comes back through at once: what then remains is its homotopy class.
class PortalTrace {
 public:
  explicit PortalTrace(const CellSpace& space) : space_(space), runs_(space.cells()) {}

  /// Goes straight on; false where that is not free. \pre both points lie within the bounds
  bool go(const Point& p, const Point& q) {
    if (p == q) return true;
    if (p.y() == q.y()) return go_level(p, q);
    const bool up = p.y() < q.y();
    const int from = row_of(p), to = row_of(q);
    // Rows that it passes, each entered at a level, the first where it is (a point on a level lies
    // above and below it).
    int row = !up && is_on_level(p, from) ? from - 1 : from;
    const int last = up && is_on_level(q, to) ? to - 1 : to;
    if (!enter(row, first_column(p, q, row))) return false;
    while (row != last) {
      const int level = up ? row + 1 : row;
      row += up ? 1 : -1;
      // It leaves a row by the run that it entered it by.
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

  /// The last row or column that begins at or before a coordinate.
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

  /// The column that a rising or falling segment enters as it crosses a level.
  int column_at(const Point& p, const Point& q, int level) const {
    const double t = (y_of(level) - p.y()) / (q.y() - p.y());
    const Point on(p.x() + t * (q.x() - p.x()), y_of(level));
    int column = column_of(on);
    // Its corner decides: left of the way up, or right of the way down, the segment passes it.
    const int up = p.y() < q.y() ? 1 : -1;
    const auto side = [&](int x) { return up * orientation(p, q, space_.corner({x, level})); };
    while (side(column) < 0) --column;
    while (side(column + 1) >= 0) ++column;
    return beside(column, up > 0 ? level : level - 1, side(column) == 0, p, q);
  }
  /// The column of a row where a segment begins.
  int first_column(const Point& p, const Point& q, int row) const {
    const int column = column_of(p);
    return beside(column, row, x_of(column) == p.x(), p, q);
  }
  /// On a line between two columns, the one that a segment goes on in; straight along the line, the
  /// free one.
  int beside(int column, int row, bool on_line, const Point& p, const Point& q) const {
    if (!on_line || q.x() > p.x()) return column;
    if (q.x() < p.x()) return column - 1;
    return is_free({column, row}) ? column : column - 1;
  }

  /// Along a row, or between two.
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
      // Where its run ends it goes on beside, in a run of the other row that began before.
      const int end = right ? run_.x1 - 1 : run_.x0, other = run_.y0 == row ? row - 1 : row;
      if (!is_free({end + (right ? 1 : -1), other}) || !enter(other, end)) return false;
    }
    return true;
  }

  bool holds(int column) const { return run_.x0 <= column && column < run_.x1; }

  /// Goes on in the run that holds a cell; false where it has no side in common with this one.
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

/// The shortest of all paths on cells that can be pulled into this one without crossing a blocked
/// cell (its homotopy class); it bends at corners of cells.
///
/// A path may slide along blocked cells and touch their corners, but does not pass between two that
/// share a side or only a corner. For any path of straight pieces on a CellSpace of safety radius
/// 0: what searches on grids find, between centres or corners. Never longer than its input; exact
/// but for the rounding of lengths; O(rows crossed). `invalid_option` for a safety radius,
/// `invalid_input` for curved pieces and for a path that is not free by these rules; what the
/// budget says.
struct StringPull {
  static constexpr std::string_view name = "string_pull";

  Expected<Curve, Failure> smooth(const CellSpace& space, const Curve& curve,
                                  const Budget& budget) const {
    if (space.safety_radius() != 0) {
      return fail(PlanError::invalid_option, "string_pull is defined for safety radius 0");
    }
    if (curve.empty()) return curve;
    const auto broken = [](std::size_t piece, const char* what) {
      return fail(PlanError::invalid_input, "piece " + std::to_string(piece) + what);
    };
    if (!space.is_free(curve.start())) return broken(0, " starts in a blocked cell");
    detail::PortalTrace trace(space);
    for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while pulling a string");
      const Segment* segment = curve.pieces()[i].get_if<Segment>();
      if (segment == nullptr) return broken(i, " is not straight");
      const bool within =
          space.bounds().contains(segment->a) && space.bounds().contains(segment->b);
      if (!within || !trace.go(segment->a, segment->b)) return broken(i, " is not free");
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
