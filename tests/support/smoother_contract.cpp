// SPDX-License-Identifier: MIT
#include "support/smoother_contract.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>

#include "support/contract_spaces.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"

namespace tutavia::test {

namespace {

/// Checks the clauses of the contract one by one.
template <class S>
class SmootherTrial {
 public:
  SmootherTrial(const AnySmoother<S>& smoother, const SmootherPromise& promise)
      : smoother_(smoother),
        promise_(promise),
        open_(arena<S>(open_scene().workspace, *open_scene().resolution, promise.robot)) {}

  Breaches run() {
    smooths_short_polylines();
    breaches_.at("a wall in the middle of a square");
    keeps_within_the_budget();
    keeps_its_promise_in_random_worlds();
    return breaches_;
  }

 private:
  void smooths_short_polylines() {
    const Point corners[] = {{0.5, 2}, {0.5, 3.8}, {3.5, 3.8}, {3.5, 2}};
    const std::span<const Point> all(corners);
    for (const std::size_t count : {1u, 2u, 3u, 4u}) {
      breaches_.at("a polyline of " + std::to_string(count) + " points");
      smooths(open_, Curve::polyline(all.first(count)));
    }
  }

  /// Checks the clauses for a curve that is proved free.
  void smooths(const Arena<S>& world, const Curve& input) {
    const auto output = smoother_.smooth(world.space, input, Budget{});
    if (!breaches_.check(output.has_value(), "a curve that is free is smoothed")) return;
    check_curve(breaches_, world, *output, input.start(), input.end(), 32);
    breaches_.check(output->length() <= promise_.longest * input.length() * (1 + 1e-12),
                    "it is no longer than its bound");
    const auto again = smoother_.smooth(world.space, input, Budget{});
    breaches_.check(again && same_curve(*output, *again), "equal curves give equal results");
  }

  void keeps_within_the_budget() {
    if (promise_.budget == BudgetUse::ignored) return;
    std::stop_source source;
    source.request_stop();
    breaches_.check(fails({.stop = source.get_token()}, PlanError::cancelled),
                    "a cancelled budget is reported");
    breaches_.check(fails(Budget::for_seconds(-1), PlanError::budget_exhausted),
                    "a past deadline is reported");
  }

  bool fails(const Budget& budget, PlanError code) const {
    const auto route =
        grid_route(open_, {.start = open_scene().start, .goal = open_scene().goals[0]}).value();
    const auto output = smoother_.smooth(open_.space, route.curve, budget);
    return !output && output.error().code == code;
  }

  void keeps_its_promise_in_random_worlds() {
    const std::uint64_t seed = 30;
    RandomArenas<S> arenas(seed, promise_.robot);
    const std::size_t rounds = scaled(60);
    std::size_t routes = 0;
    for (std::size_t round = 0; round < rounds; ++round) {
      breaches_.at("seed " + std::to_string(seed) + ", round " + std::to_string(round));
      const Arena<S> world = arenas.next();
      const auto route = grid_route(world, arenas.query(world));
      if (!route) continue;
      ++routes;
      smooths(world, route->curve);
    }
    breaches_.at(std::to_string(routes) + " of " + std::to_string(rounds));
    breaches_.check(3 * routes >= rounds && routes > 0, "a third of the worlds has a route");
  }

  const AnySmoother<S>& smoother_;
  const SmootherPromise& promise_;
  Arena<S> open_;
  Breaches breaches_;
};

}  // namespace

template <class S>
Breaches broken_clauses(const AnySmoother<S>& smoother, const SmootherPromise& promise) {
  return SmootherTrial<S>(smoother, promise).run();
}

template Breaches broken_clauses(const AnySmoother<LatticeSpace>&, const SmootherPromise&);
template Breaches broken_clauses(const AnySmoother<CellSpace>&, const SmootherPromise&);
template Breaches broken_clauses(const AnySmoother<InflatedSpace>&, const SmootherPromise&);
template Breaches broken_clauses(const AnySmoother<FieldSpace>&, const SmootherPromise&);

}  // namespace tutavia::test
