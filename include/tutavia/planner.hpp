// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "tutavia/certify/certify.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/smooth/no_smoothing.hpp"

/// \file
/// Planner: a search, a smoother and the proof, in one call.

namespace tutavia {

/// How long the shortest path there is would be; see TangentGraph.
struct Optimum {
  double length = 0;  ///< [m]
  double ratio = 1;   ///< of the plan's length to it
};

/// A path that is proved safe, and all that is known about it.
struct Plan {
  Curve curve{};              ///< from start to goal, both exact
  Certificate certificate{};  ///< always `proved`
  PathMetrics metrics{};
  Route route{};           ///< what the search found, before smoothing
  bool fell_back = false;  ///< smoothing gave nothing that could be proved: `curve` is the route's
  std::optional<Optimum> optimum{};  ///< where the planner was asked to report it
  Statistics stats{};
};

/// Chains a search, a smoother and the certificate.
///
/// `plan` returns a curve that is proved to keep the space's safety radius, or why there is none. A
/// smoothed curve that is not proved gives way to the route's own curve (`fell_back`), and where
/// that is not proved either the answer is `not_proved`. When the deadline passes during smoothing
/// or its proof, the route is still proved and returned; a cancelled query returns `cancelled`.
///
/// The planner owns the search's scratch memory: use one planner per thread, and one space for all.
template <class Search, class Smooth = NoSmoothing>
class Planner {
 public:
  explicit Planner(Search search = {}, Smooth smoother = {})
      : search_(std::move(search)), smoother_(std::move(smoother)) {}

  const Search& search() const { return search_; }
  const Smooth& smoother() const { return smoother_; }

  /// Whether plans carry the length of the shortest path: found by a search bounded by the plan's
  /// own length, in spaces that show their obstacles, at a positive safety radius. The search takes
  /// milliseconds for hundreds of obstacle vertices and keeps within the query's budget; a plan for
  /// which that is too little has none.
  Planner& report_optimum(bool on) {
    reports_optimum_ = on;
    return *this;
  }

  template <ClearanceSpace S>
  requires Searcher<Search, S> && Smoother<Smooth, S> Expected<Plan, Failure> plan(
      const S& space, const Query& query) {
    NoObserver nobody;
    return plan(space, query, nobody);
  }

  /// The same, with an observer that is told of the nodes searched.
  template <ClearanceSpace S, Observer O>
  requires Searcher<Search, S> && Smoother<Smooth, S> Expected<Plan, Failure> plan(
      const S& space, const Query& query, O& observer) {
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

    Plan plan;
    plan.route = std::move(*route);
    auto smoothed = smoother_.smooth(space, plan.route.curve, query.budget);
    stats.smooth_us = watch.lap();
    if (smoothed) {
      plan.curve = std::move(*smoothed);
      plan.certificate = certify(space, plan.curve, {}, query.budget);
    } else if (smoothed.error().code == PlanError::invalid_option) {
      return failed(std::move(smoothed.error()));
    }
    if (plan.certificate.status != ProofStatus::proved) {
      plan.fell_back = true;
      plan.curve = plan.route.curve;
      plan.certificate = certify(space, plan.curve, {}, {.stop = query.budget.stop});
    }
    stats.certify_us = watch.lap();
    if (query.budget.cancelled()) return failed({.code = PlanError::cancelled});
    if (plan.certificate.status != ProofStatus::proved) {
      return failed({.code = PlanError::not_proved,
                     .detail = "the route's certificate is " +
                               std::string(to_string(plan.certificate.status))});
    }
    plan.metrics = measure(space, plan.curve, plan.certificate);
    plan.stats = stats;
    if constexpr (FeatureSpace<S>) {
      if (reports_optimum_) plan.optimum = find_optimum(space, query, plan.metrics.length);
    }
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

  template <FeatureSpace S>
  std::optional<Optimum> find_optimum(const S& space, const Query& query, double length) {
    NoObserver nobody;
    const TangentGraph shorter{.bound = length * (1 + 1e-9)};
    const auto route = shorter.search(space, query, optimum_scratch_, nobody);
    if (!route) return std::nullopt;
    return Optimum{route->cost, route->cost > 0 ? length / route->cost : 1};
  }

  Search search_;
  Smooth smoother_;
  typename Search::Scratch scratch_{};
  bool reports_optimum_ = false;
  TangentGraph::Scratch optimum_scratch_{};
};

}  // namespace tutavia
