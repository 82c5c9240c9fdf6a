// SPDX-License-Identifier: MIT
#include "tutavia/optimum.hpp"

#include "support/catch.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

TEST_CASE("the optimum of a plan is the length of the tangent graph's path") {
  const Scene scene = maps::complex();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  const Query query{.start = scene.start, .goal = scene.goals[1]};
  const double length = Planner{AStar{}, BSplineSmoother{}}.plan(space, query)->metrics.length;
  Planner<TangentGraph> exact;
  const double shortest = exact.plan(space, query)->metrics.length;
  CHECK(shortest < length);
  CHECK(find_optimum(space, query).value() == Approx(shortest).epsilon(1e-12));
  CHECK(find_optimum(space, query, length).value() == Approx(shortest).epsilon(1e-12));
  // The shortest path itself is found within its own length, and nothing within less.
  CHECK(find_optimum(space, query, shortest).value() == Approx(shortest).epsilon(1e-12));
  CHECK(find_optimum(space, query, 0.999 * shortest).error().code == PlanError::unreachable);
}

TEST_CASE("the optimum keeps within the query's budget and says what is wrong") {
  const Scene scene = maps::maze();
  const auto space = InflatedSpace::build(scene.workspace).value();
  Query query{.start = scene.start, .goal = scene.goals[0]};
  query.budget.max_expansions = 1;
  CHECK(find_optimum(space, query).error().code == PlanError::budget_exhausted);
  query = {.start = scene.start, .goal = {-1, -1}};
  CHECK(find_optimum(space, query).error().code == PlanError::goal_out_of_bounds);
}

}  // namespace
