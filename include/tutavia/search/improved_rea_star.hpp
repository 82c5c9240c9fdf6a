// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/core/parts/remove_redundant.hpp"
#include "tutavia/geometry/tangent/funnel.hpp"
#include "tutavia/search/rectangle/bidirectional_rectangles.hpp"

/// \file
/// Improved REA*: rectangle expansion from both ends, with exits evaluated at their midpoints.

namespace tutavia {

/// How ImprovedReaStar computes the cost g of an exit.
enum class ExitCost {
  cumulative,  ///< from the root, through the midpoints of all exits before it
  last_leg,    ///< from the midpoint of the previous exit alone, as in the paper's formula
};

/// Towards what ImprovedReaStar estimates the rest of the way from an exit.
enum class ExitTarget {
  goal,         ///< the root of the other side
  newest_exit,  ///< the midpoint of the exit that the other side expanded last, as in the paper
};

namespace detail {

/// Evaluates exits by the distances between their midpoints: f = g + (1 + w) h. The weight w
/// decreases as the exit's direction aligns with the direction to the target.
class MidpointCost {
 public:
  ExitCost exit_cost = ExitCost::cumulative;
  ExitTarget target = ExitTarget::goal;

  void reset(Cell goal, Cost, const OccupancyGrid& grid) {
    target_ = {static_cast<double>(goal.x), static_cast<double>(goal.y)};
    size_ = {static_cast<double>(grid.width()), static_cast<double>(grid.height())};
  }

  double root(Exit& root, Cost cost) {
    root.g = static_cast<double>(cost) / static_cast<double>(straight_cost);
    return root.g + (target_ - middle(root.cells)).norm();
  }

  /// Tells of the exit that the other side has expanded last.
  void aim_at(const CellInterval& newest) {
    if (target == ExitTarget::newest_exit) target_ = middle(newest);
  }

  double enter(Exit& exit, const Exit& parent) {
    const Point at = middle(exit.cells);
    const double leg = (at - middle(parent.cells)).norm();
    exit.g = parent.g + leg;
    const double g = exit_cost == ExitCost::cumulative ? exit.g : leg;
    return g + (1 + weight(exit.cells, at)) * (target_ - at).norm();
  }

  /// Nodes are placed only when the path is known.
  int source_of(const Exit& exit, Cell) const { return exit.cells.first; }

  std::pair<double, Cell> meet(const Exit& from, const MidpointCost&, const Exit& to,
                               const CellInterval& meeting) const {
    const Point at = middle(meeting);
    const double length =
        from.g + (at - middle(from.cells)).norm() + (at - middle(to.cells)).norm() + to.g;
    return {length, meeting.middle()};
  }

 private:
  static Point middle(const CellInterval& cells) {
    const double along = (static_cast<double>(cells.first) + cells.last) / 2;
    return cells.axis == 0 ? Point{along, double(cells.line)} : Point{double(cells.line), along};
  }

  double weight(const CellInterval& cells, const Point& at) const {
    const auto sign = [](double v) { return (v > 0) - (v < 0); };
    const std::array<int, 2> ahead{sign(target_.x() - at.x()), sign(target_.y() - at.y())};
    const auto along = static_cast<std::size_t>(cells.axis);
    const int agreement = ahead[1 - along] * cells.side;
    const int differs = std::abs(ahead[0]) + std::abs(ahead[1]) - agreement;
    return differs / size_[static_cast<Eigen::Index>(along)];
  }

  Point target_ = Point::Zero(), size_ = Point::Zero();
};

/// The paper's numbering of directions: north (towards lower rows) 1, south 2, west 3, east 4.
inline int direction_number(const CellInterval& cells) {
  if (cells.axis == 0) return cells.side < 0 ? 1 : 2;
  return cells.side < 0 ? 3 : 4;
}

/// Places the nodes by the paper's markers, which are the changes of direction number from portal
/// to portal. If a change is reversed by the next one, or if the two searches met at the portal,
/// the node lies at the portal's end nearer to the previous node. Otherwise it lies where the
/// straight line from the previous to the next node crosses the portal, or as near to that as
/// possible. Two passes, because the next node is known only after the first.
inline void place_by_markers(std::vector<CellPortal>& portals, std::size_t meeting) {
  const std::size_t last = portals.size() - 1;
  const auto change = [&](std::size_t i) {
    if (i + 1 >= last) return 0;
    return direction_number(portals[i + 1].cells) - direction_number(portals[i].cells);
  };
  for (CellPortal& portal : portals) portal.u = (portal.cells.first + portal.cells.last) / 2;
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 1; i < last; ++i) {
      const CellInterval& cells = portals[i].cells;
      const Cell before = portals[i - 1].node(), after = portals[i + 1].node();
      if (i == meeting || (change(i) != 0 && change(i + 1) == -change(i))) {
        const bool is_first = cell_distance(before, cells.cell(cells.first)) <=
                              cell_distance(before, cells.cell(cells.last));
        portals[i].u = is_first ? cells.first : cells.last;
      } else {
        portals[i].u = nearest_column(cells, crossing(cells, before, after, portals[i].u));
      }
    }
  }
}

/// Appends the vertices of the shortest path through the portals between the nodes `first` and
/// `last`, which stay fixed, in order from `last` to `first`. Portal ends are ordered left and
/// right as seen by a robot that follows the path.
inline void append_pulled(const std::vector<CellPortal>& portals, std::size_t first,
                          std::size_t last, std::vector<Cell>& cells) {
  const auto point = [](Cell c) { return Point{double(c.x), double(c.y)}; };
  std::vector<std::pair<Point, Point>> portal_ends;
  for (std::size_t i = first + 1; i < last; ++i) {
    const CellInterval& portal = portals[i].cells;
    Point right = point(portal.cell(portal.last)), left = point(portal.cell(portal.first));
    if ((portal.axis == 0) != (portal.side > 0)) std::swap(right, left);
    portal_ends.emplace_back(right, left);
  }
  const auto path =
      funnel_path(portal_ends, point(portals[first].node()), point(portals[last].node()));
  for (auto p = path.rbegin(); p != path.rend(); ++p) {
    append_cell(cells, {static_cast<int>(p->x()), static_cast<int>(p->y())});
  }
}

inline double path_length(const std::vector<Cell>& cells) {
  double length = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) length += cell_distance(cells[i - 1], cells[i]);
  return length;
}

/// The vertices of the shortest path through the portals and one whole cell of the meeting
/// portal, from last to first. The path may leave the meeting portal on the side it came from, so
/// each half is pulled taut on its own. The total length is convex along the meeting portal, so
/// bisection finds the best cell.
inline std::vector<Cell> pulled_path(std::vector<CellPortal>& portals, std::size_t meeting) {
  const auto path_by = [&](int u) {
    portals[meeting].u = u;
    std::vector<Cell> cells;
    append_pulled(portals, meeting, portals.size() - 1, cells);
    append_pulled(portals, 0, meeting, cells);
    return cells;
  };
  int first = portals[meeting].cells.first, last = portals[meeting].cells.last;
  while (first < last) {
    const int middle = first + (last - first) / 2;
    if (path_length(path_by(middle)) <= path_length(path_by(middle + 1))) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  return path_by(first);
}

}  // namespace detail

/// Grows free rectangles from the start and from the goal in turn until they meet. Exits of
/// rectangles are evaluated at their midpoints, f = g + (1 + w) h, where the weight w penalises
/// directions away from the goal. The path is then placed through the exits.
///
/// Complete on the grid, not optimal; the test suite reports by how much its paths exceed the
/// optimum. `Statistics::expanded` counts rectangles; `Route::cost` is the length. Errors:
/// `invalid_option` for any movement rule but `no_cut`; others as for AStar.
///
/// Source: "Improved REA*", algorithms 2 to 4; docs/algorithms.md says how ambiguous and failing
/// steps are resolved.
///
/// Example: examples/searches_on_cells.cpp.
struct ImprovedReaStar {
  static constexpr std::string_view name = "improved_rea_star";
  using Scratch = detail::BidirectionalRectanglesScratch<detail::MidpointCost>;

  ExitCost exit_cost = ExitCost::cumulative;
  ExitTarget target = ExitTarget::goal;
  /// Whether to continue after the two searches have met, until no key is smaller than the length
  /// of the best known path through midpoints.
  bool continue_after_contact = false;
  /// Whether to return the shortest path through the exits and one whole cell of the meeting exit,
  /// without nodes whose neighbours see each other. Otherwise nodes are placed by the paper's
  /// markers, and the path is never shorter.
  bool funnel = true;

  template <detail::ColumnLineOfSightSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    for (auto& expansion : scratch.expansions) {
      expansion.evaluation.exit_cost = exit_cost;
      expansion.evaluation.target = target;
    }
    return detail::bidirectional_rectangles(
        space, query, scratch, observer, name, continue_after_contact,
        [&](std::vector<detail::CellPortal>& portals, std::size_t meeting,
            std::vector<Cell>& cells) {
          detail::place_by_markers(portals, meeting);
          detail::append_corners(portals, cells);
          if (!funnel) return;
          std::vector<Cell> pulled = detail::pulled_path(portals, meeting);
          detail::remove_redundant(pulled,
                                   [&](Cell a, Cell b) { return space.line_of_sight(a, b); });
          if (detail::path_length(pulled) < detail::path_length(cells)) cells = std::move(pulled);
        });
  }
};

}  // namespace tutavia
