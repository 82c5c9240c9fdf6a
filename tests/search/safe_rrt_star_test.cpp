// SPDX-License-Identifier: MIT
#include "tutavia/search/safe_rrt_star.hpp"

#include <cmath>

#include "support/tree_contract.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/rrt_star.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

TEST_CASE("SafeRrtStar keeps the contracts of searchers and of trees", "[soak]") {
  test::tree_contract(SafeRrtStar{}, 0x6486b59dbf1fa18d);
}

Expected<Route, Failure> search(const SafeRrtStar& algorithm, const InflatedSpace& space,
                                const Query& query) {
  SafeRrtStar::Scratch scratch;
  NoObserver no_observer;
  return algorithm.search(space, query, scratch, no_observer);
}

TEST_CASE("where there is a path outside the risk zones it is taken, and costs its length") {
  for (const Scene& scene : {maps::rrt_scene_1(), maps::rrt_scene_2()}) {
    const auto space = InflatedSpace::build(scene.workspace).value();
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Query query{.start = scene.start, .goal = scene.goals[0], .seed = seed};
      const SafeRrtStar algorithm{.max_iterations = 1000};
      const RiskZone zone = algorithm.zone(space);
      CHECK(zone.width == 2);
      const auto route = search(algorithm, space, query);
      REQUIRE(route);
      CHECK(zone.length_inside(space, route->curve).value == 0);
      CHECK(zone.integral(space, route->curve).value == 0);
      CHECK(route->cost == Approx(route->curve.length()).epsilon(1e-12));
      // Dropping nodes makes the same path shorter.
      const auto unpruned = search({.max_iterations = 1000, .prune = false}, space, query);
      REQUIRE(unpruned);
      CHECK(route->curve.length() <= unpruned->curve.length());
      CHECK(route->curve.pieces().size() < unpruned->curve.pieces().size());
    }
  }
}

/// Two rooms and a door of 1 m, much narrower than the zones around it.
InflatedSpace two_rooms() {
  return InflatedSpace::build(
             {.bounds = {{0, 0}, {20, 10}},
              .safety_radius = 0.2,
              .obstacles = {Polygon{{{10, -1}, {10, 4.5}}}, Polygon{{{10, 5.5}, {10, 11}}}}})
      .value();
}

TEST_CASE(
    "where every path crosses a zone it is short in it, and the iterations of both trees count") {
  const auto space = two_rooms();
  const Query query{.start = {2, 1}, .goal = {18, 1}, .seed = 3};
  const SafeRrtStar algorithm{
      .step = 2, .max_iterations = 2000, .risk_width = 1.5, .risk_weight = 5};
  const RiskZone zone = algorithm.zone(space);
  const auto route = search(algorithm, space, query);
  REQUIRE(route);
  CHECK(route->stats.expanded == 4000);
  const auto risk = zone.integral(space, route->curve);
  CHECK(risk.value > 0);
  CHECK(route->cost == Approx(route->curve.length() + 5 * risk.value).margin(5 * 0.02 * 20));
  // RRT* for length alone cuts the corners of the door, at more risk.
  RrtStar::Scratch scratch;
  NoObserver no_observer;
  const auto shortest =
      RrtStar{.step = 2, .max_iterations = 2000}.search(space, query, scratch, no_observer);
  REQUIRE(shortest);
  CHECK(shortest->curve.length() < route->curve.length());
  CHECK(zone.integral(space, shortest->curve).value > risk.value);
  // Without the attempt to keep out there is one tree.
  const auto at_once = search(
      {.step = 2, .max_iterations = 2000, .risk_width = 1.5, .risk_weight = 5, .keep_out = false},
      space, query);
  REQUIRE(at_once);
  CHECK(at_once->stats.expanded == 2000);
  CHECK(at_once->cost == Approx(route->cost).epsilon(0.05));
}

TEST_CASE("a start inside a risk zone is left without a detour of iterations") {
  const auto space = two_rooms();
  const SafeRrtStar algorithm{.max_iterations = 1000, .risk_width = 1.5};
  const auto route = search(algorithm, space, {.start = {9.5, 1}, .goal = {18, 1}});
  REQUIRE(route);
  CHECK(route->stats.expanded == 1000);
}

TEST_CASE("dropping nodes never makes a path through risk zones costlier") {
  const Scene scene = maps::maze();
  const auto space = InflatedSpace::build(scene.workspace).value();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Query query{.start = scene.start, .goal = scene.goals[0], .seed = seed};
    const auto pruned = search({.risk_weight = 3}, space, query);
    const auto whole = search({.risk_weight = 3, .prune = false}, space, query);
    REQUIRE(pruned);
    REQUIRE(whole);
    CHECK(pruned->cost <= whole->cost * (1 + 1e-12));
    CHECK(pruned->curve.pieces().size() <= whole->curve.pieces().size());
  }
}

TEST_CASE(
    "with its B-spline the method gives a smooth, proved curve whose way through grey is known") {
  for (const Scene& scene : {maps::rrt_scene_1(), maps::rrt_scene_2()}) {
    const auto space = InflatedSpace::build(scene.workspace).value();
    Planner planner{SafeRrtStar{}, BSplineSmoother{.prune = false}};
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto plan =
          planner.plan(space, {.start = scene.start, .goal = scene.goals[0], .seed = seed});
      REQUIRE(plan);
      CHECK_FALSE(plan->fell_back);
      CHECK(plan->certificate.status == ProofStatus::proved);
      CHECK(plan->certificate.lower > 0);
      CHECK(plan->metrics.length < plan->route.curve.length());
      CHECK(plan->metrics.max_joint_deflection < 1e-6);
      const auto grey = SafeRrtStar{}.zone(space).length_inside(space, plan->curve);
      CHECK(grey.value < 0.5 * plan->metrics.length);
    }
  }
}

TEST_CASE("risk zones without meaning and budgets are minded in both trees") {
  const auto space = two_rooms();
  const Query query{.start = {2, 1}, .goal = {18, 1}};
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    const auto refused = search({.risk_width = bad}, space, query);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == PlanError::invalid_option);
    CHECK(refused.error().detail.find("width") != std::string::npos);
  }
  CHECK(search({.risk_weight = -1}, space, query).error().code == PlanError::invalid_option);
  Query limited = query;
  limited.budget.max_expansions = 500;
  const auto stopped = search({.risk_width = 1.5}, space, limited);
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code == PlanError::budget_exhausted);
  CHECK(stopped.error().stats.expanded == 500);
}

}  // namespace
