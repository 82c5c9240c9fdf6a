// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <utility>

#include "tutavia/geometry/steering_word.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/search/auto_search.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// search_on_the_spot: routes of robots that turn on the spot.

namespace tutavia::detail {

/// A curve driven forwards, with a turn on the spot wherever the heading jumps: an arc of radius 0.
inline VehiclePath with_turns_on_the_spot(const Curve& curve, const Query& query) {
  VehiclePath path;
  std::optional<double> heading = query.start_heading;
  const auto turn_to = [&](const Point& at, double direction) {
    const double turn = wrapped_angle(direction - heading.value_or(direction));
    if (std::abs(turn) > 1e-12 || (path.empty() && curve.length() == 0)) {
      const Steering side = turn < 0 ? Steering::right : Steering::left;
      const Pose from{at, heading.value_or(direction)};
      path.push_back(turn_from(from, {side, std::abs(turn)}, 0), Gear::forward);
    }
    heading = direction;
  };
  for (const Piece& piece : curve.pieces()) {
    piece.visit([&](const auto& p) {
      if (!(p.length() > 0)) return;
      turn_to(p.start(), travel_direction(p, 0));
      path.push_back(p, Gear::forward);
      heading = travel_direction(p, 1);
    });
  }
  turn_to(curve.end(), query.goal_heading.value_or(heading.value_or(0)));
  return path;
}

/// The route of AutoSearch for a vehicle that is one disc, with turns on the spot.
template <ClearanceSpace S, Observer O>
Expected<Route, Failure> search_on_the_spot(const S& space, const Vehicle& vehicle,
                                            const Query& query, AutoSearch::Scratch& scratch,
                                            O& observer) {
  if constexpr (Searcher<AutoSearch, S>) {
    Query without_headings = query;
    without_headings.start_heading = without_headings.goal_heading = std::nullopt;
    const double radius = vehicle.footprint[0].radius;
    const auto search = [&](const S& wide) {
      auto route = AutoSearch{}.search(wide, without_headings, scratch, observer);
      if (!route) return route;
      VehiclePath path = with_turns_on_the_spot(route->curve, query);
      route->curve = std::move(path.curve);
      route->gears = std::move(path.gears);
      route->vehicle = vehicle;
      return route;
    };
    if (radius == 0) return search(space);
    const auto wide = space.with_safety_radius(space.safety_radius() + radius);
    if (!wide) return Unexpected{wide.error()};
    return search(*wide);
  } else {
    return fail(PlanError::invalid_option,
                "min_turning_radius must be positive in a space without a grid or a workspace");
  }
}

}  // namespace tutavia::detail
