// SPDX-License-Identifier: MIT
#include "tutavia/space/index/strict_edges.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/registry.hpp"
#include "support/scale.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/flow_field.hpp"
#include "tutavia/search/penalty_astar.hpp"
#include "tutavia/search/theta_star.hpp"
#include "tutavia/search/weighted_astar.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

LatticeSpace strict(const Workspace& workspace, double resolution) {
  return LatticeSpace::build(workspace, {.resolution = resolution, .edges = EdgeRule::paper_strict})
      .value();
}

template <class A>
Route search(const A& algorithm, const LatticeSpace& space, const Query& query) {
  typename A::Scratch scratch;
  NoObserver no_observer;
  return algorithm.search(space, query, scratch, no_observer).value();
}

TEST_CASE("the published A* lengths come out: ten to four decimals, two within a quarter percent") {
  // Abdulshaheed 2025, tables 1 to 3.
  constexpr double published[] = {10.2863, 17.4083, 20.3255, 23.9740, 11.8912, 14.5397,
                                  11.1255, 8.8627,  22.7782, 26.2510, 20.7539, 27.4853};
  std::size_t task = 0, exact = 0;
  for (const Scene& scene : {maps::array(), maps::complex(), maps::maze()}) {
    const LatticeSpace space = strict(scene.workspace, 0.2);
    for (const Point& goal : scene.goals) {
      INFO(scene.name << " to " << goal.transpose());
      const Query query{.start = scene.start, .goal = goal};
      const Route route = search(AStar{.heuristic = HeuristicKind::euclidean}, space, query);
      const double error = std::abs(route.curve.length() - published[task]);
      exact += error <= 5.1e-5;
      CHECK(error <= 0.0025 * published[task]);
      CHECK(certify(space, route.curve).status == ProofStatus::proved);
      CHECK(certify(space, route.curve).lower >= 0.3 - 2e-9);
      // Other searches that follow the steps agree.
      CHECK(search(AStar{}, space, query).cost == Approx(route.cost).epsilon(1e-8));
      CHECK(search(Dijkstra{}, space, query).cost == Approx(route.cost).epsilon(1e-8));
      CHECK(search(WeightedAStar{.weight = 1}, space, query).cost ==
            Approx(route.cost).epsilon(1e-8));
      CHECK(search(PenaltyAStar{}, space, query).curve.length() > route.curve.length());
      CHECK(search(ThetaStar{}, space, query).curve.length() < route.curve.length());
      ++task;
    }
  }
  CHECK(exact == 10);
}

TEST_CASE("about half of the diagonals fail the comparison without tolerance, no straight step") {
  int straight = 0, diagonal = 0;
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 80; ++x) {
      const Point p{x * 0.2, y * 0.2};
      straight += detail::is_strictly_near(p, {(x + 1) * 0.2, y * 0.2}, 0.2);
      diagonal += detail::is_strictly_near(p, {(x + 1) * 0.2, (y + 1) * 0.2}, 0.2);
    }
  }
  CHECK(straight == 80 * 80);
  CHECK(diagonal > 80 * 80 * 4 / 10);
  CHECK(diagonal < 80 * 80 * 7 / 10);
}

TEST_CASE("every step is free, leads both ways, and stays out of the mitred zones", "[soak]") {
  const std::uint64_t seed = 77;
  test::WorldGenerator worlds(seed);
  std::size_t checked = 0;
  for (std::size_t round = 0; round < test::scaled(30); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const LatticeSpace space = strict(world, world.bounds.width() / 25);
    const detail::MitredZones zones(world);
    const OccupancyGrid& grid = space.grid();
    bool sound = true;
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        const Cell cell{x, y};
        const StepSet own = space.edge_steps()[grid.index(cell)];
        if (!grid.is_free(cell)) sound = sound && own == 0;
        for (unsigned left = own; left != 0; left &= left - 1) {
          const auto step = static_cast<std::size_t>(std::countr_zero(left));
          const Cell next = cell + steps[step];
          const Point p = space.frame().point(cell), q = space.frame().point(next);
          sound = sound && grid.is_free(next) && space.segment_free(p, q) && !zones.enters(p, q);
          sound = sound && ((space.edge_steps()[grid.index(next)] >> detail::opposite(step)) & 1u);
          ++checked;
        }
      }
    }
    REQUIRE(sound);
  }
  CHECK(checked > 1000);
}

TEST_CASE("searches that need a movement rule answer invalid_option on such a lattice") {
  const Scene scene = maps::maze();
  const LatticeSpace space = strict(scene.workspace, 0.2);
  CHECK(space.movement() == MovementRule::by_edge);
  std::size_t refused = 0, found = 0;
  for (const auto& algorithm : all_searches<LatticeSpace>()) {
    INFO(algorithm.name);
    detail::AnyScratch scratch;
    NoObserver no_observer;
    const auto route = algorithm.search(
        space, {.start = scene.start, .goal = scene.goals[0], .budget = Budget::for_seconds(20)},
        scratch, no_observer);
    if (route) {
      ++found;
      CHECK(certify(space, route->curve).status == ProofStatus::proved);
    } else {
      ++refused;
      CHECK(route.error().code == PlanError::invalid_option);
    }
  }
  CHECK(refused >= 8);
  CHECK(found >= 7);
  const auto field = FlowField::build(space, scene.goals);
  REQUIRE_FALSE(field);
  CHECK(field.error().code == PlanError::invalid_option);
}

TEST_CASE("the rule takes no other movement rule, and by_edge is not a choice") {
  const Workspace world = maps::maze().workspace;
  const auto code = [&](const LatticeOptions& options) {
    const auto space = LatticeSpace::build(world, options);
    REQUIRE_FALSE(space);
    return space.error().code;
  };
  CHECK(code({.movement = MovementRule::by_edge}) == PlanError::invalid_option);
  CHECK(code({.movement = MovementRule::allow, .edges = EdgeRule::paper_strict}) ==
        PlanError::invalid_option);
  CHECK(LatticeSpace::build(world, {.resolution = 0.2}).value().edge_steps().empty());
  Workspace negative = world;
  negative.safety_radius = -1;
  const auto refused = LatticeSpace::build(negative, {.edges = EdgeRule::paper_strict});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_input);
}

}  // namespace
