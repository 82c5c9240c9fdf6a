// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/route/grid_nodes.hpp"
#include "tutavia/smooth/route/tangent_polyline.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Checks of a smoother's input.

namespace tutavia::detail {

/// Checks that every piece of a curve is proved free. Errors: `invalid_input` with the first piece
/// that is not free and its ends; those of the budget.
template <ClearanceSpace S>
Expected<void, Failure> check_free(const S& space, const Curve& curve, const Budget& budget) {
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    if (i % 64 == 0) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
    }
    const Piece& piece = curve.pieces()[i];
    if (piece.visit([&](const auto& p) { return is_proved_free(space, p); })) continue;
    const Point a = start_of(piece), b = end_of(piece);
    return fail(PlanError::invalid_input, "segment " + std::to_string(i) + " of the route, from " +
                                              to_text(a) + " to " + to_text(b) + ", is not free");
  }
  return {};
}

/// The curve split at grid nodes, with every piece proved free. Errors: those of `check_free`.
template <ClearanceSpace S>
Expected<Curve, Failure> free_steps(const S& space, const Curve& curve, const Budget& budget) {
  Curve split = split_at_nodes(space, curve);
  if (check_free(space, split, budget)) return split;
  // A run may be free although one of its steps, whose ends are rounded, is not.
  if (const auto free = check_free(space, curve, budget); !free) return Unexpected{free.error()};
  return curve;
}

inline bool is_polyline(const Curve& curve) {
  return std::all_of(curve.pieces().begin(), curve.pieces().end(),
                     [](const Piece& p) { return p.holds<Segment>(); });
}

/// A polyline instead of a curve of segments and arcs; see tangent_polyline. Errors:
/// `invalid_input`, which names the smoother, for a curve with other pieces.
template <FreeSpace S>
Expected<Curve, Failure> without_arcs(const S& space, const Curve& curve,
                                      std::string_view smoother) {
  if (const auto points = tangent_polyline(space, curve)) return Curve::polyline(*points);
  return fail(PlanError::invalid_input,
              std::string(smoother).append(" takes curves of segments and arcs only"));
}

/// The waypoints of a polyline that is proved free; arcs count as tangents around them. Errors:
/// those of `without_arcs` and `check_free`.
template <ClearanceSpace S>
Expected<std::vector<Point>, Failure> free_polyline(const S& space, const Curve& curve,
                                                    const Budget& budget,
                                                    std::string_view smoother) {
  if (!is_polyline(curve)) {
    const auto polyline = without_arcs(space, curve, smoother);
    if (!polyline) return Unexpected{polyline.error()};
    return free_polyline(space, *polyline, budget, smoother);
  }
  if (const auto free = check_free(space, curve, budget); !free) return Unexpected{free.error()};
  return waypoints(curve);
}

/// The same, split at grid nodes; every leg is proved.
template <ClearanceSpace S>
Expected<std::vector<Point>, Failure> free_nodes(const S& space, const Curve& curve,
                                                 const Budget& budget, std::string_view smoother) {
  if (!is_polyline(curve)) {
    const auto polyline = without_arcs(space, curve, smoother);
    if (!polyline) return Unexpected{polyline.error()};
    return free_nodes(space, *polyline, budget, smoother);
  }
  const auto curve_of_steps = free_steps(space, curve, budget);
  if (!curve_of_steps) return Unexpected{curve_of_steps.error()};
  return waypoints(*curve_of_steps);
}

}  // namespace tutavia::detail
