// SPDX-License-Identifier: MIT
#include "tutavia/repair.hpp"
#include "tutavia/search/hybrid_astar.hpp"
#include "tutavia/smooth/vehicle_shortcut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "support/catch.hpp"
#include "support/exact_checker.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/clothoid_smoother.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/changed_boxes.hpp"

namespace {

using namespace tutavia;
using test::ExactVerdict;

bool equal_pieces(const Piece& a, const Piece& b) {
  if (a.index() != b.index() || start_of(a) != start_of(b) || end_of(a) != end_of(b)) return false;
  return a.visit([](const auto& p) { return p.point(0.3); }) ==
         b.visit([](const auto& p) { return p.point(0.3); });
}

/// What a repair may not break, whatever it did.
void check_repaired(const Workspace& after, const Plan& old, const Repaired& repaired) {
  const Plan& plan = repaired.plan;
  REQUIRE(plan.certificate.status == ProofStatus::proved);
  if (repaired.kind == RepairKind::searched_part) {
    CHECK(test::ExactChecker(after).check(plan.curve) == ExactVerdict::free);
  }
  CHECK(plan.curve.start() == old.curve.start());
  CHECK(plan.curve.end() == old.curve.end());
  const Certificate whole = certify(InflatedSpace::build(after).value(), plan.curve);
  REQUIRE(whole.status == ProofStatus::proved);
  CHECK(plan.certificate.lower <= whole.upper);
  CHECK(plan.certificate.upper >= whole.lower);
  CHECK(plan.metrics.length == plan.curve.length());
  CHECK(plan.metrics.min_clearance == plan.certificate.lower);
  CHECK(plan.route.curve.start() == plan.curve.start());
  CHECK(plan.route.curve.end() == plan.curve.end());

  const auto& before = old.curve.pieces();
  const auto& now = plan.curve.pieces();
  const std::size_t front = repaired.at_start.pieces, back = repaired.at_end.pieces;
  REQUIRE(front + back <= std::min(before.size(), now.size()));
  for (std::size_t i = 0; i < front; ++i) CHECK(equal_pieces(now[i], before[i]));
  for (std::size_t i = 1; i <= back; ++i) {
    CHECK(equal_pieces(now[now.size() - i], before[before.size() - i]));
  }
  CHECK(repaired.at_start.length == old.curve.length_before(front));
  const double tail = old.curve.length() - old.curve.length_before(before.size() - back);
  CHECK(repaired.at_end.length == Approx(tail).margin(1e-9));
}

/// How often repairs of a planner did what.
struct RepairCounts {
  std::size_t kept = 0, part = 0, anew = 0, failed = 0;
  double kept_length = 0, length = 0;  // of those that searched a part [m]
};

/// A random world with many small obstacles, so that paths have many bends.
Workspace crowded_world(test::WorldGenerator& worlds) {
  Workspace world = worlds.workspace();
  world.safety_radius = std::min(world.safety_radius, world.bounds.width() / 200);
  world.obstacles.clear();
  for (int i = 0; i < 60; ++i) {
    const Point low = worlds.point(world);
    world.obstacles.push_back(
        worlds.obstacle({low, low + (world.bounds.max - world.bounds.min) / 3}));
  }
  return world;
}

/// Plans in random worlds with discs and polygons, and repairs each plan after one has come near
/// it, moved or vanished.
template <class Build, class Search, class Smooth>
RepairCounts repair_in_random_worlds(const Build& build, Search search, Smooth smooth,
                                     std::size_t rounds) {
  const std::uint64_t seed = 4200;
  test::WorldGenerator worlds(seed);
  Random& random = worlds.random();
  Planner planner(search, smooth);
  RepairCounts counts;
  for (std::size_t round = 0; round < rounds; ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = crowded_world(worlds);
    Query query{.start = worlds.point(world), .goal = worlds.point(world)};
    for (int i = 0; i < 6; ++i) {  // long paths
      const Point p = worlds.point(world);
      if (distance(query.start, p) > distance(query.start, query.goal)) query.goal = p;
    }
    const auto plan = planner.plan(build(world), query);
    if (!plan) continue;
    Workspace changed = world;
    if (random.below(3) == 0) changed.obstacles.erase(changed.obstacles.begin());
    if (random.below(6) > 0) {
      const Point at = plan->curve.point(random.uniform(0, plan->curve.length()));
      changed.obstacles.push_back(Disc{at, 0.005 * world.bounds.width()});
    }
    const auto after = build(changed);
    const auto found = revalidate(after, *plan, changed_boxes(world, changed));
    const auto repaired = repair(planner, after, *plan, found, query);
    const auto anew = planner.plan(after, query);
    REQUIRE(repaired.has_value() >= anew.has_value());
    if (!repaired) {
      ++counts.failed;
      CHECK(repaired.error().code == anew.error().code);
      continue;
    }
    check_repaired(changed, *plan, *repaired);
    CHECK((repaired->kind == RepairKind::kept) == found.failed.empty());
    if (repaired->kind == RepairKind::kept) ++counts.kept;
    if (repaired->kind == RepairKind::planned_anew) {
      ++counts.anew;
      CHECK(repaired->at_start.pieces + repaired->at_end.pieces == 0);
    }
    if (repaired->kind != RepairKind::searched_part) continue;
    ++counts.part;
    CHECK(repaired->plan.metrics.max_joint_deflection <=
          std::max(1e-7, plan->metrics.max_joint_deflection));
    CHECK(repaired->plan.curve.length() <= 2 * plan->curve.length());
    counts.kept_length += repaired->at_start.length + repaired->at_end.length;
    counts.length += plan->curve.length();
  }
  return counts;
}

const auto build_inflated = [](const Workspace& world) {
  return InflatedSpace::build(world).value();
};
const auto build_lattice = [](const Workspace& world) {
  return LatticeSpace::build(world, {.resolution = world.bounds.width() / 32}).value();
};

/// Parts were searched, and much was kept.
void check_counts(const RepairCounts& counts) {
  CAPTURE(counts.kept, counts.part, counts.anew, counts.failed, counts.kept_length, counts.length);
  CHECK(2 * counts.part > test::scaled(5));
  CHECK(counts.kept_length > 0.2 * counts.length);
}

TEST_CASE("repaired shortest paths are proved, and keep both ends of the earlier path") {
  check_counts(
      repair_in_random_worlds(build_inflated, TangentGraph{}, NoSmoothing{}, test::scaled(50)));
}

TEST_CASE("repaired clothoid paths are proved, and keep both ends of the earlier path") {
  check_counts(repair_in_random_worlds(build_inflated, TangentGraph{}, ClothoidSmoother{},
                                       test::scaled(50)));
}

TEST_CASE("repaired routes on a lattice are proved, and keep both ends of the earlier route") {
  check_counts(repair_in_random_worlds(build_lattice, AStar{}, NoSmoothing{}, test::scaled(50)));
}

TEST_CASE("repaired taut strings are proved, and keep both ends of the earlier string") {
  check_counts(repair_in_random_worlds(build_lattice, AStar{}, TautString{}, test::scaled(50)));
}

TEST_CASE("repaired Bezier paths are proved, and keep both ends of the earlier path") {
  check_counts(repair_in_random_worlds(build_lattice, AStar{}, BezierSmoother{}, test::scaled(50)));
}

TEST_CASE("routes on cells are repaired around a cell that becomes blocked") {
  const std::uint64_t seed = 4300;
  Random random(seed);
  INFO("seed " << seed);
  Planner planner(Jps{}, NoSmoothing{});
  std::size_t parts = 0, kept = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    OccupancyGrid grid = test::random_grid(random, 120);
    const auto space = CellSpace::build(grid).value();
    const Query query = test::random_query(random, space);
    const auto plan = planner.plan(space, query);
    if (!plan || plan->curve.length() == 0) continue;
    const Point at = plan->curve.point(random.uniform(0, plan->curve.length()));
    const Cell cell{static_cast<int>(at.x()), static_cast<int>(at.y())};
    grid.set(cell, false);
    const auto after = CellSpace::build(grid).value();
    const Point corner{std::floor(at.x()), std::floor(at.y())};
    const std::vector<Box> changed{{corner, corner + Point(1, 1)}};
    const auto found = revalidate(after, *plan, changed);
    REQUIRE(found.certificate.status == certify(after, plan->curve).status);
    const auto repaired = repair(planner, after, *plan, found, query);
    REQUIRE(repaired.has_value() >= planner.plan(after, query).has_value());
    if (!repaired) continue;
    CHECK(certify(after, repaired->plan.curve).status == ProofStatus::proved);
    if (repaired->kind == RepairKind::searched_part) ++parts;
    kept += repaired->at_start.pieces + repaired->at_end.pieces;
  }
  CAPTURE(parts, kept);
  CHECK(parts > test::scaled(10));
  CHECK(kept > test::scaled(10));
}

/// Discs in a slalom of six gates, whose path has many bends.
Workspace slalom() {
  Workspace world{.bounds = {{0, 0}, {30, 10}}, .safety_radius = 0.4, .obstacles = {}};
  for (int i = 0; i < 6; ++i) {
    const double x = 3 + 4.8 * i, low = i % 2 == 0 ? 0 : 3.5;
    world.obstacles.push_back(
        Polygon{{{x, low}, {x + 0.5, low}, {x + 0.5, low + 6.5}, {x, low + 6.5}}});
  }
  return world;
}
const Query slalom_query{.start = {1, 5}, .goal = {29, 5}, .seed = 3};

TEST_CASE("a repair without a change keeps the plan and computes nothing") {
  const auto space = build_inflated(slalom());
  Planner planner(TangentGraph{}, NoSmoothing{});
  const Plan plan = planner.plan(space, slalom_query).value();
  const auto found = revalidate(space, plan, {});
  const Repaired repaired = repair(planner, space, plan, found, slalom_query).value();
  CHECK(repaired.kind == RepairKind::kept);
  CHECK(repaired.at_start.pieces == plan.curve.pieces().size());
  CHECK(repaired.at_start.length == plan.curve.length());
  CHECK(repaired.plan.certificate.evaluations == 0);
  CHECK(repaired.plan.stats.expanded == 0);
  CHECK(repaired.plan.stats.seed == 3);
  check_repaired(slalom(), plan, repaired);
}

TEST_CASE("a plan is kept when an obstacle vanishes") {
  Workspace changed = slalom();
  changed.obstacles.pop_back();
  const auto space = build_inflated(slalom()), after = build_inflated(changed);
  Planner planner(TangentGraph{}, NoSmoothing{});
  const Plan plan = planner.plan(space, slalom_query).value();
  const auto found = revalidate(after, plan, changed_boxes(slalom(), changed));
  const Repaired repaired = repair(planner, after, plan, found, slalom_query).value();
  CHECK(repaired.kind == RepairKind::kept);
  check_repaired(changed, plan, repaired);
}

TEST_CASE("an obstacle in one gate of a slalom leaves the other gates as they were") {
  Workspace changed = slalom();
  const auto space = build_inflated(slalom());
  Planner planner(TangentGraph{}, ClothoidSmoother{});
  const Plan plan = planner.plan(space, slalom_query).value();
  const Point middle = plan.curve.point(0.5 * plan.curve.length());
  changed.obstacles.push_back(Disc{middle, 0.3});
  const auto after = build_inflated(changed);
  const auto found = revalidate(after, plan, changed_boxes(slalom(), changed));
  CHECK(found.certificate.status == ProofStatus::violated);
  const Repaired repaired = repair(planner, after, plan, found, slalom_query).value();
  CHECK(repaired.kind == RepairKind::searched_part);
  CHECK(repaired.at_start.length > 0.2 * plan.curve.length());
  CHECK(repaired.at_end.length > 0.2 * plan.curve.length());
  CHECK(repaired.plan.metrics.max_joint_deflection < 1e-9);
  CHECK(repaired.plan.metrics.max_curvature_jump < 1e-6);
  CHECK(repaired.plan.stats.expanded > 0);
  CHECK(repaired.plan.stats.expanded < plan.stats.expanded);
  CHECK_FALSE(repaired.plan.fell_back);
  check_repaired(changed, plan, repaired);
  const Plan anew = planner.plan(after, slalom_query).value();
  CHECK(repaired.plan.curve.length() < 1.02 * anew.curve.length());
}

TEST_CASE("a repair fails as a plan does: at a blocked end, behind a wall, out of budget") {
  const auto space = build_inflated(slalom());
  Planner planner(TangentGraph{}, NoSmoothing{});
  const Plan plan = planner.plan(space, slalom_query).value();
  const auto repaired_with = [&](const Obstacle& obstacle, const Query& query) {
    Workspace changed = slalom();
    changed.obstacles.push_back(obstacle);
    const auto after = build_inflated(changed);
    const auto found = revalidate(after, plan, changed_boxes(slalom(), changed));
    return repair(planner, after, plan, found, query);
  };
  const Obstacle on_goal = Disc{slalom_query.goal, 0.2};
  CHECK(repaired_with(on_goal, slalom_query).error().code == PlanError::goal_blocked);
  const Obstacle on_start = Disc{slalom_query.start, 0.2};
  CHECK(repaired_with(on_start, slalom_query).error().code == PlanError::start_blocked);
  const Obstacle wall = Polygon{{{15, 0}, {15.2, 0}, {15.2, 10}, {15, 10}}};
  const auto walled = repaired_with(wall, slalom_query);
  CHECK(walled.error().code == PlanError::unreachable);
  CHECK(walled.error().stats.expanded > 0);
  Query limited = slalom_query;
  limited.budget.max_expansions = 1;
  const Obstacle in_the_way = Disc{plan.curve.point(0.5 * plan.curve.length()), 0.3};
  CHECK(repaired_with(in_the_way, slalom_query).has_value());
  CHECK(repaired_with(in_the_way, limited).error().code == PlanError::budget_exhausted);
  std::stop_source source;
  source.request_stop();
  Query cancelled = slalom_query;
  cancelled.budget.stop = source.get_token();
  CHECK(repaired_with(on_goal, cancelled).error().code == PlanError::cancelled);
}

TEST_CASE("another query than the plan's is planned anew") {
  const auto space = build_inflated(slalom());
  Planner planner(TangentGraph{}, NoSmoothing{});
  const Plan plan = planner.plan(space, slalom_query).value();
  const auto found = revalidate(space, plan, {});
  Query other = slalom_query;
  other.start = {1, 6};
  const Repaired repaired = repair(planner, space, plan, found, other).value();
  CHECK(repaired.kind == RepairKind::planned_anew);
  CHECK(repaired.plan.curve.start() == other.start);
}

TEST_CASE("the plan of a vehicle is kept if it holds and has the headings, else planned anew") {
  const Workspace open{.bounds = {{0, 0}, {20, 20}}, .safety_radius = 0.2};
  Workspace changed = open;
  changed.obstacles.emplace_back(Disc{{3, 17}, 1});
  const auto before = InflatedSpace::build(open).value();
  const auto after = InflatedSpace::build(changed).value();
  const Box change{{2, 16}, {4, 18}};
  Planner planner{HybridAStar{.vehicle = Vehicle::car(2, 1, 1.2, 2)}, VehicleShortcut{}};
  Query query{.start = {4, 4}, .goal = {16, 6}, .start_heading = 0, .goal_heading = 0};
  const auto plan = planner.plan(before, query);
  REQUIRE(plan);
  const auto revalidation = revalidate(after, *plan, std::span(&change, 1));
  CHECK(revalidation.certificate.status == ProofStatus::proved);
  CHECK(repair(planner, after, *plan, revalidation, query)->kind == RepairKind::kept);
  query.goal_heading = 1;
  const auto turned = repair(planner, after, *plan, revalidation, query);
  REQUIRE(turned);
  CHECK(turned->kind == RepairKind::planned_anew);
  CHECK(VehiclePath{turned->plan.curve, turned->plan.gears}.end().heading == Approx(1));

  // The reference point passes the post, but the car would hit it.
  Workspace narrow = open;
  narrow.obstacles.emplace_back(
      Disc{plan->curve.point(plan->curve.length() / 2) + Point(0, 0.8), 0.1});
  const auto worse = InflatedSpace::build(narrow).value();
  const Box post = Box{{0, 0}, {20, 20}};
  const auto failed = revalidate(worse, *plan, std::span(&post, 1));
  CHECK(failed.certificate.status != ProofStatus::proved);
  CHECK(failed.failed.size() == plan->gears.size());
}

}  // namespace
