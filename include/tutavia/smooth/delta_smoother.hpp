// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/route/corner_triggers.hpp"
#include "tutavia/smooth/route/farthest_in_sight.hpp"
#include "tutavia/smooth/route/input_checks.hpp"
#include "tutavia/smooth/route/wide_arcs.hpp"
#include "tutavia/smooth/shortcut.hpp"

/// \file
/// DeltaSmoother: the smoothing of grid paths in the delta-smoothed path (DSP) paper.

namespace tutavia {

/// Smooths a polyline by arcs at critical corners and long straight shortcuts in between.
///
/// A corner is critical if the path passes its safety zone within `corner_threshold`. The nearest
/// path node within that distance at which the path turns is its trigger; a path that passes
/// straight has none. Shortcuts stop before triggers. At a trigger, the two steps around it become
/// one quadratic Bezier arc, whose control point is pushed away from the corner until the arc is
/// proved safe; if none is, the steps stay. Shortcuts are prudent: they stop one node before the
/// last node in sight, which is usually next to a corner.
///
/// With `Join::tangent`, the default, lines and arcs meet in one direction. The arcs' control
/// points and the ends of the shortcuts form a polyline. Its vertices are dropped where that makes
/// no arc sharper, pushed farther from their corners (up to `arc_max_offset`) where that makes
/// arcs wider, and each is rounded by the widest arc that is proved free (see WideArcs). Only
/// vertices that touch a safety zone can remain corners.
///
/// Guarantees: the ends are exact; every line and arc is proved at the space's safety radius; the
/// result is never longer than its input (otherwise the input's shortcuts are returned, rounded
/// with `Join::tangent`). O(n log n) lines of sight for n nodes.
///
/// Source: Abdulshaheed 2025, "A Delta-Smoothed Path Algorithm". The fields give the paper's names;
/// docs/algorithms.md decides the details that it leaves open.
///
/// Example: examples/smoothers.cpp.
struct DeltaSmoother {
  static constexpr std::string_view name = "delta";

  /// How lines and arcs meet.
  enum class Join {
    paper,    ///< as printed: arcs span two steps, and the direction jumps at their ends
    tangent,  ///< in one direction: arcs are as wide as their neighbours and free space allow
  };

  double corner_threshold = 0.3;  ///< cornerThresh [m]
  /// arcInitOffset [m]: the first distance tried between the corner's zone and the control point,
  /// unless the node itself is farther away.
  double arc_initial_offset = 0.12;
  double arc_max_offset = 0.6;    ///< arcMaxOffset [m]: the largest such distance
  double arc_growth_step = 0.12;  ///< arcGrowStep [m]
  /// Corners that turn by less are treated as facets of a round obstacle [rad].
  double min_exterior_angle = 20 * std::numbers::pi / 180;
  Join join = Join::tangent;

  /// Arcs of the input count as tangents around them. If no shorter curve is found, such an input
  /// is returned as it is.
  ///
  /// Errors: `invalid_option` for an option that is negative or NaN (the growth step must be
  /// positive); `invalid_input` for a curve that is not free or not of segments and arcs; those of
  /// the budget.
  template <CornerSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    if (auto valid = check(); !valid) return std::move(valid).unexpected();
    const auto nodes = detail::free_nodes(space, input, budget, "the delta smoother");
    if (!nodes) return Unexpected{nodes.error()};
    if (detail::is_polyline(input)) return smooth_polyline(space, input, *nodes, budget);
    auto result = smooth_polyline(space, Curve::polyline(*nodes), *nodes, budget);
    if (result && result->length() > input.length()) return input;
    return result;
  }

 private:
  /// Lines and arcs, and the polyline of their control points. Its legs are proved.
  struct Chain {
    Curve curve;
    std::vector<detail::ArcVertex> polyline;
  };

  template <CornerSpace S>
  Expected<Curve, Failure> smooth_polyline(const S& space, const Curve& input,
                                           const std::vector<Point>& nodes,
                                           const Budget& budget) const {
    auto chain = lines_and_arcs(space, nodes, budget);
    if (!chain) return std::move(chain).unexpected();
    if (join == Join::paper) {
      if (chain->curve.length() <= input.length()) return std::move(chain->curve);
      return Shortcut{}.smooth(space, input, budget);
    }
    auto result = detail::WideArcs(space, std::move(chain->polyline)).curve(budget);
    if (!result || result->length() <= input.length()) return result;
    return rounded_shortcuts(space, input, budget);
  }

  template <CornerSpace S>
  Expected<Chain, Failure> lines_and_arcs(const S& space, const std::vector<Point>& nodes,
                                          const Budget& budget) const {
    const auto triggers = detail::find_triggers(space, nodes, corner_threshold, min_exterior_angle);
    Chain chain;
    chain.polyline.push_back({nodes.front()});
    auto next = triggers.begin();
    for (std::size_t i = 0; i + 1 < nodes.size();) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
      while (next != triggers.end() && next->node <= i) ++next;
      const bool has_next = next != triggers.end();
      if (has_next && next->node == i + 1) {
        append_arc(space, nodes, *next, chain);
        i += 2;
      } else {
        const std::size_t barrier = has_next ? next->node - 1 : nodes.size() - 1;
        const std::size_t j = prudent_shortcut(space, nodes, i, std::max(barrier, i + 1));
        chain.curve.push_back(Segment{nodes[i], nodes[j]});
        i = j;
      }
      chain.polyline.push_back({nodes[i]});
    }
    return chain;
  }

  template <ClearanceSpace S>
  static Expected<Curve, Failure> rounded_shortcuts(const S& space, const Curve& input,
                                                    const Budget& budget) {
    auto shortcuts = Shortcut{}.smooth(space, input, budget);
    if (!shortcuts) return shortcuts;
    std::vector<detail::ArcVertex> polyline;
    for (const Point& p : waypoints(*shortcuts)) polyline.push_back({p});
    return detail::WideArcs(space, std::move(polyline)).curve(budget);
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
  void append_arc(const S& space, const std::vector<Point>& nodes,
                  const detail::CornerTrigger& trigger, Chain& chain) const {
    const Point& a = nodes[trigger.node - 1];
    const Point& b = nodes[trigger.node];
    const Point& c = nodes[trigger.node + 1];
    const Point away = b - trigger.corner;
    const double length = away.norm();
    const Point outward = length > 0 ? Point(away / length) : Point::Zero();
    detail::ArcVertex vertex{b, outward, arc_max_offset - trigger.distance};
    for (double offset = std::max(arc_initial_offset, trigger.distance); offset <= arc_max_offset;
         offset += arc_growth_step) {
      const Point pushed = detail::offset_along(b, offset - trigger.distance, outward);
      const QuadraticBezier arc{{a, pushed, c}};
      if (!is_proved_free(space, arc)) continue;
      chain.curve.push_back(arc);
      if (space.segment_free(a, pushed) && space.segment_free(pushed, c)) {
        vertex = {pushed, outward, arc_max_offset - offset};
      }
      chain.polyline.push_back(vertex);
      return;
    }
    chain.curve.push_back(Segment{a, b});
    chain.curve.push_back(Segment{b, c});
    chain.polyline.push_back(vertex);
  }
};

}  // namespace tutavia
