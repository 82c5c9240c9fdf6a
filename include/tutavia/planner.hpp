// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/certify/certify.hpp"
#include "tutavia/certify/certify_vehicle.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/smooth/no_smoothing.hpp"
#include "tutavia/smooth/route/risk_runs.hpp"

/// \file
/// Planner: search, smoothing and proof in one call.

namespace tutavia {

struct AutoSearch;  // search/auto_search.hpp

/// A path that is proved safe, with its certificate, metrics and statistics.
struct Plan {
  Curve curve{};              ///< from start to goal, both exact
  std::vector<Gear> gears{};  ///< one per piece of the path of a vehicle; else empty
  Certificate certificate{};  ///< always `proved`; of a vehicle's whole footprint
  PathMetrics metrics{};
  Route route{};  ///< result of the search, before smoothing
  /// No smoothed curve was proved, and `curve` is the route's; or parts of it are (see Planner).
  bool fell_back = false;
  Statistics stats{};
};

namespace detail {

/// A space on which both a search and a smoother work.
template <class S, class Search, class Smooth>
concept PlannableSpace = ClearanceSpace<S> && Searcher<Search, S> && Smoother<Smooth, S>;

}  // namespace detail

/// Runs a search and a smoother, and proves the result.
///
/// `plan` returns a curve that is proved to keep the space's safety radius from the start to the
/// goal, or a failure. If the smoothed curve is not proved, the plan uses the route's own curve
/// (`fell_back`); if that is not proved either, the result is `not_proved`. If the deadline passes
/// during smoothing or its proof, the route is still proved and returned. A cancelled query returns
/// `cancelled`. If the search avoided a risk zone (SafeRrtStar), the smoothed curve avoids it
/// wherever the route does. A route that leads through the zone may have to be smoothed in parts,
/// or stay unsmoothed in parts: then what the smoother promises holds for each part alone, and the
/// plan says `fell_back`.
///
/// The route of a vehicle (HybridAStar) is smoothed by a VehicleSmoother and proved for the
/// vehicle's whole footprint, turning radius and gears; any other smoother is an `invalid_option`.
///
/// The default search is complete: AutoSearch, whose header a program has to include.
///
/// The planner owns the search's scratch memory: use one planner per thread. Threads may share a
/// space.
template <class Search = AutoSearch, class Smooth = NoSmoothing>
class Planner {
 public:
  explicit Planner(Search search = {}, Smooth smoother = {})
      : search_(std::move(search)), smoother_(std::move(smoother)) {}

  const Search& search() const { return search_; }
  const Smooth& smoother() const { return smoother_; }

  /// A planner with the same options and its own scratch memory, for another thread.
  Planner worker() const { return Planner(search_, smoother_); }

  template <detail::PlannableSpace<Search, Smooth> S>
  Expected<Plan, Failure> plan(const S& space, const Query& query) {
    NoObserver no_observer;
    return plan(space, query, no_observer);
  }

  /// The same, with an observer of the search.
  template <detail::PlannableSpace<Search, Smooth> S, Observer O>
  Expected<Plan, Failure> plan(const S& space, const Query& query, O& observer) {
    Stopwatch watch;
    auto route = search_.search(space, query, scratch_, observer);
    Statistics stats = route ? route->stats : route.error().stats;
    stats.seed = query.seed;
    stats.search_us = watch.lap();
    const auto failed = [&](Failure failure) {
      failure.stats = stats;
      return Unexpected{std::move(failure)};
    };
    if (!route) return failed(std::move(route.error()));
    if (route->vehicle && !PlansVehicles<Search>) {
      return failed({.code = PlanError::invalid_option,
                     .detail = "the route is that of a vehicle, but the search does not say "
                               "plans_vehicles"});
    }

    Plan plan;
    plan.route = std::move(*route);
    const auto smoothed = smooth(space, plan, query.budget);
    stats.smooth_us = watch.lap();
    if (smoothed) {
      prove(space, query, plan, query.budget);
    } else if (smoothed.error().code == PlanError::invalid_option) {
      return failed(smoothed.error());
    }
    if (plan.certificate.status != ProofStatus::proved) {
      plan.fell_back = true;
      plan.curve = plan.route.curve;
      plan.gears = plan.route.gears;
      prove(space, query, plan, {.stop = query.budget.stop});
    }
    stats.certify_us = watch.lap();
    if (query.budget.cancelled()) return failed({.code = PlanError::cancelled});
    if (plan.certificate.status != ProofStatus::proved) {
      return failed(
          {.code = PlanError::not_proved,
           .detail =
               leads_to_goal(plan, query)
                   ? "the route's certificate is " + std::string(to_string(plan.certificate.status))
                   : "the route does not lead from the start to the goal, or not in "
                     "the query's headings"});
    }
    plan.metrics = measure(plan.curve, plan.certificate, plan.gears);
    plan.stats = stats;
    return plan;
  }

 private:
  /// Wall-clock laps in microseconds.
  class Stopwatch {
   public:
    double lap() {
      const auto now = std::chrono::steady_clock::now();
      const std::chrono::duration<double, std::micro> elapsed = now - last_;
      last_ = now;
      return elapsed.count();
    }

   private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  };

  /// Smooths the plan's route into its curve.
  template <class S>
  Expected<void, Failure> smooth(const S& space, Plan& plan, const Budget& budget) const {
    if constexpr (PlansVehicles<Search>) {
      if (plan.route.vehicle) return smooth_for_vehicle(space, plan, budget);
    }
    auto smoothed = detail::smooth_outside_risk(space, smoother_, plan.route, budget);
    if (!smoothed) return std::move(smoothed).unexpected();
    plan.curve = std::move(smoothed->curve);
    plan.fell_back = !smoothed->is_whole;
    return {};
  }
  template <class S>
  Expected<void, Failure> smooth_for_vehicle(const S& space, Plan& plan,
                                             const Budget& budget) const {
    if constexpr (VehicleSmoother<Smooth, S>) {
      const VehiclePath path{plan.route.curve, plan.route.gears};
      auto smoothed = smoother_.smooth(space, *plan.route.vehicle, path, budget);
      if (!smoothed) return std::move(smoothed).unexpected();
      plan.curve = std::move(smoothed->curve);
      plan.gears = std::move(smoothed->gears);
      return {};
    } else {
      return fail(PlanError::invalid_option,
                  std::string(Smooth::name) +
                      " keeps no headings; use none, vehicle_shortcut (VehicleShortcut) or "
                      "continuous_curvature (ContinuousCurvature)");
    }
  }

  /// Certifies the plan's curve. One that does not lead from start to goal, in the headings that
  /// the query has, stays undecided.
  template <class S>
  void prove(const S& space, const Query& query, Plan& plan, const Budget& budget) const {
    plan.certificate = {};
    if (!leads_to_goal(plan, query)) return;
    if constexpr (PlansVehicles<Search>) {
      if (plan.route.vehicle) {
        const VehiclePath path{plan.curve, plan.gears};
        const auto proof = certify(space, *plan.route.vehicle, path, {}, budget);
        plan.certificate = proof.clearance;
        plan.certificate.status = proof.status;
        return;
      }
    }
    plan.certificate = certify(space, plan.curve, {}, budget);
  }

  /// Whether the curve leads from start to goal, that of a vehicle in the headings of the query.
  static bool leads_to_goal(const Plan& plan, const Query& query) {
    if (plan.curve.empty() || plan.curve.start() != query.start || plan.curve.end() != query.goal) {
      return false;
    }
    if (!plan.route.vehicle) return true;
    const VehiclePath path{plan.curve, plan.gears};
    const auto is_equal = [](const std::optional<double>& asked, double heading) {
      return !asked || std::abs(detail::wrapped_angle(detail::wrapped_angle(*asked) - heading)) <=
                           detail::heading_tolerance;
    };
    return path.gears.size() == path.curve.pieces().size() &&
           is_equal(query.start_heading, path.start().heading) &&
           is_equal(query.goal_heading, path.end().heading);
  }

  Search search_;
  Smooth smoother_;
  typename Search::Scratch scratch_{};
};

}  // namespace tutavia
