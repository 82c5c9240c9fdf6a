// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <string_view>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/route/critical_corners.hpp"
#include "tutavia/smooth/route/farthest_in_sight.hpp"
#include "tutavia/smooth/route/input_checks.hpp"
#include "tutavia/smooth/shortcut.hpp"

/// \file
/// DeltaSmoother: the smoothing of grid paths in the delta-smoothed path (DSP) paper.

namespace tutavia {

/// Smooths a polyline by arcs at critical corners and greedy shortcuts in between.
///
/// A corner is critical if the path passes its safety zone within `corner_threshold`. The path node
/// nearest to it is its trigger. Shortcuts stop before triggers. At a trigger, the two steps around
/// it become one quadratic Bezier arc, whose control point is pushed away from the corner until the
/// arc is proved safe; if none is, the steps stay. Shortcuts are prudent: they stop one node before
/// the last node in sight, which is usually next to a corner.
///
/// Guarantees: the ends are exact; every line and arc is proved at the space's safety radius; the
/// result is never longer than its input (otherwise the input's shortcuts are returned). Arcs are
/// smooth inside. Where they meet lines there may be corners, as in the paper. With `Join::tangent`
/// only corners that cannot be rounded in free space remain (see BezierSmoother). O(n log n) lines
/// of sight for n nodes.
///
/// Source: Abdulshaheed 2025, "A Delta-Smoothed Path Algorithm". The fields give the paper's names;
/// docs/algorithms.md decides the details that it leaves open.
///
/// Example: examples/smoothers.cpp.
struct DeltaSmoother {
  static constexpr std::string_view name = "delta";

  /// How lines and arcs meet.
  enum class Join {
    paper,    ///< the direction may jump
    tangent,  ///< corners between them are rounded by cubic pieces
  };

  double corner_threshold = 0.3;     ///< cornerThresh [m]
  double arc_initial_offset = 0.12;  ///< arcInitOffset [m]: the first offset tried after 0
  double arc_max_offset = 0.6;       ///< arcMaxOffset [m]
  double arc_growth_step = 0.12;     ///< arcGrowStep [m]
  /// Corners that turn by less are treated as facets of a round obstacle [rad].
  double min_exterior_angle = 20 * std::numbers::pi / 180;
  Join join = Join::paper;

  /// Errors: `invalid_option` for an option that is negative or NaN (the growth step must be
  /// positive); `invalid_input` for a curve that is not a polyline or not free; those of the
  /// budget.
  template <CornerSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    if (auto valid = check(); !valid) return std::move(valid).unexpected();
    const auto nodes = detail::free_nodes(space, input, budget, "the delta smoother");
    if (!nodes) return Unexpected{nodes.error()};
    auto result = lines_and_arcs(space, *nodes, budget);
    if (result && result->length() > input.length()) {
      result = Shortcut{}.smooth(space, input, budget);
    }
    if (!result || join == Join::paper) return result;
    return BezierSmoother{}.smooth(space, *result, budget);
  }

 private:
  /// A path node at which an arc is tried, and its critical corner.
  struct Trigger {
    std::size_t node;
    Point corner;
    std::uint32_t corner_id;
    double distance;  // between the node and the corner's zone or disc
  };

  template <CornerSpace S>
  Expected<Curve, Failure> lines_and_arcs(const S& space, const std::vector<Point>& nodes,
                                          const Budget& budget) const {
    const std::vector<Trigger> triggers = find_triggers(space, nodes);
    Curve result;
    auto next = triggers.begin();
    for (std::size_t i = 0; i + 1 < nodes.size();) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
      while (next != triggers.end() && next->node <= i) ++next;
      const bool has_next = next != triggers.end();
      if (has_next && next->node == i + 1 && i + 2 < nodes.size()) {
        append_arc(space, nodes, *next, result);
        i += 2;
      } else {
        const std::size_t barrier = has_next ? next->node - 1 : nodes.size() - 1;
        const std::size_t j = prudent_shortcut(space, nodes, i, std::max(barrier, i + 1));
        result.push_back(Segment{nodes[i], nodes[j]});
        i = j;
      }
    }
    return result;
  }

  Expected<void, Failure> check() const {
    if (!(corner_threshold >= 0))
      return fail(PlanError::invalid_option, "corner_threshold must not be negative");
    if (!(arc_initial_offset >= 0))
      return fail(PlanError::invalid_option, "arc_initial_offset must not be negative");
    if (!(arc_max_offset >= 0) || !std::isfinite(arc_max_offset)) {
      return fail(PlanError::invalid_option, "arc_max_offset must be finite and not negative");
    }
    if (!(arc_growth_step > 0))
      return fail(PlanError::invalid_option, "arc_growth_step must be positive");
    if (arc_max_offset > 1e4 * arc_growth_step) {
      return fail(PlanError::invalid_option,
                  "arc_growth_step is less than a ten-thousandth of arc_max_offset");
    }
    if (!(min_exterior_angle >= 0))
      return fail(PlanError::invalid_option, "min_exterior_angle must not be negative");
    return {};
  }

  /// One trigger per node: the nearest node of each critical corner, with the nearest corner of
  /// each node, in path order.
  template <CornerSpace S>
  std::vector<Trigger> find_triggers(const S& space, const std::vector<Point>& nodes) const {
    std::vector<Trigger> triggers;
    std::vector<std::size_t> by_x(nodes.size());
    std::iota(by_x.begin(), by_x.end(), std::size_t{0});
    std::sort(by_x.begin(), by_x.end(), [&](std::size_t i, std::size_t j) {
      return nodes[i].x() != nodes[j].x() ? nodes[i].x() < nodes[j].x() : i < j;
    });
    for (const Corner& corner :
         detail::critical_corners(space, nodes, corner_threshold, min_exterior_angle)) {
      triggers.push_back(trigger_of(corner, nodes, by_x));
    }
    std::sort(triggers.begin(), triggers.end(), [](const Trigger& a, const Trigger& b) {
      if (a.node != b.node) return a.node < b.node;
      return a.distance != b.distance ? a.distance < b.distance : a.corner_id < b.corner_id;
    });
    const auto same = [](const Trigger& a, const Trigger& b) { return a.node == b.node; };
    triggers.erase(std::unique(triggers.begin(), triggers.end(), same), triggers.end());
    return triggers;
  }

  /// The node nearest to a corner, the first one of ties. Searches outwards from the corner's x.
  /// \pre there are nodes
  static Trigger trigger_of(const Corner& corner, const std::vector<Point>& nodes,
                            const std::vector<std::size_t>& by_x) {
    Trigger best{0, corner.position, corner.id, std::numeric_limits<double>::infinity()};
    double least = best.distance;  // from the corner's position
    const auto look_at = [&](std::size_t i) {
      const double aside = std::abs(nodes[i].x() - corner.position.x());
      if (aside > least) return false;
      const double d = distance(nodes[i], corner.position);
      if (d < least || (d == least && i < best.node)) {
        best.node = i;
        least = d;
      }
      return true;
    };
    const auto from = std::lower_bound(by_x.begin(), by_x.end(), corner.position.x(),
                                       [&](std::size_t i, double x) { return nodes[i].x() < x; });
    for (auto i = from; i != by_x.end() && look_at(*i);) ++i;
    for (auto i = from; i != by_x.begin() && look_at(*(i - 1));) --i;
    best.distance = least - corner.radius;
    return best;
  }

  /// The end of a shortcut from i: one node before the last in sight, but at most `barrier`.
  template <FreeSpace S>
  static std::size_t prudent_shortcut(const S& space, const std::vector<Point>& nodes,
                                      std::size_t i, std::size_t barrier) {
    const auto sees = [&](std::size_t j) { return space.segment_free(nodes[i], nodes[j]); };
    const std::size_t end = nodes.size() - 1;
    const std::size_t last = detail::farthest_looking_ahead(i, end, sees);
    const std::size_t target = std::clamp(last == end ? end : last - 1, i + 1, barrier);
    if (target == last || target == i + 1) return target;
    if (sees(target)) return target;
    if (last <= barrier) return last;  // in sight, unlike its predecessor
    return detail::farthest_looking_ahead(i, target, sees);
  }

  /// Replaces the two steps around a trigger by one arc, if the arc is proved for some offset.
  template <ClearanceSpace S>
  void append_arc(const S& space, const std::vector<Point>& nodes, const Trigger& trigger,
                  Curve& result) const {
    const Point& a = nodes[trigger.node - 1];
    const Point& b = nodes[trigger.node];
    const Point& c = nodes[trigger.node + 1];
    const double chord = distance(a, c);
    if (std::abs(cross(b - a, c - b)) <= 1e-9 * chord * chord && space.segment_free(a, c)) {
      result.push_back(Segment{a, c});
      return;
    }
    const Point away = b - trigger.corner;
    const double length = away.norm();
    double offset = 0;
    while (offset <= arc_max_offset) {
      const Point pushed = length > 0 ? detail::offset_along(b, offset / length, away) : b;
      const QuadraticBezier arc{{a, pushed, c}};
      if (is_proved_free(space, arc)) {
        result.push_back(arc);
        return;
      }
      offset =
          offset == 0 && arc_initial_offset > 0 ? arc_initial_offset : offset + arc_growth_step;
    }
    result.push_back(Segment{a, b});
    result.push_back(Segment{b, c});
  }
};

}  // namespace tutavia
