// SPDX-License-Identifier: MIT
#include "tutavia/smooth/vehicle_shortcut.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "support/catch.hpp"
#include "support/random_drives.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/vehicle_checker.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/first_of.hpp"
#include "tutavia/search/hybrid_astar.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;

static_assert(VehicleSmoother<VehicleShortcut, InflatedSpace>);
static_assert(VehicleSmoother<NoSmoothing, InflatedSpace>);
static_assert(!VehicleSmoother<DeltaSmoother, InflatedSpace>);

TEST_CASE("a detour becomes the shortest drive where that is free") {
  const auto space = test::yard();
  const Vehicle vehicle = Vehicle::car(2, 1, 1.2, 2);
  const Pose start{{3, 3}, 0}, by{{4, 12}, 2}, goal{{12, 4}, 1};
  VehiclePath detour = reeds_shepp_path(start, by, 2);
  const VehiclePath rest = reeds_shepp_path(by, goal, 2);
  for (std::size_t i = 0; i < rest.gears.size(); ++i) {
    detour.push_back(rest.curve.pieces()[i], rest.gears[i]);
  }
  const VehicleShortcut smoother{.reverse_weight = 1, .cusp_cost = 0};
  const auto smoothed = smoother.smooth(space, vehicle, detour, {});
  REQUIRE(smoothed);
  CHECK(smoothed->length() == Approx(reeds_shepp_length(start, goal, 2)).epsilon(1e-9));
  CHECK(test::largest_jump(*smoothed, start, goal) <= 1e-12L);
  const auto again = smoother.smooth(space, vehicle, *smoothed, {});
  CHECK(smoother.cost_of(*again) <= smoother.cost_of(*smoothed));
}

TEST_CASE("smoothed paths of random vehicles cost less and are proved", "[soak]") {
  const std::uint64_t seed = 7;
  test::WorldGenerator worlds(seed);
  Random random(seed);
  std::size_t smoothed = 0, shorter = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto [world, vehicle, query] = test::random_drive(worlds, random);
    const auto space = InflatedSpace::build(world).value();
    Planner planner{HybridAStar{.vehicle = vehicle, .headings = 16, .searches = 2},
                    VehicleShortcut{}};
    const auto plan = planner.plan(space, query);
    if (!plan) continue;
    ++smoothed;
    CHECK_FALSE(plan->fell_back);
    const VehiclePath path{plan->curve, plan->gears};
    const VehiclePath route{plan->route.curve, plan->route.gears};
    const VehicleShortcut weights;
    CHECK(weights.cost_of(path) <= weights.cost_of(route));
    if (weights.cost_of(path) < 0.999 * weights.cost_of(route)) ++shorter;
    const double largest = world.bounds.largest_coordinate();
    CHECK(test::clearance_deficit(world, vehicle, path) <= 1e-12L * (1 + largest));
    CHECK(test::largest_curvature(path) <= 1 / test::Real(vehicle.min_turning_radius));
    CHECK(test::largest_jump(path, {query.start, *query.start_heading},
                             {query.goal, *query.goal_heading}) <= 1e-12L * (1 + largest));
    CHECK(plan->metrics.max_joint_deflection <= 1e-9);
  }
  CHECK(smoothed > test::scaled(60) / 5);
  CHECK(shorter > 0);
}

TEST_CASE("a vehicle's plan is refused by smoothers that keep no headings") {
  const auto space = test::yard();
  Planner planner{HybridAStar{}, DeltaSmoother{}};
  const auto plan = planner.plan(space, {.start = {3, 3}, .goal = {27, 27}, .start_heading = 0});
  REQUIRE_FALSE(plan);
  CHECK(plan.error().code == PlanError::invalid_option);
  CHECK(plan.error().detail.find("delta") == 0);
  Planner unsmoothed{HybridAStar{}, NoSmoothing{}};
  const auto route = unsmoothed.plan(space, {.start = {3, 3}, .goal = {27, 27}});
  REQUIRE(route);
  CHECK(route->gears.size() == route->curve.pieces().size());
  CHECK(VehicleShortcut{}.smooth(space, route->curve, {}).error().code ==
        PlanError::invalid_option);
}

/// A search that hands on the routes of another one and does not say so.
struct Wrapped {
  static constexpr std::string_view name = "wrapped";
  using Scratch = HybridAStar::Scratch;
  HybridAStar inner{};

  template <class S, Observer O>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    return inner.search(space, query, scratch, observer);
  }
};

TEST_CASE("a planner never takes the route of a vehicle for that of a point") {
  const auto space = test::yard();
  const HybridAStar car{.vehicle = Vehicle::car(2, 1, 1.2, 2)};
  const Query query{.start = {3, 3}, .goal = {27, 27}, .start_heading = 0, .goal_heading = 0};
  Planner wrapped{Wrapped{car}, NoSmoothing{}};
  const auto refused = wrapped.plan(space, query);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_option);
  CHECK(refused.error().detail.find("plans_vehicles") != std::string::npos);
  Planner first{FirstOf{car, car}, VehicleShortcut{}};
  const auto plan = first.plan(space, query);
  REQUIRE(plan);
  CHECK(plan->gears.size() == plan->curve.pieces().size());
  CHECK(plan->route.found_by == "hybrid_astar");
}

/// Comes to the goal in another heading than its input.
struct TurnedGoal {
  static constexpr std::string_view name = "turned_goal";
  template <class S>
  Expected<Curve, Failure> smooth(const S&, const Curve& curve, const Budget&) const {
    return curve;
  }
  template <class S>
  Expected<VehiclePath, Failure> smooth(const S&, const Vehicle& vehicle, const VehiclePath& path,
                                        const Budget&) const {
    Pose goal = path.end();
    goal.heading += 0.1;
    return reeds_shepp_path(path.start(), goal, vehicle.min_turning_radius);
  }
};

TEST_CASE("a planner falls back if a smoother does not keep the headings") {
  const InflatedSpace space = InflatedSpace::build({.bounds = {{0, 0}, {30, 30}}}).value();
  Planner planner{HybridAStar{.vehicle = Vehicle::point(2, true)}, TurnedGoal{}};
  Query query{.start = {9, 9}, .goal = {20, 20}, .start_heading = 0, .goal_heading = 0};
  const auto fell_back = planner.plan(space, query);
  REQUIRE(fell_back);
  CHECK(fell_back->fell_back);
  query.goal_heading = std::nullopt;
  CHECK_FALSE(planner.plan(space, query)->fell_back);
  query.start_heading = 1e9;  // rounded to 1e-7 rad, which is no fault of a path
  CHECK(planner.plan(space, query));
}

TEST_CASE("options out of range are refused, and without time the path stays") {
  const auto space = test::yard();
  const VehiclePath path = reeds_shepp_path({{3, 3}, 0}, {{5, 9}, 2}, 2);
  const Vehicle vehicle = Vehicle::point(2, true);
  for (const VehicleShortcut& bad :
       {VehicleShortcut{.reverse_weight = 0.5}, VehicleShortcut{.cusp_cost = -1},
        VehicleShortcut{.places = 1}, VehicleShortcut{.reverse_weight = std::nan("")}}) {
    const auto smoothed = bad.smooth(space, vehicle, path, {});
    REQUIRE_FALSE(smoothed);
    CHECK(smoothed.error().code == PlanError::invalid_option);
  }
  const auto kept = VehicleShortcut{}.smooth(space, vehicle, path, Budget::for_seconds(0));
  REQUIRE(kept);
  CHECK(kept->length() == path.length());
  CHECK(VehicleShortcut{}.smooth(space, Vehicle::point(), path, {})->length() == path.length());
}

}  // namespace
