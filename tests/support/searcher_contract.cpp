// SPDX-License-Identifier: MIT
#include "support/searcher_contract.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <stop_token>
#include <string>

#include "support/contract_spaces.hpp"
#include "support/scale.hpp"

namespace tutavia::test {

const Scene& open_scene() {
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

namespace {

using Answer = Expected<Route, Failure>;

/// Checks the clauses of the contract one by one.
template <class S>
class SearcherTrial {
 public:
  SearcherTrial(const AnySearch<S>& search, const SearcherPromise& promise)
      : search_(search),
        promise_(promise),
        open_(arena<S>(open_scene().workspace, *open_scene().resolution, promise.robot)) {}

  Breaches run() {
    finds_routes_on_the_built_in_maps();
    breaches_.at("a wall in the middle of a square");
    refuses_blocked_ends();
    refuses_ends_out_of_bounds();
    refuses_ends_that_are_no_points();
    keeps_within_the_budget();
    answers_start_at_goal();
    reports_that_there_is_no_path();
    keeps_its_promise_in_random_worlds();
    return breaches_;
  }

 private:
  void finds_routes_on_the_built_in_maps() {
    for (const Scene& scene : contract_scenes()) {
      const Arena<S> map = arena<S>(scene.workspace, *scene.resolution, promise_.robot);
      detail::AnyScratch used;
      for (const Point& goal : scene.goals) {
        breaches_.at(scene.name + " to " + detail::to_text(goal));
        const Query query{.start = scene.start, .goal = goal};
        const Answer route = search(map.space, query, used);
        if (!breaches_.check(route.has_value(), "a route is found on a built-in map")) continue;
        check_route(map, query, *route);
        gives_equal_routes(map, query, *route);
      }
    }
  }

  void check_route(const Arena<S>& map, const Query& query, const Route& route) {
    check_curve(breaches_, map, route.curve, query.start, query.goal, 8);
  }

  void gives_equal_routes(const Arena<S>& map, const Query& query, const Route& route) {
    const Answer again = search(map.space, query);
    breaches_.check(again && same_curve(route.curve, again->curve) && route.cost == again->cost &&
                        route.stats.expanded == again->stats.expanded,
                    "equal queries give equal routes, with any scratch");
  }

  void refuses_blocked_ends() {
    const bool point = promise_.robot == Robot::point;
    const Point blocked = point ? Point(1.6, 2) : Point(1.4, 2);
    Query query = good();
    query.start = blocked;
    breaches_.check(fails(query, PlanError::start_blocked), "a blocked start is reported");
    const Answer answer = search(open_.space, query);
    breaches_.check(!answer && answer.error().clearance &&
                        std::abs(*answer.error().clearance - (point ? -0.1 : 0.1)) < 1e-9,
                    "the clearance of a blocked start is reported");
    query = good();
    query.goal = {2, 2};
    breaches_.check(fails(query, PlanError::goal_blocked), "a blocked goal is reported");
  }

  void refuses_ends_out_of_bounds() {
    Query query = good();
    query.start = {-1, 2};
    breaches_.check(fails(query, PlanError::start_out_of_bounds),
                    "a start out of bounds is reported");
    query = good();
    query.goal = {1, 4.01};
    breaches_.check(fails(query, PlanError::goal_out_of_bounds),
                    "a goal out of bounds is reported");
  }

  void refuses_ends_that_are_no_points() {
    Query query = good();
    query.start.x() = std::numeric_limits<double>::quiet_NaN();
    breaches_.check(fails(query, PlanError::invalid_input), "a start that is NaN is reported");
    query = {.start = good().start};
    breaches_.check(fails(query, PlanError::invalid_input), "a missing goal is reported");
  }

  void keeps_within_the_budget() {
    Query query = good();
    query.budget.max_expansions = 0;
    breaches_.check(fails(query, PlanError::budget_exhausted),
                    "a budget without expansions is reported");
    query.budget = Budget::for_seconds(-1);
    breaches_.check(fails(query, PlanError::budget_exhausted), "a past deadline is reported");
    std::stop_source source;
    source.request_stop();
    query.budget = {.stop = source.get_token()};
    breaches_.check(fails(query, PlanError::cancelled), "a cancelled budget is reported");
  }

  void answers_start_at_goal() {
    const Point start = good().start;
    const Answer route = search(open_.space, {.start = start, .goal = start});
    breaches_.check(route && route->curve.length() == 0 && route->curve.start() == start,
                    "a route from a point to itself is that point");
  }

  void reports_that_there_is_no_path() {
    Workspace split = open_scene().workspace;
    split.obstacles.push_back(Polygon{{{1.9, 0}, {2.1, 0}, {2.1, 4}, {1.9, 4}}});
    const Arena<S> two_rooms = arena<S>(split, *open_scene().resolution, promise_.robot);
    const Answer answer = search(two_rooms.space, good());
    breaches_.check(!answer && is_no_path(answer.error().code),
                    "it is reported that there is no path");
  }

  void keeps_its_promise_in_random_worlds() {
    const std::uint64_t seed = 20;
    RandomArenas<S> arenas(seed, promise_.robot);
    const std::size_t rounds = scaled(60);
    std::size_t found = 0, possible = 0, found_of_possible = 0;
    for (std::size_t round = 0; round < rounds; ++round) {
      breaches_.at("seed " + std::to_string(seed) + ", round " + std::to_string(round));
      const Arena<S> world = arenas.next();
      const Query query = arenas.query(world);
      const Answer route = search(world.space, query);
      const bool is_possible = grid_route(world, query).has_value();
      if (route) {
        check_route(world, query, *route);
      } else {
        gives_a_reason_that_holds(world, query, route.error());
      }
      found += route ? 1 : 0;
      possible += is_possible ? 1 : 0;
      found_of_possible += route && is_possible ? 1 : 0;
    }
    answers_enough(found, rounds);
    finds_enough(found_of_possible, possible);
  }

  void gives_a_reason_that_holds(const Arena<S>& world, const Query& query,
                                 const Failure& failure) {
    std::ostringstream text;
    text << failure;
    breaches_.at(breaches_.place() + ": " + text.str());
    if (promise_.ties == Ties::not_proved && failure.code == PlanError::not_proved) return;
    const auto ends = check_query(world.space, query);
    breaches_.check(ends ? is_no_path(failure.code) : failure.code == ends.error().code,
                    "a query without a route fails for a reason that holds");
  }

  void answers_enough(std::size_t found, std::size_t rounds) {
    breaches_.at(std::to_string(found) + " of " + std::to_string(rounds));
    breaches_.check(found > 0 && 3 * found >= rounds, "a third of random queries has a route");
  }

  void finds_enough(std::size_t found, std::size_t possible) {
    breaches_.at(std::to_string(found) + " of " + std::to_string(possible));
    breaches_.check(static_cast<double>(found) >= promise_.found * static_cast<double>(possible),
                    "so many routes as promised are found where A* finds one");
  }

  bool is_no_path(PlanError code) const {
    if (promise_.completeness == Completeness::gives_up) {
      return code == PlanError::budget_exhausted;
    }
    return code == PlanError::unreachable || code == PlanError::unreachable_at_resolution;
  }

  static Query good() { return {.start = open_scene().start, .goal = open_scene().goals[0]}; }

  bool fails(const Query& query, PlanError code) const {
    const Answer answer = search(open_.space, query);
    return !answer && answer.error().code == code;
  }

  Answer search(const S& space, const Query& query) const {
    detail::AnyScratch scratch;
    return search(space, query, scratch);
  }
  Answer search(const S& space, const Query& query, detail::AnyScratch& scratch) const {
    NoObserver no_observer;
    return search_.search(space, query, scratch, no_observer);
  }

  const AnySearch<S>& search_;
  const SearcherPromise& promise_;
  Arena<S> open_;
  Breaches breaches_;
};

}  // namespace

template <class S>
Breaches broken_clauses(const AnySearch<S>& search, const SearcherPromise& promise) {
  return SearcherTrial<S>(search, promise).run();
}

template Breaches broken_clauses(const AnySearch<LatticeSpace>&, const SearcherPromise&);
template Breaches broken_clauses(const AnySearch<CellSpace>&, const SearcherPromise&);
template Breaches broken_clauses(const AnySearch<InflatedSpace>&, const SearcherPromise&);
template Breaches broken_clauses(const AnySearch<FieldSpace>&, const SearcherPromise&);

}  // namespace tutavia::test
