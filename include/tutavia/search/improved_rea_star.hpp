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
/// Improved REA*: rectangle expansion from both ends, evaluated at the middles of exits.

namespace tutavia {

/// From where ImprovedReaStar counts what a exit has cost.
enum class ExitCost {
  cumulative,  ///< from the root, by the middles of all exits on the way
  last_leg,    ///< from the middle of the exit before, as the paper's formula has it
};

namespace detail {

/// Exits by the distances between their middles: f = g + (1 + w) h, where w is the less the
/// better a exit's direction agrees with that to the goal.
class MidpointCost {
 public:
  ExitCost exit_cost = ExitCost::cumulative;

  void reset(Cell goal, Cost, const OccupancyGrid& grid) {
    goal_ = {static_cast<double>(goal.x), static_cast<double>(goal.y)};
    size_ = {static_cast<double>(grid.width()), static_cast<double>(grid.height())};
  }

  double root(Exit& root, Cost cost) {
    root.g = static_cast<double>(cost) / static_cast<double>(straight_cost);
    return root.g + (goal_ - middle(root.cells)).norm();
  }

  double enter(Exit& exit, const Exit& parent) {
    const Point at = middle(exit.cells);
    const double leg = (at - middle(parent.cells)).norm();
    exit.g = parent.g + leg;
    const double g = exit_cost == ExitCost::cumulative ? exit.g : leg;
    return g + (1 + weight(exit.cells, at)) * (goal_ - at).norm();
  }

  /// Nodes have their places when the path is known.
  int place_before(const Exit& exit, Cell) const { return exit.cells.first; }

  std::pair<double, Cell> meet(const Exit& from, const MidpointCost&, const Exit& to,
                               const CellInterval& joint) const {
    const Point at = middle(joint);
    const double length =
        from.g + (at - middle(from.cells)).norm() + (at - middle(to.cells)).norm() + to.g;
    return {length, joint.middle()};
  }

 private:
  static Point middle(const CellInterval& cells) {
    const double along = (static_cast<double>(cells.first) + cells.last) / 2;
    return cells.axis == 0 ? Point{along, double(cells.line)} : Point{double(cells.line), along};
  }

  double weight(const CellInterval& cells, const Point& at) const {
    const auto sign = [](double v) { return (v > 0) - (v < 0); };
    const std::array<int, 2> to_goal{sign(goal_.x() - at.x()), sign(goal_.y() - at.y())};
    const auto along = static_cast<std::size_t>(cells.axis);
    const int agreement = to_goal[1 - along] * cells.side;
    const int differs = std::abs(to_goal[0]) + std::abs(to_goal[1]) - agreement;
    return differs / size_[static_cast<Eigen::Index>(along)];
  }

  Point goal_ = Point::Zero(), size_ = Point::Zero();
};

/// The paper's numbers of directions: north (towards lower rows) 1, south 2, west 3, east 4.
inline int direction_number(const CellInterval& cells) {
  if (cells.axis == 0) return cells.side < 0 ? 1 : 2;
  return cells.side < 0 ? 3 : 4;
}

/// Places the nodes by the paper's markers, of the changes of direction d from rail to rail: where
/// one is taken back by the next (and where the waves met) at the end of the rail that is nearer to
/// the node before; elsewhere where the straight line from the node before to the one after crosses
/// the rail, or as near as it can be. Twice, because the node after is known only then.
inline void place_by_markers(std::vector<Rail>& rails, std::size_t joint) {
  const std::size_t last = rails.size() - 1;
  const auto change = [&](std::size_t i) {
    if (i + 1 >= last) return 0;
    return direction_number(rails[i + 1].cells) - direction_number(rails[i].cells);
  };
  for (Rail& rail : rails) rail.place = (rail.cells.first + rail.cells.last) / 2;
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 1; i < last; ++i) {
      const CellInterval& cells = rails[i].cells;
      const Cell before = rails[i - 1].node(), after = rails[i + 1].node();
      if (i == joint || (change(i) != 0 && change(i + 1) == -change(i))) {
        const bool is_first = cell_distance(before, cells.cell(cells.first)) <=
                              cell_distance(before, cells.cell(cells.last));
        rails[i].place = is_first ? cells.first : cells.last;
      } else {
        rails[i].place = nearest_place(cells, crossing(cells, before, after, rails[i].place));
      }
    }
  }
}

/// Appends the corners of the shortest path through rails, from the last node to the first, which
/// stay; each end of a rail on the hand where who follows the path has it.
inline void append_pulled(const std::vector<Rail>& rails, std::size_t first, std::size_t last,
                          std::vector<Cell>& cells) {
  const auto point = [](Cell c) { return Point{double(c.x), double(c.y)}; };
  std::vector<std::pair<Point, Point>> portals;
  for (std::size_t i = first + 1; i < last; ++i) {
    const CellInterval& rail = rails[i].cells;
    Point right = point(rail.cell(rail.last)), left = point(rail.cell(rail.first));
    if ((rail.axis == 0) != (rail.side > 0)) std::swap(right, left);
    portals.emplace_back(right, left);
  }
  const auto path = funnel_path(portals, point(rails[first].node()), point(rails[last].node()));
  for (auto p = path.rbegin(); p != path.rend(); ++p) {
    append_cell(cells, {static_cast<int>(p->x()), static_cast<int>(p->y())});
  }
}

inline double path_length(const std::vector<Cell>& cells) {
  double length = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) length += cell_distance(cells[i - 1], cells[i]);
  return length;
}

/// The corners of the shortest path through rails and a whole cell of the joint, from last to
/// first. The path may come back from the joint to the side that it came from, so it is pulled in
/// two halves; their lengths are convex along the joint, and the best cell is found by bisection.
inline std::vector<Cell> pulled_path(std::vector<Rail>& rails, std::size_t joint) {
  const auto path_by = [&](int place) {
    rails[joint].place = place;
    std::vector<Cell> cells;
    append_pulled(rails, joint, rails.size() - 1, cells);
    append_pulled(rails, 0, joint, cells);
    return cells;
  };
  int first = rails[joint].cells.first, last = rails[joint].cells.last;
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

/// Free rectangles that grow from the start and from the goal by turns until they meet; exits
/// out of them are evaluated at their middles, f = g + (1 + w) h, with a weight w against
/// directions away from the goal. Then the path is laid through the exits.
///
/// Complete on the grid, not optimal; the test suite reports how much longer its paths are. Needs
/// the movement rule `no_cut`, else `invalid_option`; other errors as for AStar.
/// `Statistics::expanded` counts rectangles; `Route::cost` is the length.
///
/// Source: "Improved REA*", algorithms 2 to 4; what is ambiguous or does not work there, see
/// docs/algorithms.md.
struct ImprovedReaStar {
  static constexpr std::string_view name = "improved_rea_star";
  using Scratch = detail::BidirectionalRectanglesScratch<detail::MidpointCost>;

  ExitCost exit_cost = ExitCost::cumulative;
  /// Whether to go on after the waves have met, until no key is below the length of a path through
  /// the middles that is known.
  bool continue_after_contact = false;
  /// Whether the path is the shortest through the exits and a whole cell of where the waves met,
  /// nodes left out whose neighbours see each other; else its nodes are placed by the paper's
  /// markers, and it is never shorter.
  bool funnel = true;

  template <detail::ColumnLineOfSightSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    for (auto& wave : scratch.waves) wave.evaluation.exit_cost = exit_cost;
    return detail::bidirectional_rectangles(
        space, query, scratch, observer, name, continue_after_contact,
        [&](std::vector<detail::Rail>& rails, std::size_t joint, std::vector<Cell>& cells) {
          detail::place_by_markers(rails, joint);
          detail::append_corners(rails, cells);
          if (!funnel) return;
          std::vector<Cell> pulled = detail::pulled_path(rails, joint);
          detail::remove_redundant(pulled,
                                   [&](Cell a, Cell b) { return space.line_of_sight(a, b); });
          if (detail::path_length(pulled) < detail::path_length(cells)) cells = std::move(pulled);
        });
  }
};

}  // namespace tutavia
