// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/route/input_checks.hpp"
#include "tutavia/smooth/spline/corner_spline.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// TwoStageBSpline: moves a grid path's nodes off corners and obstacles, then fits a B-spline.

namespace tutavia {

/// Takes all nodes of a grid path as control points, moves them, and runs a cubic B-spline along
/// them.
///
/// Stage 1, corner avoidance: a diagonal step beside a blocked cell is replaced by two steps
/// through the free cell on its other side. Stage 2, obstacle avoidance: a node with blocked cells
/// nearer than d0 moves away from them by the mean of f(d) = 1 / (a + b e^(c d)) over their
/// distances d. Distances are between a node and centres of cells, in cells. A move that would
/// leave free space is halved up to five times, then dropped. If the spline cannot be proved, legs
/// get additional control points until it can (see CornerSpline).
///
/// Guarantees: the ends are exact and every piece is proved at the space's safety radius. The
/// result may be longer than its input: each pass moves each node by at most 1 / (a + b) cells and
/// so lengthens each leg by at most twice that.
///
/// Source: Zhou, Shang, Wang, Zuo 2025, Appl. Sci. 15(10) 5583 (SSA), equations (10) to (20),
/// algorithms 2 and 3; it gives no values for a, b, c and d0. See docs/algorithms.md.
///
/// Example: examples/smoothers.cpp.
struct TwoStageBSpline {
  static constexpr std::string_view name = "two_stage_b_spline";

  double a = 0.5;
  double b = 0.5;
  double c = 1;    ///< per cell
  double d0 = 2;   ///< range of influence of blocked cells [cells]; at most 100
  int passes = 1;  ///< of stage 2

  /// Errors: `invalid_option` for an option that is negative, not finite or too large;
  /// `invalid_input` for a curve that is not free or not of segments and arcs; those of the budget.
  template <ClearanceGridSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    if (auto valid = check(); !valid) return std::move(valid).unexpected();
    auto nodes = detail::free_nodes(space, input, budget, "the two-stage B-spline");
    if (!nodes) return Unexpected{nodes.error()};
    if (nodes->empty()) return input;
    avoid_corners(space, *nodes);
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t i = 1; i + 1 < nodes->size(); ++i) {
        if (i % 64 == 1) {
          if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
        }
        move_away(space, *nodes, i);
      }
    }
    return detail::CornerSpline(std::move(*nodes), detail::CornerSpline::no_auxiliary_points)
        .prove(space, budget);
  }

 private:
  Expected<void, Failure> check() const {
    const auto is_valid = [](double x) { return x >= 0 && std::isfinite(x); };
    if (!is_valid(a)) return fail(PlanError::invalid_option, "a must be finite and not negative");
    if (!is_valid(b)) return fail(PlanError::invalid_option, "b must be finite and not negative");
    if (!(a + b > 0)) return fail(PlanError::invalid_option, "a and b must not both be 0");
    if (!is_valid(c)) return fail(PlanError::invalid_option, "c must be finite and not negative");
    if (!(0 <= d0 && d0 <= 100)) return fail(PlanError::invalid_option, "d0 must lie in [0, 100]");
    if (passes < 0 || passes > 100)
      return fail(PlanError::invalid_option, "passes must lie in [0, 100]");
    return {};
  }

  template <GridSpace S>
  static bool is_blocked(const S& space, Cell cell) {
    return space.grid().contains(cell) && !space.grid().is_free(cell);
  }

  /// The detour through a free cell instead of the step from p to q, if the step is diagonal and
  /// passes exactly one blocked cell.
  template <GridSpace S>
  static std::optional<Point> detour(const S& space, const Point& p, const Point& q) {
    const Frame& frame = space.frame();
    const Cell from = frame.nearest_cell(p), to = frame.nearest_cell(q);
    if (std::abs(from.x - to.x) != 1 || std::abs(from.y - to.y) != 1) return std::nullopt;
    const Cell first{from.x, to.y}, second{to.x, from.y};
    const bool blocked = is_blocked(space, first);
    if (blocked == is_blocked(space, second))
      return std::nullopt;  // a gap between two blocked cells stays
    const Point through = frame.point(blocked ? second : first);
    const bool free = space.segment_free(p, through) && space.segment_free(through, q);
    return free ? std::optional(through) : std::nullopt;
  }

  /// Stage 1. Nodes at the ends of such a step are removed if their neighbours then see each other.
  template <GridSpace S>
  static void avoid_corners(const S& space, std::vector<Point>& nodes) {
    std::vector<Point> result{nodes.front()};
    std::vector<bool> marked{false};
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const auto through = detour(space, nodes[i - 1], nodes[i]);
      if (through) {
        marked.back() = true;
        result.push_back(*through);
        marked.push_back(false);
      }
      result.push_back(nodes[i]);
      marked.push_back(through.has_value());
    }
    std::size_t kept = 1;
    for (std::size_t i = 1; i < result.size(); ++i) {
      const bool is_end = i + 1 == result.size();
      if (marked[i] && !is_end && space.segment_free(result[kept - 1], result[i + 1])) continue;
      result[kept++] = result[i];
    }
    result.resize(kept);
    nodes = std::move(result);
  }

  /// Stage 2 for one node.
  template <GridSpace S>
  void move_away(const S& space, std::vector<Point>& nodes, std::size_t i) const {
    const Point shift = push(space, nodes[i]);
    for (double part = 1; part > 1.0 / 64; part /= 2) {
      const Point moved = detail::offset_along(nodes[i], part, shift);
      if (moved == nodes[i]) return;
      if (space.segment_free(nodes[i - 1], moved) && space.segment_free(moved, nodes[i + 1])) {
        nodes[i] = moved;
        return;
      }
    }
  }

  /// The mean push of the blocked cells around a point [m].
  template <GridSpace S>
  Point push(const S& space, const Point& p) const {
    const Frame& frame = space.frame();
    const Cell centre = frame.nearest_cell(p);
    const int reach = static_cast<int>(std::ceil(d0));
    Point sum = Point::Zero();
    int count = 0;
    for (int y = centre.y - reach; y <= centre.y + reach; ++y) {
      for (int x = centre.x - reach; x <= centre.x + reach; ++x) {
        if (!is_blocked(space, {x, y})) continue;
        const Point away = p - frame.point({x, y});
        const double distance = away.norm() / frame.resolution;
        if (!(distance < d0) || distance == 0) continue;
        sum = detail::offset_along(sum, 1 / (a + b * std::exp(c * distance)) / distance, away);
        ++count;
      }
    }
    return count == 0 ? sum : Point(sum / count);
  }
};

}  // namespace tutavia
