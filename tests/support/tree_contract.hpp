// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "support/exact_checker.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "support/tree_invariants.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/search/rrt_connect.hpp"
#include "tutavia/search/tree/tree_growth.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/maps.hpp"

/// \file
/// The contract of searches with random trees, beyond that of searchers.

namespace tutavia::test {

inline void check_trees(const detail::TreeScratch& scratch) { check_tree(scratch.tree); }
inline void check_trees(const detail::TwoTreesScratch& scratch) {
  check_tree(scratch.from_start);
  check_tree(scratch.from_goal);
}
inline std::uint64_t fingerprint(const detail::TreeScratch& scratch) {
  return fingerprint(scratch.tree);
}
inline std::uint64_t fingerprint(const detail::TwoTreesScratch& scratch) {
  return fingerprint(scratch.from_start) ^ fingerprint(scratch.from_goal) << 1;
}

/// The scenes for trees: those of the RRT* paper, for a point and for a disc, and the built-in
/// maps.
inline std::vector<Scene> sampling_scenes() {
  std::vector<Scene> scenes{maps::rrt_scene_1(), maps::rrt_scene_2(), maps::array(),
                            maps::complex(), maps::maze()};
  for (std::size_t i = 0; i < 2; ++i) {
    Scene wide = scenes[i];
    wide.workspace.safety_radius = 1;
    scenes.push_back(wide);
  }
  return scenes;
}

/// Records the improved paths of a search.
struct Improvements : NoObserver {
  std::vector<double> costs;
  Curve last;
  std::size_t generated_nodes = 0;

  void generated(const Point&) { ++generated_nodes; }
  void improved(const Curve& path, double cost) {
    costs.push_back(cost);
    last = path;
  }
};
static_assert(AnytimeObserver<Improvements>);

template <class A>
void check_tree_options(const A& algorithm, const InflatedSpace& space, const Query& query) {
  const auto refused = [&](const char* option, auto change) {
    A changed = algorithm;
    change(changed);
    typename A::Scratch scratch;
    NoObserver no_observer;
    const auto route = changed.search(space, query, scratch, no_observer);
    INFO(option);
    REQUIRE_FALSE(route);
    CHECK(route.error().code == PlanError::invalid_option);
    CHECK(route.error().detail.find(option) == 0);
  };
  const Box& bounds = space.bounds();
  for (const double step :
       {0.0, -1.0, 1.001 * distance(bounds.min, bounds.max), HUGE_VAL, std::nan("")}) {
    refused("step", [&](A& a) { a.step = step; });
  }
  refused("max_iterations", [](A& a) { a.max_iterations = 0; });
  if constexpr (requires(A a) { a.goal_bias = 0; }) {
    for (const double bias : {-0.001, 1.001, std::nan("")}) {
      refused("goal_bias", [&](A& a) { a.goal_bias = bias; });
    }
  }
  if constexpr (requires(A a) { a.rewire_factor = 0; }) {
    for (const double factor : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
      refused("rewire_factor", [&](A& a) { a.rewire_factor = factor; });
    }
  }
}

/// The clauses of the contract of searches with random trees.
template <class A>
class TreeTrial {
 public:
  TreeTrial(const A& algorithm, std::uint64_t golden)
      : algorithm_(algorithm),
        golden_(golden),
        maze_(maps::maze()),
        space_(InflatedSpace::build(maze_.workspace).value()),
        query_{.start = maze_.start, .goal = maze_.goals[0], .seed = 7} {}

  void run() {
    check_tree_options(algorithm_, space_, query_);
    grows_the_same_tree_from_the_same_seed();
    grows_another_tree_from_another_seed();
    tells_of_better_paths();
    searches_for_nothing_in_full_view();
    gives_up_after_its_iterations();
    finds_routes_among_cells();
    is_exact_on_all_scenes();
  }

 private:
  Expected<Route, Failure> search(const InflatedSpace& space, const Query& query) {
    NoObserver no_observer;
    return algorithm_.search(space, query, used_, no_observer);
  }

  void grows_the_same_tree_from_the_same_seed() {
    INFO("the same seed gives the same tree, also in used memory");
    REQUIRE(search(space_, query_));
    const std::uint64_t print = fingerprint(used_);
#if !defined(__FMA__) && !defined(__aarch64__)
    CHECK(print == golden_);
#endif
    REQUIRE(search(space_, query_));
    CHECK(fingerprint(used_) == print);
  }

  void grows_another_tree_from_another_seed() {
    INFO("another seed gives another tree, after which the first one gives its own again");
    const auto first = search(space_, query_);
    REQUIRE(first);
    const std::uint64_t print = fingerprint(used_);
    Query other = query_;
    other.seed = 8;
    const auto second = search(space_, other);
    REQUIRE(second);
    CHECK(fingerprint(used_) != print);
    CHECK_FALSE(same_curve(first->curve, second->curve));
    REQUIRE(search(space_, query_));
    CHECK(fingerprint(used_) == print);
  }

  void tells_of_better_paths() {
    INFO("better paths are told as they are found, and the last one is the best");
    REQUIRE(search(space_, query_));
    const std::uint64_t print = fingerprint(used_);
    Improvements observer;
    const auto watched = algorithm_.search(space_, query_, used_, observer);
    REQUIRE(watched);
    CHECK(fingerprint(used_) == print);
    CHECK(observer.generated_nodes == watched->stats.generated);
    REQUIRE(!observer.costs.empty());
    for (std::size_t i = 1; i < observer.costs.size(); ++i) {
      CHECK(observer.costs[i] < observer.costs[i - 1]);
    }
    CHECK(watched->cost <= observer.costs.back());
    CHECK(observer.last.start() == query_.start);
    CHECK(observer.last.end() == query_.goal);
  }

  void searches_for_nothing_in_full_view() {
    INFO("nothing is searched for where start and goal see each other");
    const auto straight =
        search(space_, {.start = maze_.start, .goal = maze_.start + Point(0.01, 0)});
    REQUIRE(straight);
    CHECK(straight->curve.pieces().size() == 1);
    CHECK(straight->stats.expanded == 0);
  }

  void gives_up_after_its_iterations() {
    INFO("a closed room is searched until the iterations are used up");
    const auto room = InflatedSpace::build({.bounds = {{0, 0}, {10, 10}},
                                            .safety_radius = 0.1,
                                            .obstacles = {Polygon{{{5, -1}, {5, 11}}}}})
                          .value();
    A few = algorithm_;
    few.max_iterations = 200;
    NoObserver no_observer;
    const auto none = few.search(room, {.start = {1, 1}, .goal = {9, 9}}, used_, no_observer);
    REQUIRE_FALSE(none);
    CHECK(none.error().code == PlanError::budget_exhausted);
    CHECK(none.error().stats.expanded % 200 == 0);
    CHECK(none.error().detail.find("m of the goal") != std::string::npos);
  }

  void finds_routes_among_cells() {
    OccupancyGrid grid = free_grid(20, 20);
    for (int y = 0; y < 16; ++y) grid.set({10, y}, false);
    NoObserver no_observer;
    for (const double radius : {0.0, 0.7}) {
      INFO("cells are as good, safety radius " << radius);
      const auto cells = CellSpace::build(grid, {.safety_radius = radius}).value();
      const auto route =
          algorithm_.search(cells, {.start = {3, 3}, .goal = {17, 3}}, used_, no_observer);
      REQUIRE(route);
      CHECK(certify(cells, route->curve).status == ProofStatus::proved);
    }
  }

  void is_exact_on_all_scenes() {
    for (const Scene& scene : sampling_scenes()) {
      const auto world = InflatedSpace::build(scene.workspace).value();
      const ExactChecker judge(scene.workspace);
      for (std::uint64_t seed = 1; seed <= scaled(10); ++seed) {
        INFO("routes are exact with any seed: " << scene.name << ", safety radius "
                                                << scene.workspace.safety_radius << ", seed "
                                                << seed);
        const Query task{.start = scene.start, .goal = scene.goals.back(), .seed = seed};
        const auto route = search(world, task);
        REQUIRE(route);
        CHECK(route->curve.start() == task.start);
        CHECK(route->curve.end() == task.goal);
        CHECK(judge.check(route->curve) == ExactVerdict::free);
        check_trees(used_);
      }
    }
  }

  const A& algorithm_;
  [[maybe_unused]] std::uint64_t golden_;
  Scene maze_;
  InflatedSpace space_;
  Query query_;
  typename A::Scratch used_;
};

/// `golden` is the fingerprint of the trees on the maze with seed 7. It is the same on every
/// compiler without fused multiply-add.
template <class A>
void tree_contract(const A& algorithm, std::uint64_t golden) {
  // Samples miss a gap as wide as the robot: of 34 routes of A* among cells, all trees find 32.
  searcher_contract(algorithm, {.completeness = Completeness::gives_up, .found = 0.9});
  TreeTrial<A>(algorithm, golden).run();
}

}  // namespace tutavia::test
