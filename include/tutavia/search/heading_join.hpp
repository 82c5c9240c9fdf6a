// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/search/auto_search.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/hybrid_astar.hpp"
#include "tutavia/search/vehicle/drive_chain.hpp"

/// \file
/// HeadingJoin: puts the path of a robot without headings onto headings and a turning radius.

namespace tutavia {

/// Follows the route of another search with a vehicle: a cheapest chain of shortest drives, each
/// proved, from the start pose through places on the route, where the vehicle heads along it, to
/// the goal pose. Where there is no such chain, HybridAStar searches.
///
/// Options of the vehicle, its costs and errors are those of `hybrid`. Failures of the other search
/// are left to HybridAStar, too. The chain is the cheapest through those places, not of all paths.
/// `Route::found_by` names the search that found the path. A missing heading at the start or the
/// goal is that of the route there.
///
/// Example: tests/search/heading_join_test.cpp.
template <class Search = AutoSearch>
struct HeadingJoin {
  static constexpr std::string_view name = "heading_join";
  static constexpr bool plans_vehicles = true;
  struct Scratch {
    typename Search::Scratch route;
    HybridAStar::Scratch hybrid;
  };

  HybridAStar hybrid{};  ///< the vehicle, its costs, and the search where the route does not help
  Search along{};        ///< finds the route
  int places = 40;       ///< on the route, at most; 2 to 1000

  template <ClearanceSpace S, Observer O = NoObserver>
  requires Searcher<Search, S> Expected<Route, Failure> search(const S& space, const Query& query,
                                                               Scratch& scratch, O& observer)
  const {
    if (places < 2 || places > 1000) {
      return fail(PlanError::invalid_option, "places must be 2 to 1000");
    }
    if (auto valid = hybrid.check(space, query); !valid) return std::move(valid).unexpected();
    if (hybrid.vehicle.min_turning_radius > 0) {
      Query plain = query;
      plain.start_heading = plain.goal_heading = std::nullopt;
      const auto route = along.search(space, plain, scratch.route, observer);
      if (route) {
        if (auto joined = join(space, query, *route)) {
          joined->found_by = Search::name;
          joined->stats = route->stats;
          return std::move(*joined);
        }
      } else if (query.budget.exceeded()) {
        return Unexpected{route.error()};
      }
    }
    auto found = hybrid.search(space, query, scratch.hybrid, observer);
    if (found) found->found_by = HybridAStar::name;
    return found;
  }

 private:
  /// The start pose, places on the route between its corners, and the goal pose.
  std::vector<Pose> places_on(const Curve& curve, const Query& query) const {
    const CurvePoint first = curve.at(0), last = curve.at(curve.length());
    std::vector<Pose> poses{{query.start, query.start_heading.value_or(first.heading)}};
    const double spacing = curve.length() / places;
    for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
      const double from = curve.length_before(i), length = curve.length_before(i + 1) - from;
      const int count = std::max(1, static_cast<int>(std::ceil(length / spacing - 1e-6)));
      for (int k = 0; length > 0 && k < count; ++k) {
        const CurvePoint at = curve.at(from + length * (k + 0.5) / count);
        poses.push_back({at.position, at.heading});
      }
    }
    poses.push_back({query.goal, query.goal_heading.value_or(last.heading)});
    return poses;
  }

  template <ClearanceSpace S>
  std::optional<Route> join(const S& space, const Query& query, const Route& route) const {
    if (!(route.curve.length() > 0)) return std::nullopt;
    const Vehicle& vehicle = hybrid.vehicle;
    const detail::DrivingCosts costs{1, hybrid.reverse_weight, hybrid.cusp_cost};
    const std::vector<Pose> poses = places_on(route.curve, query);
    const detail::CircularDrives drives(vehicle);
    detail::DriveChain chain(drives, costs, poses);
    detail::FootprintTest footprint(vehicle);
    VehiclePath path;
    const auto no_path = [](std::size_t) { return std::optional<detail::KnownPath>(); };
    for (const auto& step : chain.cheapest(space, footprint, no_path, query.budget)) {
      path.append(chain.path(*step.drive, step.from, step.to));
    }
    if (path.empty()) return std::nullopt;
    return detail::route_of(std::move(path), vehicle, costs);
  }
};

}  // namespace tutavia
