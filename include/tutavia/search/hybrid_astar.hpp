// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "tutavia/plan/vehicle.hpp"
#include "tutavia/search/auto_search.hpp"
#include "tutavia/search/vehicle/hybrid_search.hpp"
#include "tutavia/search/vehicle/turn_on_the_spot.hpp"

/// \file
/// HybridAStar: paths of vehicles with headings, a turning radius and a footprint.

namespace tutavia {

/// A* over positions and headings of a vehicle: arcs and straight moves, and drives of Reeds and
/// Shepp (or Dubins, without reverse) to the goal.
///
/// The route is the VehiclePath {curve, gears} of `Route::vehicle`. Every disc of the vehicle's
/// footprint is proved to keep the safety radius over the continuous motion. No curvature exceeds
/// 1 / min_turning_radius, and the headings at both ends are those of the query (within 1e-12 rad).
/// A missing heading is free.
///
/// The search is repeated with finer headings and moves while it finds nothing, so it is complete
/// at the finest of them alone; the path is not the cheapest there is. `Route::cost` is the length,
/// in which reverse counts `reverse_weight` times, plus `cusp_cost` for every change of gear. If
/// the budget ends after a path has been found, that path is the answer. The results of one machine
/// are reproducible; sine and cosine of another library may choose another path of nearly equal
/// cost.
///
/// A vehicle that turns on the spot (min_turning_radius 0) takes the route of AutoSearch, and turns
/// where that has corners.
///
/// Errors: those of `validate(vehicle)`; `invalid_option` for weights below 1, a negative or
/// infinite cusp_cost, fewer than 8 headings, more than 8 searches or more than 1022 headings in
/// the last; `start_blocked` and `goal_blocked` if the footprint there is not free (where the
/// heading is given, or does not matter because the footprint is one centred disc); `unreachable`
/// if no way is wide enough whatever the headings; `unreachable_at_resolution` if there is no path
/// at the finest resolution; those of the budget.
///
/// Source: Dolgov, Thrun, Montemerlo and Diebel 2010, "Path planning for autonomous vehicles in
/// unknown semi-structured environments". Here moves and drives are proved, and headings are exact.
///
/// Example: examples/13_car.cpp.
struct HybridAStar {
  static constexpr std::string_view name = "hybrid_astar";
  static constexpr bool plans_vehicles = true;
  struct Scratch {
    detail::HybridScratch states;
    AutoSearch::Scratch on_the_spot;
  };

  Vehicle vehicle = Vehicle::point(1, true);
  double reverse_weight = 1.5;  ///< a metre in reverse costs so much
  double cusp_cost = 1;         ///< a change of gear costs so much [m]
  /// Factor of the heuristic, at least 1: the smaller, the cheaper the path and the longer the
  /// search.
  double heuristic_weight = 2;
  int headings = 24;  ///< directions in the first search; doubled in each further one
  int searches = 3;   ///< at most

  template <ClearanceSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (auto valid = check(space, query); !valid) return std::move(valid).unexpected();
    if (auto within = detail::check_budget(query.budget, 0); !within) {
      return std::move(within).unexpected();
    }
    Query wrapped = query;
    for (std::optional<double>* heading : {&wrapped.start_heading, &wrapped.goal_heading}) {
      if (*heading) **heading = detail::wrapped_angle(**heading);
    }
    if (vehicle.min_turning_radius == 0) {
      return detail::search_on_the_spot(space, vehicle, wrapped, scratch.on_the_spot, observer);
    }
    // At the end with less clearance few moves are free. Drives reach the other end easily.
    const bool from_goal =
        vehicle.reverse && clearance(space, wrapped.goal, wrapped.goal_heading) <
                               0.5 * clearance(space, wrapped.start, wrapped.start_heading);
    detail::DrivingCosts costs{1, reverse_weight, cusp_cost};
    if (from_goal) {
      std::swap(wrapped.start, wrapped.goal);
      std::swap(wrapped.start_heading, wrapped.goal_heading);
      std::swap(costs.forward, costs.reverse);
    }
    detail::SearchContext<S, O> context{space, query, observer};
    detail::HybridSearch<S, O> search(context, wrapped, vehicle, costs, heuristic_weight,
                                      scratch.states);
    const auto found = [&](VehiclePath path) {
      Route route = detail::route_of(from_goal ? path.reversed() : std::move(path), vehicle,
                                     {1, reverse_weight, cusp_cost});
      route.stats = context.statistics;
      return route;
    };
    if (auto direct = search.drive_directly()) return found(std::move(*direct));
    const double side = std::fmax(space.bounds().width(), space.bounds().height());
    detail::DistanceToGo<S> to_go(space, vehicle, wrapped.start, wrapped.goal, side / 64);
    const double endless = std::numeric_limits<double>::infinity();
    if (to_go.refined(wrapped.start, endless) == endless) {
      return fail(PlanError::unreachable,
                  "the reference point cannot reach the goal, whatever its headings");
    }
    for (int i = 0; i < searches; ++i) {
      auto path = search.run(to_go, headings << i, side / (128 << i));
      if (!path) return failed(std::move(path.error()), context.statistics);
      if (*path) return found(std::move(**path));
    }
    return failed(
        {.code = PlanError::unreachable_at_resolution,
         .detail = "no path with " + std::to_string(headings << (searches - 1)) + " headings"},
        context.statistics);
  }

  /// Checks options and query as `search` does.
  template <ClearanceSpace S>
  Expected<void, Failure> check(const S& space, const Query& query) const {
    if (auto valid = check_options(); !valid) return valid;
    return check_ends(space, query);
  }

 private:
  static Unexpected<Failure> failed(Failure failure, const Statistics& stats) {
    failure.stats = stats;
    return {std::move(failure)};
  }

  /// The least distance of the footprint from obstacles at a pose, or of the reference point if the
  /// heading is free [m].
  template <ClearanceSpace S>
  double clearance(const S& space, const Point& p, const std::optional<double>& heading) const {
    if (!heading) return space.clearance(p);
    double least = std::numeric_limits<double>::infinity();
    for (const FootprintDisc& disc : vehicle.footprint) {
      const Point centre = detail::carried_from(p, *heading, disc.offset);
      least = std::fmin(least, space.clearance(centre) - disc.radius);
    }
    return least;
  }

  Expected<void, Failure> check_options() const {
    if (auto valid = validate(vehicle); !valid) return valid;
    for (const double weight : {reverse_weight, heuristic_weight}) {
      if (weight >= 1 && std::isfinite(weight)) continue;
      return fail(PlanError::invalid_option,
                  "reverse_weight and heuristic_weight must be at least 1 and finite");
    }
    if (!(cusp_cost >= 0) || !std::isfinite(cusp_cost)) {
      return fail(PlanError::invalid_option, "cusp_cost must be finite and not negative");
    }
    if (headings < 8 || searches < 1 || searches > 8 || headings > (1022 >> (searches - 1))) {
      return fail(PlanError::invalid_option,
                  "headings must be at least 8, searches 1 to 8, and the last search may have at "
                  "most 1022 headings");
    }
    return {};
  }

  template <ClearanceSpace S>
  Expected<void, Failure> check_ends(const S& space, const Query& query) const {
    detail::FootprintTest footprint(vehicle);
    for (const bool is_start : {true, false}) {
      const Point& p = is_start ? query.start : query.goal;
      const std::optional<double>& heading = is_start ? query.start_heading : query.goal_heading;
      const bool within = space.bounds().contains(p);  // false for NaN
      Failure failure = detail::endpoint_failure(p, is_start, within);
      if (!within) return Unexpected{std::move(failure)};
      if (heading && !std::isfinite(*heading)) {
        return fail(PlanError::invalid_input,
                    failure.detail.substr(0, 5) + std::string("_heading is not finite"));
      }
      // Without a heading only a centred disc is known to be where it is.
      if (!heading && !vehicle.is_centred_disc()) continue;
      const Arc there = detail::turn_from({p, heading.value_or(0)}, {Steering::left, 0}, 0);
      if (footprint.is_free(space, there, Gear::forward)) continue;
      if (!vehicle.is_centred_disc()) {
        failure.detail =
            std::string(is_start ? "start " : "goal ") + detail::to_text(p) +
            ": the footprint there leaves the bounds or comes too close to an obstacle";
      }
      failure.clearance = space.clearance(p);
      return Unexpected{std::move(failure)};
    }
    return {};
  }
};

}  // namespace tutavia
