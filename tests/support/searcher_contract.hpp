// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <limits>
#include <string>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/reference_distance.hpp"
#include "support/scale.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

/// \file
/// What every searcher on lattices must do; one line in a test file instantiates it.

namespace tutavia::test {

inline const Scene& open_scene() {
  static const Scene scene = [] {
    Scene s;
    s.workspace = {.bounds = {{0, 0}, {4, 4}}, .safety_radius = 0.25};
    s.workspace.obstacles.push_back(Polygon{{{1.5, 0.5}, {2.5, 0.5}, {2.5, 3.5}, {1.5, 3.5}}});
    s.start = {0.5, 2};
    s.goals = {{3.5, 2}};
    s.resolution = 0.1;
    return s;
  }();
  return scene;
}

/// Runs one query with scratch of its own.
template <class A>
Expected<Route, Failure> search_once(const A& algorithm, const LatticeSpace& space,
                                     const Query& query) {
  typename A::Scratch scratch;
  NoObserver nobody;
  return algorithm.search(space, query, scratch, nobody);
}

template <class A>
PlanError failure_of(const A& algorithm, const LatticeSpace& space, const Query& query) {
  const auto route = search_once(algorithm, space, query);
  REQUIRE_FALSE(route);
  return route.error().code;
}

inline bool same_curve(const Curve& a, const Curve& b) {
  if (a.pieces().size() != b.pieces().size()) return false;
  for (std::size_t i = 0; i < a.pieces().size(); ++i) {
    if (a.pieces()[i].index() != b.pieces()[i].index()) return false;
    if (start_of(a.pieces()[i]) != start_of(b.pieces()[i])) return false;
    if (end_of(a.pieces()[i]) != end_of(b.pieces()[i])) return false;
  }
  return true;
}

/// Whether a search can know that there is no path.
enum class Completeness { proves_that_there_is_none, gives_up };

template <class A>
void searcher_contract(const A& algorithm,
                       Completeness completeness = Completeness::proves_that_there_is_none) {
  static_assert(Searcher<A, LatticeSpace>);

  for (const Scene& scene : {maps::array(), maps::complex(), maps::maze()}) {
    const auto space =
        LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
    typename A::Scratch used;
    NoObserver nobody;
    for (const Point& goal : scene.goals) {
      INFO(scene.name << " to " << goal.transpose());
      const Query query{.start = scene.start, .goal = goal};
      const auto route = algorithm.search(space, query, used, nobody);
      REQUIRE(route);
      CHECK(route->curve.start() == scene.start);
      CHECK(route->curve.end() == goal);
      CHECK(certify(space, route->curve).status == ProofStatus::proved);
      const auto again = search_once(algorithm, space, query);
      REQUIRE(again);
      CHECK(same_curve(route->curve, again->curve));
      CHECK(route->stats.expanded == again->stats.expanded);
    }
  }

  const Scene& scene = open_scene();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.1}).value();
  const Query good{.start = scene.start, .goal = scene.goals[0]};
  const auto with = [&](auto change) {
    Query query = good;
    change(query);
    return query;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Q = Query&;
  CHECK(failure_of(algorithm, space, with([](Q q) {
                     q.start = {1.4, 2};
                   })) == PlanError::start_blocked);
  CHECK(failure_of(algorithm, space, with([](Q q) {
                     q.goal = {2, 2};
                   })) == PlanError::goal_blocked);
  CHECK(failure_of(algorithm, space, with([](Q q) {
                     q.start = {-1, 2};
                   })) == PlanError::start_out_of_bounds);
  CHECK(failure_of(algorithm, space, with([](Q q) {
                     q.goal = {1, 4.01};
                   })) == PlanError::goal_out_of_bounds);
  CHECK(failure_of(algorithm, space, with([&](Q q) { q.start.x() = nan; })) ==
        PlanError::invalid_input);
  CHECK(failure_of(algorithm, space, {.start = good.start}) == PlanError::invalid_input);
  CHECK(failure_of(algorithm, space, with([](Q q) { q.budget.max_expansions = 0; })) ==
        PlanError::budget_exhausted);
  CHECK(failure_of(algorithm, space, with([](Q q) { q.budget = Budget::for_seconds(-1); })) ==
        PlanError::budget_exhausted);
  std::stop_source source;
  source.request_stop();
  CHECK(failure_of(algorithm, space, with([&](Q q) { q.budget.stop = source.get_token(); })) ==
        PlanError::cancelled);
  const auto blocked = search_once(algorithm, space, with([](Q q) { q.start = {1.4, 2}; }));
  REQUIRE(blocked.error().clearance);
  CHECK(*blocked.error().clearance == Approx(0.1));

  const auto point = search_once(algorithm, space, with([](Q q) { q.goal = q.start; }));
  REQUIRE(point);
  CHECK(point->curve.length() == 0);
  CHECK(point->curve.start() == good.start);

  Workspace split = scene.workspace;
  split.obstacles.push_back(Polygon{{{1.9, 0}, {2.1, 0}, {2.1, 4}, {1.9, 4}}});
  const auto two_rooms = LatticeSpace::build(split, {.resolution = 0.1}).value();
  const PlanError no_way = failure_of(algorithm, two_rooms, good);
  if (completeness == Completeness::gives_up) {
    CHECK(no_way == PlanError::budget_exhausted);
  } else {
    CHECK((no_way == PlanError::unreachable || no_way == PlanError::unreachable_at_resolution));
  }

  const std::uint64_t seed = 20;
  WorldGenerator worlds(seed);
  for (std::size_t round = 0; round < scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto random_space =
        LatticeSpace::build(world, {.resolution = world.bounds.width() / 40}).value();
    const Query query{.start = worlds.point(world), .goal = worlds.point(world)};
    const auto route = search_once(algorithm, random_space, query);
    if (!route) continue;
    CHECK(route->curve.start() == query.start);
    CHECK(route->curve.end() == query.goal);
    CHECK(certify(random_space, route->curve).status == ProofStatus::proved);
    CHECK(sampled_clearance(world, route->curve, 8) >=
          world.safety_radius - 1e-12 * random_space.magnitude());
  }
}

}  // namespace tutavia::test
