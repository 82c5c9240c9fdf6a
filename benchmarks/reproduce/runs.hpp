// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "report.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/smooth/concepts.hpp"

/// \file
/// Runs of searches and smoothers, with their figures.

namespace reproduce {

using namespace tutavia;

inline double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// A route or a smoothed curve, and what tables say of it.
struct Run {
  Route route{};  ///< of a smoother: its curve and the statistics of the search
  PathMetrics metrics{};
  bool is_proved = false;
  double micros = std::numeric_limits<double>::quiet_NaN();  ///< least time

  double length() const { return metrics.length; }
  double turning() const { return degrees(metrics.turning_angle); }
  double interior() const { return degrees(metrics.interior_angle_sum); }
  double turns() const { return static_cast<double>(metrics.turning_points); }
  double expanded() const { return static_cast<double>(route.stats.expanded); }
  double distinct() const {
    return static_cast<double>(route.stats.distinct.value_or(route.stats.expanded));
  }
};

/// Calls `run` and returns its result; measures the least time of `rounds` more calls.
template <class Call>
auto least_time(std::size_t rounds, double& micros, const Call& run) {
  auto result = run();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < rounds; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const auto again = run();
    const std::chrono::duration<double, std::micro> passed =
        std::chrono::steady_clock::now() - begin;
    if (again.has_value() != result.has_value())
      throw std::runtime_error("a run cannot be repeated");
    least = std::min(least, passed.count());
  }
  if (rounds > 0) micros = least;
  return result;
}

template <class S>
Run measured(const S& space, Route route, double micros) {
  Run run{.route = std::move(route), .micros = micros};
  const Certificate certificate = certify(space, run.route.curve);
  run.metrics = measure(run.route.curve, certificate);
  run.is_proved = certificate.status == ProofStatus::proved;
  return run;
}

/// A query that has to succeed.
template <class S, Searcher<S> A>
Run search(const A& algorithm, const S& space, const Query& query, const Options& options) {
  typename A::Scratch scratch;
  NoObserver no_observer;
  double micros = std::numeric_limits<double>::quiet_NaN();
  auto route = least_time(options.rounds, micros,
                          [&] { return algorithm.search(space, query, scratch, no_observer); });
  if (!route) throw std::runtime_error(std::string(A::name) + ": " + route.error().detail);
  return measured(space, std::move(*route), micros);
}

/// A run's curve, smoothed.
template <class S, Smoother<S> A>
Run smooth(const A& algorithm, const S& space, const Run& input, const Options& options) {
  double micros = std::numeric_limits<double>::quiet_NaN();
  auto curve = least_time(options.rounds, micros,
                          [&] { return algorithm.smooth(space, input.route.curve, {}); });
  if (!curve) throw std::runtime_error(std::string(A::name) + ": " + curve.error().detail);
  return measured(space, {.curve = std::move(*curve), .stats = input.route.stats}, micros);
}

/// A plan for pictures.
inline Plan plan_of(const Run& route, const Run& smoothed) {
  return {.curve = smoothed.route.curve, .metrics = smoothed.metrics, .route = route.route};
}

}  // namespace reproduce
