// SPDX-License-Identifier: MIT
#include "tutavia/smooth/continuous_curvature.hpp"

#include <cstddef>
#include <cstdint>
#include <numbers>

#include "support/catch.hpp"
#include "support/random_drives.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/steering_checker.hpp"
#include "support/vehicle_checker.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/hybrid_astar.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/pipeline.hpp"
#include "tutavia/smooth/vehicle_shortcut.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;

static_assert(VehicleSmoother<ContinuousCurvature, InflatedSpace>);

TEST_CASE("in open space one drive of continuous curvature takes the place of the path") {
  const auto space = test::yard();
  const Vehicle vehicle = Vehicle::car(2, 1, 1.2, 2);
  const Pose start{{3, 3}, 0}, goal{{12, 4}, 1};
  const ContinuousCurvature smoother{.reverse_weight = 1, .cusp_cost = 0};
  const auto smoothed = smoother.smooth(space, vehicle, reeds_shepp_path(start, goal, 2), {});
  REQUIRE(smoothed);
  CHECK(test::broken_steering_limit(*smoothed, 2, 0.25) == "");
  CHECK(test::largest_jump(*smoothed, start, goal) <= 1e-12L);
  CHECK(smoothed->length() <=
        ContinuousDrives({2, 0.25}, true).word(start, goal).length * (1 + 1e-9));
}

TEST_CASE("random vehicles' paths become continuous in curvature, and are proved", "[soak]") {
  const std::uint64_t seed = 9;
  test::WorldGenerator worlds(seed);
  Random random(seed);
  std::size_t planned = 0, smoothed = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto [world, vehicle, query] = test::random_drive(worlds, random);
    const auto space = InflatedSpace::build(world).value();
    const double radius = vehicle.min_turning_radius;
    const double sharpness = random.uniform(0.3, 3) / (radius * radius);
    Planner planner{HybridAStar{.vehicle = vehicle, .headings = 16, .searches = 2},
                    ContinuousCurvature{.max_sharpness = sharpness}};
    const auto plan = planner.plan(space, query);
    if (!plan) continue;
    ++planned;
    if (plan->fell_back) continue;
    ++smoothed;
    const VehiclePath path{plan->curve, plan->gears};
    const double largest = world.bounds.largest_coordinate();
    CHECK(test::broken_steering_limit(path, radius, sharpness) == "");
    CHECK(test::clearance_deficit(world, vehicle, path) <= 1e-12L * (1 + largest));
    CHECK(test::largest_jump(path, {query.start, *query.start_heading},
                             {query.goal, *query.goal_heading}) <= 1e-12L * (1 + largest));
    CHECK(plan->metrics.max_joint_deflection <= 1e-9);
    CHECK(plan->metrics.max_curvature_jump <= 1e-9 / radius);
  }
  INFO(planned << " planned, " << smoothed << " smoothed");
  CHECK(planned > test::scaled(60) / 5);
  CHECK(smoothed > planned / 2);
}

TEST_CASE("a path of continuous curvature stays as it is, or gets shorter") {
  const auto space = test::yard();
  const Vehicle vehicle = Vehicle::car(2, 1, 1.2, 2);
  Planner planner{HybridAStar{.vehicle = vehicle}, NoSmoothing{}};
  const auto plan = planner.plan(
      space, {.start = {3, 3}, .goal = {27, 25}, .start_heading = 0, .goal_heading = 1});
  REQUIRE(plan);
  const VehiclePath path{plan->curve, plan->gears};
  const ContinuousCurvature smoother;
  const VehiclePath once = smoother.smooth(space, vehicle, path, {}).value();
  const VehiclePath twice = smoother.smooth(space, vehicle, once, {}).value();
  CHECK(twice.length() <= once.length());
  CHECK(twice.length() >= 0.999 * once.length());
  CHECK(certify(space, vehicle, once).status == ProofStatus::proved);
}

TEST_CASE("in a pipeline shortcuts come first, and the planner proves the result") {
  const auto space = test::yard();
  const Vehicle vehicle = Vehicle::car(2, 1, 1.2, 2);
  Planner planner{HybridAStar{.vehicle = vehicle},
                  Pipeline{VehicleShortcut{}, ContinuousCurvature{}}};
  const auto plan = planner.plan(
      space, {.start = {3, 3}, .goal = {27, 25}, .start_heading = 2, .goal_heading = 1});
  REQUIRE(plan);
  CHECK_FALSE(plan->fell_back);
  CHECK(test::broken_steering_limit({plan->curve, plan->gears}, 2, 0.25) == "");
  Planner half{HybridAStar{.vehicle = vehicle}, Pipeline{VehicleShortcut{}, DeltaSmoother{}}};
  const auto refused = half.plan(space, {.start = {3, 3}, .goal = {27, 25}, .start_heading = 2});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_option);
}

TEST_CASE("continuous curvature is refused where it has no room, and for options out of range") {
  // A lane just wide enough for the arcs of a turning circle.
  const auto lane = InflatedSpace::build({.bounds = {{-3, -0.2}, {3, 4.2}},
                                          .safety_radius = 0.1,
                                          .obstacles = {Disc{{0, 2}, 1.8}}})
                        .value();
  const Vehicle vehicle = Vehicle::point(2);
  const VehiclePath around = dubins_path({{0, 0}, 0}, {{0, 4}, std::numbers::pi}, 2);
  REQUIRE(certify(lane, vehicle, around).status == ProofStatus::proved);
  const auto none = ContinuousCurvature{}.smooth(lane, vehicle, around, {});
  REQUIRE_FALSE(none);
  CHECK(none.error().code == PlanError::not_proved);
  const auto late = ContinuousCurvature{}.smooth(lane, vehicle, around, Budget::for_seconds(0));
  REQUIRE_FALSE(late);
  CHECK(late.error().code == PlanError::budget_exhausted);
  for (const ContinuousCurvature& bad :
       {ContinuousCurvature{.max_sharpness = -1}, ContinuousCurvature{.reverse_weight = 0.5},
        ContinuousCurvature{.cusp_cost = -1}, ContinuousCurvature{.places = 1}}) {
    CHECK(bad.smooth(lane, vehicle, around, {}).error().code == PlanError::invalid_option);
  }
  CHECK(ContinuousCurvature{}.smooth(lane, around.curve, {}).error().code ==
        PlanError::invalid_option);
  const auto point = ContinuousCurvature{}.smooth(lane, Vehicle::point(), around, {});
  REQUIRE(point);
  CHECK(point->length() == around.length());
}

}  // namespace
